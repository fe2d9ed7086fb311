// Why a point lies where it lies, and why the gradient is what it is: the formulas of the maps, component by component.
#include "kits/tensors/tensor_why.h"
#include "map_controls.h"

#include <fmt/format.h>

namespace pliant {
namespace {

constexpr std::array<const char*, 3> place{"x", "y", "z"}, material{"X", "Y", "Z"}, displaced{"u", "v", "w"};

std::string slope(int i, int j) {
    return fmt::format("∂{}/∂{}", displaced[static_cast<std::size_t>(i)], material[static_cast<std::size_t>(j)]);
}

Explanation zero(const std::string& left, const char* because) { return {fmt::format("{} = 0   ({})", left, because), {}}; }

}  // namespace

// α: the angle by which the cross-section of X turns.
Input MapControls::turning_angle(const std::array<Input, 3>& X) const {
    if (is(MapKind::rotation)) return why::in_radians("α", angle_);
    if (is(MapKind::bend)) return part("α = κ X", {bending_[0], X[0]});
    return part("α = T X", {why::in_radians("T", bending_[1]), X[0]});
}

// The translation is added where there is one.
Explanation MapControls::why_moved(int i, std::string rest, std::vector<Input> inputs) const {
    const std::string left = place[static_cast<std::size_t>(i)];
    if (shift_.empty()) return {fmt::format("{} = {}", left, rest), std::move(inputs)};
    const Number& t = shift_[static_cast<std::size_t>(i)];
    inputs.push_back(t);
    return {fmt::format("{} = {} + {}", left, rest, t.info.symbol), std::move(inputs)};
}

Explanation MapControls::why_position(int i, const std::array<Input, 3>& X) const {
    const auto k = static_cast<std::size_t>(i);
    switch (MapKind(kind_)) {
        case MapKind::translation:
            break;
        case MapKind::rotation:
        case MapKind::twist:
            return why_turned(i, X);
        case MapKind::bend:
            return why_bent(i, X);
        case MapKind::stretch:
            return why_moved(i, fmt::format("{} {}", stretches_[k].info.symbol, material[k]), {stretches_[k], X[k]});
        case MapKind::shear:
            if (i == 0) return why_moved(i, "X + γ Y", {X[0], shear_, X[1]});
            break;
        case MapKind::free:
            return why_free(i, X);
    }
    return why_moved(i, material[k], {X[k]});
}

Explanation MapControls::why_free(int i, const std::array<Input, 3>& X) const {
    std::vector<Input> inputs;
    std::string rest;
    for (int j = 0; j < 3; ++j) {
        const auto k = static_cast<std::size_t>(j);
        inputs.push_back(Input::of(entries_(i, j)));
        inputs.push_back(X[k]);
        rest += fmt::format("{}{} {}", j ? " + " : "", entries_(i, j).info.symbol, material[k]);
    }
    return why_moved(i, rest, std::move(inputs));
}

// About an axis of coordinates by α.
Explanation MapControls::why_turned(int i, const std::array<Input, 3>& X) const {
    const int axis = is(MapKind::twist) ? 0 : turning_axis();
    const auto k = static_cast<std::size_t>(i), first = static_cast<std::size_t>((axis + 1) % 3),
               second = static_cast<std::size_t>((axis + 2) % 3);
    if (i == axis) return why_moved(i, material[k], {X[k]});
    if (k == first)
        return why_moved(i, fmt::format("{} cos(α) − {} sin(α)", material[first], material[second]),
                         {X[first], X[second], turning_angle(X)});
    return why_moved(i, fmt::format("{} sin(α) + {} cos(α)", material[first], material[second]),
                     {X[first], X[second], turning_angle(X)});
}

Explanation MapControls::why_bent(int i, const std::array<Input, 3>& X) const {
    if (i == 2) return why_moved(i, "Z", {X[2]});
    const Input a = turning_angle(X);
    // The same as (1/κ − Y) sin(α) and 1/κ − (1/κ − Y) cos(α), without the difference of large numbers.
    if (bending_[0] * X[0].value == 0)
        return i == 0 ? why_moved(i, "X − Y sin(α)", {X[0], X[1], a}) : why_moved(i, "Y cos(α)", {X[1], a});
    if (i == 0) return why_moved(i, "X sin(α) / α − Y sin(α)", {X[0], X[1], a});
    return why_moved(i, "2 X sin²(α / 2) / α + Y cos(α)", {X[0], X[1], a});
}

// ------------------------------------------------------------------------------------------------------------ gradients

Explanation MapControls::why_gradient(int i, int j, const std::array<Input, 3>& X) const {
    const auto k = static_cast<std::size_t>(i);
    switch (MapKind(kind_)) {
        case MapKind::translation:
            return zero(slope(i, j), "a translation displaces every point alike");
        case MapKind::rotation:
            return why_turned_gradient(i, j, turning_axis(), X);
        case MapKind::stretch:
            if (i != j) break;
            return {fmt::format("{} = {} − 1", slope(i, j), stretches_[k].info.symbol), {stretches_[k]}};
        case MapKind::shear:
            if (i != 0 || j != 1) break;
            return {fmt::format("{} = γ", slope(i, j)), {shear_}};
        case MapKind::free: {
            const Number& F = entries_(i, j);
            return {fmt::format("{} = {}{}", slope(i, j), F.info.symbol, i == j ? " − 1" : ""), {F}};
        }
        case MapKind::bend:
            return why_bent_gradient(i, j, X);
        case MapKind::twist:
            return why_twisted_gradient(i, j, X);
    }
    return zero(slope(i, j), "the map does not mix these directions");
}

Explanation MapControls::why_turned_gradient(int i, int j, int axis, const std::array<Input, 3>& X) const {
    if (i == axis || j == axis) return zero(slope(i, j), "along the axis nothing changes");
    if (i == j) return {fmt::format("{} = −2 sin²(α / 2)", slope(i, j)), {turning_angle(X)}};
    const bool minus = i == (axis + 1) % 3;
    return {fmt::format("{} = {}sin(α)", slope(i, j), minus ? "−" : ""), {turning_angle(X)}};
}

Explanation MapControls::why_bent_gradient(int i, int j, const std::array<Input, 3>& X) const {
    if (i == 2 || j == 2 || j == 1) return why_turned_gradient(i, j, 2, X);
    const std::vector<Input> inputs{bending_[0], X[1], turning_angle(X)};
    if (i == 0) return {fmt::format("{} = −2 sin²(α / 2) − κ Y cos(α)", slope(i, j)), inputs};
    return {fmt::format("{} = (1 − κ Y) sin(α)", slope(i, j)), inputs};
}

Explanation MapControls::why_twisted_gradient(int i, int j, const std::array<Input, 3>& X) const {
    if (i == 0 || j > 0) return why_turned_gradient(i, j, 0, X);
    const std::vector<Input> inputs{why::in_radians("T", bending_[1]), X[1], X[2], turning_angle(X)};
    if (i == 1) return {fmt::format("{} = −T (Y sin(α) + Z cos(α))", slope(i, j)), inputs};
    return {fmt::format("{} = T (Y cos(α) − Z sin(α))", slope(i, j)), inputs};
}

}  // namespace pliant
