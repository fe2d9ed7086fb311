#include <pliant/fluids/advection.h>
#include <pliant/fluids/parallel_rows.h>

#include <algorithm>

namespace pliant {
namespace {

// The velocity at the samples of one row: the faces across Axis, or the cell centres for Axis = -1. A component that is stored
// elsewhere is the mean of the two or four samples around.
template <int Dim, int Axis>
class RowVelocity {
public:
    RowVelocity(const VelocitySampler<Dim>& flow, const Counts<Dim>& row) {
        for (int b = 0; b < Dim; ++b) {
            const PaddedField<Dim>& component = flow.component(b);
            first_[b] = component.data() + component.position(row);
            up_[b] = component.stride(b);
            if constexpr (Axis >= 0) before_[b] = -component.stride(Axis);
        }
    }

    [[gnu::always_inline]] PlacePair<Dim> at(Index i) const {
        return for_axes<Dim>([&](auto b) -> Pair {
            const auto samples = [&](Index offset) { return load_pair(first_[b] + i + offset); };
            if constexpr (Axis < 0)
                return Real(0.5) * (samples(0) + samples(up_[b]));
            else if constexpr (b == Axis)
                return samples(0);
            else
                return Real(0.25) * ((samples(0) + samples(before_[b])) + (samples(up_[b]) + samples(up_[b] + before_[b])));
        });
    }

private:
    std::array<const Real*, Dim> first_;
    Counts<Dim> up_{}, before_{};
};

template <int Dim>
Index longest_row(const StaggeredGrid<Dim>& grid) {
    return grid.cell_counts()[0] + 1;
}

}  // namespace

template <int Dim>
SemiLagrangian<Dim>::SemiLagrangian(const StaggeredGrid<Dim>& grid, AdvectionSettings settings)
    : grid_(grid), settings_(settings), flow_(grid, settings.interpolation), quantity_(grid.cells(), settings.interpolation) {
    if (!settings.mac_cormack) return;
    Index most = grid.cells().size();
    for (int a = 0; a < Dim; ++a) {
        forward_.emplace_back(grid.faces(a), settings.interpolation);
        most = std::max(most, grid.faces(a).size());
    }
    forward_.emplace_back(grid.cells(), settings.interpolation);
    low_ = high_ = VecX::Zero(most);
}

// ------------------------------------------------------------------------------------------------------------- the path

template <int Dim>
[[gnu::always_inline]] inline PlacePair<Dim> SemiLagrangian<Dim>::stepped_back(const PlacePair<Dim>& arrival,
                                                                               const PlacePair<Dim>& speed,
                                                                               Real cells_per_speed) const {
    return for_axes<Dim>([&](auto a) { return arrival[a] - cells_per_speed * speed[a]; });
}

template <int Dim>
Departure<Dim> SemiLagrangian<Dim>::departure(const GridPlace<Dim>& arrival, Real dt) const {
    const auto both = VelocitySampler<Dim>::both;
    const auto one = [](const PlacePair<Dim>& x) { return PaddedField<Dim>::lane(x, 0); };
    const Real cells_per_speed = dt / grid_.dx();
    const auto back = [&](const GridPlace<Dim>& speed, Real step) { return one(stepped_back(both(arrival), both(speed), step)); };
    Departure<Dim> d;
    d.arrival = d.free_middle = d.middle = arrival;
    if (settings_.trace == BackTrace::midpoint) {
        d.free_middle = back(flow_.at(arrival), Real(0.5) * cells_per_speed);
        d.middle = flow_.confined(d.free_middle);
    }
    d.free_departure = back(flow_.at(d.middle), cells_per_speed);
    d.departure = flow_.confined(d.free_departure);
    return d;
}

// In short passes over the row, so that no particle waits for another.
template <int Dim>
template <int Axis>
void SemiLagrangian<Dim>::trace_row(const Lattice<Dim>& lattice, const Counts<Dim>& row, Real dt, Particles& p) const {
    const Index n = lattice.count[0];
    const auto places = for_axes<Dim>([&](auto a) { return p.place[a].data(); });
    const auto step_back = [&](Real cells_per_speed, const auto& speed) {
        PlacePair<Dim> arrival = VelocitySampler<Dim>::both(lattice.place(row));
        arrival[0] = arrival[0] + Pair{0, 1};
        for (Index i = 0; i < n; i += 2, arrival[0] = arrival[0] + 2) {
            const PlacePair<Dim> x = flow_.confined(stepped_back(arrival, speed(i), cells_per_speed));
            for_axes<Dim>([&](auto a) { return store_pair(places[a] + i, x[a]), 0; });
        }
    };
    const bool midpoint = settings_.trace == BackTrace::midpoint;
    const Real whole = dt / grid_.dx();
    const RowVelocity<Dim, Axis> at_arrival(flow_, row);
    step_back(midpoint ? Real(0.5) * whole : whole, [&](Index i) { return at_arrival.at(i); });
    if (!midpoint) return;
    const auto speeds = for_axes<Dim>([&](auto a) { return p.speed[a].data(); });
    for (int a = 0; a < Dim; ++a)
        flow_.component(a).at(for_axes<Dim>([&](auto b) -> const Real* { return places[b]; }), n, speeds[a]);
    step_back(whole, [&](Index i) { return for_axes<Dim>([&](auto a) { return load_pair(speeds[a] + i); }); });
}

// ----------------------------------------------------------------------------------------- interpolation and correction

template <int Dim>
void SemiLagrangian<Dim>::interpolate_row(const PaddedField<Dim>& field, Index n, Particles& p) const {
    if (settings_.interpolation == Interpolation::linear)
        field.at(for_axes<Dim>([&](auto a) { return static_cast<const Real*>(p.place[a].data()); }), n, p.row.data());
    else
        for (Index i = 0; i < n; ++i) p.row[i] = field.cubic_at(for_axes<Dim>([&](auto a) { return p.place[a][i]; }));
}

template <int Dim>
void SemiLagrangian<Dim>::make_particles() {
    while (static_cast<int>(particles_.size()) < threads()) {
        Particles p{{}, {}, VecX::Zero(longest_row(grid_) + 1)};  // of whole pairs
        for (int a = 0; a < Dim; ++a) p.place[a] = p.speed[a] = p.row;
        particles_.push_back(std::move(p));
    }
}

template <int Dim>
template <int Axis>
void SemiLagrangian<Dim>::carry(const PaddedField<Dim>& old, VecX& out, Real dt) {
    const Lattice<Dim>& lattice = old.lattice();
    const Index n = lattice.count[0];
    make_particles();
    parallel_for_each_row(lattice, [&](Index start, const Counts<Dim>& at, int thread) {
        Particles& p = particles_[static_cast<std::size_t>(thread)];
        trace_row<Axis>(lattice, at, dt, p);
        interpolate_row(old, n, p);
        if (settings_.mac_cormack)
            for (Index i = 0; i < n; ++i) {
                const auto [low, high] = old.range_around(for_axes<Dim>([&](auto a) { return p.place[a][i]; }));
                low_[start + i] = low;
                high_[start + i] = high;
            }
        write_row<Axis>(start, at, p.row, out);
    });
}

// q′ = q̂ + ½ (q − q̃) within the samples around the departure, where q̂ is `out` and q̃ is q̂ carried back again.
template <int Dim>
template <int Axis>
void SemiLagrangian<Dim>::correct(const PaddedField<Dim>& old, VecX& out, Real dt) {
    if (!settings_.mac_cormack) return;
    const Lattice<Dim>& lattice = old.lattice();
    PaddedField<Dim>& forward = forward_[static_cast<std::size_t>(Axis < 0 ? Dim : Axis)];
    forward.fill(out);
    const Index n = lattice.count[0];
    make_particles();
    parallel_for_each_row(lattice, [&](Index start, const Counts<Dim>& at, int thread) {
        Particles& p = particles_[static_cast<std::size_t>(thread)];
        trace_row<Axis>(lattice, at, -dt, p);
        interpolate_row(forward, n, p);
        const auto before = Eigen::Map<const VecX>(old.data() + old.position(at), n);
        auto row = p.row.head(n);
        row = out.segment(start, n) + Real(0.5) * (before - row);
        row = row.cwiseMax(low_.segment(start, n)).cwiseMin(high_.segment(start, n));
        write_row<Axis>(start, at, p.row, out);
    });
}

// Takes over the values of a row, except on closed faces and in solid cells.
template <int Dim>
template <int Axis>
void SemiLagrangian<Dim>::write_row(Index start, const Counts<Dim>& at, const VecX& values, VecX& out) const {
    if constexpr (Axis < 0) {
        const Index n = grid_.cells().count[0];
        if (!grid_.has_gaps())
            out.segment(start, n) = values.head(n);
        else
            for (Index i = 0; i < n; ++i)
                if (grid_.is_fluid(start + i)) out[start + i] = values[i];
    } else {
        // A row of faces on a wall is closed; so are the ends of a row that runs from wall to wall.
        const Lattice<Dim>& lattice = grid_.faces(Axis);
        const bool walled = !grid_.periodic(Axis);
        if (walled && Axis != 0 && (at[Axis] == 0 || at[Axis] == lattice.count[Axis] - 1)) return;
        const Index first = walled && Axis == 0 ? 1 : 0, open = lattice.count[0] - 2 * first;
        auto row = out.segment(start + first, open);
        const auto carried = values.segment(first, open);
        if (grid_.has_gaps())
            row += grid_.openness(Axis).segment(start + first, open).cwiseProduct(carried - row);
        else
            row = carried;
    }
}

// ------------------------------------------------------------------------------------------------------------ the stages

template <int Dim>
template <int Axis>
void SemiLagrangian<Dim>::advect_components(FaceField<Dim>& velocity, Real dt) {
    carry<Axis>(flow_.component(Axis), velocity[Axis], dt);
    correct<Axis>(flow_.component(Axis), velocity[Axis], dt);
    if constexpr (Axis + 1 < Dim) advect_components<Axis + 1>(velocity, dt);
}

template <int Dim>
void SemiLagrangian<Dim>::advect(FaceField<Dim>& velocity, Real dt) {
    flow_.set(velocity);
    advect_components(velocity, dt);
}

template <int Dim>
void SemiLagrangian<Dim>::carry(VecX& quantity, const FaceField<Dim>& velocity, Real dt) {
    flow_.set(velocity);
    quantity_.fill(quantity);
    carry<-1>(quantity_, quantity, dt);
}

template <int Dim>
void SemiLagrangian<Dim>::correct(VecX& quantity, Real dt) {
    correct<-1>(quantity_, quantity, dt);
}

template <int Dim>
void SemiLagrangian<Dim>::advect(VecX& quantity, const FaceField<Dim>& velocity, Real dt) {
    carry(quantity, velocity, dt);
    correct(quantity, dt);
}

template class SemiLagrangian<2>;
template class SemiLagrangian<3>;

}  // namespace pliant
