#include <pliant/solids/stretched_cube.h>

#include <pliant/continuum/deformation.h>

#include <cmath>

namespace pliant {
namespace {

constexpr Real rounding = 1e-13;

SimplexMesh<3> cube_mesh(Real length, int cells) {
    BlockShape<3> block;
    block.size = Vec<3>::Constant(length);
    block.cells = {cells, cells, cells};
    return block_mesh<3>(block);
}

}  // namespace

StretchedCube::StretchedCube(Real nu, Real length, int cells)
    : material_(IsotropicModuli::from_young_poisson(1, nu).lame()), length_(length), rest_(cube_mesh(length, cells)) {}

void StretchedCube::begin(const Points<3>& u) {
    auto reached = std::make_unique<SimplexMesh<3>>(rest_.with_points(rest_.points() + u));
    body_ = std::make_unique<LinearFem<3>>(*reached, material_);
    reached_ = std::move(reached);
}

Points<3> StretchedCube::increment(Real dx) const {
    DisplacementConstraints<3> constraints(rest_.node_count());
    const char* lower[]{"x_min", "y_min", "z_min"};
    for (int k = 0; k < 3; ++k) constraints.prescribe(rest_.nodes(lower[k]), k, 0);
    constraints.prescribe(rest_.nodes("x_max"), 0, dx);
    Points<3> step = solve_static<3>(*body_, constraints, Points<3>::Zero(3, rest_.node_count())).displacement;
    // What is left of 0 by rounding is 0: a cube with nu = 0 keeps its width to the bit.
    return (step.array().abs() < rounding * std::abs(dx)).select(0, step);
}

Real StretchedCube::mean(const char* face, int component, const Points<3>& u) const {
    Real sum = 0;
    for (const Index n : rest_.nodes(face)) sum += u(component, n);
    return sum / static_cast<Real>(rest_.nodes(face).size());
}

Real StretchedCube::axial_strain(const Points<3>& u) const { return (mean("x_max", 0, u) - mean("x_min", 0, u)) / length_; }

Real StretchedCube::contraction(const Points<3>& u) const { return (mean("z_min", 2, u) - mean("z_max", 2, u)) / length_; }

Real StretchedCube::element_volume_ratio(Index element, const Points<3>& u) const {
    return pliant::volume_ratio<3>(deformation_gradient<3>(rest_.field_gradient(element, u)));
}

Real StretchedCube::volume_ratio(const Points<3>& u) const {
    Real volume = 0;
    for (Index e = 0; e < rest_.simplex_count(); ++e) volume += rest_.volumes()[e] * element_volume_ratio(e, u);
    return volume / rest_.volume();
}

}  // namespace pliant
