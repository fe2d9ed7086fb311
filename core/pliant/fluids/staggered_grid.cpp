#include <fmt/format.h>
#include <pliant/fluids/staggered_grid.h>
#include <pliant/math/error.h>

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

void check_types(const std::vector<CellType>& types, Index cells) {
    if (!types.empty() && static_cast<Index>(types.size()) != cells)
        throw Refused("types", static_cast<Real>(types.size()), "",
                      fmt::format("one type for each of the {} cells, or none", cells));
}

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
    check_types(info.types, cells);
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
    lay_out();
    find_faces();
}

template <int Dim>
void StaggeredGrid<Dim>::set_types(const std::vector<CellType>& types) {
    check_types(types, cells_.size());
    info_.types = types;
    find_faces();
}

template <int Dim>
void StaggeredGrid<Dim>::find_faces() {
    // A map of nothing but fluid is the plain box.
    std::vector<CellType>& types = info_.types;
    const auto count = [&](CellType type) { return std::count(types.begin(), types.end(), type); };
    if (count(CellType::fluid) == static_cast<std::ptrdiff_t>(types.size())) types.clear();
    fluid_cells_ = has_gaps() ? count(CellType::fluid) : cells_.size();
    has_air_ = count(CellType::air) > 0;
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
    closed_[axis].clear();
    beside_closed_[axis].clear();
    surface_[axis].clear();
    if (has_gaps())
        openness_[axis].setOnes(lattice.size());
    else
        openness_[axis].resize(0);
    for (Index face = 0; face < lattice.size(); ++face) {
        const Index at = lattice.coordinates(face)[axis];
        const bool on_wall = !info_.periodic[axis] && (at == 0 || at == info_.cells[axis]);
        if (!on_wall && !has_gaps()) continue;
        int fluid = 0, barriers = 0;
        for (int side = 0; side < 2; ++side) {
            const Index cell = cell_beside(axis, face, side);
            fluid += cell >= 0 && is_fluid(cell);
            barriers += cell < 0 || type(cell) == CellType::solid;
        }
        if (fluid == 1 && barriers == 0) surface_[axis].push_back(face);
        if (fluid > 0 && barriers == 0) continue;
        closed_[axis].push_back(face);
        beside_closed_[axis].push_back(static_cast<std::uint8_t>(fluid));
        if (has_gaps()) openness_[axis][face] = 0;
    }
}

template <int Dim>
bool StaggeredGrid<Dim>::beside_solid(int axis, Index face) const {
    for (int side = 0; side < 2; ++side) {
        const Index cell = cell_beside(axis, face, side);
        if (cell >= 0 && type(cell) == CellType::solid) return true;
    }
    return false;
}

template <int Dim>
bool StaggeredGrid<Dim>::prescribed(int axis, Index face) const {
    int solid = 0, wall = 0;
    for (int side = 0; side < 2; ++side) {
        const Index cell = cell_beside(axis, face, side);
        wall += cell < 0;
        solid += cell >= 0 && type(cell) == CellType::solid;
    }
    // Along the faces inside a solid the fluid may slide.
    if (solid == 2) return info_.solid_slip == Slip::none;
    return wall + solid > 0;
}

template <int Dim>
Real StaggeredGrid<Dim>::prescribed_value(int axis, Index face) const {
    // A solid cell next to a wall shields the fluid from the wall's motion.
    if (beside_solid(axis, face)) {
        if (!info_.solid_velocity) return 0;
        const GridPlace<Dim> place = faces_[axis].place(faces_[axis].coordinates(face));
        Vec<Dim> x;
        for (int a = 0; a < Dim; ++a) x[a] = place[a] * info_.dx;
        return info_.solid_velocity(x)[axis];
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
        for (Index face : closed_[a])
            if (prescribed(a, face)) velocity[a][face] = prescribed_value(a, face);
}

template class StaggeredGrid<2>;
template class StaggeredGrid<3>;

}  // namespace pliant
