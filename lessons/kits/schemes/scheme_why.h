// What the explanations of steps in time share: rows of an explicit scheme's table, velocities from forces, Newton's method. The
// fields are "position" and "velocity".
#pragma once
#include <pliant/lesson/explanation.h>
#include <pliant/time/time_integrator.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pliant::stepping {

// x′ = x + Δt v, with the velocity of the start of the step or of its end.
Explanation drifted(const Parameter& dt, Index node, int component, bool with_new_velocity);
// v′ = v + Δt (f + fᵈ + …) / m
Explanation pushed(Input v, const Parameter& dt, Input mass, std::vector<Input> forces);
// a_1 = (f + fᵈ + …) / m, of the first pass
Input first_acceleration(Input mass, std::vector<Input> forces);
// The row of the scheme's table that the latest pass has filled in, x′ = x + c Δt v + Δt² (b_1 a_1 + …) or
// v′ = v + Δt (b_1 a_1 + …): the next place to evaluate forces at, or the end of the step. symbol: of what it gives. first: the
// first acceleration, where it is known how it came about.
Explanation table_row(std::string_view symbol, const TimeIntegrator& integrator, bool of_velocity, Index dof, Input x, Input v,
                      const Parameter& dt, const std::optional<Input>& first);

// An iterate of Newton's method, x′ = x_k + d or from where a search along a line began, kept above a bound where there is one.
// symbols: of the iterate and of its letter before, "x′" and "x".
Explanation newton_iterate(const std::string& symbol, const std::string& letter, const ImplicitSolver& solver, Index dof,
                           Input iterate_before, Input direction, const std::optional<Input>& bound);
// One row of H d = R − g − r: R the force of a bound, r what conjugate gradients have left, each where there is one. dimension:
// of the nodes.
Input newton_direction(const ImplicitSolver& solver, Index dof, Real diagonal, const std::vector<std::pair<Index, Real>>& row,
                       int dimension = 3);
// The same with the matrix of a direct solve.
Input newton_direction(const ImplicitSolver& solver, Index dof, int dimension = 3);
// What the solver has left unbalanced there.
Input imbalance_left(Real r);

}  // namespace pliant::stepping
