// How the divergence left falls with the passes of each solver, found when it is asked for.
#pragma once
#include <pliant/fluids/projection.h>

#include <array>
#include <optional>
#include <vector>

namespace pliant::projection {

inline constexpr std::size_t solver_count = 4;

class SolverHistories {
public:
    // The grid must outlive this, or the next call. Forgets what was found before.
    void reset(const StaggeredGrid<2>& grid, const FaceField<2>& velocity, Real dt, const ProjectionSettings& settings);
    void clear() { grid_ = nullptr, known_ = {}; }

    // Largest divergence left after pass 1, 2, ..., over the largest before; from p = 0 until the solver meets its tolerance or
    // its cap. Empty where there is nothing to solve, or no solution.
    const std::vector<Real>& of(PressurePreconditioner solver);

private:
    std::vector<Real> run(PressurePreconditioner solver) const;

    const StaggeredGrid<2>* grid_ = nullptr;
    FaceField<2> velocity_;
    Real dt_ = 1;
    ProjectionSettings settings_;
    std::array<std::optional<std::vector<Real>>, solver_count> known_;
};

}  // namespace pliant::projection
