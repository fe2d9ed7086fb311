// Scalars that take both signs say so, so that their colours are the same ones from the first step to the last; and parameters
// stand in groups.
#include <pliant/document/scene_file.h>
#include <pliant/run/runner.h>
#include <pliant/text/texts.h>

#include "../every_lesson.h"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

using namespace pliant;
using namespace pliant::test;

namespace {

void look_at_signs(const Runner& runner) {
    for (const Field& f : runner.lesson().fields) {
        if (!f.in_use() || f.rank != Rank::scalar || f.both_signs) continue;
        const auto numbers = f.view();
        if (numbers.empty()) continue;
        const auto [least, greatest] = std::ranges::minmax(numbers);
        CAPTURE(f.name, least, greatest, runner.place().step);
        // Rounding, and what is 1 at rest and below 0 where a body is turned inside out, make no field one of both signs.
        const bool both = least < -1e-6 * std::abs(greatest) && greatest > 1e-6 * std::abs(least);
        CHECK((!both || f.name == "volume_ratio" || f.name == "cauchy_stretch"));
    }
}

}  // namespace

TEST_CASE("a field of one sign keeps it, in the first scene and in the presets", "[every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        std::vector<Runner::Assignments> scenes{{}};
        for (const std::string& name : preset_names(entry.info.id)) scenes.push_back(preset(entry, name).parameters);
        for (const auto& scene : scenes) {
            CAPTURE(entry.info.id, scene);
            Runner runner(entry, scene);
            look_at_signs(runner);
            try {
                for (int k = 0; k < 5; ++k) runner.step(), look_at_signs(runner);
            } catch (const Diverged&) {
            }
        }
    }
}

TEST_CASE("many parameters stand in several groups, and what the lesson opens with is in those that are open", "[every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        const auto lesson = entry.make();
        std::set<Group> all, open;
        for (const Parameter* p : lesson->parameters) all.insert(p->info.group);
        CAPTURE(entry.info.id);
        if (lesson->parameters.size() > 12) CHECK(all.size() >= 2);
        for (const Group g : lesson->first_groups()) open.insert(g);
        std::size_t members = 0;
        for (const Group g : all_groups) members += lesson->parameters_of(g).size();
        CHECK(members == lesson->parameters.size());
        for (const std::string_view key : lesson->map_knobs()) CHECK(open.contains(lesson->parameter(key).info.group));
    }
}
