#include <pliant/fluids/level_set.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace pliant {
namespace {

template <int Dim>
StaggeredGrid<Dim> box_of(const StaggeredGrid<Dim>& grid) {
    StaggeredGridInfo<Dim> info;
    info.cells = grid.cell_counts();
    info.dx = grid.dx();
    for (int a = 0; a < Dim; ++a) info.periodic[a] = grid.periodic(a);
    return StaggeredGrid<Dim>(info);
}

}  // namespace

template <int Dim>
LevelSet<Dim>::LevelSet(const StaggeredGrid<Dim>& grid)
    : box_(box_of(grid)),
      advection_(box_, {.interpolation = Interpolation::monotone_cubic}),
      distance_(VecX::Zero(grid.cells().size())),
      old_(distance_),
      fixed_(static_cast<std::size_t>(distance_.size())) {}

template <int Dim>
Index LevelSet<Dim>::beside(const Counts<Dim>& at, int axis, int step) const {
    const Index n = box_.cells().neighbour(at, axis, step);
    return n >= 0 && !solid(n) ? n : box_.cells().index(at);
}

template <int Dim>
void LevelSet<Dim>::advect(const FaceField<Dim>& velocity, Real dt) {
    advection_.advect(distance_, velocity, dt);
}

template <int Dim>
void LevelSet<Dim>::classify(std::vector<CellType>& types) const {
    types.resize(static_cast<std::size_t>(distance_.size()));
    for (Index c = 0; c < distance_.size(); ++c)
        types[c] = solid(c) ? CellType::solid : distance_[c] < 0 ? CellType::fluid : CellType::air;
}

// ---------------------------------------------------------------------------------------------------------- redistancing

template <int Dim>
void LevelSet<Dim>::redistance() {
    // Without a surface there is nothing to be distant from.
    if (distance_.minCoeff() >= 0 || distance_.maxCoeff() < 0) return;
    old_ = distance_;
    measure_beside_surface();
    // Every distance is final when a round of sweeps changes none.
    for (bool changed = true; changed;) {
        changed = false;
        for (int direction = 0; direction < (1 << Dim); ++direction) changed = sweep(direction) || changed;
    }
    extend_into_solids();
}

// The cells that have the surface between themselves and a neighbour keep φ, or get φ over its slope, for which the largest of
// the slopes to both sides and across counts; the others are far until a sweep reaches them. Through solids no distance is
// measured.
template <int Dim>
void LevelSet<Dim>::measure_beside_surface() {
    const Lattice<Dim>& cells = box_.cells();
    const Real far = std::numeric_limits<Real>::max();
    for (Index c = 0; c < old_.size(); ++c) {
        const Counts<Dim> at = cells.coordinates(c);
        const bool inside = old_[c] < 0;
        if (solid(c)) {
            fixed_[c] = 1;
            distance_[c] = far;
            continue;
        }
        bool crossed = false;
        Real square = 0;
        for (int a = 0; a < Dim; ++a) {
            const Real low = old_[beside(at, a, -1)], high = old_[beside(at, a, 1)];
            crossed = crossed || (low < 0) != inside || (high < 0) != inside;
            const Real slope =
                std::max({std::abs(high - low) / 2, std::abs(high - old_[c]), std::abs(old_[c] - low)}) / box_.dx();
            square += slope * slope;
        }
        fixed_[c] = crossed;
        const Real slope = std::sqrt(square);
        const bool sound = slope >= flattest && slope <= steepest;
        distance_[c] = !crossed ? (inside ? -far : far) : sound ? old_[c] : old_[c] / std::max(slope, Real(1e-6));
    }
}

