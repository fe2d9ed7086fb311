// A lecture from JSON or Markdown.
#include <pliant/document/walkthrough_words.h>
#include <pliant/lecture/slide_facts.h>
#include <pliant/text/file.h>
#include <pliant/text/suggest.h>
#include <pliant/text/texts.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;
constexpr int version = 1;

std::string folder_of(std::string_view path) { return std::filesystem::path(path).parent_path().string(); }

bool is_json(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    return first != std::string_view::npos && text[first] == '{';
}

class JsonLecture {
public:
    JsonLecture(std::string_view text, std::string_view path) : path_(path), text_(text), json_(parse_json(text, path)) {}

    Lecture read() const {
        const Json& root = json_.value;
        check_version(root);
        known_keys(root, "", {"pliant_lecture", "title", "slides"});
        Lecture lecture{.path = path_, .title = text_at(root, "title", ""), .slides = {}};
        if (!root.contains("slides") || !root["slides"].is_array() || root["slides"].empty())
            refuse("/slides", "\"slides\" is a list of slides in brackets, and there is one at least");
        for (std::size_t n = 0; n < root["slides"].size(); ++n)
            for (LectureSlide& s : lecture_slides(slide(root["slides"][n], fmt::format("/slides/{}", n)), folder_of(path_)))
                lecture.slides.push_back(std::move(s));
        return lecture;
    }

private:
    std::string place(const std::string& pointer) const {
        const TextPlace p = json_.at(pointer);
        return fmt::format("{}:{}:{}", path_, p.line, p.column);
    }
    [[noreturn]] void refuse(const std::string& pointer, const std::string& what) const {
        throw Refused(fmt::format("{}: {}", place(pointer), what));
    }
    void check_version(const Json& root) const {
        if (!root.is_object() || !root.contains("pliant_lecture"))
            refuse("",
                   "the key \"pliant_lecture\" is missing: a lecture begins with {\"pliant_lecture\": 1, \"title\": ..., "
                   "\"slides\": [...]}");
        const Json& v = root["pliant_lecture"];
        if (!v.is_number_integer() || v.get<long long>() < 1)
            refuse("/pliant_lecture", "\"pliant_lecture\" is the version of the format: give 1");
        if (v.get<long long>() > version)
            refuse("/pliant_lecture",
                   fmt::format("this lecture is of version {}, newer than this program, which reads version {}: update Pliant",
                               v.dump(), version));
    }
    void known_keys(const Json& object, const std::string& pointer, const std::vector<std::string>& known) const {
        for (const auto& [key, value] : object.items())
            if (std::ranges::find(known, key) == known.end())
                refuse(pointer + "/" + pointer_part(key),
                       fmt::format("unknown key '{}'{}; known here: {}", key, did_you_mean(key, known), fmt::join(known, ", ")));
    }
    std::string text_at(const Json& object, const std::string& key, const std::string& pointer) const {
        if (!object.contains(key) || !object[key].is_string() || object[key].get<std::string>().empty())
            refuse(object.contains(key) ? pointer + "/" + key : pointer,
                   fmt::format("'{}' is a text in quotes, and not empty", key));
        return object[key].get<std::string>();
    }

    // What is wrong with a slide is its own trouble.
    SlideFacts slide(const Json& object, const std::string& pointer) const {
        SlideFacts said{.slide = {.title = {}, .blocks = {}, .line = json_.at(pointer).line},
                        .facts = {},
                        .path = path_,
                        .place = place(pointer)};
        try {
            if (!object.is_object()) refuse(pointer, fmt::format("a slide is an object in braces, not {}", object.type_name()));
            if (object.contains("title")) said.slide.title = text_at(object, "title", pointer);
            for (const auto& [key, value] : object.items()) take(said, key, value, pointer + "/" + pointer_part(key));
        } catch (const Refused& e) {
            said.trouble = e.what();
        }
        return said;
    }
    void take(SlideFacts& said, const std::string& key, const Json& value, const std::string& pointer) const {
        if (key == "title") return;
        const auto kind = key == "text" ? BlockKind::text : block_kind(key);
        if (kind && *kind != BlockKind::scene && *kind != BlockKind::show) return take_block(said, *kind, value, pointer);
        const auto& facts = slide_fact_keys();
        if (std::ranges::find(facts, key) == facts.end()) {
            std::vector<std::string> known{"title",  "text",   "formula", "ask",   "predict", "do",
                                           "expect", "answer", "hide",    "plots", "notes",   "controls"};
            std::erase_if(known, [](const std::string& k) { return k != "title" && k != "text" && !block_kind(k); });
            known.insert(known.end(), facts.begin(), facts.end());
            refuse(pointer,
                   fmt::format("unknown key '{}'{}; known here: {}", key, did_you_mean(key, known), fmt::join(known, ", ")));
        }
        SlideFact fact{key, {}, place(pointer), false};
        if (key == "scene" && value.is_object())
            fact.values.push_back(object_behind(pointer)), fact.is_object = true;
        else
            fact.values = values(value, pointer, key);
        said.facts.push_back(std::move(fact));
    }
    // The object that stands behind a key, where it stands in the file.
    std::string object_behind(const std::string& pointer) const {
        const TextPlace p = json_.at(pointer);
        std::size_t at = 0;
        for (int line = 1; line < p.line; ++line) at = text_.find('\n', at) + 1;
        at += static_cast<std::size_t>(p.column) - 1;
        const std::size_t begin = text_.find('{', at + 1);
        std::string padded = text_.substr(0, begin);
        for (char& c : padded)
            if (c != '\n') c = ' ';
        return padded + text_.substr(begin, end_of_object(begin) - begin);
    }
    std::size_t end_of_object(std::size_t begin) const {
        int depth = 0;
        bool quoted = false;
        for (std::size_t at = begin; at < text_.size(); ++at) {
            const char c = text_[at];
            if (quoted && c == '\\')
                ++at;
            else if (c == '"')
                quoted = !quoted;
            else if (!quoted && c == '{')
                ++depth;
            else if (!quoted && c == '}' && --depth == 0)
                return at + 1;
        }
        return text_.size();
    }

