#include <pliant/math/sparse_cholesky.h>
#include <pliant/solids/linear_fem_static.h>

namespace pliant {
namespace {

template <int Dim>
const SparseMatrix& supported_stiffness(const LinearFem<Dim>& body, const DisplacementConstraints<Dim>& constraints) {
    require_support(body.mesh(), constraints);
    return body.stiffness();
}

template <int Dim>
StaticSolution<Dim> finish(const StaticProblem<Dim>& problem, const Points<Dim>& force, const VecX& x, const VecX& b) {
    StaticSolution<Dim> solution;
    problem.displacement(x, solution.displacement);
    problem.reaction(solution.displacement, force, solution.reaction);
    const Real scale = b.stableNorm();
    if (scale > 0) solution.residual = (b - problem.system().matrix() * x).stableNorm() / scale;
    return solution;
}

}  // namespace

template <int Dim>
StaticProblem<Dim>::StaticProblem(const LinearFem<Dim>& body, const DisplacementConstraints<Dim>& constraints)
    : body_(&body), constraints_(constraints), system_(supported_stiffness(body, constraints), constraints.flags()) {}

template <int Dim>
void StaticProblem<Dim>::right_side(const Points<Dim>& force, VecX& b) const {
    const VecX full = flat(force) - body_->stiffness() * flat(constraints_.values());
    system_.reduce(full, b);
}

template <int Dim>
void StaticProblem<Dim>::displacement(const VecX& x, Points<Dim>& u) const {
    u = constraints_.values();
    const auto& free = system_.free();
    for (std::size_t i = 0; i < free.size(); ++i) u.data()[free[i]] = x[static_cast<Index>(i)];
}

template <int Dim>
void StaticProblem<Dim>::spread(const VecX& reduced, Points<Dim>& full) const {
    full.setZero(Dim, constraints_.values().cols());
    const auto& free = system_.free();
    for (std::size_t i = 0; i < free.size(); ++i) full.data()[free[i]] = reduced[static_cast<Index>(i)];
}

template <int Dim>
void StaticProblem<Dim>::reaction(const Points<Dim>& u, const Points<Dim>& force, Points<Dim>& reaction) const {
    body_->internal_force(u, reaction);
    reaction -= force;
    for (const int i : system_.free()) reaction.data()[i] = 0;
}

template <int Dim>
StaticSolution<Dim> solve_static(const LinearFem<Dim>& body, const DisplacementConstraints<Dim>& constraints,
                                 const Points<Dim>& force) {
    const StaticProblem<Dim> problem(body, constraints);
    VecX b, x;
    problem.right_side(force, b);
    SparseCholesky cholesky;
    cholesky.factorize(problem.system().matrix());
    cholesky.solve(b, x);
    return finish<Dim>(problem, force, x, b);
}

template <int Dim>
StaticSolution<Dim> solve_static(const LinearFem<Dim>& body, const DisplacementConstraints<Dim>& constraints,
                                 const Points<Dim>& force, const ConjugateGradients::Settings& settings) {
    const StaticProblem<Dim> problem(body, constraints);
    VecX b;
    problem.right_side(force, b);
    const SparseMatrix& matrix = problem.system().matrix();
    ConjugateGradients cg(matrix.rows(), product_with(matrix), incomplete_cholesky_preconditioner(matrix), settings);
    cg.begin(b, VecX::Zero(b.size()));
    cg.solve();
    cg.require_convergence();
    StaticSolution<Dim> solution = finish<Dim>(problem, force, cg.x(), b);
    solution.iterations = cg.iterations();
    return solution;
}

#define PLIANT_INSTANTIATE(Dim)                                                                                                \
    template class StaticProblem<Dim>;                                                                                         \
    template StaticSolution<Dim> solve_static(const LinearFem<Dim>&, const DisplacementConstraints<Dim>&, const Points<Dim>&); \
    template StaticSolution<Dim> solve_static(const LinearFem<Dim>&, const DisplacementConstraints<Dim>&, const Points<Dim>&,  \
                                              const ConjugateGradients::Settings&)
PLIANT_INSTANTIATE(2);
PLIANT_INSTANTIATE(3);
#undef PLIANT_INSTANTIATE

}  // namespace pliant