namespace {

// A distance from the nearest ones along the axes: Σ max(0, d − d_a)² = Δx² [Zhao2005 §2].
template <std::size_t Dim>
Real distance_from(std::array<Real, Dim> nearest, Real dx) {
    std::sort(nearest.begin(), nearest.end());
    Real d = nearest[0] + dx, sum = nearest[0], squares = nearest[0] * nearest[0];
    for (std::size_t k = 1; k < Dim && d > nearest[k]; ++k) {
        sum += nearest[k];
        squares += nearest[k] * nearest[k];
        const auto count = static_cast<Real>(k + 1);
        const Real root = sum * sum - count * (squares - dx * dx);
        d = (sum + std::sqrt(std::max(root, Real(0)))) / count;
    }
    return d;
}

template <int Dim>
Index row_beside(const Lattice<Dim>& cells, const std::type_identity_t<Counts<Dim>>& at, int axis, int step) {
    const Index n = cells.neighbour(at, axis, step);
    return n >= 0 ? n : cells.index(at);
}

}  // namespace

// One pass over all cells; bit a of the direction says whether axis a is gone through downwards. Did it change anything?
template <int Dim>
bool LevelSet<Dim>::sweep(int direction) {
    const Lattice<Dim>& cells = box_.cells();
    const Index n = cells.count[0], rows = cells.rows();
    const bool wraps = cells.periodic(0);
    bool changed = false;
    for (Index k = 0; k < rows; ++k) {
        // The row with this number when the other axes are gone through in their directions, and the rows beside it.
        Counts<Dim> at{};
        Index rest = k;
        for (int a = 1; a < Dim; ++a) {
            const Index i = rest % cells.count[a];
            rest /= cells.count[a];
            at[a] = (direction >> a) & 1 ? cells.count[a] - 1 - i : i;
        }
        Real* row = distance_.data() + cells.index(at);
        const std::uint8_t* fixed = fixed_.data() + cells.index(at);
        std::array<const Real*, 2 * (Dim - 1)> rows_beside;
        for (int a = 1; a < Dim; ++a)
            for (int side = 0; side < 2; ++side)
                rows_beside[2 * (a - 1) + side] = distance_.data() + row_beside(cells, at, a, side ? 1 : -1);
        for (Index m = 0; m < n; ++m) {
            const Index i = direction & 1 ? n - 1 - m : m;
            if (fixed[i]) continue;
            const Index low = i > 0 ? i - 1 : wraps ? n - 1 : 0, high = i < n - 1 ? i + 1 : wraps ? 0 : i;
            std::array<Real, Dim> nearest{std::min(std::abs(row[low]), std::abs(row[high]))};
            for (int a = 1; a < Dim; ++a)
                nearest[a] = std::min(std::abs(rows_beside[2 * (a - 1)][i]), std::abs(rows_beside[2 * (a - 1) + 1][i]));
            const Real reached = distance_from(nearest, box_.dx());
            if (!(reached < std::abs(row[i]))) continue;
            row[i] = row[i] < 0 ? -reached : reached;
            changed = true;
        }
    }
    return changed;
}

template <int Dim>
void LevelSet<Dim>::extend_into_solids() {
    if (solids_.empty()) return;
    known_.resize(static_cast<std::size_t>(distance_.size()));
    for (Index c = 0; c < distance_.size(); ++c) known_[c] = solid(c) ? Known::no : Known::yes;
    extrapolation_.fill(box_.cells(), known_, distance_);
}

// ---------------------------------------------------------------------------------------------------------------- volume

template <int Dim>
Real filled_fraction(Real middle, const GridPlace<Dim>& slopes) {
    // Reflected so that all slopes rise, φ at the lower corner is −lowest; a plane that hardly tilts along an axis does not
    // depend on it.
    constexpr Real smallest_tilt = 1e-4;
    std::array<Real, Dim> m{};
    int count = 0;
    Real largest = 0, total = 0;
    for (const Real slope : slopes) largest = std::max(largest, std::abs(slope));
    if (largest == 0) return middle < 0 ? 1 : 0;
    for (const Real slope : slopes)
        if (std::abs(slope) > smallest_tilt * largest) m[count++] = std::abs(slope), total += std::abs(slope);
    const Real alpha = total / 2 - middle;
    if (alpha <= 0) return 0;
    if (alpha >= total) return 1;

    // Inclusion and exclusion over the corners: Σ ± max(0, α − Σ m)^n / (n! Π m) [ScardovelliZaleski2000 §2].
    Real sum = 0, scale = 1;
    for (int a = 0; a < count; ++a) scale *= m[a] * (a + 1);
    for (int corner = 0; corner < (1 << count); ++corner) {
        Real beyond = alpha, sign = 1;
        for (int a = 0; a < count; ++a)
            if ((corner >> a) & 1) beyond -= m[a], sign = -sign;
        if (beyond <= 0) continue;
        Real power = sign;
        for (int a = 0; a < count; ++a) power *= beyond;
        sum += power;
    }
    return std::clamp(sum / scale, Real(0), Real(1));
}

