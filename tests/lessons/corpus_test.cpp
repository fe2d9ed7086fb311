// The inputs that the fuzzers start from, and those that they have found, under the same functions.
#include "../fuzz/targets.h"

#include <pliant/text/file.h>
#include <catch2/catch_test_macros.hpp>

#include <filesystem>

using namespace pliant;

namespace {

// A file whose name begins with "refused_" is refused; every other one is accepted, but for those that the fuzzer found.
void replay(const std::string& reader, bool (*accepts)(std::string_view)) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(PLIANT_SOURCE_DIR "/tests/fuzz/corpus/" + reader)) {
        const std::string name = entry.path().filename().string();
        INFO(reader << "/" << name);
        bool accepted = false;
        REQUIRE_NOTHROW(accepted = accepts(read_file(entry.path().string())));
        if (!name.starts_with("found_")) CHECK(accepted != name.starts_with("refused_"));
        ++count;
    }
    CHECK(count >= 8);
}

}  // namespace

TEST_CASE("corpus: scene files") { replay("scene_file", test::fuzz_scene_file); }
TEST_CASE("corpus: share strings") { replay("share_string", test::fuzz_share_string); }
TEST_CASE("corpus: formulas") { replay("formula", test::fuzz_formula); }
TEST_CASE("corpus: mesh files") { replay("mesh_file", test::fuzz_mesh_file); }
TEST_CASE("corpus: lectures") { replay("lecture", test::fuzz_lecture); }
TEST_CASE("corpus: walkthroughs") { replay("walkthrough", test::fuzz_walkthrough); }
