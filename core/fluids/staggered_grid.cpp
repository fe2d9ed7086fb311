#include <fmt/format.h>
#include <pliant/fluids/staggered_grid.h>
#include <pliant/math/error.h>

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

template <int Dim>
void check(const StaggeredGridInfo<Dim>& info) {
    if (!(info.dx > 0) || !std::isfinite(info.dx)) throw Refused("dx", info.dx, "m", "a finite cell size above 0");
    Index cells = 1;
    for (int a = 0; a < Dim; ++a) {
        const Index n = info.cells[a];
        if (n < 1) throw Refused(fmt::format("cells[{}]", a), static_cast<Real>(n), "", "at least 1");
        cells *= n;
        for (int side = 0; side < 2; ++side) {
            const Vec<Dim>& v = info.walls[a][side].velocity;
            for (int b = 0; b < Dim; ++b)
                if (!std::isfinite(v[b]))
                    throw Refused(fmt::format("walls[{}][{}].velocity[{}]", a, side, b), v[b], "m/s", "a finite number");
        }
    }
    if (!info.types.empty() && static_cast<Index>(info.types.size()) != cells)
        throw Refused("types", static_cast<Real>(info.types.size()), "",
                      fmt::format("one type for each of the {} cells, or none", cells));
}

// What the component across `axis` meets beyond the walls of axis `along`.
template <int Dim>
std::array<LatticeSide, 2> sides_of_component(const StaggeredGridInfo<Dim>& info, int axis, int along) {
    if (info.periodic[along]) return {LatticeSide{Beyond::periodic}, LatticeSide{Beyond::periodic}};
    if (along == axis) return {LatticeSide{Beyond::held}, LatticeSide{Beyond::held}};
    std::array<LatticeSide, 2> sides;
    for (int side = 0; side < 2; ++side) {
        const Wall<Dim>& wall = info.walls[along][side];
        if (wall.slip == Slip::none) sides[side] = {Beyond::wall_value, wall.velocity[axis]};
    }
    return sides;
}

}  // namespace

template <int Dim>
StaggeredGrid<Dim>::StaggeredGrid(StaggeredGridInfo<Dim> info) : info_(std::move(info)) {
    check(info_);
    // A map without a single solid cell is the plain box.
    if (std::all_of(info_.types.begin(), info_.types.end(), [](CellType t) { return t == CellType::fluid; })) info_.types.clear();
    lay_out();
    fluid_cells_ = has_solids() ? std::count(info_.types.begin(), info_.types.end(), CellType::fluid) : cells_.size();
    for (int a = 0; a < Dim; ++a) find_closed_faces(a);
}

template <int Dim>
void StaggeredGrid<Dim>::lay_out() {
    cells_.count = info_.cells;
    cells_.offset.fill(0.5);
    for (int a = 0; a < Dim; ++a) {
        const Beyond beyond = info_.periodic[a] ? Beyond::periodic : Beyond::zero_gradient;
        cells_.sides[a] = {LatticeSide{beyond}, LatticeSide{beyond}};
        faces_[a].count = info_.cells;
        if (!info_.periodic[a]) faces_[a].count[a] += 1;
        faces_[a].offset.fill(0.5);
        faces_[a].offset[a] = 0;
        for (int b = 0; b < Dim; ++b) faces_[a].sides[b] = sides_of_component(info_, a, b);
    }
}

template <int Dim>
Real StaggeredGrid<Dim>::cell_volume() const {
    Real volume = 1;
    for (int a = 0; a < Dim; ++a) volume *= info_.dx;
    return volume;
}

template <int Dim>
Index StaggeredGrid<Dim>::cell_beside(int axis, Index face, int side) const {
    Counts<Dim> at = faces_[axis].coordinates(face);
    if (side == 0) at[axis] -= 1;
    if (at[axis] < 0) {
        if (!info_.periodic[axis]) return -1;
        at[axis] += info_.cells[axis];
    }
    return at[axis] < info_.cells[axis] ? cells_.index(at) : -1;
}

template <int Dim>
void StaggeredGrid<Dim>::find_closed_faces(int axis) {
    const Lattice<Dim>& lattice = faces_[axis];
    if (has_solids()) openness_[axis] = VecX::Ones(lattice.size());
    for (Index face = 0; face < lattice.size(); ++face) {
        const Index at = lattice.coordinates(face)[axis];
        const bool on_wall = !info_.periodic[axis] && (at == 0 || at == info_.cells[axis]);
        if (!on_wall && !has_solids()) continue;
        int fluid = 0;
        for (int side = 0; side < 2; ++side) {
            const Index cell = cell_beside(axis, face, side);
            fluid += cell >= 0 && is_fluid(cell);
        }
        if (fluid == 2) continue;
        closed_[axis].push_back(face);
        beside_closed_[axis].push_back(static_cast<std::uint8_t>(fluid));
        if (has_solids()) openness_[axis][face] = 0;
    }
}

template <int Dim>
Real StaggeredGrid<Dim>::closed_value(int axis, Index face) const {
    // A solid cell next to a wall shields the fluid from the wall's motion.
    for (int side = 0; side < 2; ++side) {
        const Index cell = cell_beside(axis, face, side);
        if (cell >= 0 && !is_fluid(cell)) return 0;
    }
    const bool high = faces_[axis].coordinates(face)[axis] != 0;
    return info_.walls[axis][high ? 1 : 0].velocity[axis];
}

template <int Dim>
FaceField<Dim> StaggeredGrid<Dim>::zero_velocity() const {
    FaceField<Dim> velocity;
    for (int a = 0; a < Dim; ++a) velocity[a] = VecX::Zero(faces_[a].size());
    return velocity;
}

template <int Dim>
void StaggeredGrid<Dim>::impose_walls(FaceField<Dim>& velocity) const {
    for (int a = 0; a < Dim; ++a)
        for (Index face : closed_[a]) velocity[a][face] = closed_value(a, face);
}

template class StaggeredGrid<2>;
template class StaggeredGrid<3>;

}  // namespace pliant
