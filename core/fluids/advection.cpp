#include <pliant/fluids/advection.h>

namespace pliant {
namespace {

template <int Dim>
std::array<const Real*, Dim> pointers(const AxisArrays<Dim>& arrays) {
    std::array<const Real*, Dim> data;
    for (int a = 0; a < Dim; ++a) data[a] = arrays[a].data();
    return data;
}

}  // namespace

template <int Dim>
SemiLagrangian<Dim>::SemiLagrangian(const StaggeredGrid<Dim>& grid) : grid_(grid), flow_(grid), quantity_(grid.cells()) {
    const Index longest = grid.cell_counts()[0] + 1;
    ramp_ = VecX::LinSpaced(longest, 0, static_cast<Real>(longest - 1));
    for (int a = 0; a < Dim; ++a) place_[a] = speed_[a] = VecX::Zero(longest);
}

template <int Dim>
void SemiLagrangian<Dim>::advect(FaceField<Dim>& velocity, Real dt) {
    flow_.set(velocity);
    for (int a = 0; a < Dim; ++a) advect_component(a, dt / grid_.dx(), velocity[a]);
}

template <int Dim>
void SemiLagrangian<Dim>::advect_component(int axis, Real cells_per_speed, VecX& out) {
    const Lattice<Dim>& lattice = grid_.faces(axis);
    const bool walled = !grid_.periodic(axis);
    const Index n = lattice.count[0];
    for_each_row(lattice, [&](Index start, const Counts<Dim>& at) {
        // A row of faces on a wall is closed; so are the ends of a row that runs from wall to wall.
        if (walled && axis != 0 && (at[axis] == 0 || at[axis] == lattice.count[axis] - 1)) return;
        velocity_at_faces(axis, at);
        trace_back(lattice.place(at), n, cells_per_speed);
        VecX& arrived = speed_[0];
        flow_.component(axis).at(pointers(place_), n, arrived.data());
        const Index first = walled && axis == 0 ? 1 : 0, open = n - 2 * first;
        auto row = out.segment(start + first, open);
        const auto carried = arrived.segment(first, open);
        if (grid_.has_solids())
            row += grid_.openness(axis).segment(start + first, open).cwiseProduct(carried - row);
        else
            row = carried;
    });
}

// The whole velocity at a row of faces across `axis`: its own component, and of each other component the mean of the four
// faces around.
template <int Dim>
void SemiLagrangian<Dim>::velocity_at_faces(int axis, const Counts<Dim>& at) {
    const Index n = grid_.faces(axis).count[0];
    for (int b = 0; b < Dim; ++b) {
        const PaddedField<Dim>& component = flow_.component(b);
        const Real* corner = component.data() + component.position(at);
        const auto row = [&](Index offset) { return Eigen::Map<const VecX>(corner + offset, n); };
        const Index back = -component.stride(axis), up = component.stride(b);
        if (b == axis)
            speed_[b].head(n) = row(0);
        else
            speed_[b].head(n) = Real(0.25) * ((row(0) + row(back)) + (row(up) + row(up + back)));
    }
}

// Takes the row of particles that starts at `first` with the velocity speed_ to where it was one step ago, into place_: the
// midpoint rule, the second-order Runge-Kutta method [Bridson2007 §3.2].
template <int Dim>
void SemiLagrangian<Dim>::trace_back(const GridPlace<Dim>& first, Index n, Real cells_per_speed) {
    step_back(first, n, Real(0.5) * cells_per_speed);
    for (int a = 0; a < Dim; ++a) flow_.component(a).at(pointers(place_), n, speed_[a].data());
    step_back(first, n, cells_per_speed);
}

template <int Dim>
void SemiLagrangian<Dim>::step_back(const GridPlace<Dim>& first, Index n, Real cells_per_speed) {
    for (int a = 0; a < Dim; ++a) {
        const auto travelled = cells_per_speed * speed_[a].head(n).array();
        auto x = place_[a].head(n).array();
        if (a == 0)
            flow_.confine(a, (ramp_.head(n).array() + first[0]) - travelled, x);
        else
            flow_.confine(a, first[a] - travelled, x);
    }
}

template <int Dim>
void SemiLagrangian<Dim>::advect(VecX& quantity, const FaceField<Dim>& velocity, Real dt) {
    flow_.set(velocity);
    quantity_.fill(quantity);
    const Lattice<Dim>& cells = grid_.cells();
    const Index n = cells.count[0];
    for_each_row(cells, [&](Index start, const Counts<Dim>& at) {
        // At a cell centre the velocity is the mean of the two faces across each axis.
        for (int b = 0; b < Dim; ++b) {
            const PaddedField<Dim>& component = flow_.component(b);
            const Real* low = component.data() + component.position(at);
            speed_[b].head(n) =
                Real(0.5) * (Eigen::Map<const VecX>(low, n) + Eigen::Map<const VecX>(low + component.stride(b), n));
        }
        trace_back(cells.place(at), n, dt / grid_.dx());
        quantity_.at(pointers(place_), n, speed_[0].data());
        for (Index i = 0; i < n; ++i)
            if (grid_.is_fluid(start + i)) quantity[start + i] = speed_[0][i];
    });
}

template class SemiLagrangian<2>;
template class SemiLagrangian<3>;

}  // namespace pliant
