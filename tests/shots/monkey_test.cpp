// A monkey at the lab: random keys, clicks, drags, typed numbers and changes of layout, a frame for each. Whatever it does,
// nothing may be thrown, no number shown may be other than finite or undefined, no frame may wait for more passes of the run than
// it has room for, and the lab can be reset.
//   PLIANT_MONKEY_SEED=7 PLIANT_MONKEY_INPUTS=10000 build/release/tests/pliant_shots_tests "[monkey]"
#include "monkey.h"
#include "../every_lesson.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <cstdlib>

using namespace pliant;
using namespace pliant::test;

namespace {

long from_environment(const char* name, long otherwise) {
    const char* text = std::getenv(name);
    return text ? std::strtol(text, nullptr, 10) : otherwise;
}

void play(const LessonEntry& entry, long inputs) {
    const auto seed = static_cast<unsigned>(from_environment("PLIANT_MONKEY_SEED", 1));
    Monkey monkey(entry.info.id, seed);
    for (long i = 0; i < from_environment("PLIANT_MONKEY_INPUTS", inputs); ++i) {
        const std::string wrong = monkey.play();
        if (!wrong.empty()) FAIL(monkey.report(wrong));
    }
    const std::string wrong = monkey.reset();
    if (!wrong.empty()) FAIL(monkey.report(wrong));
    SUCCEED();
}

}  // namespace

TEST_CASE("nothing that a monkey does breaks the lab", "[monkey][every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        CAPTURE(entry.info.id);
        play(entry, 250);
    }
}
