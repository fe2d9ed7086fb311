// How an advected number came about, for every scheme of SemiLagrangian: the path back, the samples around its end, and
// MacCormack's correction of the linearly interpolated value.
#pragma once
#include "grid_why.h"

#include <pliant/fluids/advection.h>

namespace pliant::grid2d {

// The schemes that a person chooses from.
enum class Carrying { linear, monotone_cubic, mac_cormack };
inline AdvectionSettings settings_of(Carrying scheme, BackTrace trace) {
    return {trace, scheme == Carrying::monotone_cubic ? Interpolation::monotone_cubic : Interpolation::linear,
            scheme == Carrying::mac_cormack};
}

class AdvectionWhy {
public:
    // Keeps references. To be asked right after `advection` has carried something for dt seconds; step: the time step, as it
    // stands in formulas.
    AdvectionWhy(const StaggeredGrid<2>& grid, const SemiLagrangian<2>& advection, Real dt, Input step)
        : grid_(grid), advection_(advection), dt_(dt), step_(std::move(step)) {}

    // A component of the velocity that carried itself.
    Explanation velocity(int axis, Index face) const;
    // A cell-centred quantity, carried by the velocity that the fields show.
    Explanation quantity(std::string_view field, Index cell) const;

private:
    // What was carried: where its samples lie, what they were, and how the fields and formulas call it.
    struct Carried {
        const Lattice<2>& lattice;
        const PaddedField<2>& old;
        std::string_view field;
        std::string symbol;
        int axis;  // -1 at cell centres
    };
    using Terms = std::vector<std::pair<Input, Input>>;  // a weight and a sample

    Carried component(int axis) const;
    bool kept(const Carried& what, Index sample) const;
    Explanation answer(const Carried& what, Index sample) const;
    Explanation interpolated(const Carried& what, Index sample) const;
    Explanation corrected(const Carried& what, Index sample) const;

    Input path(int axis, const Departure<2>& departure) const;
    Explanation bilinear(const Carried& what, const Departure<2>& departure) const;
    Terms cubic_terms(const Carried& what, const GridPlace<2>& place) const;
    Input carried_back(const Carried& what, Index sample) const;
    Input carried_sample(const Carried& what, std::string symbol, const SampleBeyond& at) const;

    const StaggeredGrid<2>& grid_;
    const SemiLagrangian<2>& advection_;
    Real dt_;
    Input step_;
};

}  // namespace pliant::grid2d
