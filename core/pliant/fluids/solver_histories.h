// How the divergence left falls with the passes of each solver, found when it is asked for.
#pragma once
#include <pliant/fluids/collocated.h>
#include <pliant/fluids/projection.h>

#include <array>
#include <optional>
#include <variant>
#include <vector>

namespace pliant {

class SolverHistories {
public:
    static constexpr std::size_t solver_count = 4;

    // The grid must outlive this, or the next call. Forgets what was found before.
    void reset(const StaggeredGrid<2>& grid, const FaceField<2>& velocity, Real dt, const ProjectionSettings& settings);
    // On the collocated grid of its cells, where every solver is the plain one.
    void reset(const StaggeredGrid<2>& grid, const Points<2>& velocity, Real dt, const ProjectionSettings& settings);

    // Largest divergence left after pass 1, 2, ..., over the largest before; from p = 0 until the solver meets its tolerance or
    // its cap. Empty where there is nothing to solve, or no solution.
    const std::vector<Real>& of(PressurePreconditioner solver);

private:
    std::vector<Real> run(PressurePreconditioner solver) const;

    const StaggeredGrid<2>* grid_ = nullptr;
    std::variant<FaceField<2>, Points<2>> velocity_;
    Real dt_ = 1;
    ProjectionSettings settings_;
    std::array<std::optional<std::vector<Real>>, solver_count> known_;
};

}  // namespace pliant
