// F5: what the lectures say of free surfaces and of solids, measured.
#include <pliant/document/scene_file.h>
#include <pliant/fluids/liquid.h>
#include <pliant/run/runner.h>
#include <pliant/study/claims.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::free_surface {
namespace {

constexpr Real g = 9.81;
constexpr Real U = 0.3;  // of the plate, m/s
// In column widths, at t √(2g/a) = 2: what was filmed behind a gate that takes time to open [MartinMoyce1952, figure 3], and a
// volume-of-fluid solution that slides along walls.
constexpr Real filmed_front = 2.29, volume_of_fluid_front = 2.66;

Runner run(const char* preset_name, const Runner::Assignments& more, Index steps) {
    const LessonEntry& entry = find_lesson("fluids/free_surface");
    Runner::Assignments parameters = preset(entry, preset_name).parameters;
    parameters.insert(parameters.end(), more.begin(), more.end());
    Runner runner(entry, parameters);
    for (Index k = 0; k < steps; ++k) runner.step();
    return runner;
}

struct AtSolid {
    Real across = 0, along = 0;  // largest difference from the body's velocity, m/s
};
// Water pushed by a plate that moves at 0.3 m/s.
AtSolid beside_a_plate() {
    StaggeredGridInfo<2> tank;
    tank.cells = {40, 20};
    tank.dx = 0.05;
    tank.solid_velocity = [](const Vec<2>&) { return Vec<2>(U, 0); };
    tank.types.assign(800, CellType::fluid);
    for (Index j = 0; j < 20; ++j)
        for (Index i = 8; i < 10; ++i) tank.types[static_cast<std::size_t>(i + 40 * j)] = CellType::solid;
    Liquid<2> water(std::move(tank), {.projection = {1e-10, 300}});
    water.fill([](const Vec<2>& x) { return x[1] - 0.5; });
    water.step({0, -g}, 0.01);
    AtSolid found;
    for (Index j = 0; j < 9; ++j) {
        for (const Index face : {8, 10})
            found.across = std::max(found.across, std::abs(water.velocity()[0][water.grid().faces(0).index({face, j})] - U));
        for (const Index cell : {7, 10})
            found.along = std::max(found.along, std::abs(water.velocity()[1][water.grid().faces(1).index({cell, j})]));
    }
    return found;
}

Finding surfaces_and_solids() {
    const Real a = 0.05715;
    const Runner falls = run("dam_break", {}, 54), coarse = run("dam_break", {{"resolution", "48"}}, 54),
                 stands = run("mould", {}, 50);
    const Real front = falls.value("front_position") / a;
    // What twice the cells still change is the margin that the front has.
    const Real margin = std::abs(front - coarse.value("front_position") / a);
    const Real held = std::abs(stands.value("front_position") - 0.25);
    const Runner still = run("still_water", {{"column_height", "0.325"}}, 1),
                 off = run("still_water", {{"column_height", "0.325"}, {"surface_condition", "at_cell_centre"}}, 1);
    const Real right = std::abs(still.value("pressure_offset")), wrong = off.value("pressure_offset");
    const AtSolid solid = beside_a_plate();
    const bool so = front > filmed_front && std::abs(front - volume_of_fluid_front) < margin && margin < 0.1 && held < 2e-3 &&
                    right < 1e-4 && solid.across < 1e-12 && solid.along > 0.01;
    return {.figure = front,
            .verdict = so ? Verdict::reproduced : Verdict::refuted,
            .text = fmt::format(
                "With p = 0 on the surface the front of a column is {:.2f} column widths from the wall at t √(2g/a) = 2, {:.2f} "
                "farther than on cells twice as wide ({:.2f} were filmed behind a gate, {:.2f} follow from a volume-of-fluid "
                "method); with u·n = 0 there it stays where it is, to {:.1g} mm. In still water p is g times the depth to {:.0e} "
                "m²/s²; with p = 0 in the cell of air it is {:.3f} m²/s² off, which is g Δx/2. At a plate that moves, u·n "
                "differs from the plate's by {:.0g} m/s, and along it the water moves at up to {:.2f} m/s.",
                front, margin, filmed_front, volume_of_fluid_front, 1e3 * held, std::max(right, 1e-9), wrong, solid.across,
                solid.along)};
}

const ClaimRegistration f5{"F5", surfaces_and_solids};

}  // namespace
}  // namespace pliant::free_surface
