// Pictures of known scenes against those in tests/shots/golden, which somebody has looked at. To renew them after a change that
// is meant to be seen, run this program with PLIANT_UPDATE_GOLDEN=1 in the environment, look at every picture, and commit them:
//   PLIANT_UPDATE_GOLDEN=1 build/release/tests/pliant_shots_tests "[golden]"
// Drivers and compilers may differ in the last digit: a picture may differ a little in a few pixels, and a scene with one
// parameter changed has to differ by more.
#include "../every_lesson.h"
#include "picture.h"

#include <catch2/catch_test_macros.hpp>

#include <cstdlib>

using namespace pliant;
using namespace pliant::test;

namespace {

constexpr int amount = 24;              // of 255, that a colour may be off
constexpr Real largest_part = 0.002;    // of the pixels, that may be off by more
constexpr Real smallest_change = 0.01;  // of the pixels, that a changed parameter must change

struct Golden {
    std::string name;
    Shot shot;
    std::string changed;  // a setting for the twin that must look different; a slide of a deck goes without its answer
    Shot twin() const {
        Shot other = shot;
        if (changed.empty()) other.picture.revealed = false;
        if (!changed.empty()) other.settings.push_back(changed);
        return other;
    }
};

std::vector<Golden> goldens() {
    PictureOptions small;
    small.size = "640x360";
    PictureOptions smaller;
    smaller.size = "560x315";
    PictureOptions projector = small;
    projector.theme = "projector";
    PictureOptions deck = projector;
    deck.size = "960x540", deck.layout = "deck", deck.slide = 1, deck.revealed = true;
    PictureOptions medium, large, full;
    medium.size = "720x405", large.size = "920x518", full.size = "960x540";
    PictureOptions bright = large;
    bright.theme = "projector";
    PictureOptions wide;
    wide.size = "1120x630";
    return {
        {"deformation_gradient", {"elasticity/deformation_gradient", {}, {}, medium}, "bend_curvature=0.9"},
        {"strain_measures", {"elasticity/strain_measures", {"turn=30"}, {}, large}, "F12=0.8"},
        {"stress_strain_disc", {"elasticity/stress_strain", {"resolution=2"}, {}, medium}, "radius=0.06"},
        {"stress_strain_cut", {"elasticity/stress_strain", {"scene=cut", "resolution=2"}, {}, medium}, "angle=60"},
        {"poisson", {"elasticity/poisson", {}, {}, medium}, "poisson_ratio=-0.4"},
        {"energy_density", {"elasticity/energy_density", {"path=shear"}, {}, medium}, "shear=0.8"},
        {"moduli_shear", {"elasticity/moduli", {"test=shear", "resolution=3"}, {}, small}, "poisson_ratio=-0.4"},
        {"moduli_projector", {"elasticity/moduli", {"test=tension", "resolution=3"}, {}, projector}, "length=0.1"},
        {"cloth", {"mesh/cloth", {"scene=drape", "nodes=13"}, 60, medium}, "k_bending=200"},
        {"cloth_flag", {"mesh/cloth", {"scene=flag", "nodes=13", "wind=8"}, 40, medium}, "wind=2"},
        {"integration", {"time/integration", {"time_step=0.15"}, 20, large}, "scheme=velocity_verlet"},
        {"integration_pendulum",
         {"time/integration", {"system=pendulum", "x0=6.8", "scheme=explicit_euler"}, 60, bright},
         "x0=6"},
        {"mass_spring", {"mesh/mass_spring", {"cells_x=2", "cells_y=2", "cells_z=2"}, 370, smaller}, "time_step=0.0012"},
        {"mass_spring_test",
         {"mesh/mass_spring",
          {"scene=stretch_test", "lattice=triangular", "test=bend", "target_poisson=0.3333", "cells_x=3", "cells_y=6"},
          {},
          medium},
         "k_bending=0"},
        {"mass_spring_chain",
         {"mesh/mass_spring", {"scene=swing", "cells_y=10", "mode_number=3", "k_bending=0", "damping_mode=none"}, 40, bright},
         "mode_number=2"},
        {"rod", {"mesh/rod", {"segments=20"}, {}, full}, "segments=8"},
        {"rod_pulse", {"mesh/rod", {"scene=free_end", "segments=40"}, 120, bright}, "axial_stiffness=12"},
        {"advection",
         {"fluids/advection", {"scheme=mac_cormack", "resolution=32", "cfl=6", "cell_x=10", "cell_y=23"}, 1, full},
         "back_trace=euler"},
        {"advection_schemes",
         {"fluids/advection", {"compare=true", "blob=slotted_disc", "radius=0.2", "resolution=48"}, 20, full},
         "blob=hill"},
        {"diffusion_row", {"fluids/diffusion", {}, 10, wide}, "diffusion_number=0.4"},
        {"diffusion_square",
         {"fluids/diffusion", {"dimension=2", "start=random", "resolution=16", "boundary=insulated", "cell_x=0"}, 5, wide},
         "seed=2"},
        {"navier_stokes", {"fluids/navier_stokes", {"resolution=32"}, 40, small}, "viscosity=0.002"},
        {"navier_stokes_cavity",
         {"fluids/navier_stokes", {"scene=cavity", "resolution=32", "aspect=0.6"}, 60, medium},
         "aspect=1"},
        {"navier_stokes_taylor_green",
         {"fluids/navier_stokes", {"scene=taylor_green", "resolution=32"}, 20, small},
         "resolution=8"},
        {"navier_stokes_poiseuille",
         {"fluids/navier_stokes", {"scene=poiseuille", "resolution=24", "viscosity=0.1", "body_force=0.8"}, 60, bright},
         "viscosity=0.001"},
        {"navier_stokes_couette",
         {"fluids/navier_stokes", {"scene=couette", "resolution=24", "viscosity=0.1"}, 20, large},
         "viscosity=0.005"},
        {"navier_stokes_karman", {"fluids/navier_stokes", {"scene=karman", "resolution=48"}, 300, medium}, "reynolds=40"},
        {"navier_stokes_smoke", {"fluids/navier_stokes", {"scene=smoke", "resolution=32"}, 80, bright}, "buoyancy=1"},
        {"projection", {"fluids/projection", {"resolution=16"}, {}, medium}, "field=jet"},
        {"projection_collocated",
         {"fluids/projection", {"grid=collocated", "boundary=periodic", "field=checkerboard", "resolution=8"}, {}, full},
         "grid=staggered"},
        {"free_surface", {"fluids/free_surface", {"resolution=40"}, 40, large}, "column_width=0.2"},
        {"free_surface_wave",
         {"fluids/free_surface", {"scene=wave", "resolution=32", "wave_height=0.04"}, 30, bright},
         "depth=0.2"},
        {"free_surface_paddle", {"fluids/free_surface", {"scene=paddle", "resolution=48"}, 60, medium}, "paddle_stroke=0.02"},
        {"navier_stokes_deck", {"fluids/navier_stokes", {}, {}, deck}, ""},
    };
}

fs::path golden_path(const std::string& name) { return fs::path(PLIANT_SOURCE_DIR) / "tests/shots/golden" / (name + ".png"); }

bool updating() {
    const char* wish = std::getenv("PLIANT_UPDATE_GOLDEN");
    return wish && std::string(wish) == "1";
}

}  // namespace

