#include <pliant/mesh/simplex_quadrature.h>
#include <pliant/solids/fem_loads.h>

namespace pliant {
namespace {

// A constant force on a facet goes to its nodes in equal parts.
template <int Dim>
void share(const SimplexMesh<Dim>& mesh, Index facet, const Vec<Dim>& total, Points<Dim>& force) {
    for (int a = 0; a < Dim; ++a) force.col(mesh.facets()(a, facet)) += total / Dim;
}

// Integral of load × shape function over one simplex or facet of the given measure. corners: its node numbers.
template <int Dim, int Corners>
void integrate(const SimplexMesh<Dim>& mesh, const Eigen::Matrix<int, Corners, 1>& corners, Real measure,
               const LoadFunction<Dim>& load, const SimplexRule<Corners - 1>& rule, Points<Dim>& force) {
    for (Index q = 0; q < rule.weights.size(); ++q) {
        Vec<Dim> X = Vec<Dim>::Zero();
        for (int a = 0; a < Corners; ++a) X += rule.barycentric(a, q) * mesh.points().col(corners[a]);
        const Vec<Dim> part = measure * rule.weights[q] * load(X);
        for (int a = 0; a < Corners; ++a) force.col(corners[a]) += rule.barycentric(a, q) * part;
    }
}

}  // namespace

template <int Dim>
void add_traction(const SimplexMesh<Dim>& mesh, const FacetSet& facets, const Vec<Dim>& traction, Points<Dim>& force) {
    for (const Index f : facets) share<Dim>(mesh, f, mesh.facet_areas().col(f).norm() * traction, force);
}

template <int Dim>
void add_pressure(const SimplexMesh<Dim>& mesh, const FacetSet& facets, Real pressure, Points<Dim>& force) {
    for (const Index f : facets) share<Dim>(mesh, f, -pressure * mesh.facet_areas().col(f), force);
}

template <int Dim>
void add_boundary_stress(const SimplexMesh<Dim>& mesh, const FacetSet& facets, const Mat<Dim>& stress, Points<Dim>& force) {
    for (const Index f : facets) share<Dim>(mesh, f, stress * mesh.facet_areas().col(f), force);
}

// One degree more than the load, for the shape function.
template <int Dim>
void add_traction(const SimplexMesh<Dim>& mesh, const FacetSet& facets, const LoadFunction<Dim>& traction, int degree,
                  Points<Dim>& force) {
    const SimplexRule<Dim - 1> rule = simplex_rule<Dim - 1>(degree + 1);
    for (const Index f : facets)
        integrate<Dim, Dim>(mesh, mesh.facets().col(f), mesh.facet_areas().col(f).norm(), traction, rule, force);
}

template <int Dim>
void add_body_force(const SimplexMesh<Dim>& mesh, const LoadFunction<Dim>& force_density, int degree, Points<Dim>& force) {
    const SimplexRule<Dim> rule = simplex_rule<Dim>(degree + 1);
    for (Index e = 0; e < mesh.simplex_count(); ++e)
        integrate<Dim, Dim + 1>(mesh, mesh.simplices().col(e), mesh.volumes()[e], force_density, rule, force);
}

#define PLIANT_INSTANTIATE(Dim)                                                                                        \
    template void add_traction(const SimplexMesh<Dim>&, const FacetSet&, const Vec<Dim>&, Points<Dim>&);               \
    template void add_pressure(const SimplexMesh<Dim>&, const FacetSet&, Real, Points<Dim>&);                          \
    template void add_boundary_stress(const SimplexMesh<Dim>&, const FacetSet&, const Mat<Dim>&, Points<Dim>&);        \
    template void add_traction(const SimplexMesh<Dim>&, const FacetSet&, const LoadFunction<Dim>&, int, Points<Dim>&); \
    template void add_body_force(const SimplexMesh<Dim>&, const LoadFunction<Dim>&, int, Points<Dim>&)
PLIANT_INSTANTIATE(2);
PLIANT_INSTANTIATE(3);
#undef PLIANT_INSTANTIATE

}  // namespace pliant
