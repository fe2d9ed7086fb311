// A picture as data. A lesson fills one in; who draws it, and with what, it does not know.
//
// Coordinates are metres, y up; a 2D lesson leaves z = 0. Sizes of marks are in pixels at UI scale 1. Colours are named by role
// (Ink), so that one picture serves the dark and the projector theme.
#pragma once
#include <pliant/lesson/array.h>
#include <pliant/math/types.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

enum class Ink {
    body,      // the thing itself
    edge,      // its mesh lines
    rest,      // its undeformed shape; guides
    ground,    // walls, floors
    fixed,     // supports, pinned nodes
    force,     // loads and forces
    velocity,  // velocities
    accent,    // what to look at
    text,      // words
};

using Position = std::array<float, 3>;

inline Position position(Real x, Real y, Real z = 0) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}
template <int Dim>
Position position(const Vec<Dim>& p) {
    if constexpr (Dim == 2)
        return position(p[0], p[1]);
    else
        return position(p[0], p[1], p[2]);
}

// What marks stand for, so that one can be hovered, picked or pulled: mark k of the batch is entry first + k of the fields on
// `on` (or ids[k] when ids are given).
struct PickId {
    bool pickable = false;
    On on = On::node;
    Index first = 0;
    std::vector<Index> ids{};
    Index id(std::size_t mark) const { return ids.empty() ? first + static_cast<Index>(mark) : ids[mark]; }
};

// `values`, where given, are numbers of the field being shown, one per mark (or corner): the mark takes its colour from the
// colour bar instead of the ink.
struct PointMarks {
    std::vector<Position> at;
    std::vector<float> values{};
    Ink ink = Ink::body;
    float radius = 4;  // px
    PickId pick{};
};

struct LineMarks {
    std::vector<Position> ends;  // two per line
    std::vector<float> values{};
    Ink ink = Ink::edge;
    float width = 1.5f;  // px
    bool dashed = false;
    PickId pick{};
};

// Triangles, lit by a headlight in 3D; `values` per corner, or per triangle.
struct TriangleMarks {
    std::vector<Position> corners;
    std::vector<std::array<int, 3>> triangles;
    std::vector<float> values{};
    Ink ink = Ink::body;
    float opacity = 1;
    bool edges = false;  // draw the outlines of the triangles too
    PickId pick{};       // per triangle
};

struct ArrowMarks {
    std::vector<Position> from, to;
    std::vector<float> values{};
    Ink ink = Ink::force;
    float width = 2.5f;  // px
};

// A 2D grid of cells drawn as a heat map: value of cell (i, j) at i + nx j, i along x.
struct GridMarks {
    int nx = 0, ny = 0;
    Position lower{}, upper{};  // corners of the whole grid
    std::vector<float> values;
    bool smooth = true;  // interpolate between cell centres
    PickId pick{true, On::cell, 0, {}};
};

struct LabelMark {
    Position at;
    std::string text;
    Ink ink = Ink::text;
    float offset_x = 0, offset_y = 0;  // px, y down: of the label's middle from `at`
    bool large = false;
    std::optional<Position> away_from{};  // the words then stand beyond `at`, as seen from here: behind the head of an arrow
};

// Numbers in brackets beside the picture, row by row: "F = [...]". Drawn one under another in a corner of the picture.
struct MatrixMark {
    std::string name, unit;
    int rows = 0, columns = 0;
    std::vector<Real> entries;
    Ink ink = Ink::text;
};

class Lesson;

// Which field gives the colours. component -1: a scalar's value, a vector's length, a tensor's norm.
struct ColourBy {
    std::string field;
    int component = -1;
};

class Scene {
public:
    // Set by the viewer before draw(): what the person wants to see.
    ColourBy colour_by;
    bool show_arrows = true, show_labels = true;
    // Shown in place of the numbers of the field that is chosen, one per row: a difference of two runs, or of after and before.
    // Ignored where the field has another number of rows.
    std::optional<std::vector<Real>> override_values;
    // Fields that no stage has computed yet: their numbers stand at 0, which is no result, and are drawn without colours and
    // written as "—".
    std::vector<std::string> awaited{};
    bool awaits(std::string_view field) const;

    // The part of space that the picture frames at first. Kept the same from step to step, so that nothing jumps.
    Position lower{0, 0, 0}, upper{1, 1, 1};

    std::vector<GridMarks> grids;
    std::vector<TriangleMarks> triangles;
    std::vector<LineMarks> lines;
    std::vector<PointMarks> points;
    std::vector<ArrowMarks> arrows;
    std::vector<LabelMark> labels;
    std::vector<MatrixMark> matrices;
    std::vector<std::string> notes;  // short lines in a corner of the picture: a formula with its numbers put in, a magnification

    void clear();  // marks only; the choices of the person stay

    // The numbers of the field being shown, one per row, if that field belongs to `on`; else none.
    std::vector<float> values(const Lesson& lesson, On on) const;

    void frame(const Position& lower_corner, const Position& upper_corner);
    void arrow(const Position& from, const Position& to, Ink ink, std::string label = "");
    void line(const Position& from, const Position& to, Ink ink, float width = 1.5f, bool dashed = false);
    void label(const Position& at, std::string text, Ink ink = Ink::text, float offset_x = 0, float offset_y = 0);
    // A dimension line with ticks at both ends and a label in its middle: "L = 2 m".
    void dimension_line(const Position& from, const Position& to, std::string text, float offset_x = 0, float offset_y = 0);
    // A matrix or a column of numbers, with its name and unit.
    template <class Derived>
    void matrix(std::string name, const Eigen::MatrixBase<Derived>& m, std::string unit = "", Ink ink = Ink::text) {
        MatrixMark mark{std::move(name), std::move(unit), static_cast<int>(m.rows()), static_cast<int>(m.cols()), {}, ink};
        for (Index i = 0; i < m.rows(); ++i)
            for (Index j = 0; j < m.cols(); ++j) mark.entries.push_back(m(i, j));
        matrices.push_back(std::move(mark));
    }
    // The twelve edges of a box (four of a rectangle when it is flat).
    void box(const Position& lower_corner, const Position& upper_corner, Ink ink, float width = 1.5f, bool dashed = false);
};

}  // namespace pliant