TEST_CASE("pictures of known scenes are as they were", "[shots][golden][every_lesson]") {
    for (const Golden& golden : goldens()) {
        if (!is_asked_for(golden.shot.lesson)) continue;
        CAPTURE(golden.name);
        if (updating()) take(golden.shot, golden_path(golden.name));
        const Image expected = viewer::read_png(golden_path(golden.name)), image = picture_of(golden.shot);
        const auto difference = viewer::compare(image, expected, amount);
        CAPTURE(difference.largest, difference.fraction_over);
        CHECK(difference.fraction_over <= largest_part);
    }
}

TEST_CASE("a changed parameter changes the picture", "[shots][golden][every_lesson]") {
    for (const Golden& golden : goldens()) {
        if (!is_asked_for(golden.shot.lesson)) continue;
        CAPTURE(golden.name, golden.changed);
        const auto difference = viewer::compare(picture_of(golden.twin()), viewer::read_png(golden_path(golden.name)), amount);
        CHECK(difference.fraction_over >= smallest_change);
    }
}

TEST_CASE("the golden pictures stay small", "[shots][golden]") {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(golden_path("x").parent_path())) {
        CAPTURE(entry.path().string());
        CHECK(entry.file_size() < 100000);
        ++count;
    }
    CHECK(count == goldens().size());
}
