#include "map_controls.h"

#include <numbers>

namespace pliant {
namespace {

// "F11" and "F₁₁" of each entry, row by row.
constexpr std::array<std::string_view, 9> entry_keys{"F11", "F12", "F13", "F21", "F22", "F23", "F31", "F32", "F33"};
constexpr std::array<std::string_view, 9> entry_symbols{"F₁₁", "F₁₂", "F₁₃", "F₂₁", "F₂₂", "F₂₃", "F₃₁", "F₃₂", "F₃₃"};
// A map that does a little of everything.
constexpr std::array<Real, 9> entry_values{1.2, 0.3, 0, 0, 0.9, 0.1, 0.05, 0, 1.1};

std::vector<Option> options(MapControls::Offer offer) {
    std::vector<Option> all{{"translation", "translation"}, {"rotation", "rotation"}, {"stretch", "stretch"}, {"shear", "shear"},
                            {"free", "free: F as given"},   {"bend", "bend"},         {"twist", "twist"}};
    if (offer == MapControls::Offer::homogeneous) all.resize(5);
    return all;
}

}  // namespace

MapControls::MapControls(Lesson& owner, Offer offer, MapKind initial, const Vec<3>& shift)
    : kind_(owner,
            {.key = "map",
             .help = "that takes every material point X to its place x",
             .initial = static_cast<Real>(initial),
             .effect = Effect::rebuild},
            options(offer)),
      angle_(owner, {.key = "angle",
                     .symbol = "α",
                     .unit = "°",
                     .help = "of the rotation",
                     .initial = 30,
                     .useful = {-180, 180},
                     .accepted = Interval{-3600, 3600},
                     .effect = Effect::rebuild,
                     .used = [this] { return is(MapKind::rotation); }}),
      axis_(owner,
            {.key = "axis",
             .help = "about which the body turns",
             .effect = Effect::rebuild,
             .used = [this] { return is(MapKind::rotation); }},
            {{"z", "z, towards you"}, {"x", "x, to the right"}, {"y", "y, upward"}}),
      shear_(owner, {.key = "shear",
                     .symbol = "γ",
                     .help = "sideways shift along x per height y",
                     .initial = 0.6,
                     .useful = {-2, 2},
                     .accepted = Interval{-100, 100},
                     .effect = Effect::rebuild,
                     .used = [this] { return is(MapKind::shear); }}) {
    constexpr std::array<std::string_view, 3> stretch_keys{"stretch_x", "stretch_y", "stretch_z"},
        stretch_symbols{"s₁", "s₂", "s₃"},
        stretch_help{"length along x over rest length; 1 changes nothing, below 0 turns the body inside out",
                     "length along y over rest length", "length along z over rest length"};
    constexpr std::array<Real, 3> stretch_values{1.5, 0.8, 1};
    for (std::size_t k = 0; k < 3; ++k)
        stretches_.emplace_back(owner, ParameterInfo{.key = stretch_keys[k],
                                                     .symbol = stretch_symbols[k],
                                                     .help = stretch_help[k],
                                                     .initial = stretch_values[k],
                                                     .useful = {0.1, 2},
                                                     .accepted = Interval{-100, 100},
                                                     .effect = Effect::rebuild,
                                                     .used = [this] { return is(MapKind::stretch); }});
    if (offer == Offer::homogeneous) return;
    bending_.emplace_back(owner, ParameterInfo{.key = "bend_curvature",
                                               .symbol = "κ",
                                               .unit = "1/m",
                                               .help = "of the middle line: one over the radius of its circle",
                                               .initial = 1.5,
                                               .useful = {-3, 3},
                                               .accepted = Interval{-100, 100},
                                               .effect = Effect::rebuild,
                                               .used = [this] { return is(MapKind::bend); }});
    bending_.emplace_back(owner, ParameterInfo{.key = "twist_rate",
                                               .symbol = "τ",
                                               .unit = "°/m",
                                               .help = "angle by which cross-sections turn about x, per length",
                                               .initial = 90,
                                               .useful = {-360, 360},
                                               .accepted = Interval{-3600, 3600},
                                               .effect = Effect::rebuild,
                                               .used = [this] { return is(MapKind::twist); }});
    constexpr std::array<std::string_view, 3> shift_keys{"shift_x", "shift_y", "shift_z"}, shift_symbols{"t₁", "t₂", "t₃"},
        shift_help{"translation along x, after the map", "translation along y, after the map",
                   "translation along z, after the map"};
    for (std::size_t k = 0; k < 3; ++k)
        shift_.emplace_back(owner, ParameterInfo{.key = shift_keys[k],
                                                 .symbol = shift_symbols[k],
                                                 .unit = "m",
                                                 .help = shift_help[k],
                                                 .initial = shift[static_cast<Index>(k)],
                                                 .useful = {-2, 2},
                                                 .accepted = Interval{-100, 100},
                                                 .effect = Effect::rebuild});
}

void MapControls::add_entries(Lesson& owner) {
    for (std::size_t k = 0; k < 9; ++k)
        entries_.emplace_back(owner, ParameterInfo{.key = entry_keys[k],
                                                   .symbol = entry_symbols[k],
                                                   .help = "entry of the deformation gradient: row, then column",
                                                   .initial = entry_values[k],
                                                   .useful = {-2, 2},
                                                   .accepted = Interval{-100, 100},
                                                   .effect = Effect::rebuild,
                                                   .used = [this] { return is(MapKind::free); }});
}

int MapControls::turning_axis() const {
    switch (Axis(axis_)) {
        case Axis::x:
            return 0;
        case Axis::y:
            return 1;
        case Axis::z:
            return 2;
    }
    return 2;
}

DeformationMap MapControls::map() const {
    DeformationMap m{.kind = kind_, .angle = angle_ * one_degree, .axis = turning_axis(), .shear = shear_};
    for (std::size_t k = 0; k < 3; ++k) m.stretches[static_cast<Index>(k)] = stretches_[k];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) m.gradient(i, j) = entry(i, j);
    if (!bending_.empty()) m.curvature = bending_[0], m.twist = bending_[1] * one_degree;
    for (std::size_t k = 0; k < shift_.size(); ++k) m.translation[static_cast<Index>(k)] = shift_[k];
    return m;
}

}  // namespace pliant
