// The stability atlas of lessons whose limit is known in closed form.
#include "../every_lesson.h"

#include <pliant/study/stability_report.h>

#include <catch2/catch_test_macros.hpp>

using namespace pliant;
using namespace pliant::test;

namespace {

StabilityMap map_of(std::string_view lesson_name, std::string_view across, std::string_view up, Runner::Assignments settings) {
    const LessonEntry& entry = find_lesson(lesson_name);
    const auto lesson = entry.make();
    return make_stability_map(
        {.lesson = &entry, .settings = std::move(settings), .across = parse_knob(*lesson, across), .up = parse_knob(*lesson, up)},
        2);
}

// The first cell that contradicts theory, in words.
std::string contradiction(const StabilityMap& map) {
    for (Index j = 0; j < map.rows(); ++j)
        for (Index i = 0; i < map.columns(); ++i)
            if (contradicts_theory(map, i, j))
                return std::to_string(map.order.across.values[static_cast<std::size_t>(i)]) + ", " +
                       std::to_string(map.order.up.values[static_cast<std::size_t>(j)]) + ": " + map.at(i, j).verdict.reason;
    return "";
}

}  // namespace

TEST_CASE("the atlas agrees with theory to one cell for every scheme", "[atlas]") {
    const auto lesson = find_lesson("time/integration").make();
    for (const Option& scheme : lesson->parameter("scheme").info.options)
        for (const std::string up : {"omega=1:100:9:log", "damping_ratio=0:1.5:9"}) {
            INFO(scheme.key << " " << up);
            const StabilityMap map = map_of("time/integration", "time_step=2e-3:1:12:log", up,
                                            {{"scheme", std::string(scheme.key)},
                                             {up.starts_with("omega") ? "v0" : "omega", up.starts_with("omega") ? "0" : "10"}});
            REQUIRE(agreement(map));
            CHECK(agreement(map)->compared == 12 * 9);
            CHECK(contradiction(map).empty());
            INFO(contradiction(map));
            CHECK(agreement(map)->contradicts == 0);
        }
}

TEST_CASE("the map of diffusion agrees with the limit of its stencil in a row and in a square, in both forms", "[atlas]") {
    struct Case {
        const char *dimension, *form, *across;
        Real limit;
    };
    // As on the slide the limit is on νΔt: here Δx = 1 m.
    for (const auto& [dimension, form, across, limit] : {Case{"1", "careful", "diffusion_number=0.1:1:9", 0.5},
                                                         {"2", "careful", "diffusion_number=0.05:0.5:9", 0.25},
                                                         {"1", "lecture", "diffusion_number=0.05:0.5:9", 0.25},
                                                         {"2", "lecture", "diffusion_number=0.02:0.2:9", 0.125}}) {
        CAPTURE(dimension, form);
        const StabilityMap map = map_of("fluids/diffusion", across, "resolution=8:10:2",
                                        {{"start", "random"}, {"dimension", dimension}, {"form", form}, {"length", "8"}});
        REQUIRE(agreement(map));
        CHECK(agreement(map)->contradicts == 0);
        INFO(contradiction(map));
        CHECK(map.count(Stability::diverged) > 0);
        for (Index i = 0; i < map.columns(); ++i)
            CHECK(map.at(i, 0).predicted_stable() == (map.order.across.values[static_cast<std::size_t>(i)] <= limit));
        CHECK_FALSE(theory_bound(map).empty());
    }
    const StabilityMap implicit = map_of("fluids/diffusion", "diffusion_number=1:100:3:log", "resolution=8:10:2",
                                         {{"start", "random"}, {"scheme", "implicit"}});
    CHECK(implicit.count(Stability::diverged) == 0);
    CHECK(implicit.at(2, 0).theory == 0);
}

TEST_CASE("every lesson that steps in time can be mapped", "[atlas][every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        const auto lesson = entry.make();
        if (lesson->time_step() == 0) continue;
        INFO(entry.info.id);
        const auto [across, up] = first_knobs(*lesson);
        CHECK(across != up);
        CHECK(can_be_knob(*across));
        for (const Parameter* p : {across, up}) {
            const Knob knob = useful_knob(*p, 5);
            CHECK(knob.values.size() >= 2);
            CHECK(text_of(*lesson, parse_knob(*lesson, text_of(*lesson, knob))) == text_of(*lesson, knob));
        }
    }
}

TEST_CASE("a map shows coarse cells first, in place of those that are not run yet, and ends as the whole", "[atlas]") {
    const LessonEntry& entry = find_lesson("time/integration");
    const auto lesson = entry.make();
    const MapOrder order{.lesson = &entry,
                         .settings = {{"scheme", "semi_implicit_euler"}, {"omega", "10"}},
                         .across = parse_knob(*lesson, "time_step=1e-2:1:13:log"),
                         .up = parse_knob(*lesson, "damping_ratio=0:1.5:12")};
    MapSoFar so_far;
    std::vector<StabilityMap> seen;
    Index first = 0;
    const auto look = [&](Index done, Index) {
        CHECK(so_far.done() == done);
        auto map = so_far.map(order);
        if (!map) return;
        if (first == 0) first = done;
        if (done % 10 == 0) seen.push_back(std::move(*map));
    };
    const StabilityMap whole = make_stability_map(order, 1, look, {}, &so_far);
    // Four cells apart: four columns and three rows of them.
    CHECK(first == 12);
    REQUIRE(seen.size() > 5);
    for (const StabilityMap& map : seen) {
        CHECK_FALSE(map.complete);
        REQUIRE(map.cells.size() == whole.cells.size());
        for (Index j = 0; j < map.rows(); j += 4)
            for (Index i = 0; i < map.columns(); i += 4) CHECK(map.at(i, j).verdict.reason == whole.at(i, j).verdict.reason);
    }
    const auto at_last = so_far.map(order);
    REQUIRE(at_last);
    for (std::size_t k = 0; k < whole.cells.size(); ++k) CHECK(at_last->cells[k].verdict.reason == whole.cells[k].verdict.reason);
    // The order of the cells is nothing that the map depends on.
    CHECK(map_csv(make_stability_map(order, 2)) == map_csv(whole));
}
