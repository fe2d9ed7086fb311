// How the numbers on a staggered grid came about, in the words of every lesson that has one. Their fields are called u_on_faces,
// v_on_faces, velocity, speed, pressure, divergence_before and divergence_after.
#pragma once
#include <pliant/fluids/samples_beyond.h>
#include <pliant/fluids/velocity_sampler.h>
#include <pliant/lesson/lesson.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace pliant::grid2d {

// Of the formulas of such a lesson: places, cells and the time step, viscosity.
inline std::vector<Symbol> symbols_and(std::vector<Symbol> own) {
    own.insert(own.end(), {{"x", "m"}, {"Δx", "m"}, {"Δt", "s"}, {"ν", "m²/s"}});
    return own;
}

inline constexpr std::array<std::string_view, 2> face_fields{"u_on_faces", "v_on_faces"};
inline std::string_view face_field(int axis) { return face_fields[static_cast<std::size_t>(axis)]; }
inline int axis_of(std::string_view field) { return field == face_fields[0] ? 0 : 1; }

// One number of a field as it stood before the stage or as it stands now.
Input sample(std::string symbol, Input::From from, std::string_view field, Index index);
// The same, or what a wall makes of it one step beyond.
Input sample(std::string symbol, Input::From from, std::string_view field, const SampleBeyond& s);

// A number that a face on a wall or a solid keeps.
Explanation kept_by_wall(int axis, Index face);

// The four samples around a place, in cells from the corner of the domain.
struct Surrounding {
    Counts<2> corner;  // the lower left sample; may lie one step beyond the lattice
    std::array<Real, 2> fraction;
};
Surrounding surrounding(const Lattice<2>& lattice, const GridPlace<2>& place);

// left = Σ w q_k over the four samples around a place in a field, before the stage if nothing else is said. where: "the four
// samples around the place".
Explanation interpolated(const std::string& left, const Lattice<2>& lattice, std::string_view field, const GridPlace<2>& place,
                         Input::From from = Input::From::before, std::string_view where = "the four samples around the place");

// A free surface: its signed distance, the field `distance`, and whether p = 0 lies on it or in the middle of the cells of air.
struct Surface {
    const VecX* distance = nullptr;  // m, per cell; none: no surface
    bool exact = true;
};

class GridWhy {
public:
    // Keeps a reference to the grid. dt: the time step, as it stands in formulas.
    GridWhy(const StaggeredGrid<2>& grid, Input dt, Surface surface = {}) : grid_(grid), dt_(std::move(dt)), surface_(surface) {}

    bool closed(int axis, Index face) const;
    Input dx() const;

    // viscosity: m²/s, with the symbol ν.
    Input diffusion_number(Input viscosity) const;
    // residual: of the implicit solver, m/s; none for the explicit scheme.
    Explanation diffused(Input viscosity, const VecX* residual, int axis, Index face) const;

    Explanation divergence(Index cell, Input::From from) const;
    // The row of the pressure equation that belongs to the cell, solved for its own pressure. What the solver has not removed
    // yet is the divergence that is left.
    Explanation pressure(Index cell) const;
    // During the solver's passes: what the pressure so far would leave.
    Explanation remaining_divergence(Index cell) const;
    Explanation projected(int axis, Index face) const;
    // Any of the numbers that the stage of the projection writes; none for a velocity before its solver has converged.
    std::optional<Explanation> projection(const Question& q, bool converged) const;

    Explanation cell_velocity(Index cell, int component) const;
    Explanation speed(Index cell) const;
    Explanation vorticity(Index cell) const;
    Explanation courant(const FaceField<2>& velocity) const;

private:
    // What stands around a cell in its row of the pressure equation: p of the fluid beside it, and the weight of each way to the
    // air.
    struct Row {
        std::vector<Input> pressures, weights;
        std::string diagonal() const;  // "4", "3 + w_above"
        std::string sum() const;       // "p_left + p_right", "0"
        std::vector<Input> inputs(std::vector<Input> others = {}) const;
    };
    Row row_of(Index cell) const;
    Explanation part_of_way(Index fluid, Index air) const;

    const StaggeredGrid<2>& grid_;
    Input dt_;
    Surface surface_;
};

// The largest magnitude in a field, with the cell where it is reached.
Explanation largest(std::string_view name, const VecX& values, std::string_view field);

}  // namespace pliant::grid2d
