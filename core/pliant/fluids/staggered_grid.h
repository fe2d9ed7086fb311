// The staggered (marker-and-cell) grid: pressure at cell centres, one velocity component on the faces across each axis
// [HarlowWelch1965; Bridson2007].
#pragma once
#include <pliant/fluids/lattice.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace pliant {

enum class CellType : std::uint8_t { fluid, solid, air };

// Does the fluid slide along a wall, or stick to it?
enum class Slip { free, none };

template <int Dim>
struct Wall {
    Slip slip = Slip::free;
    Vec<Dim> velocity = Vec<Dim>::Zero();  // m/s; the normal part is imposed on the wall's faces, the rest where slip is none
};

// The velocity: one array per axis, each entry the component along that axis on one face, m/s.
template <int Dim>
using FaceField = AxisArrays<Dim>;

template <int Dim>
struct StaggeredGridInfo {
    Counts<Dim> cells{};                                // at least 1 along each axis
    Real dx = 1;                                        // edge of a cell, m
    std::array<bool, Dim> periodic{};                   // along which axes the domain closes onto itself
    std::array<std::array<Wall<Dim>, 2>, Dim> walls{};  // [axis][0: low, 1: high], for the axes that are not periodic
    std::vector<CellType> types{};                      // one per cell; empty: all fluid
    Slip solid_slip = Slip::none;                       // does the fluid stick to the solid cells or slide along them?
    // Velocity of the solid cells, m/s, at a place in metres from the corner of the domain; none: at rest.
    std::function<Vec<Dim>(const Vec<Dim>&)> solid_velocity{};
};

// Which cells are fluid, which faces are open, and how every array of the solver is laid out. A walled axis of n cells has
// n + 1 faces across it, a periodic one n. A face is open when fluid lies on one side and no wall or solid on the other; no stage
// changes the value on a closed face. It belongs to the wall or the solid, and impose_walls() sets it; between cells of air, and
// inside solids that the fluid slides along, it continues the fluid's velocity, see extrapolate_velocity().
template <int Dim>
class StaggeredGrid {
public:
    // Throws Refused for a size below 1, a dx that is not positive and finite, a wall velocity that is not finite, or
    // types whose count is not the number of cells.
    explicit StaggeredGrid(StaggeredGridInfo<Dim> info);

    // The fluid or the solids have moved. types: one per cell, or none for a box full of fluid. Throws as the constructor does.
    void set_types(const std::vector<CellType>& types);

    const Counts<Dim>& cell_counts() const { return info_.cells; }
    Real dx() const { return info_.dx; }
    Real cell_volume() const;  // m^Dim
    bool periodic(int axis) const { return info_.periodic[axis]; }
    const Wall<Dim>& wall(int axis, int side) const { return info_.walls[axis][side]; }

    // Cell centres; beyond a wall a quantity keeps its value.
    const Lattice<Dim>& cells() const { return cells_; }
    // Faces across `axis`; beyond a wall along another axis the component mirrors (free slip) or meets the wall's (no slip).
    const Lattice<Dim>& faces(int axis) const { return faces_[axis]; }

    // Is there a cell that is not fluid?
    bool has_gaps() const { return !info_.types.empty(); }
    bool has_air() const { return has_air_; }
    CellType type(Index cell) const { return info_.types.empty() ? CellType::fluid : info_.types[cell]; }
    bool is_fluid(Index cell) const { return type(cell) == CellType::fluid; }
    Index fluid_cells() const { return fluid_cells_; }

    // The cell below (side 0) or above (side 1) a face, or -1 beyond a wall.
    Index cell_beside(int axis, Index face, int side) const;
    // The closed faces across `axis`, ascending, and how many fluid cells touch each: 0 or 1.
    const std::vector<Index>& closed_faces(int axis) const { return closed_[axis]; }
    const std::vector<std::uint8_t>& fluid_beside_closed(int axis) const { return beside_closed_[axis]; }
    // The open faces across `axis` between fluid and air, ascending.
    const std::vector<Index>& surface_faces(int axis) const { return surface_[axis]; }
    // Does the value on a closed face belong to a wall or a solid?
    bool prescribed(int axis, Index face) const;
    // 1 on open faces and 0 on closed ones; empty where the grid has no solid cells, since then only walls are closed.
    const VecX& openness(int axis) const { return openness_[axis]; }

    FaceField<Dim> zero_velocity() const;
    // Writes the velocity of the walls and of the solids onto the faces that belong to them.
    void impose_walls(FaceField<Dim>& velocity) const;

private:
    void lay_out();
    void find_faces();
    void find_closed_faces(int axis);
    bool beside_solid(int axis, Index face) const;
    Real prescribed_value(int axis, Index face) const;

    StaggeredGridInfo<Dim> info_;
    Lattice<Dim> cells_;
    std::array<Lattice<Dim>, Dim> faces_;
    std::array<std::vector<Index>, Dim> closed_, surface_;
    std::array<std::vector<std::uint8_t>, Dim> beside_closed_;
    std::array<VecX, Dim> openness_;
    Index fluid_cells_ = 0;
    bool has_air_ = false;
};

// Where the surface of the fluid crosses the way between the centres of the cells beside its surface_faces(), as a part of that
// way from the fluid, in (0, 1]; one array per axis, in the order of the faces.
template <int Dim>
using SurfaceFractions = AxisArrays<Dim>;

extern template class StaggeredGrid<2>;
extern template class StaggeredGrid<3>;

}  // namespace pliant
