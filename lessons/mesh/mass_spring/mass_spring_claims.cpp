// What the lectures say of mass-spring nets, measured.
#include <pliant/run/runner.h>
#include <pliant/run/until.h>
#include <pliant/solids/lattice_elasticity.h>
#include <pliant/study/claims_report.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace pliant::mass_spring {
namespace {

// ------------------------------------------------------------------------------------------------------------------- M7

struct Net {
    LatticeKind kind;
    FamilyStiffness stiffness;
};

// A net drifts when its stiffness grows by more than this from 4 to 8 cells, and settles when each change is at most this part of
// the one before it; an error of first order leaves a half.
constexpr Real drifting = 1.5, settling = 0.6;

// Of a block of a given size, cut into n cells along each axis: Young's modulus, in units of k over the size; of a sheet E times
// its thickness, in units of k.
Real modulus(const Net& net, Index n) {
    return test_block(SpringLattice(net.kind, {n, n, n}, 1 / Real(n)), net.stiffness, BlockTest::stretch).youngs_modulus;
}

// How many times as stiff a net becomes when it is cut twice as fine, from 4 to 8 cells per edge, with the same springs.
Real doubled(const Net& net) { return modulus(net, 8) / modulus(net, 4); }

// What is left of the last change of the modulus when the cells are halved once more: below 1 the net converges.
Real change_left(const Net& net) {
    const Real coarse = modulus(net, 8), middle = modulus(net, 16), fine = modulus(net, 32);
    return (fine - middle) / (middle - coarse);
}

// Stiffness of a block over that of the solid which its lattice makes when it goes on without end, with k that shrinks with the
// edge.
Real over_solid(const char* test, Index n) {
    const std::string cells = std::to_string(n), k = fmt::format("{}", 800 / Real(n));
    Runner runner(find_lesson("mesh/mass_spring"), {{"scene", "stretch_test"},
                                                    {"test", test},
                                                    {"cells_x", cells},
                                                    {"cells_y", cells},
                                                    {"cells_z", cells},
                                                    {"k_structural", k},
                                                    {"k_shear", k},
                                                    {"k_bending", "0"}});
    runner.step();
    return runner.value("stiffness_ratio");
}

// Of these ratios at 2, 4 and 8 cells: do both halvings bring them nearer to 1, by a third at least?
bool tends_to_one(const std::array<Real, 3>& ratio) {
    return ratio[2] > 1 && ratio[1] - 1 < (ratio[0] - 1) / 1.5 && ratio[2] - 1 < (ratio[1] - 1) / 1.5;
}

Finding drift() {
    const Net faces{LatticeKind::cubic_face, {1, 1, 0}}, bodies{LatticeKind::cubic_body, {1, 1, 0}},
        squares{LatticeKind::square, {1, 0.5, 0}}, triangles{LatticeKind::triangular, {1, 0, 0}};
    const Real growth = std::min(doubled(faces), doubled(bodies));
    const std::array<Real, 2> left{change_left(squares), change_left(triangles)};
    const Real square = modulus(squares, 32), triangle = modulus(triangles, 32);
    std::array<Real, 3> stretched{}, bent{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Index n = Index{2} << k;
        stretched[k] = over_solid("stretch", n), bent[k] = over_solid("bend", n);
    }
    const bool drifts = growth > drifting;
    const bool sheets_settle = left[0] > 0 && left[0] < settling && left[1] > 0 && left[1] < settling;
    return {
        .figure = growth,
        .verdict = !drifts                                                          ? Verdict::refuted
                   : sheets_settle && tends_to_one(stretched) && tends_to_one(bent) ? Verdict::qualified
                                                                                    : Verdict::reproduced,
        .text = fmt::format(
            "The same springs in a block of 1, 2, 4 and 8 cells: E is {:.2f}, {:.2f}, {:.2f} and {:.2f} k/L with face diagonals, "
            "and {:.2f} k/L at 8 cells with body diagonals. From 4 to 8 cells it grows {:.2f}-fold at least: there is no limit.",
            modulus(faces, 1), modulus(faces, 2), modulus(faces, 4), modulus(faces, 8), modulus(bodies, 8), growth),
        .condition =
            fmt::format("of nets in space, with a k that is picked by hand and kept. Sheets do converge with it: from 16 to 32 "
                        "cells their E times thickness changes {:.2f} and {:.2f} times as much as from 8 to 16, and tends to a "
                        "number of the topology ({:.2f} k at 32 cells for squares, {:.2f} k for triangles). In space k has to "
                        "shrink with the edge: then at 2, 4 and 8 cells a block pulled is {:.2f}, {:.2f}, {:.2f} times as stiff "
                        "as the solid, and bent {:.2f}, {:.2f}, {:.2f} times",
                        left[0], left[1], square, triangle, stretched[0], stretched[1], stretched[2], bent[0], bent[1], bent[2])};
}

const ClaimRegistration m7{"M7", drift};

// ------------------------------------------------------------------------------------------------------------------- M9

struct Turned {
    Real momentum, energy;  // parts that are left
};

Turned turned(const char* damping_mode) {
    Runner runner(find_lesson("mesh/mass_spring"), {{"scene", "spin"}, {"damping_mode", damping_mode}, {"damping", "0.05"}});
    const Real momentum = runner.value("angular_momentum"), energy = runner.value("kinetic_energy");
    advance(runner, Until::after_time(0.5));
    return {runner.value("angular_momentum") / momentum, runner.value("kinetic_energy") / energy};
}

Finding rotation() {
    const Turned naive = turned("naive"), projected = turned("projected");
    const Real off = std::abs(projected.momentum - 1);
    return {.figure = off,
            .verdict = off <= 1e-9 && naive.momentum < 0.5 ? Verdict::reproduced : Verdict::refuted,
            .text = fmt::format(
                "After 0.5 s of spinning freely at 10 rad/s the naive dampers have left {:.2g} % of the angular momentum "
                "and {:.2g} % of the kinetic energy; the projected ones all of the momentum, off by {}, and {:.1f} % of "
                "the energy, the rest of which went into the vibration of the start.",
                100 * naive.momentum, 100 * naive.energy, steady_figure(off), 100 * projected.energy)};
}

const ClaimRegistration m9{"M9", rotation};

// ------------------------------------------------------------------------------------------------------------------ M10

Finding coupling() {
    constexpr std::array<const char*, 3> tests{"stretch", "shear", "bend"},
        own{"coupling_structural", "coupling_shear", "coupling_bending"};
    std::array<Real, 3> foreign{};
    for (std::size_t t = 0; t < tests.size(); ++t) {
        Runner runner(find_lesson("mesh/mass_spring"), {{"scene", "stretch_test"}, {"test", tests[t]}});
        runner.step();
        foreign[t] = 1 - runner.value(own[t]);
    }
    const Real most = *std::ranges::max_element(foreign);
    return {.figure = most,
            .verdict = most >= 0.25 ? Verdict::reproduced : Verdict::refuted,
            .text = fmt::format(
                "Of the stiffness against stretching {:.0f} % comes from other springs than the structural ones, against "
                "shear {:.0f} % from others than the diagonals, against bending {:.0f} % from others than the bending "
                "springs: these are the parts of the energy, and so ∂ ln K/∂ ln k.",
                100 * foreign[0], 100 * foreign[1], 100 * foreign[2])};
}

const ClaimRegistration m10{"M10", coupling};

}  // namespace
}  // namespace pliant::mass_spring
