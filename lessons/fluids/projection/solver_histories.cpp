#include "solver_histories.h"

#include <pliant/math/error.h>

namespace pliant::projection {

void SolverHistories::reset(const StaggeredGrid<2>& grid, const FaceField<2>& velocity, Real dt,
                            const ProjectionSettings& settings) {
    grid_ = &grid;
    velocity_ = velocity;
    dt_ = dt;
    settings_ = settings;
    known_ = {};
}

const std::vector<Real>& SolverHistories::of(PressurePreconditioner solver) {
    auto& history = known_[static_cast<std::size_t>(solver)];
    if (!history) history = grid_ ? run(solver) : std::vector<Real>{};
    return *history;
}

std::vector<Real> SolverHistories::run(PressurePreconditioner solver) const {
    std::vector<Real> left;
    ProjectionSettings settings = settings_;
    settings.preconditioner = solver;
    PressureProjection<2> projection(*grid_, settings);
    try {
        projection.begin(velocity_, dt_);
        while (!projection.converged()) {
            projection.iterate();
            left.push_back(projection.remaining_divergence() / projection.initial_divergence());
        }
    } catch (const Diverged&) {
        // The curve ends at the cap; a flow that does not balance has none.
    }
    return left;
}

}  // namespace pliant::projection
