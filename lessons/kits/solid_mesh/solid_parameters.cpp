#include "solid_parameters.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>

namespace pliant::solid_mesh {
namespace {

// Larger bodies take more than a lecture has patience for.
constexpr Index most_elements = 60000;
// Of the longest edge of a cell over its shortest.
constexpr Real longest_needle = 1e4;

ParameterInfo force_along(std::string_view key, std::string_view symbol, Real initial, std::string_view axis_help) {
    return quantity(key, symbol, "N", initial, {-500, 500}, {-1e15, 1e15}, axis_help).in(Group::forces).rebuilds();
}

ParameterInfo size_along(std::string_view key, std::string_view symbol, Real initial, std::string_view help) {
    return log_quantity(key, symbol, "m", initial, {0.05, 5}, {1e-9, 1e9}, help).in(Group::shape).rebuilds();
}

ParameterInfo cells_along(std::string_view key, std::string_view symbol, int initial, std::string_view help) {
    return quantity(key, symbol, "", initial, {1, 32}, {1, 200}, help).in(Group::shape).rebuilds();
}

ParameterInfo starting_at(Real initial, ParameterInfo info) {
    info.initial = initial;
    return info;
}

std::function<bool()> either(const std::function<bool()>& a, const std::function<bool()>& b) {
    if (!b) return a;
    return [a, b] { return a() || b(); };
}

}  // namespace

SolidParameters::SolidParameters(Lesson& lesson, Uses uses, const Initial& initial)
    : law(lesson,
          setting_of("model", "how the energy follows from the deformation", 1).in(Group::material).rebuilds().when(uses.law),
          {{"linear", "linear"},
           {"corotational", "corotational"},
           {"stvk", "St. Venant–Kirchhoff"},
           {"neo_hookean", "neo-Hookean"}}),
      plane(lesson,
            setting_of("plane", "of a body in the plane: free to become thinner, or held at its thickness", initial.plane)
                .in(Group::material)
                .rebuilds()
                .when(uses.plane),
            {{"stress", "plane stress"}, {"strain", "plane strain"}}),
      youngs_modulus(lesson,
                     starting_at(initial.youngs_modulus,
                                 youngs_modulus_info("stress per strain in a pull; rubber 1 MPa, steel 200 GPa", {1e3, 1e12}))),
      poisson_ratio(lesson, poisson_ratio_info("narrowing over lengthening; linear elements lock near ½", {-0.5, 0.4999})),
      load_x(lesson, force_along("load_x", "F_x", 0, "force along x on the loaded face, spread evenly").when(uses.load)),
      load_y(lesson,
             force_along("load_y", "F_y", initial.load_y, "force along y on the loaded face, spread evenly; negative pulls down")
                 .when(uses.load)),
      load_z(lesson, force_along("load_z", "F_z", 0, "force along z on the loaded face, spread evenly").when(uses.space_load)),
      length(lesson, size_along("length", "L", 1, "of the body, along x").when(either(uses.beam, uses.panel))),
      height(lesson, size_along("height", "h", initial.height, "of the body, along y").when(either(uses.beam, uses.panel))),
      width(lesson, size_along("width", "w", initial.width, "of the beam, along z").when(uses.beam)),
      cells_x(
          lesson,
          cells_along("cells_x", "nₓ", initial.cells_x, "cells along x; a cell is 2 triangles or 6 tetrahedra").when(uses.cells)),
      cells_y(lesson, cells_along("cells_y", "n_y", initial.cells_y, "cells along y").when(uses.cells)),
      cells_z(lesson, cells_along("cells_z", "n_z", 2, "cells along z").when(uses.beam)) {}

BodySettings SolidParameters::settings(Shape shape, int order) const {
    const auto cells = [](const Whole& n) { return static_cast<int>(Index(n)); };
    BodySettings s;
    s.shape = shape, s.law = law, s.plane = plane, s.order = order;
    s.youngs_modulus = youngs_modulus, s.poisson_ratio = poisson_ratio;
    s.size = {length, height, width};
    s.cells = {cells(cells_x), cells(cells_y), cells(cells_z)};
    return s;
}

void SolidParameters::check(const BodySettings& s, bool in_plane, bool has_law) const {
    if (in_plane && has_law && Law(law) == Law::neo_hookean && Plane(plane) == Plane::stress)
        throw Refused(
            "plane = stress with model = neo_hookean: in plane stress the thickness of a neo-Hookean body is an unknown of its "
            "own. "
            "Take plane=strain, or model=linear, corotational or stvk");
    if (s.shape == Shape::file) return;
    const bool in_space = s.shape == Shape::beam;
    // The middles of edges make a body of second order about eight times as dear.
    const Index count = cells_x * cells_y * (in_space ? 6 * Index(cells_z) : Index{2}),
                most = most_elements / (s.order == 2 ? 6 : 1);
    if (count > most)
        throw Refused(fmt::format("cells_x = {}, cells_y = {}{} make {} elements: at most {} are accepted{}. Take fewer cells",
                                  Index(cells_x), Index(cells_y),
                                  in_space ? fmt::format(", cells_z = {}", Index(cells_z)) : std::string(), count, most,
                                  s.order == 2 ? " of second order" : ""));
    if (!in_space) return;
    const Vec<3> edge(length / static_cast<Real>(Index(cells_x)), height / static_cast<Real>(Index(cells_y)),
                      width / static_cast<Real>(Index(cells_z)));
    if (edge.maxCoeff() > longest_needle * edge.minCoeff())
        throw Refused(
            fmt::format("length = {} m, height = {} m and width = {} m make cells with edges from {} to {}: at most {} "
                        "times as long as short is accepted",
                        Real(length), Real(height), Real(width), format_quantity(edge.minCoeff(), "m"),
                        format_quantity(edge.maxCoeff(), "m"), longest_needle));
}

}  // namespace pliant::solid_mesh
