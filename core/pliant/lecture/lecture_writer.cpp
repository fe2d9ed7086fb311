// Slides added to the text of a lecture.
#include <pliant/document/share.h>
#include <pliant/document/walkthrough_words.h>
#include <pliant/lecture/lecture.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

std::string fill_text(const FilledPanel& fill) {
    return fill.probe.empty() ? fill.panel : fmt::format("{} {}", fill.panel, fill.probe);
}

std::string knob_text(const LectureSlide& slide, const Knob& knob) {
    return text_of(*find_lesson(slide.scene->lesson).make(), knob);
}

Json json_of(const LectureSlide& slide) {
    Json object{{"title", slide.slide.title}};
    if (slide.minutes > 0) object["minutes"] = slide.minutes;
    for (const Block& b : slide.slide.blocks) {
        const std::string key(name_of(b.kind));
        for (const std::string& line : b.lines) object[key].push_back(line);
    }
    if (slide.scene) object["scene"] = Json::parse(compact_scene_text(*slide.scene));
    if (slide.beside)
        for (const auto& [key, value] : *slide.beside) object["beside"][key] = value;
    if (slide.atlas) object["atlas"] = {knob_text(slide, slide.atlas->first), knob_text(slide, slide.atlas->second)};
    if (slide.deck) object["deck"] = slide.deck->lesson, object["slides"] = {slide.deck->number + 1};
    if (!slide.claim.empty()) object["claim"] = slide.claim;
    if (!slide.picture.empty()) object["picture"] = slide.picture;
    if (slide.fill) object["fill"] = fill_text(*slide.fill);
    return object;
}

std::string markdown_of(const LectureSlide& slide) {
    std::string text = fmt::format("\n## {}\n", slide.slide.title), shown;
    if (slide.minutes > 0) shown += fmt::format("minutes {:g}\n", slide.minutes);
    if (slide.scene) shown += fmt::format("scene {}\n", share_text(*slide.scene));
    if (slide.beside)
        for (const auto& [key, value] : *slide.beside) shown += fmt::format("beside {}={}\n", key, value);
    if (slide.atlas)
        shown += fmt::format("atlas {} {}\n", knob_text(slide, slide.atlas->first), knob_text(slide, slide.atlas->second));
    if (slide.deck) shown += fmt::format("deck {}\nslides {}\n", slide.deck->lesson, slide.deck->number + 1);
    if (!slide.claim.empty()) shown += fmt::format("claim {}\n", slide.claim);
    if (!slide.picture.empty()) shown += fmt::format("picture {}\n", slide.picture);
    if (slide.fill) shown += fmt::format("fill {}\n", fill_text(*slide.fill));
    if (!shown.empty()) text += fmt::format("\n```show\n{}```\n", shown);
    for (const Block& b : slide.slide.blocks) {
        if (b.kind == BlockKind::text) {
            text += fmt::format("\n{}\n", b.paragraph());
            continue;
        }
        text += fmt::format("\n```{}\n", name_of(b.kind));
        for (const std::string& line : b.lines) text += line + "\n";
        text += "```\n";
    }
    return text;
}

bool is_markdown(std::string_view path) { return path.ends_with(".md"); }

}  // namespace

std::string with_slide_added(std::string_view text, std::string_view path, const LectureSlide& slide) {
    const bool fresh = trimmed(text).empty();
    if (!fresh) parse_lecture(text, path);
    const bool markdown = fresh ? is_markdown(path) : trimmed(text).front() != '{';
    if (markdown) {
        std::string all = fresh ? "# A lecture\n" : std::string(text);
        if (all.back() != '\n') all += '\n';
        return all + markdown_of(slide);
    }
    Json root = fresh ? Json{{"pliant_lecture", 1}, {"title", "A lecture"}, {"slides", Json::array()}} : Json::parse(text);
    root["slides"].push_back(json_of(slide));
    return root.dump(2) + "\n";
}

}  // namespace pliant
