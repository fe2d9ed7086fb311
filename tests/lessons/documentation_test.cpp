// The generated pages are those that the lessons declare now.
#include "../every_lesson.h"

#include <fmt/format.h>
#include <pliant/study/lesson_page.h>
#include <pliant/text/file.h>

#include <catch2/catch_test_macros.hpp>

using namespace pliant;
using namespace pliant::test;

TEST_CASE("documentation: the page of every lesson is up to date; scripts/docs makes it again", "[every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        if (entry.info.id == "time/bead_chain") continue;  // the example of the developer guide
        INFO(entry.info.id);
        std::string name(entry.info.id);
        std::ranges::replace(name, '/', '_');
        const std::string page = read_file(fmt::format("{}/docs/lessons/{}.md", PLIANT_SOURCE_DIR, name));
        CHECK(page == lesson_markdown(entry));
    }
}
