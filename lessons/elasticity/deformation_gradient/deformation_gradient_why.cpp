// Why every number of a local deformation is what it is.
#include "deformation_gradient.h"
#include "kits/tensors/tensor_why.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace pliant::deformation {
namespace {

constexpr std::array<const char*, 3> place{"x", "y", "z"}, material_letter{"X", "Y", "Z"}, displaced{"u", "v", "w"};
constexpr std::array<const char*, 2> point{"P", "Q"};

std::size_t at(int k) { return static_cast<std::size_t>(k); }

Explanation difference(std::string formula, Input minuend, Input subtrahend) {
    return {std::move(formula), {std::move(minuend), std::move(subtrahend)}};
}

}  // namespace

// Where the point lies at rest: of the body a place of its grid, of P and Q what their sliders say.
std::array<Input, 3> DeformationGradientLesson::coordinates(bool of_node, Index index) const {
    const auto one = [&](int k) {
        if (of_node)
            return Input::constant(material_letter[at(k)], body_.points()(k, index), "m", "coordinate of the material point");
        return Input::of((index == 0 ? P : Q)[at(k)], material_letter[at(k)]);
    };
    return {one(0), one(1), one(2)};
}

Explanation DeformationGradientLesson::why_map(const Question& q) const {
    const auto k = at(q.component);
    if (q.field == "rest_vector")
        return difference(fmt::format("dX_{} = {} − {}", place[k], Q[k].info.symbol, P[k].info.symbol), Q[k], P[k]);
    return controls.why_position(q.component, coordinates(q.field == "position", q.index));
}

Explanation DeformationGradientLesson::why_displaced(const Question& q) const {
    const auto k = at(q.component);
    if (q.field == "deformed_vector")
        return {fmt::format("dx_{0} = dX_{0} + du_{0}", place[k]),
                {Input::now(fmt::format("dX_{}", place[k]), "rest_vector", 0, q.component),
                 Input::now(fmt::format("du_{}", place[k]), "relative_displacement", 0, q.component)}};
    if (q.field == "relative_displacement")
        return difference(fmt::format("du_{} = {}(Q) − {}(P)", place[k], displaced[k], displaced[k]),
                          Input::now(fmt::format("{}(Q)", displaced[k]), "point_displacement", 1, q.component),
                          Input::now(fmt::format("{}(P)", displaced[k]), "point_displacement", 0, q.component));
    const bool of_node = q.field == "displacement";
    return difference(fmt::format("{} = {} − {}", displaced[k], place[k], material_letter[k]),
                      Input::now(place[k], of_node ? "position" : "point_position", q.index, q.component),
                      coordinates(of_node, q.index)[k]);
}

Explanation DeformationGradientLesson::why_slope(const Question& q) const {
    return controls.why_gradient(q.component / 3, q.component % 3, coordinates(q.field == "displacement_gradient", q.index));
}

Explanation DeformationGradientLesson::why_deformation(const Question& q) const {
    if (q.field == "volume_ratio") return why::determinant("deformation_gradient", q.index);
    const int i = q.component / 3, j = q.component % 3;
    const std::string slope = fmt::format("∂{}/∂{}", displaced[at(i)], material_letter[at(j)]);
    return {fmt::format("{} = {}{}", why::entry("F", i, j), i == j ? "1 + " : "", slope),
            {Input::now(slope, q.field == "deformation_gradient" ? "displacement_gradient" : "point_gradient", q.index,
                        q.component)}};
}

Explanation DeformationGradientLesson::why_compared(const Question& q) const {
    const char* const axis = place[at(q.component)];
    if (q.field == "taylor_gap")
        return difference(fmt::format("gap_{0} = dx_{0} − FdX_{0}", axis),
                          Input::now(fmt::format("dx_{}", axis), "deformed_vector", 0, q.component),
                          Input::now(fmt::format("FdX_{}", axis), "mapped_vector", 0, q.component));
    std::vector<Input> inputs;
    for (int j = 0; j < 3; ++j) {
        inputs.push_back(why::entry_now("F", "point_deformation", 0, q.component, j));
        inputs.push_back(Input::now(fmt::format("dX_{}", place[at(j)]), "rest_vector", 0, j));
    }
    return {fmt::format("FdX_{0} = F_{1}1 dX_x + F_{1}2 dX_y + F_{1}3 dX_z", axis, q.component + 1), std::move(inputs)};
}

Explanation DeformationGradientLesson::why_polar(const Question& q) const {
    const int i = q.component / 3, j = q.component % 3;
    if (q.field == "point_stretch")
        return why::transposed_product("S", "R", "point_rotation", "F", "point_deformation", q.index, i, j);
    return why::of_matrix(why::entry("R", i, j), why::entry("rot", i, j), "an entry of the rotation nearest to F", "F",
                          "point_deformation", q.index, [i, j](const Mat<3>& F) { return nearest_rotation<3>(F)(i, j); });
}

Explanation DeformationGradientLesson::why_strain(const Question& q) const {
    return why::green("displacement_gradient", q.index, q.component / 3, q.component % 3);
}

// -------------------------------------------------------------------------------------------------------------- probes

void DeformationGradientLesson::explain_probes() {
    explain_probe("rotation_angle", [] {
        return why::of_matrix(
            "∠R", "angle", "atan2(|axis of R − Rᵀ|, tr R − 1)", "R", "point_rotation", 0,
            [](const Mat<3>& R) {
                const Vec<3> axial(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
                return std::atan2(axial.norm(), R.trace() - 1) * 180 / std::numbers::pi;
            },
            "°");
    });
    constexpr std::array<std::string_view, 3> names{"stretch_1", "stretch_2", "stretch_3"}, symbols{"λ₁", "λ₂", "λ₃"},
        functions{"sv₁", "sv₂", "sv₃"},
        words{"the largest singular value", "the middle singular value", "the least singular value, with the sign of det F"};
    for (std::size_t k = 0; k < 3; ++k)
        explain_probe(names[k], [k, symbols, functions, words] {
            return why::of_matrix(symbols[k], std::string(functions[k]), words[k], "F", "point_deformation", 0,
                                  [k](const Mat<3>& F) { return principal_stretches<3>(F).stretches[static_cast<Index>(k)]; });
        });
}

}  // namespace pliant::deformation
