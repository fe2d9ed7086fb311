// M1, M2 and M3: what the lectures say of finite elements, measured.
#include "fem.h"

#include <pliant/math/line_fit.h>
#include <pliant/run/runner.h>
#include <pliant/study/claims.h>
#include <pliant/study/claims_report.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <cmath>

namespace pliant::fem {
namespace {

struct Orders {
    Real displacement, gradient;
};

// Of the errors of a solution that is known.
Orders measured_orders(const char* of_element, std::initializer_list<int> cells) {
    std::vector<Real> sizes, displacements, gradients;
    for (const int n : cells) {
        const std::string count = std::to_string(n);
        Runner runner(
            find_lesson("mesh/fem"),
            {{"scene", "manufactured"}, {"plane", "strain"}, {"element", of_element}, {"cells_x", count}, {"cells_y", count}});
        runner.step();
        sizes.push_back(std::log(Real{1} / n));
        displacements.push_back(std::log(runner.value("l2_error"))), gradients.push_back(std::log(runner.value("h1_error")));
    }
    return {fit_line(sizes, displacements)->slope, fit_line(sizes, gradients)->slope};
}

Finding convergence_orders() {
    const Orders linear = measured_orders("linear", {8, 16, 32}), quadratic = measured_orders("quadratic", {4, 8, 16});
    const auto near = [](Real order, Real expected) { return std::abs(order - expected) <= 0.1; };
    const bool right = near(linear.displacement, 2) && near(linear.gradient, 1) && near(quadratic.displacement, 3) &&
                       near(quadratic.gradient, 2);
    return {
        .figure = linear.displacement,
        .verdict = right ? Verdict::reproduced : Verdict::refuted,
        .text = fmt::format("With linear triangles the error of the displacement falls with order {}, that of its gradient with "
                            "order {}; with quadratic ones with {} and {}.",
                            format_quantity(linear.displacement, "", 3), format_quantity(linear.gradient, "", 3),
                            format_quantity(quadratic.displacement, "", 3), format_quantity(quadratic.gradient, "", 3))};
}

struct Turned90 {
    Real volume, iterations;
};

Turned90 turned_beam(const char* model, int angle) {
    Runner runner(find_lesson("mesh/fem"), {{"scene", "twist"},
                                            {"turned", "support"},
                                            {"model", model},
                                            {"twist_angle", std::to_string(angle)},
                                            {"cells_x", "6"},
                                            {"cells_y", "1"},
                                            {"cells_z", "1"},
                                            {"load_steps", std::string(model) == "linear" ? "1" : "4"}});
    runner.step();
    return {runner.value("volume_ratio"), runner.value("newton_iterations")};
}

Finding inflated_by_rotation() {
    std::vector<Turned90> linear, turning;
    for (const int angle : {30, 60, 90})
        linear.push_back(turned_beam("linear", angle)), turning.push_back(turned_beam("corotational", angle));
    const bool inflates = 1.05 < linear[0].volume && linear[0].volume < linear[1].volume && linear[1].volume < linear[2].volume &&
                          linear[2].volume > 1.9;
    Real off = 0;
    for (const Turned90& t : turning) off = std::max(off, std::abs(t.volume - 1));
    return {
        .figure = linear[2].volume,
        .verdict = inflates && off < 1e-6 ? Verdict::reproduced : Verdict::refuted,
        .text = fmt::format("Turned by 30°, 60° and 90° the linear beam has {}, {} and {} times its volume; the corotational one "
                            "keeps it. That costs {} solutions of K d = r in four load steps, instead of one.",
                            format_quantity(linear[0].volume, "", 3), format_quantity(linear[1].volume, "", 3),
                            format_quantity(linear[2].volume, "", 3), format_quantity(turning[2].iterations, "", 3))};
}

// Per element M is that of a mean plus a part (d + 1)(d + 2) times smaller than the mass, against d + 1 times when it is lumped:
// so the fastest vibration of an element is √(d + 2) times faster.
Finding lumped_against_consistent() {
    std::vector<Real> ratios;
    for (const char* cells : {"4", "8", "12"}) {
        const auto longest_step = [cells](const char* mass) {
            Runner runner(find_lesson("mesh/fem"), {{"mass", mass}, {"cells_x", cells}});
            return runner.value("stable_time_step");
        };
        ratios.push_back(longest_step("lumped") / longest_step("consistent"));
    }
    bool right = true;
    for (const Real r : ratios) right = right && r > 1.5 && r <= std::sqrt(Real{5});
    solid_mesh::BodySettings beam;
    beam.size = {1, 0.2, 0.2}, beam.cells = {12, 2, 2};
    const auto solid = solid_mesh::make_solid(beam);
    const Index entries = solid->mass(1, false)->matrix()->nonZeros(), diagonal = solid->mass(1, true)->size();
    return {.figure = ratios.back(),
            .verdict = right ? Verdict::reproduced : Verdict::refuted,
            .text = fmt::format(
                "On 4, 8 and 12 cells along the beam the stable step is {}, {} and {} times as long with lumped masses; for a "
                "single tetrahedron it would be √5 = 2.24. The lumped matrix has {} entries, the consistent one {}, and "
                "equations to solve in every step.",
                format_quantity(ratios[0], "", 3), format_quantity(ratios[1], "", 3), format_quantity(ratios[2], "", 3), diagonal,
                entries)};
}

const ClaimRegistration m1{"M1", convergence_orders}, m2{"M2", inflated_by_rotation}, m3{"M3", lumped_against_consistent};

}  // namespace
}  // namespace pliant::fem
