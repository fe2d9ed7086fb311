#include "scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::navier_stokes {
namespace {

using std::numbers::pi;

// u = sin 2πx cos 2πy, v = −cos 2πx sin 2πy, in m/s and with lengths in L [Taylor1923].
void start_vortices(const StaggeredGrid<2>& grid, const SceneSettings& settings, FaceField<2>& velocity) {
    for (int axis = 0; axis < 2; ++axis) {
        const Lattice<2>& faces = grid.faces(axis);
        for (Index f = 0; f < faces.size(); ++f) {
            const GridPlace<2> at = faces.place(faces.coordinates(f));
            const Real x = 2 * pi * at[0] * grid.dx() / settings.size, y = 2 * pi * at[1] * grid.dx() / settings.size;
            velocity[axis][f] = axis == 0 ? std::sin(x) * std::cos(y) : -std::cos(x) * std::sin(y);
        }
    }
}

void start_stream(const StaggeredGrid<2>&, const SceneSettings& settings, FaceField<2>& velocity) {
    velocity[0].setConstant(settings.inflow);
}

std::vector<FlowScene> make_scenes() {
    return {
        {.key = "box",
         .label = "stirred box",
         .any_aspect = true,
         .drives = {.stirrer = true},
         .readings = {.centre_lines = true},
         .arrow_speed = 0.7,
         .colours = "vorticity",
         .plots = {"kinetic_energy", "max_divergence", "cfl"},
         .key_numbers = {"kinetic_energy", "max_divergence", "cfl"}},
        {.key = "cavity",
         .label = "lid-driven cavity",
         .any_aspect = true,
         .slip = Slip::none,
         .reynolds_length = 1,
         .drives = {.lid = true},
         .readings = {.centre_lines = true},
         .arrow_speed = 0.4,
         .colours = "speed",
         .plots = {"u_center", "v_center", "kinetic_energy"},
         .key_numbers = {"reynolds_number", "kinetic_energy", "max_divergence"}},
        {.key = "taylor_green",
         .label = "Taylor–Green vortices",
         .periodic = {true, true},
         .readings = {.decay = true},
         .colours = "vorticity",
         .plots = {"kinetic_energy", "effective_viscosity", "max_divergence"},
         .key_numbers = {"kinetic_energy", "effective_viscosity", "max_divergence"},
         .start = start_vortices},
        {.key = "poiseuille",
         .label = "Poiseuille: pushed through a channel",
         .periodic = {true, false},
         .slip = Slip::none,
         .drives = {.body_force = true},
         .readings = {.profile = true},
         .colours = "speed",
         .plots = {"profile", "kinetic_energy", "profile_difference"},
         .key_numbers = {"kinetic_energy", "profile_difference", "cfl"}},
        {.key = "couette",
         .label = "Couette: dragged by a wall",
         .periodic = {true, false},
         .slip = Slip::none,
         .drives = {.lid = true},
         .readings = {.profile = true},
         .arrow_speed = 0.7,
         .colours = "speed",
         .plots = {"profile", "kinetic_energy", "profile_difference"},
         .key_numbers = {"kinetic_energy", "profile_difference", "cfl"}},
        {.key = "karman",
         .label = "Kármán vortex street",
         .width = 2,
         .height = 0.75,
         .obstacle = 0.15,
         .reynolds_length = 0.15,
         .drives = {.inflow = true},
         .readings = {.wake = true},
         .arrow_speed = 1.2,
         .colours = "velocity",
         .component = 1,
         .plots = {"wake_velocity", "strouhal", "max_divergence"},
         .key_numbers = {"reynolds_number", "strouhal", "max_divergence"},
         .start = start_stream},
        {.key = "smoke",
         .label = "rising smoke",
         .any_aspect = true,
         .drives = {.smoke = true},
         .arrow_speed = 0.7,
         .colours = "smoke",
         .plots = {"smoke_volume", "kinetic_energy", "max_divergence"},
         .key_numbers = {"smoke_volume", "kinetic_energy", "max_divergence"}},
    };
}

void add_obstacle(const FlowScene& scene, const SceneSettings& settings, StaggeredGridInfo<2>& info) {
    const Vec<2> centre = obstacle_centre(scene);
    const Real cells = static_cast<Real>(settings.resolution), radius = scene.obstacle / 2;
    for (Index j = 0; j < info.cells[1]; ++j)
        for (Index i = 0; i < info.cells[0]; ++i) {
            const Vec<2> place((static_cast<Real>(i) + 0.5) / cells, (static_cast<Real>(j) + 0.5) / cells);
            info.types.push_back((place - centre).norm() < radius ? CellType::solid : CellType::fluid);
        }
}

}  // namespace

std::span<const FlowScene> scenes() {
    static const std::vector<FlowScene> table = make_scenes();
    return table;
}

std::vector<Option> scene_options() {
    std::vector<Option> options;
    for (const FlowScene& s : scenes()) options.push_back({s.key, s.label});
    return options;
}

Vec<2> obstacle_centre(const FlowScene& scene) { return {0.45, 0.47 * scene.height}; }

SmokeSource smoke_source() { return {{0.5, 0.1}, 0.07}; }

Counts<2> cells_of(const FlowScene& scene, const SceneSettings& settings) {
    const Real height = scene.any_aspect ? settings.aspect * scene.width : scene.height;
    const auto cells = [&](Real length) {
        return std::max<Index>(1, std::lround(length * static_cast<Real>(settings.resolution)));
    };
    return {cells(scene.width), cells(height)};
}

StaggeredGridInfo<2> domain(const FlowScene& scene, const SceneSettings& settings) {
    StaggeredGridInfo<2> info;
    info.cells = cells_of(scene, settings);
    info.dx = settings.size / static_cast<Real>(settings.resolution);
    info.periodic = scene.periodic;
    for (auto& axis : info.walls)
        for (Wall<2>& wall : axis) wall.slip = scene.slip;
    if (scene.drives.lid) info.walls[1][1].velocity = {settings.lid_speed, 0};
    if (scene.drives.inflow)
        for (Wall<2>& wall : info.walls[0]) wall.velocity = {settings.inflow, 0};
    if (scene.obstacle > 0) add_obstacle(scene, settings, info);
    return info;
}

}  // namespace pliant::navier_stokes
