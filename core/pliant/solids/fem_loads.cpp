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

// A constant force on a facet of elements of either order.
template <int Dim, int Order>
void share_out(const SimplexElements<Dim, Order>& elements, Index facet, const Vec<Dim>& total, Points<Dim>& force) {
    const auto shares = facet_shares<Dim, Order>();
    for (int a = 0; a < shares.size(); ++a) force.col(elements.facets()(a, facet)) += shares[a] * total;
}

// As integrate(), for a simplex of any order and dimension whose nodes, corners first, are `nodes`.
template <int Dim, int Size, int Order, class Nodes>
void integrate_shapes(const Points<Dim>& positions, const Nodes& nodes, Real measure, const LoadFunction<Dim>& load,
                      const SimplexRule<Size>& rule, Points<Dim>& force) {
    for (Index q = 0; q < rule.weights.size(); ++q) {
        Vec<Dim> X = Vec<Dim>::Zero();
        for (int a = 0; a <= Size; ++a) X += rule.barycentric(a, q) * positions.col(nodes[a]);
        const Vec<Dim> part = measure * rule.weights[q] * load(X);
        const auto N = simplex_shape<Size, Order>(rule.barycentric.col(q));
        for (int a = 0; a < N.size(); ++a) force.col(nodes[a]) += N[a] * part;
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

template <int Dim, int Order>
void add_traction(const SimplexElements<Dim, Order>& elements, const FacetSet& facets, const Vec<Dim>& traction,
                  Points<Dim>& force) {
    for (const Index f : facets)
        share_out<Dim, Order>(elements, f, elements.mesh().facet_areas().col(f).norm() * traction, force);
}

template <int Dim, int Order>
void add_pressure(const SimplexElements<Dim, Order>& elements, const FacetSet& facets, Real pressure, Points<Dim>& force) {
    for (const Index f : facets) share_out<Dim, Order>(elements, f, -pressure * elements.mesh().facet_areas().col(f), force);
}

template <int Dim, int Order>
void add_boundary_stress(const SimplexElements<Dim, Order>& elements, const FacetSet& facets, const Mat<Dim>& stress,
                         Points<Dim>& force) {
    for (const Index f : facets) share_out<Dim, Order>(elements, f, stress * elements.mesh().facet_areas().col(f), force);
}

template <int Dim, int Order>
void add_traction(const SimplexElements<Dim, Order>& elements, const FacetSet& facets, const LoadFunction<Dim>& traction,
                  int degree, Points<Dim>& force) {
    const SimplexRule<Dim - 1> rule = simplex_rule<Dim - 1>(degree + Order);
    for (const Index f : facets)
        integrate_shapes<Dim, Dim - 1, Order>(elements.positions(), elements.facets().col(f),
                                              elements.mesh().facet_areas().col(f).norm(), traction, rule, force);
}

template <int Dim, int Order>
void add_body_force(const SimplexElements<Dim, Order>& elements, const LoadFunction<Dim>& force_density, int degree,
                    Points<Dim>& force) {
    const SimplexRule<Dim> rule = simplex_rule<Dim>(degree + Order);
    for (Index e = 0; e < elements.element_count(); ++e)
        integrate_shapes<Dim, Dim, Order>(elements.positions(), elements.elements().col(e), elements.mesh().volumes()[e],
                                          force_density, rule, force);
}

#define PLIANT_INSTANTIATE_ORDER(Dim, Order)                                                                               \
    template void add_traction(const SimplexElements<Dim, Order>&, const FacetSet&, const Vec<Dim>&, Points<Dim>&);        \
    template void add_pressure(const SimplexElements<Dim, Order>&, const FacetSet&, Real, Points<Dim>&);                   \
    template void add_boundary_stress(const SimplexElements<Dim, Order>&, const FacetSet&, const Mat<Dim>&, Points<Dim>&); \
    template void add_traction(const SimplexElements<Dim, Order>&, const FacetSet&, const LoadFunction<Dim>&, int,         \
                               Points<Dim>&);                                                                              \
    template void add_body_force(const SimplexElements<Dim, Order>&, const LoadFunction<Dim>&, int, Points<Dim>&)
PLIANT_INSTANTIATE_ORDER(2, 1);
PLIANT_INSTANTIATE_ORDER(2, 2);
PLIANT_INSTANTIATE_ORDER(3, 1);
PLIANT_INSTANTIATE_ORDER(3, 2);
#undef PLIANT_INSTANTIATE_ORDER

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
