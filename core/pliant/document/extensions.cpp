#include <pliant/document/extensions.h>
#include <pliant/document/share.h>
#include <pliant/document/walkthrough_words.h>
#include <pliant/text/texts.h>

#include <fmt/format.h>

#include <algorithm>

namespace pliant {
namespace {

// The lines of a scene block, checked against the lesson.
class SceneBlockReader {
public:
    SceneBlockReader(const LessonEntry& entry, std::string_view path) : entry_(entry), path_(path) {}

    SceneFile read(const Block& block) const {
        SceneFile scene{.lesson = std::string(entry_.info.id), .parameters = {}};
        int number = block.first_line;
        for (const std::string& line : block.lines) take(scene, words_of_line("set " + line), number++);
        return scene;
    }
    [[noreturn]] void refuse(int line, const std::string& what) const {
        throw Refused(fmt::format("{}:{}: {}", path_, line, what));
    }

private:
    void take(SceneFile& scene, const std::vector<std::string>& words, int line) const try {
        if (words.size() == 3 && words[1] == "show") {
            scene.view.emplace().field = entry_.make()->field(words[2]).name;
            return;
        }
        const auto more = assignments_of(words);
        scene.parameters.insert(scene.parameters.end(), more.begin(), more.end());
        Runner(entry_, scene.parameters, 0);
    } catch (const Refused& e) {
        refuse(line, e.what());
    }

    const LessonEntry& entry_;
    std::string_view path_;
};

}  // namespace

std::vector<Extension> parse_extensions(const LessonEntry& entry, std::string_view text, std::string_view path) {
    const SceneBlockReader reader(entry, path);
    Walkthrough all = parse_walkthrough(text, path, ExtraBlock::scene);
    std::vector<Extension> extensions;
    for (Slide& slide : all.slides) {
        const auto scene = std::ranges::find(slide.blocks, BlockKind::scene, &Block::kind);
        if (scene == slide.blocks.end())
            throw Refused(fmt::format("{}: '{}' lacks a ```scene block with the parameters to start from", path, slide.title));
        Extension e{.scene = reader.read(*scene),
                    .walkthrough = {.path = all.path, .title = all.title, .introduction = {}, .slides = {}}};
        e.walkthrough.slides.push_back(std::move(slide));
        extensions.push_back(std::move(e));
    }
    return extensions;
}

std::vector<Extension> extensions_of(const LessonEntry& entry) {
    const std::string path = fmt::format("{}/extensions.md", entry.info.id);
    const std::string_view text = find_text(path);
    return text.empty() ? std::vector<Extension>() : parse_extensions(entry, text, path);
}

std::vector<ExpectationResult> played(const LessonEntry& entry, const Extension& extension) {
    const SceneFile opened = read_share(share_text(extension.scene));
    Runner runner(entry, opened.parameters);
    WalkthroughPlayer player(runner, extension.walkthrough);
    player.next();
    return player.results();
}

}  // namespace pliant
