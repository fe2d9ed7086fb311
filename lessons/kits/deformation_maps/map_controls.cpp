#include "map_controls.h"

#include <numbers>

namespace pliant {
namespace {

std::vector<Option> options(MapControls::Offer offer) {
    std::vector<Option> all{{"translation", "translation"}, {"rotation", "rotation"}, {"stretch", "stretch"}, {"shear", "shear"},
                            {"free", "free: F as given"},   {"bend", "bend"},         {"twist", "twist"}};
    if (offer == MapControls::Offer::homogeneous) all.resize(5);
    return all;
}

}  // namespace

MapControls::MapControls(Lesson& owner, Offer offer, MapKind initial, const Vec<3>& shift)
    : kind_(owner, setting_of("map", "that takes every material point X to its place x", initial).rebuilds(), options(offer)),
      angle_(owner, quantity("angle", "α", "°", 30, {-180, 180}, {-3600, 3600}, "of the rotation").rebuilds().when([this] {
          return is(MapKind::rotation);
      })),
      axis_(owner, setting_of("axis", "about which the body turns").rebuilds().when([this] { return is(MapKind::rotation); }),
            {{"z", "z, towards you"}, {"x", "x, to the right"}, {"y", "y, upward"}}),
      shear_(owner,
             quantity("shear", "γ", "", 0.6, {-2, 2}, {-100, 100}, "sideways shift along x per height y").rebuilds().when([this] {
                 return is(MapKind::shear);
             })) {
    constexpr std::array<std::string_view, 3> stretch_keys{"stretch_x", "stretch_y", "stretch_z"},
        stretch_symbols{"s₁", "s₂", "s₃"},
        stretch_help{"length along x over rest length; 1 changes nothing, below 0 turns the body inside out",
                     "length along y over rest length", "length along z over rest length"};
    constexpr std::array<Real, 3> stretch_values{1.5, 0.8, 1};
    for (std::size_t k = 0; k < 3; ++k)
        stretches_.emplace_back(
            owner, quantity(stretch_keys[k], stretch_symbols[k], "", stretch_values[k], {0.1, 2}, {-100, 100}, stretch_help[k])
                       .rebuilds()
                       .when([this] { return is(MapKind::stretch); }));
    if (offer == Offer::homogeneous) return;
    bending_.emplace_back(owner, quantity("bend_curvature", "κ", "1/m", 1.5, {-3, 3}, {-100, 100},
                                          "of the middle line: one over the radius of its circle")
                                     .rebuilds()
                                     .when([this] { return is(MapKind::bend); }));
    bending_.emplace_back(owner, quantity("twist_rate", "τ", "°/m", 90, {-360, 360}, {-3600, 3600},
                                          "angle by which cross-sections turn about x, per length")
                                     .rebuilds()
                                     .when([this] { return is(MapKind::twist); }));
    constexpr std::array<std::string_view, 3> shift_keys{"shift_x", "shift_y", "shift_z"}, shift_symbols{"t₁", "t₂", "t₃"},
        shift_help{"translation along x, after the map", "translation along y, after the map",
                   "translation along z, after the map"};
    for (std::size_t k = 0; k < 3; ++k)
        shift_.emplace_back(owner, quantity(shift_keys[k], shift_symbols[k], "m", shift[static_cast<Index>(k)], {-2, 2},
                                            {-100, 100}, shift_help[k])
                                       .rebuilds());
}

void MapControls::add_entries(Lesson& owner) {
    entries_.join(owner, {-2, 2}, {-100, 100}, "entry of the deformation gradient: row, then column",
                  [this] { return is(MapKind::free); });
}

int MapControls::turning_axis() const { return Axis(axis_) == Axis::x ? 0 : Axis(axis_) == Axis::y ? 1 : 2; }

DeformationMap MapControls::map() const {
    DeformationMap m{.kind = kind_, .angle = angle_ * one_degree, .axis = turning_axis(), .shear = shear_};
    for (std::size_t k = 0; k < 3; ++k) m.stretches[static_cast<Index>(k)] = stretches_[k];
    m.gradient = entries_.matrix();
    if (!bending_.empty()) m.curvature = bending_[0], m.twist = bending_[1] * one_degree;
    for (std::size_t k = 0; k < shift_.size(); ++k) m.translation[static_cast<Index>(k)] = shift_[k];
    return m;
}

}  // namespace pliant