    // A list of texts is a block for each where they are paragraphs, else its lines.
    void take_block(SlideFacts& said, BlockKind kind, const Json& value, const std::string& pointer) const {
        const int line = json_.at(pointer).line;
        const auto lines = values(value, pointer, name_of(kind));
        if (kind != BlockKind::text) return said.slide.blocks.push_back({kind, lines, line});
        for (const std::string& paragraph : lines) said.slide.blocks.push_back({kind, {paragraph}, line});
    }
    static std::string scalar(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }
    std::vector<std::string> values(const Json& value, const std::string& pointer, std::string_view key) const {
        if (value.is_null()) refuse(pointer, fmt::format("'{}' is null: give a value, or leave it out", key));
        std::vector<std::string> result;
        if (value.is_object())
            for (const auto& [name, member] : value.items()) result.push_back(fmt::format("{}={}", name, scalar(member)));
        else if (value.is_array())
            for (const Json& element : value) result.push_back(scalar(element));
        else
            result.push_back(scalar(value));
        return result;
    }

    std::string path_, text_;
    PlacedJson json_;
};

// The lines of a ```show block: a key, and its value behind it.
void take_shown(SlideFacts& said, const Block& block, std::string_view path) {
    int number = block.first_line;
    const auto& known = slide_fact_keys();
    for (const std::string& raw : block.lines) {
        const std::string line = trimmed(raw), place = fmt::format("{}:{}", path, number++);
        if (line.empty()) continue;
        const auto end = line.find(' ');
        const std::string key = line.substr(0, end), value = end == std::string::npos ? "" : trimmed(line.substr(end));
        if (std::ranges::find(known, key) == known.end())
            throw Refused(fmt::format("{}: unknown word '{}'{}; known in a show block: {}", place, key, did_you_mean(key, known),
                                      fmt::join(known, ", ")));
        const auto same = std::ranges::find(said.facts, key, &SlideFact::key);
        if (same != said.facts.end())
            same->values.push_back(value);
        else
            said.facts.push_back({key, {value}, place, false});
    }
}

Lecture markdown_lecture(std::string_view text, std::string_view path) {
    const Walkthrough read = parse_walkthrough(text, path, ExtraBlock::show);
    if (read.title.empty()) throw Refused(fmt::format("{}:1: the lecture has no title: begin with '# Title'", path));
    Lecture lecture{.path = std::string(path), .title = read.title, .slides = {}};
    for (const Slide& slide : read.slides) {
        SlideFacts said{.slide = {slide.title, {}, slide.line},
                        .facts = {},
                        .path = std::string(path),
                        .place = fmt::format("{}:{}", path, slide.line)};
        try {
            for (const Block& b : slide.blocks)
                b.kind == BlockKind::show ? take_shown(said, b, path) : said.slide.blocks.push_back(b);
        } catch (const Refused& e) {
            said.trouble = e.what();
        }
        for (LectureSlide& s : lecture_slides(said, folder_of(path))) lecture.slides.push_back(std::move(s));
    }
    return lecture;
}

}  // namespace

Lecture parse_lecture(std::string_view text, std::string_view path) {
    return is_json(text) ? JsonLecture(text, path).read() : markdown_lecture(text, path);
}

bool looks_like_lecture(std::string_view text) { return !is_json(text) || text.find("\"pliant_lecture\"") != text.npos; }

std::vector<std::string> lecture_names() {
    std::vector<std::string> names;
    for (const std::string_view path : texts_in("lectures")) names.push_back(std::filesystem::path(path).stem().string());
    return names;
}

Lecture read_lecture(const std::string& path) {
    std::error_code error;
    for (const std::string_view text : texts_in("lectures"))
        if ((text == path || std::filesystem::path(text).stem() == path) && !std::filesystem::is_regular_file(path, error))
            return parse_lecture(find_text(text), text);
    if (path.find_first_of("/.") == std::string::npos && !std::filesystem::exists(path, error))
        throw Refused(fmt::format("no lecture is called '{}'{}; with Pliant come {}, any other is the path of a file", path,
                                  did_you_mean(path, lecture_names()), fmt::join(lecture_names(), ", ")));
    return parse_lecture(read_file(path), path);
}

}  // namespace pliant
