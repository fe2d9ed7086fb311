// Advection: how a quantity is carried along by the flow, ∂q/∂t + u·∇q = 0.
#pragma once
#include <pliant/fluids/velocity_sampler.h>

#include <vector>

namespace pliant {

// How the particle that arrives at a sample is followed back through a velocity that is the same during the whole step.
enum class BackTrace {
    euler,    // straight, with the velocity at its arrival: order 1
    midpoint  // with the velocity half way, the second-order Runge–Kutta method [Bridson2007 §3.2]
};

struct AdvectionSettings {
    BackTrace trace = BackTrace::midpoint;
    Interpolation interpolation = Interpolation::linear;
    // Carries the result back again, takes half of what that misses as the error, and removes it, as far as the result stays
    // within the samples around the departure [Selle2008 §3].
    bool mac_cormack = false;

    bool operator==(const AdvectionSettings&) const = default;
};

// The path of the particle that arrives at a place, in cells from the corner of the domain. `middle` and `departure` have been
// moved into the domain; the `free_` ones are where they were before that.
template <int Dim>
struct Departure {
    GridPlace<Dim> arrival, middle, departure;
    GridPlace<Dim> free_middle, free_departure;
};

// Semi-Lagrangian advection [Stam1999 §2.2; Bridson2007 §3]: the new value at a sample is the old one where the particle that
// arrives there was one step ago, interpolated. Every new value lies within the old samples and wall values around that place,
// so that the largest magnitude never grows, at any time step; the interpolation dissipates. Closed faces and the quantity in
// solid cells keep their value.
//
// No step allocates memory. A quantity that MacCormack's correction works on is stored three times more.
template <int Dim>
class SemiLagrangian {
public:
    // Keeps a reference to the grid.
    explicit SemiLagrangian(const StaggeredGrid<Dim>& grid, AdvectionSettings settings = {});

    // Carries the velocity along itself for dt seconds.
    void advect(FaceField<Dim>& velocity, Real dt);

    // Carries a cell-centred quantity along `velocity` for dt seconds.
    void advect(VecX& quantity, const FaceField<Dim>& velocity, Real dt);

    // The two halves of the latter: the interpolated values, and what MacCormack's correction makes of them. correct() does
    // nothing when the settings leave the correction out.
    void carry(VecX& quantity, const FaceField<Dim>& velocity, Real dt);
    void correct(VecX& quantity, Real dt);

    const AdvectionSettings& settings() const { return settings_; }
    // The velocity that carried the latest advection, and the cell-centred quantity that it carried, as it was before.
    const VelocitySampler<Dim>& flow() const { return flow_; }
    const PaddedField<Dim>& carried() const { return quantity_; }
    // The same after carry(), for MacCormack's correction.
    const PaddedField<Dim>& forward() const { return forward_.back(); }

    // Where the particle that arrives at a place in the domain comes from, dt seconds ago; with a negative dt, where the one
    // that leaves it goes. In the velocity of the latest advection.
    Departure<Dim> departure(const GridPlace<Dim>& arrival, Real dt) const;

private:
    PlacePair<Dim> stepped_back(const PlacePair<Dim>& arrival, const PlacePair<Dim>& speed, Real cells_per_speed) const;
    // The particles of one row: where they are, in cells, and how fast, along each axis; what they carry.
    struct Particles {
        AxisArrays<Dim> place, speed;
        VecX row;
    };
    void make_particles();
    // place of the particles that arrive at a row of samples.
    template <int Axis>
    void trace_row(const Lattice<Dim>& lattice, const Counts<Dim>& row, Real dt, Particles& p) const;
    // row = a field at place.
    void interpolate_row(const PaddedField<Dim>& field, Index n, Particles& p) const;

    // Axis: of the faces whose component is carried, or -1 for a quantity at cell centres.
    template <int Axis>
    void carry(const PaddedField<Dim>& old, VecX& out, Real dt);
    template <int Axis>
    void correct(const PaddedField<Dim>& old, VecX& out, Real dt);
    template <int Axis>
    void write_row(Index start, const Counts<Dim>& at, const VecX& values, VecX& out) const;
    template <int Axis = 0>
    void advect_components(FaceField<Dim>& velocity, Real dt);

    const StaggeredGrid<Dim>& grid_;
    AdvectionSettings settings_;
    VelocitySampler<Dim> flow_;
    PaddedField<Dim> quantity_;
    std::vector<PaddedField<Dim>> forward_;  // by axis, then of the cells; none without MacCormack
    VecX low_, high_;                        // of the samples around each departure
    std::vector<Particles> particles_;       // by thread
};

extern template class SemiLagrangian<2>;
extern template class SemiLagrangian<3>;

}  // namespace pliant
