#include <pliant/fluids/solver_histories.h>

#include <pliant/math/error.h>

namespace pliant {

namespace {

template <class Solve, class Velocity>
std::vector<Real> divergence_left(Solve&& solve, const Velocity& velocity, Real dt) {
    std::vector<Real> left;
    try {
        solve.begin(velocity, dt);
        while (!solve.converged()) {
            solve.iterate();
            left.push_back(solve.remaining_divergence() / solve.initial_divergence());
        }
    } catch (const Diverged&) {
        // The curve ends at the cap; a flow that does not balance has none.
    }
    return left;
}

}  // namespace

void SolverHistories::reset(const StaggeredGrid<2>& grid, const FaceField<2>& velocity, Real dt,
                            const ProjectionSettings& settings) {
    grid_ = &grid;
    velocity_ = velocity;
    dt_ = dt;
    settings_ = settings;
    known_ = {};
}

void SolverHistories::reset(const StaggeredGrid<2>& grid, const Points<2>& velocity, Real dt,
                            const ProjectionSettings& settings) {
    reset(grid, FaceField<2>{}, dt, settings);
    velocity_ = velocity;
}

const std::vector<Real>& SolverHistories::of(PressurePreconditioner solver) {
    auto& history = known_[static_cast<std::size_t>(solver)];
    if (!history) history = grid_ ? run(solver) : std::vector<Real>{};
    return *history;
}

std::vector<Real> SolverHistories::run(PressurePreconditioner solver) const {
    ProjectionSettings settings = settings_;
    settings.preconditioner = solver;
    if (const auto* in_cells = std::get_if<Points<2>>(&velocity_))
        return divergence_left(CollocatedProjection<2>(grid_->cells(), grid_->dx(), settings), *in_cells, dt_);
    return divergence_left(PressureProjection<2>(*grid_, settings), std::get<FaceField<2>>(velocity_), dt_);
}

}  // namespace pliant