template <int Dim>
Index LevelSet<Dim>::full_cells(std::vector<Crossed>& crossed) const {
    const Lattice<Dim>& cells = box_.cells();
    crossed.clear();
    Index full = 0;
    for (Index c = 0; c < distance_.size(); ++c) {
        if (solid(c)) continue;
        // No plane of slope 1 reaches a cell from farther away than half its diagonal and the shift.
        if (std::abs(distance_[c]) > (Dim + 1) * box_.dx()) {
            full += distance_[c] < 0;
            continue;
        }
        const Counts<Dim> at = cells.coordinates(c);
        Crossed cell{distance_[c], {}};
        for (int a = 0; a < Dim; ++a) cell.slopes[a] = (distance_[beside(at, a, 1)] - distance_[beside(at, a, -1)]) / 2;
        crossed.push_back(cell);
    }
    return full;
}

template <int Dim>
Real LevelSet<Dim>::volume() const {
    Real sum = static_cast<Real>(full_cells(crossed_));
    for (const Crossed& c : crossed_) sum += filled_fraction<Dim>(c.middle, c.slopes);
    return sum * box_.cell_volume();
}

template <int Dim>
Real LevelSet<Dim>::shift_to_volume(Real target) {
    if (distance_.minCoeff() >= 0 || distance_.maxCoeff() < 0) return 0;
    const Index full = full_cells(crossed_);
    const auto volume_shifted = [&](Real shift) {
        Real sum = static_cast<Real>(full);
        for (const Crossed& c : crossed_) sum += filled_fraction<Dim>(c.middle - shift, c.slopes);
        return sum * box_.cell_volume();
    };
    // The volume grows with the shift: bisection within a cell, which no single step exceeds.
    Real low = -box_.dx(), high = box_.dx();
    if (volume_shifted(low) >= target)
        high = low;
    else if (volume_shifted(high) <= target)
        low = high;
    for (int k = 0; k < 40 && low < high; ++k) {
        const Real middle = (low + high) / 2;
        (volume_shifted(middle) < target ? low : high) = middle;
    }
    const Real shift = (low + high) / 2;
    distance_.array() -= shift;
    return shift;
}

Real surface_crossing(Real distance_in_fluid, Real distance_in_air, Real smallest) {
    const Real whole = distance_in_air - distance_in_fluid;
    if (!(whole > 0)) return 1;
    return std::clamp(-distance_in_fluid / whole, smallest, Real(1));
}

template <int Dim>
SurfaceFractions<Dim> surface_fractions(const StaggeredGrid<Dim>& grid, const VecX& distance) {
    SurfaceFractions<Dim> fractions;
    for (int a = 0; a < Dim; ++a) {
        const std::vector<Index>& faces = grid.surface_faces(a);
        fractions[a].resize(static_cast<Index>(faces.size()));
        for (std::size_t k = 0; k < faces.size(); ++k) {
            Index fluid = grid.cell_beside(a, faces[k], 0), air = grid.cell_beside(a, faces[k], 1);
            if (!grid.is_fluid(fluid)) std::swap(fluid, air);
            fractions[a][static_cast<Index>(k)] = surface_crossing(distance[fluid], distance[air]);
        }
    }
    return fractions;
}

template class LevelSet<2>;
template class LevelSet<3>;
template SurfaceFractions<2> surface_fractions(const StaggeredGrid<2>&, const VecX&);
template SurfaceFractions<3> surface_fractions(const StaggeredGrid<3>&, const VecX&);
template Real filled_fraction<2>(Real, const GridPlace<2>&);
template Real filled_fraction<3>(Real, const GridPlace<3>&);

}  // namespace pliant
