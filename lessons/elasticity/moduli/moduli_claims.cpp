// What the lectures say of the three moduli, measured by the virtual tests of the lesson.
#include <pliant/run/runner.h>
#include <pliant/study/claims_report.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pliant::moduli {
namespace {

struct Material {
    std::string_view name;
    Real Y, nu;  // Pa, dimensionless
};
constexpr std::array<Material, 5> materials{
    {{"steel", 200e9, 0.29}, {"rubber", 1e6, 0.49}, {"cork", 20e6, 0}, {"jelly", 3e3, 0.45}, {"auxetic foam", 1e6, -0.5}}};

// m
struct Shape {
    Real length, width;
};
constexpr std::array<Shape, 3> shapes{{{0.2, 0.1}, {0.4, 0.1}, {0.05, 0.1}}};

constexpr Real enough = 1e-9;

// Slope of stress over strain that the lesson's machine reads off [Pa].
Real slope(std::string_view test, const Material& m, const Shape& shape = shapes[0]) {
    Runner runner(find_lesson("elasticity/moduli"), {{"test", std::string(test)},
                                                     {"youngs_modulus", format_exact(m.Y)},
                                                     {"poisson_ratio", format_exact(m.nu)},
                                                     {"load", format_exact(m.Y / 100)},
                                                     {"length", format_exact(shape.length)},
                                                     {"width", format_exact(shape.width)},
                                                     {"resolution", "2"}});
    runner.step();
    return runner.value("measured_modulus");
}

// Slopes of every material against a closed form: how far they are off, and what they are.
Finding compare(std::string_view test, std::string_view symbol, Real (*exact)(const Material&)) {
    Finding f;
    for (const Material& m : materials) {
        const Real measured = slope(test, m);
        f.figure = std::max(f.figure, std::abs(measured - exact(m)) / exact(m));
        f.text += fmt::format("{}{} {}", f.text.empty() ? fmt::format("{}: ", symbol) : ", ", m.name,
                              format_quantity(measured, "Pa", 3));
    }
    f.text += fmt::format(
        ". The largest relative difference is {}: the strain is the same everywhere, which linear elements hold "
        "exactly.",
        steady_figure(f.figure));
    f.verdict = f.figure <= enough ? Verdict::reproduced : Verdict::refuted;
    return f;
}

Finding measure_young() {
    Finding f = compare("tension", "Y", [](const Material& m) { return m.Y; });
    Real shape_difference = 0;
    for (const Shape& shape : shapes) {
        const Material& m = materials[1];
        shape_difference = std::max(shape_difference, std::abs(slope("tension", m, shape) - m.Y) / m.Y);
    }
    f.text += fmt::format(" Over three lengths of a rubber block it is {}.", steady_figure(shape_difference));
    f.figure = std::max(f.figure, shape_difference);
    if (f.figure > enough) f.verdict = Verdict::refuted;
    return f;
}

const ClaimRegistration e3{"E3", measure_young};
const ClaimRegistration e4{"E4", [] { return compare("shear", "G", [](const Material& m) { return m.Y / (2 * (1 + m.nu)); }); }};
const ClaimRegistration e5{"E5",
                           [] { return compare("pressure", "B", [](const Material& m) { return m.Y / (3 * (1 - 2 * m.nu)); }); }};

}  // namespace
}  // namespace pliant::moduli
