// The generated pages are those that the lessons declare now, and nothing is missing on them.
#include "../every_lesson.h"
#include "page_difference.h"

#include <pliant/math/error.h>
#include <pliant/study/lesson_page.h>
#include <pliant/text/file.h>
#include <pliant/text/source_code.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <filesystem>
#include <sstream>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string sources = PLIANT_SOURCE_DIR;

std::string file_name_of(const LessonEntry& entry) {
    std::string name(entry.info.id);
    std::ranges::replace(name, '/', '_');
    return name;
}

// The example of the developer guide has no page.
bool has_page(const LessonEntry& entry) { return entry.info.id != "time/bead_chain"; }

std::string part(const std::string& page, const std::string& heading) {
    const auto from = page.find("\n## " + heading + "\n");
    REQUIRE(from != std::string::npos);
    return page.substr(from + 1, page.find("\n## ", from + 1) - from);
}

}  // namespace

TEST_CASE("documentation: the page of every lesson is up to date; scripts/docs makes it again", "[every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        if (!has_page(entry)) continue;
        INFO(entry.info.id);
        const std::string page = read_file(fmt::format("{}/docs/lessons/{}.md", sources, file_name_of(entry)));
        CHECK(page_difference(page, lesson_markdown(entry, sources)) == "");
        CHECK(std::filesystem::exists(fmt::format("{}/docs/pictures/lessons/{}.png", sources, file_name_of(entry))));
    }
}

TEST_CASE("documentation: code in the guide stands in the files that it names, line by line") {
    std::istringstream guide(read_file(sources + "/docs/developer-guide.md"));
    std::string line, before, file;
    std::size_t found = 0, at = 0;
    bool inside = false;
    while (std::getline(guide, line)) {
        const auto blank = line.find_first_not_of(' ');
        if (line.starts_with("```")) {
            const auto link = before.rfind("](../lessons/");
            inside = !inside && line == "```cpp" && before.ends_with("):") && link != before.npos;
            if (inside) file = read_file(sources + "/" + before.substr(link + 5, before.size() - link - 7)), at = 0;
        } else if (inside && blank != line.npos && line.substr(blank) != "…") {
            INFO(before << ": " << line);
            at = file.find(line.substr(blank), at);
            REQUIRE(at != file.npos);
            ++found;
        }
        if (!inside && blank != line.npos) before = line;
    }
    CHECK(found >= 25);
}

TEST_CASE("documentation: a page tells why, shows formula and code of every stage, and what came out", "[every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        if (!has_page(entry)) continue;
        INFO(entry.info.id);
        const std::string page = lesson_markdown(entry, sources);
        CHECK(part(page, "Why").size() > 200);
        const std::string stages = part(page, "Stages");
        const auto lesson = entry.make();
        for (const Stage& s : lesson->stages) {
            INFO(s.name);
            const auto from = stages.find(fmt::format(". {}", s.name));
            REQUIRE(from != std::string::npos);
            const std::string stage = stages.substr(from, stages.find("\n### ", from) - from);
            CHECK_THAT(stage, ContainsSubstring("$$\n"));
            CHECK_THAT(stage, ContainsSubstring("Reads ") && ContainsSubstring("writes "));
        }
        CHECK_THAT(part(page, "Results"), ContainsSubstring("| measured |") && ContainsSubstring("pliant run"));
        CHECK_THAT(part(page, "Possibilities for extensions"), ContainsSubstring("pliant1:"));
    }
}

TEST_CASE("documentation: every stage names code that is there", "[every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        if (!has_page(entry)) continue;
        const auto lesson = entry.make();
        for (const Stage& s : lesson->stages) {
            INFO(entry.info.id << ": " << s.name);
            CHECK_FALSE(s.code.empty());
            for (const CodePlace& place : code_places(s.code))
                CHECK_NOTHROW(definition_in(read_file(sources + "/" + place.file), place.function, place.file));
        }
    }
}
