#include <pliant/continuum/deformation.h>
#include <pliant/math/error.h>
#include <pliant/math/small_eigen.h>
#include <pliant/solids/element_materials.h>
#include <pliant/solids/hyperelastic_fem.h>
#include <pliant/solids/neo_hookean_element.h>

#include <algorithm>
#include <limits>

namespace pliant {
namespace {

template <int Dim>
std::vector<EnergyDensity<Dim>> densities_of(Energy energy, const std::vector<Lame>& materials) {
    std::vector<EnergyDensity<Dim>> densities;
    densities.reserve(materials.size());
    for (const Lame& material : materials) densities.emplace_back(energy, material);
    return densities;
}

}  // namespace

template <int Dim, int Order>
HyperelasticFem<Dim, Order>::HyperelasticFem(const SimplexMesh<Dim>& mesh, Energy energy, const Lame& material)
    : HyperelasticFem(mesh, energy, std::vector<Lame>(static_cast<std::size_t>(mesh.simplex_count()), material)) {}

template <int Dim, int Order>
HyperelasticFem<Dim, Order>::HyperelasticFem(const SimplexMesh<Dim>& mesh, Energy energy, const std::vector<Lame>& materials)
    : elements_(mesh), densities_(densities_of<Dim>(energy, materials)), assembly_(elements_.elements(), elements_.node_count()) {
    check_materials<Dim>(materials, mesh.simplex_count());
}

template <int Dim, int Order>
Mat<Dim> HyperelasticFem<Dim, Order>::deformation_gradient(Index element, const Points<Dim>& displacement, int point) const {
    return Mat<Dim>::Identity() + elements_.field_gradient(element, point, displacement);
}

// Loops in several threads must not throw.
template <int Dim, int Order>
void HyperelasticFem<Dim, Order>::require_admitted(const Points<Dim>& displacement) const {
    Index e = 0;
    try {
        for (; e < elements_.element_count(); ++e) {
            if (density(e).admits(Mat<Dim>::Zero())) continue;
            for (int q = 0; q < Elements::points; ++q) {
                const Mat<Dim> F = deformation_gradient(e, displacement, q);
                if (!density(e).admits(F)) (void)density(e).P(F);
            }
        }
    } catch (Diverged& diverged) {
        diverged.failure.index = e;
        throw Diverged(diverged.failure);
    }
}

template <int Dim, int Order>
void HyperelasticFem<Dim, Order>::stress(const Points<Dim>& displacement, Tensors<Dim>& P) const {
    P.resize(Dim * Dim, elements_.element_count());
    require_admitted(displacement);
    for (Index e = 0; e < elements_.element_count(); ++e) {
        Mat<Dim> sum = density(e).P(deformation_gradient(e, displacement));
        for (int q = 1; q < Elements::points; ++q) sum += density(e).P(deformation_gradient(e, displacement, q));
        tensor<Dim>(P, e) = sum / Elements::points;
    }
}

template <int Dim, int Order>
Real HyperelasticFem<Dim, Order>::energy(const Points<Dim>& displacement) const {
    return parallel_sum(elements_.element_count(), [&](Index first, Index last) {
        Real sum = 0;
        for (Index e = first; e < last; ++e)
            for (int q = 0; q < Elements::points; ++q)
                sum += elements_.weight(e) * density(e).psi(deformation_gradient(e, displacement, q));
        return sum;
    });
}

// The neo-Hookean energy is mu/2 (tr F^T F - Dim) and more, of which little is left near rest.
template <int Dim, int Order>
Real HyperelasticFem<Dim, Order>::energy_scale() const {
    Real sum = 0;
    for (Index e = 0; e < elements_.element_count(); ++e)
        if (density(e).energy() == Energy::neo_hookean) sum += mesh().volumes()[e] * density(e).material().mu * Dim / 2;
    return sum;
}

// Node a takes w P g_a from each point, g the gradients of the shape functions.
template <int Dim, int Order>
void HyperelasticFem<Dim, Order>::internal_force(const Points<Dim>& displacement, Points<Dim>& force) const {
    require_admitted(displacement);
    collect([&](Index e, int q) { return density(e).P(deformation_gradient(e, displacement, q)); }, force);
}

template <int Dim, int Order>
void HyperelasticFem<Dim, Order>::stiffness(const Points<Dim>& displacement, bool definite, SparseMatrix& matrix) const {
    require_admitted(displacement);
    assemble([&](Index e) { return element_stiffness(e, displacement, definite); }, matrix);
}

// Both ends of a step may be admitted with a mirror image between them: two axes turned over make a proper body again.
template <int Dim, int Order>
Real HyperelasticFem<Dim, Order>::admissible_share(const Points<Dim>& displacement, const Points<Dim>& change) const {
    constexpr Real margin = 0.9;
    Real share = 1;
    for (Index e = 0; e < elements_.element_count(); ++e) {
        if (density(e).admits(Mat<Dim>::Zero())) continue;
        for (int q = 0; q < Elements::points; ++q) {
            const Mat<Dim> F = deformation_gradient(e, displacement, q), dF = elements_.field_gradient(e, q, change);
            const Real relative = (cofactor<Dim>(F).transpose() * dF).norm() / volume_ratio<Dim>(F);
            if (share * relative > margin) share = margin / relative;
        }
    }
    return share;
}

// Sum of w B^T (dP/dF) B with B: displacements of the nodes to F in columns; block (a, b) contracts the tangent with both
// gradients.
template <int Dim, int Order>
typename HyperelasticFem<Dim, Order>::ElementMatrix HyperelasticFem<Dim, Order>::element_stiffness(
    Index element, const Points<Dim>& displacement, bool definite) const {
    ElementMatrix K = ElementMatrix::Zero();
    const bool neo_hookean = density(element).energy() == Energy::neo_hookean;
    for (int q = 0; q < Elements::points; ++q) {
        if (neo_hookean) {
            const NeoHookeanElement<Dim, nodes> at(density(element).material(), deformation_gradient(element, displacement, q),
                                                   elements_.gradients(element, q));
            if (!definite || at.only_twists()) {
                at.add(1, K);
                if (definite) at.lift_twists(1, K);
                continue;
            }
        }
        Mat<Dim* Dim> T = density(element).tangent(deformation_gradient(element, displacement, q));
        if (definite) T = positive_part<Dim * Dim>(T);
        const typename Elements::Gradients g = elements_.gradients(element, q);
        Eigen::Matrix<Real, Dim * Dim, Dim * nodes> TB;
        TB.setZero();
        for (int b = 0; b < nodes; ++b)
            for (int l = 0; l < Dim; ++l) TB.template middleCols<Dim>(Dim * b) += g(l, b) * T.template middleCols<Dim>(Dim * l);
        for (int a = 0; a < nodes; ++a)
            for (int j = 0; j < Dim; ++j) K.template middleRows<Dim>(Dim * a) += g(j, a) * TB.template middleRows<Dim>(Dim * j);
    }
    // Symmetric to the bit, as the solvers expect.
    return (0.5 * elements_.weight(element)) * (K + K.transpose()).eval();
}

template class HyperelasticFem<2, 1>;
template class HyperelasticFem<2, 2>;
template class HyperelasticFem<3, 1>;
template class HyperelasticFem<3, 2>;

}  // namespace pliant
