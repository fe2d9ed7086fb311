// E1 and E2: what the lectures say of stress and strain, measured on bodies of finite elements.
#include <pliant/continuum/deformation.h>
#include <pliant/run/runner.h>
#include <pliant/study/claims.h>
#include <pliant/text/format.h>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::stress_strain {
namespace {

Real measured(const Runner::Assignments& parameters, std::string_view probe) {
    Runner runner(find_lesson("elasticity/stress_strain"), parameters);
    runner.step();
    return runner.value(probe);
}

Runner::Assignments disc(Real mass, Real radius) {
    return {{"scene", "disc"}, {"mass", format_exact(mass)}, {"radius", format_exact(radius)}};
}

// Mean stress in the elements against m g / (π r²), over masses and radii.
Finding stress_under_a_weight() {
    Real worst = 0;
    for (const Real mass : {1.0, 50.0, 3000.0})
        for (const Real radius : {0.02, 0.1, 0.7}) {
            const Real exact = mass * 9.81 / (std::numbers::pi * radius * radius);
            worst = std::max(worst, std::abs(-measured(disc(mass, radius), "mean_stress") / exact - 1));
        }
    const Real once = measured(disc(50, 0.1), "stress"), heavier = measured(disc(100, 0.1), "stress"),
               smaller = measured(disc(50, 0.05), "stress");
    return {.figure = worst,
            .verdict = worst <= 1e-9 ? Verdict::reproduced : Verdict::refuted,
            .text = fmt::format(
                "50 kg on a disc of radius 10 cm: {}. Twice the mass: {} times that; half the radius: {} times. Linear "
                "elements hold a stress that is the same everywhere exactly: what differs is rounding.",
                format_quantity(once, "Pa"), format_quantity(heavier / once, ""), format_quantity(smaller / once, ""))};
}

Real rod_strain(Real force, Real unit = 1) {
    // In another unit of length, Y counts per that unit squared.
    return measured({{"scene", "rod"},
                     {"force", format_exact(force)},
                     {"length", format_exact(0.2 * unit)},
                     {"width", format_exact(0.1 * unit)},
                     {"youngs_modulus", format_exact(1e6 / (unit * unit))}},
                    "strain");
}

// Signs on a rod, the same strain in millimetres, and a turn by 30 degrees, which is rigid.
Finding sign_of_strain() {
    const Real pressed = rod_strain(-300), pulled = rod_strain(300), in_millimetres = rod_strain(300, 1000);
    const Mat<3> R = Eigen::AngleAxis<Real>(std::numbers::pi / 6, Vec<3>::UnitZ()).toRotationMatrix();
    const Mat<3> H = displacement_gradient<3>(R);
    const Real green = green_strain<3>(H).cwiseAbs().maxCoeff(), cauchy = cauchy_strain<3>(H)(0, 0);
    const bool signs = pressed < 0 && pulled > 0 && green < 1e-12 && std::abs(in_millimetres / pulled - 1) < 1e-9;
    return {
        .figure = cauchy,
        .verdict = !signs                     ? Verdict::refuted
                   : std::abs(cauchy) < 1e-12 ? Verdict::reproduced
                                              : Verdict::qualified,
        .text = fmt::format("A rod pressed with 300 N: ε = {}; pulled: {}, in metres and in millimetres alike. "
                            "Turned by 30°: {} by Green's strain, {} by Cauchy's.",
                            format_quantity(pressed, ""), format_quantity(pulled, ""),
                            green < 1e-12 ? "0" : format_quantity(green, ""), format_quantity(cauchy, "")),
        .condition = "Cauchy's strain is zero for shifts (E8) and very small turns only; Green's is zero for every rigid motion"};
}

const ClaimRegistration e1{"E1", stress_under_a_weight};
const ClaimRegistration e2{"E2", sign_of_strain};

}  // namespace
}  // namespace pliant::stress_strain
