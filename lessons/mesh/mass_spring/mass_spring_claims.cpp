// What the lectures say of mass-spring nets, measured.
#include <pliant/lesson/runner.h>
#include <pliant/lesson/until.h>
#include <pliant/solids/lattice_elasticity.h>
#include <pliant/study/claims_report.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace pliant::mass_spring {
namespace {

Real value(const Runner& runner, std::string_view probe) { return runner.value(runner.lesson().probe(probe)).value(); }

// ------------------------------------------------------------------------------------------------------------------- M7

struct Net {
    LatticeKind kind;
    FamilyStiffness stiffness;
    const char* name;
};

// Of a block of a given size, cut into n cells along each axis, in units of k and of its length.
Real modulus(const Net& net, Index n, Real scale, bool shared = false) {
    FamilyStiffness k = net.stiffness;
    for (Real& each : k) each *= scale;
    return test_block(SpringLattice(net.kind, {n, n, n}, 1 / Real(n)), k, BlockTest::stretch, shared).youngs_modulus;
}

Finding drift() {
    const std::array<Net, 4> nets{{{LatticeKind::cubic_face, {1, 1, 0}, "cubes with face diagonals"},
                                   {LatticeKind::cubic_body, {1, 1, 0}, "cubes with body diagonals"},
                                   {LatticeKind::square, {1, 0.5, 0}, "squares"},
                                   {LatticeKind::triangular, {1, 0, 0}, "triangles"}}};
    Real least = std::numeric_limits<Real>::infinity(), shared_off = 0;
    for (const Net& net : nets) {
        // The modulus of a sheet, per thickness, drifts by its edges alone.
        const Real change = std::abs(modulus(net, 4, 1) / modulus(net, 2, 1) - 1);
        least = std::min(least, change);
        const Real endless = lattice_constants(net.kind, net.stiffness, 0.25).youngs_modulus();
        shared_off = std::max(shared_off, std::abs(modulus(net, 4, 1, true) / endless - 1));
    }
    const Net &faces = nets[0], &bodies = nets[1];
    const Real e1 = modulus(faces, 1, 1), e2 = modulus(faces, 2, 1), e4 = modulus(faces, 4, 1);
    return {
        .figure = least,
        .verdict = least < 0.05 ? Verdict::refuted : Verdict::qualified,
        .text = fmt::format(
            "The same springs in a block of 1, 2 and 4 cells: E is {:.2f}, {:.2f} and {:.2f} k/L with face diagonals, "
            "{:.2f} k/L at 4 cells with body diagonals. In the net that changes least, the step from 2 to 4 cells "
            "still changes E by {:.0f} %.",
            e1, e2, e4, modulus(bodies, 4, 1), 100 * least),
        .condition = fmt::format(
            "with springs picked by hand. If k shrinks with the edge, as the energy of a solid asks, E becomes {:.2f}, {:.2f}, "
            "{:.2f} at 1, 2, 4 cells and tends to 2.5 with order one; with springs on the surface shared out it is exact at "
            "every size (off by {} at most) — but only for the Poisson ratio that the lattice has",
            modulus(faces, 1, 1), modulus(faces, 2, 0.5), modulus(faces, 4, 0.25), steady_figure(shared_off))};
}

const ClaimRegistration m7{
    {.id = "M7",
     .lesson = "mesh/mass_spring",
     .statement =
         "Mass–spring nets do not converge: their stiffness drifts with the resolution and with the topology of the net.",
     .source = "U, S, T: mass–spring systems, drawbacks",
     .experiment =
         "Young's modulus of one block, of four lattices of 2 and of 4 cells per edge with the same springs, by a static "
         "test between plates; once more with springs that follow from an energy.",
     .figure = "smallest change of E from 2 to 4 cells per edge",
     .criterion = "≥ 5 %",
     .question = "A block of springs is cut twice as fine, with the same spring stiffness. What does its Young's modulus do?",
     .answers = {"it converges to that of the material", "it grows, without an end", "it stays as it is", "it falls to half"},
     .right_answer = 1,
     .scene = {{"scene", "stretch_test"}, {"k_shear", "200"}, {"k_bending", "0"}},
     .expected = Verdict::qualified,
     .measure = drift}};

// ------------------------------------------------------------------------------------------------------------------- M9

struct Turned {
    Real momentum, energy;  // parts that are left
};

Turned turned(const char* damping_mode) {
    Runner runner(find_lesson("mesh/mass_spring"), {{"scene", "spin"}, {"damping_mode", damping_mode}, {"damping", "0.05"}});
    const Real momentum = value(runner, "angular_momentum"), energy = value(runner, "kinetic_energy");
    advance(runner, Until::after_time(0.5));
    return {value(runner, "angular_momentum") / momentum, value(runner, "kinetic_energy") / energy};
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

const ClaimRegistration m9{
    {.id = "M9",
     .lesson = "mesh/mass_spring",
     .statement = "Damping k_d (vⱼ − vᵢ) brakes a rigid rotation; projected onto the spring it does not.",
     .source = "S: mass–spring systems, damping",
     .experiment = "A block that spins freely for 0.5 s, with each damper: what is left of its angular momentum.",
     .figure = "|change| of the angular momentum with projected dampers, as a part of it",
     .criterion = "≤ 10⁻⁹, while naive dampers take more than half",
     .question = "A block spins freely in empty space; dampers act between its nodes. Who brakes its rotation?",
     .answers = {"neither damper: nothing outside acts", "the naive one", "the projected one", "both"},
     .right_answer = 1,
     .scene = {{"scene", "spin"}, {"damping_mode", "naive"}, {"damping", "0.01"}},
     .measure = rotation}};

// ------------------------------------------------------------------------------------------------------------------ M10

Finding coupling() {
    constexpr std::array<const char*, 3> tests{"stretch", "shear", "bend"},
        own{"coupling_structural", "coupling_shear", "coupling_bending"};
    std::array<Real, 3> foreign{};
    for (std::size_t t = 0; t < tests.size(); ++t) {
        Runner runner(find_lesson("mesh/mass_spring"), {{"scene", "stretch_test"}, {"test", tests[t]}});
        runner.step();
        foreign[t] = 1 - value(runner, own[t]);
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

const ClaimRegistration m10{
    {.id = "M10",
     .lesson = "mesh/mass_spring",
     .statement = "Structural, shear and bending springs cannot be tuned independently of each other.",
     .source = "S: mass–spring systems, cross-coupling",
     .experiment =
         "A block of all three families between two plates, pulled, sheared and bent: which family stores which part of "
         "the energy.",
     .figure = "largest part of a stiffness that another family than its own sets",
     .criterion = "≥ 0.25",
     .question = "You double the stiffness of the bending springs, and nothing else. What becomes stiffer?",
     .answers = {"bending alone", "bending and stretching", "nothing: they only work when bent", "bending and shear alone"},
     .right_answer = 1,
     .scene = {{"scene", "stretch_test"}, {"test", "bend"}},
     .measure = coupling}};

}  // namespace
}  // namespace pliant::mass_spring
