// Named arrays: what a lesson's state consists of, and what it shows.
#pragma once
#include <pliant/lesson/explanation.h>
#include <pliant/math/types.h>

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace pliant {

// What the entries of an array belong to. x_face and y_face: the faces of a staggered grid across that axis. handle: what a
// person may take hold of, no field.
enum class On { node, edge, face, cell, element, particle, x_face, y_face, handle };
enum class Rank { scalar, vector, tensor };

std::string_view name_of(On on);
std::string_view name_of(Rank rank);

// A part of the state: the numbers that, with the parameters, define "now" between two steps. Save, restore, step back, compare,
// replay and the NaN check follow from the list of them. `view` gives the numbers where they live.
struct StateArray {
    std::string_view name, unit;
    std::function<std::span<Real>()> view;
};

// A quantity to show, in rows of `components` numbers per node, cell, ...: 1 for a scalar; 2 or 3 for a vector; for a tensor
// dim × dim numbers row by row (4 or 9).
struct Field {
    std::string_view name, symbol = "", unit = "";
    On on = On::node;
    Rank rank = Rank::scalar;
    int components = 1;
    std::function<std::span<const Real>()> view;
    std::string_view help = "";
    // Beyond this magnitude the run has blown up and is stopped; no bound when empty.
    std::function<Real()> bound{};
    // Does the present scene compute it? always, when empty.
    std::function<bool()> used{};
    // A quantity that other fields define at each moment (a speed, an energy density): their names, and how it follows from them.
    // What a stage writes is explained by the stage instead.
    std::vector<std::string_view> defined_by{};
    std::function<Explanation(const Question&)> explain{};
    // A scalar that may have both signs, and is shown by colours that diverge from 0, in every state. Components of vectors and
    // tensors always are, lengths and norms never.
    bool both_signs = false;

    Index size() const { return static_cast<Index>(view().size()) / components; }
    bool in_use() const { return !used || used(); }

    // For declarations of a line or two: scalar_field(…).stops_at(1e9).when([this] { return staggered(); })
    Field stops_at(Real magnitude) const;
    Field stops_at(std::function<Real()> magnitude) const;
    Field when(std::function<bool()> uses) const;
    Field of_both_signs() const;
    Field follows(std::vector<std::string_view> from, std::function<Explanation(const Question&)> why) const;
};

// "x", "y" or "z".
constexpr const char* axis_name(Index component) {
    constexpr std::array<const char*, 3> names{"x", "y", "z"};
    return names[static_cast<std::size_t>(component)];
}

// The components of a row by name: {""}, {"x", "y"}, {"xx", "xy", ...}.
std::vector<std::string> component_names(const Field& field);

// One number per row: the component, or with component = -1 the value of a scalar, the length of a vector, the Frobenius norm of
// a tensor.
void row_values(const Field& field, int component, std::vector<Real>& values);
// The same of numbers that are laid out like the field's: a copy of another moment.
void row_values(const Field& field, std::span<const Real> numbers, int component, std::vector<Real>& values);
Real row_value(const Field& field, Index row, int component);

// A state array over any Eigen matrix or std::vector<Real> that outlives it.
template <class Storage>
StateArray state_array(std::string_view name, std::string_view unit, Storage& storage) {
    return {name, unit, [&storage] { return std::span<Real>(storage.data(), static_cast<std::size_t>(storage.size())); }};
}

// A view for a Field over any Eigen matrix or std::vector<Real> that outlives it, or over what a function gives.
template <class Storage>
std::function<std::span<const Real>()> view_of(const Storage& storage) {
    if constexpr (std::is_invocable_v<Storage>)
        return [storage] { return std::span<const Real>(storage()); };
    else
        return [&storage] { return std::span<const Real>(storage.data(), static_cast<std::size_t>(storage.size())); };
}

// Fields over an array in memory, or a function that gives their view: a number, three components, two of them in a plane, or
// 3 × 3 numbers row by row, for each thing of its kind.
template <class Storage>
Field scalar_field(std::string_view name, std::string_view symbol, std::string_view unit, On on, const Storage& numbers,
                   std::string_view help) {
    return {.name = name, .symbol = symbol, .unit = unit, .on = on, .view = view_of(numbers), .help = help};
}
template <class Storage>
Field vector_field(std::string_view name, std::string_view symbol, std::string_view unit, On on, const Storage& numbers,
                   std::string_view help) {
    Field f = scalar_field(name, symbol, unit, on, numbers, help);
    f.rank = Rank::vector, f.components = 3;
    return f;
}
template <class Storage>
Field plane_vector_field(std::string_view name, std::string_view symbol, std::string_view unit, On on, const Storage& numbers,
                         std::string_view help) {
    Field f = vector_field(name, symbol, unit, on, numbers, help);
    f.components = 2;
    return f;
}
template <class Storage>
Field tensor_field(std::string_view name, std::string_view symbol, std::string_view unit, On on, const Storage& numbers,
                   std::string_view help) {
    Field f = scalar_field(name, symbol, unit, on, numbers, help);
    f.rank = Rank::tensor, f.components = 9;
    return f;
}

}  // namespace pliant
