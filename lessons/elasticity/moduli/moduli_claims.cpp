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
    const auto measured = runner.value(runner.lesson().probe("measured_modulus"));
    if (!measured) throw Refused(fmt::format("the {} test of {} has no slope", test, m.name));
    return *measured;
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

const ClaimRegistration e3{
    {.id = "E3",
     .lesson = "elasticity/moduli",
     .statement = "Young's modulus is stress over strain in tension, Y = (F/A)/(ΔL/L), a number of the material alone.",
     .source = "U, T: Young's modulus",
     .experiment =
         "Pull blocks of five materials and of three lengths in the virtual tensile test, and compare the slope of stress over "
         "strain with the Y that each is made of.",
     .figure = "largest |slope − Y| / Y",
     .criterion = "≤ 10⁻⁹",
     .question = "A block of the same rubber, but twice as long, is pulled with the same force. What does the test give for Y?",
     .answers = {"half as much, since it stretches twice as far", "the same", "twice as much, since there is more of it"},
     .right_answer = 1,
     .scene = {{"test", "tension"}, {"youngs_modulus", "1e6"}, {"poisson_ratio", "0.49"}, {"load", "1e4"}, {"length", "0.4"}},
     .measure = measure_young}};

const ClaimRegistration e4{
    {.id = "E4",
     .lesson = "elasticity/moduli",
     .statement = "The shear modulus is shear stress over shear strain, and follows from Y and ν: G = Y/(2(1+ν)).",
     .source = "U, T: shear modulus",
     .experiment =
         "Shear blocks of five materials, ν from −0.5 to 0.49, in the virtual shear test, and compare the slope of stress over "
         "strain with Y/(2(1+ν)).",
     .figure = "largest |slope − G| / G",
     .criterion = "≤ 10⁻⁹",
     .question = "Y stays, and ν is raised from 0 to 0.49. What becomes of the resistance to shear?",
     .answers = {"it stays, since shear keeps the volume", "it falls by a third", "it grows without limit"},
     .right_answer = 1,
     .scene = {{"test", "shear"}, {"youngs_modulus", "1e6"}, {"poisson_ratio", "0.49"}, {"load", "1e4"}},
     .measure = [] { return compare("shear", "G", [](const Material& m) { return m.Y / (2 * (1 + m.nu)); }); }}};

const ClaimRegistration e5{
    {.id = "E5",
     .lesson = "elasticity/moduli",
     .statement = "The bulk modulus is pressure over loss of volume, B = −ΔP/(ΔV/V), and follows from Y and ν: B = Y/(3(1−2ν)).",
     .source = "U, T: bulk modulus",
     .experiment =
         "Squeeze blocks of five materials, ν from −0.5 to 0.49, from all sides in the virtual pressure test, and compare the "
         "slope with Y/(3(1−2ν)).",
     .figure = "largest |slope − B| / B",
     .criterion = "≤ 10⁻⁹",
     .question = "Steel has Y = 200 GPa, rubber 1 MPa. Y of rubber stays, and its ν goes to ½. What becomes of its bulk modulus?",
     .answers = {"it stays below 1 MPa", "it grows without limit, beyond that of steel", "it falls to 0, as in a liquid"},
     .right_answer = 1,
     .scene = {{"test", "pressure"}, {"youngs_modulus", "1e6"}, {"poisson_ratio", "0.49"}, {"load", "1e4"}},
     .measure = [] { return compare("pressure", "B", [](const Material& m) { return m.Y / (3 * (1 - 2 * m.nu)); }); }}};

}  // namespace
}  // namespace pliant::moduli
