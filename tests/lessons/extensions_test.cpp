// Possibilities for extensions: at least two for each lesson, complete, and with the answers that their share strings give.
#include "../every_lesson.h"

#include <pliant/document/extensions.h>
#include <pliant/document/share.h>
#include <pliant/document/unused.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <string>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string rod = "mesh/rod";

std::vector<Extension> parsed(const std::string& blocks) {
    return parse_extensions(find_lesson(rod), "# T\n## One\n" + blocks, "e.md");
}

void check_refused(const std::string& blocks, const std::string& place, const std::string& what) {
    INFO(blocks);
    CHECK_THROWS_WITH(parsed(blocks), ContainsSubstring(place) && ContainsSubstring(what));
}

}  // namespace

TEST_CASE("extensions: every lesson has two, and each is met from its share string", "[every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        if (entry.info.id == "time/bead_chain") continue;
        const auto extensions = extensions_of(entry);
        INFO(entry.info.id);
        CHECK(extensions.size() >= 2);
        for (const Extension& e : extensions) {
            INFO(e.slide().title);
            for (const BlockKind kind :
                 {BlockKind::text, BlockKind::ask, BlockKind::actions, BlockKind::expect, BlockKind::answer})
                CHECK(e.slide().has(kind));
            CHECK(unused_settings(e.scene).empty());
            const auto results = played(entry, e);
            CHECK_FALSE(results.empty());
            for (const ExpectationResult& r : results) {
                INFO(e.walkthrough.path << ":" << r.line << ": " << r.text << " (" << r.measured << ")");
                CHECK(r.met);
            }
        }
    }
}

TEST_CASE("extensions: a scene is opened as it is written, and each starts anew") {
    const auto list = parsed(
        "```scene\nsegments=4 length=2\nshow strain\n```\n```do\nset segments=8\nrun rest\n```\n```expect\nsegments = 8 within "
        "0\n```\n"
        "## Two\n```scene\nmass=3\n```\n```do\nrun rest\n```\n```expect\nsegments = 10 within 0\nmass = 4 within 0.1\n```\n");
    REQUIRE(list.size() == 2);
    const SceneFile opened = read_share(share_text(list[0].scene));
    CHECK(opened.lesson == rod);
    CHECK(opened.parameters.size() == 2);
    const Runner runner(find_lesson(rod), opened.parameters, 0);
    CHECK(runner.lesson().parameter("segments").value() == 4);
    CHECK(runner.lesson().parameter("length").value() == 2);
    CHECK(opened.view->field == "strain");
    CHECK(played(find_lesson(rod), list[0]).at(0).met);
    const auto second = played(find_lesson(rod), list[1]);
    REQUIRE(second.size() == 2);
    CHECK(second[0].met);
    CHECK_FALSE(second[1].met);
    CHECK(second[1].line == 23);
}

TEST_CASE("extensions: a scene that the lesson refuses is told with file and line") {
    check_refused("```do\nrun rest\n```\n", "e.md", "lacks a ```scene block");
    check_refused("```scene\nmass=1\nmas=3\n```\n", "e.md:5", "'mas'");
    check_refused("```scene\nmass=-3\n```\n", "e.md:4", "mass");
    check_refused("```scene\nmass\n```\n", "e.md:4", "KEY=VALUE");
    check_refused("```scene\nshow stran\n```\n", "e.md:4", "'stran'");
    CHECK_THROWS_WITH(parse_walkthrough("## One\n```scene\nmass=1\n```\n", "w.md"), ContainsSubstring("unknown block 'scene'"));
    CHECK(parsed("```scene\n```\n").at(0).scene.parameters.empty());
}
