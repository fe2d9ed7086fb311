// The scenes of the lesson: what the fluid is in, how it starts and what drives it. One entry of the table each; to add one, add
// its entry.
#pragma once
#include <pliant/fluids/staggered_grid.h>
#include <pliant/lesson/parameter.h>

#include <span>
#include <string_view>
#include <vector>

namespace pliant::navier_stokes {

// What a scene takes from the parameters.
struct SceneSettings {
    Index resolution;        // cells along the length L
    Real size;               // L, m
    Real aspect;             // height over width, where the scene leaves it open
    Real lid_speed, inflow;  // m/s
};

// What drives the fluid; each brings its own parameters, marks in the picture and readings.
struct Drives {
    bool stirrer = false;     // a jet on its way around a figure of eight
    bool lid = false;         // the upper wall moves along itself
    bool inflow = false;      // fluid enters through the left wall and leaves through the right one, at one speed
    bool body_force = false;  // an acceleration along x
    bool smoke = false;       // carried along, and lifted by its warmth

    // Is there a force in it?
    bool by_force() const { return stirrer || body_force || smoke; }
};

// What is measured.
struct Readings {
    bool centre_lines = false;  // the velocity on the lines through the middle
    bool profile = false;       // across a channel, against its closed form
    bool decay = false;         // of the energy, against its closed form
    bool wake = false;          // the rhythm of the vortices
};

struct FlowScene {
    std::string_view key, label;
    Real width = 1, height = 1;  // of the domain, in L
    bool any_aspect = false;     // the height is `aspect` times the width instead
    std::array<bool, 2> periodic{};
    Slip slip = Slip::free;    // at the walls
    Real obstacle = 0;         // diameter of a disc in the way, in L; none for 0
    Real reynolds_length = 0;  // L_Re in L, where the Reynolds number U L_Re/ν sets the viscosity; 0 where the viscosity is given
    Drives drives{};
    Readings readings{};
    Real arrow_speed = 1;      // m/s, or of the lid's or the inflow's speed, of an arrow that is as long as arrows are apart
    std::string_view colours;  // the field that the picture shows at first,
    int component = -1;        // and of a vector which component
    std::vector<std::string_view> plots, key_numbers;
    void (*start)(const StaggeredGrid<2>&, const SceneSettings&, FaceField<2>&) = nullptr;  // at rest for none
};

std::span<const FlowScene> scenes();
std::vector<Option> scene_options();

// Cells along both axes. The height is rounded to whole cells, at least one.
Counts<2> cells_of(const FlowScene& scene, const SceneSettings& settings);
// The grid of a scene. Its cells are squares of L/resolution.
StaggeredGridInfo<2> domain(const FlowScene& scene, const SceneSettings& settings);

// The middle of the disc, in L: a little below the middle of the channel, so that the wake does not stay symmetric.
Vec<2> obstacle_centre(const FlowScene& scene);

// Where smoke is made, in L: a disc at the floor.
struct SmokeSource {
    Vec<2> centre;
    Real radius;
};
SmokeSource smoke_source();

}  // namespace pliant::navier_stokes
