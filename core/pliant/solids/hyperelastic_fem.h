// Elastic bodies of finite elements under any energy density [Sifakis2012 §4]: the energy of the body is the sum of w psi(F) over
// the points of integration of its elements, F = I + du/dX. In elements of first order F is constant and w their volume.
#pragma once
#include <pliant/continuum/energy_density.h>
#include <pliant/continuum/strain.h>
#include <pliant/math/element_assembly.h>
#include <pliant/math/parallel.h>
#include <pliant/mesh/simplex_elements.h>
#include <pliant/solids/elastic_body.h>

#include <algorithm>
#include <vector>

namespace pliant {

// In 2D per metre of thickness: plane strain with the coefficients of IsotropicModuli::lame(). Those of plane_stress_lame() give
// plane stress for the linear, the corotated and the St. Venant-Kirchhoff energy, each of which is quadratic in its strain, so
// that the stretch across the plane that no stress holds is known; a neo-Hookean body takes plane strain alone.
template <int Dim, int Order = 1>
class HyperelasticFem final : public ElasticBody<Dim> {
public:
    using Elements = SimplexElements<Dim, Order>;
    static constexpr int nodes = Elements::nodes;
    using ElementMatrix = Mat<Dim * nodes>;

    // The mesh outlives this. One material for all elements, or one for each. Throws Refused, naming the element, for a material
    // that is not stable.
    HyperelasticFem(const SimplexMesh<Dim>& mesh, Energy energy, const Lame& material);
    HyperelasticFem(const SimplexMesh<Dim>& mesh, Energy energy, const std::vector<Lame>& materials);

    const SimplexMesh<Dim>& mesh() const { return elements_.mesh(); }
    const Elements& elements() const { return elements_; }
    Index node_count() const override { return elements_.node_count(); }
    void check_support(const DisplacementConstraints<Dim>& constraints) const override { require_support(mesh(), constraints); }
    bool is_linear() const override { return densities_.empty() || densities_.front().energy() == Energy::linear; }
    const EnergyDensity<Dim>& density(Index element) const { return densities_[static_cast<std::size_t>(element)]; }

    Mat<Dim> deformation_gradient(Index element, const Points<Dim>& displacement, int point = 0) const;
    // First Piola-Kirchhoff stress [Pa] of each element, the mean over its points. Throws Diverged, naming the element, where the
    // energy does not admit its F.
    void stress(const Points<Dim>& displacement, Tensors<Dim>& P) const;

    Real energy(const Points<Dim>& displacement) const override;
    Real energy_scale() const override;
    void internal_force(const Points<Dim>& displacement, Points<Dim>& force) const override;
    void stiffness(const Points<Dim>& displacement, bool definite, SparseMatrix& matrix) const override;
    const SparseMatrix& pattern() const override { return assembly_.pattern(); }
    Real admissible_share(const Points<Dim>& displacement, const Points<Dim>& change) const override;
    // Forces of the stresses P(element, point) [Pa], and the sum of the matrices that local(element) gives. In several threads,
    // each for nodes of its own; the bits do not depend on how many there are.
    template <class Stress>
    void collect(Stress stress, Points<Dim>& force) const;
    template <class Local>
    void assemble(Local local, SparseMatrix& matrix) const;
    // Of one element [N/m], symmetric to the bit.
    ElementMatrix element_stiffness(Index element, const Points<Dim>& displacement, bool definite) const;

private:
    void require_admitted(const Points<Dim>& displacement) const;

    Elements elements_;
    std::vector<EnergyDensity<Dim>> densities_;
    ElementAssembly<Dim, nodes> assembly_;
};

template <int Dim, int Order>
template <class Stress>
void HyperelasticFem<Dim, Order>::collect(Stress stress, Points<Dim>& force) const {
    force.setZero(Dim, node_count());
    parallel_parts(node_count(), Dim * Dim * nodes, [&](Index first, Index last, int) {
        for (Index e = 0; e < elements_.element_count(); ++e) {
            if (!assembly_.touches(e, first, last)) continue;
            for (int q = 0; q < Elements::points; ++q) {
                const Mat<Dim> P = elements_.weight(e) * stress(e, q);
                const auto g = elements_.gradients(e, q);
                for (int a = 0; a < nodes; ++a) {
                    const Index n = elements_.elements()(a, e);
                    if (n >= first && n < last) force.col(n).noalias() += P * g.col(a);
                }
            }
        }
    });
}

template <int Dim, int Order>
template <class Local>
void HyperelasticFem<Dim, Order>::assemble(Local local, SparseMatrix& matrix) const {
    parallel_parts(node_count(), Dim * nodes * nodes, [&](Index first, Index last, int) {
        const Index from = matrix.outerIndexPtr()[Dim * first], to = matrix.outerIndexPtr()[Dim * last];
        std::fill(matrix.valuePtr() + from, matrix.valuePtr() + to, Real{0});
        for (Index e = 0; e < elements_.element_count(); ++e)
            if (assembly_.touches(e, first, last)) assembly_.add(e, local(e), matrix, first, last);
    });
}

}  // namespace pliant
