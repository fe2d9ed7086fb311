#include <pliant/continuum/deformation.h>
#include <pliant/math/error.h>
#include <pliant/math/small_eigen.h>
#include <pliant/solids/element_materials.h>
#include <pliant/solids/hyperelastic_fem.h>

#include <algorithm>
#include <limits>

namespace pliant {
namespace {

// The nearest matrix without negative eigenvalues.
template <int Size>
void remove_negative_part(Mat<Size>& A) {
    const SymmetricEigen<Size> eigen = symmetric_eigen<Size>(A);
    if (eigen.values[0] >= 0) return;
    A = eigen.vectors * eigen.values.cwiseMax(0).asDiagonal() * eigen.vectors.transpose();
}

template <int Dim>
std::vector<EnergyDensity<Dim>> densities_of(Energy energy, const std::vector<Lame>& materials) {
    std::vector<EnergyDensity<Dim>> densities;
    densities.reserve(materials.size());
    for (const Lame& material : materials) densities.emplace_back(energy, material);
    return densities;
}

}  // namespace

template <int Dim>
HyperelasticFem<Dim>::HyperelasticFem(const SimplexMesh<Dim>& mesh, Energy energy, const Lame& material)
    : HyperelasticFem(mesh, energy, std::vector<Lame>(static_cast<std::size_t>(mesh.simplex_count()), material)) {}

template <int Dim>
HyperelasticFem<Dim>::HyperelasticFem(const SimplexMesh<Dim>& mesh, Energy energy, const std::vector<Lame>& materials)
    : mesh_(&mesh), densities_(densities_of<Dim>(energy, materials)), assembly_(mesh.simplices(), mesh.node_count()) {
    check_materials<Dim>(materials, mesh.simplex_count());
}

template <int Dim>
Mat<Dim> HyperelasticFem<Dim>::deformation_gradient(Index element, const Points<Dim>& displacement) const {
    return Mat<Dim>::Identity() + mesh_->field_gradient(element, displacement);
}

template <int Dim>
void HyperelasticFem<Dim>::stress(const Points<Dim>& displacement, Tensors<Dim>& P) const {
    P.resize(Dim * Dim, mesh_->simplex_count());
    Index e = 0;
    try {
        for (; e < mesh_->simplex_count(); ++e) tensor<Dim>(P, e) = density(e).P(deformation_gradient(e, displacement));
    } catch (Diverged& diverged) {
        diverged.failure.index = e;
        throw Diverged(diverged.failure);
    }
}

template <int Dim>
Real HyperelasticFem<Dim>::energy(const Points<Dim>& displacement) const {
    Real sum = 0;
    for (Index e = 0; e < mesh_->simplex_count(); ++e)
        sum += mesh_->volumes()[e] * density(e).psi(deformation_gradient(e, displacement));
    return sum;
}

template <int Dim>
void HyperelasticFem<Dim>::internal_force(const Points<Dim>& displacement, Points<Dim>& force) const {
    force.setZero(Dim, mesh_->node_count());
    Index e = 0;
    try {
        for (; e < mesh_->simplex_count(); ++e) {
            const Mat<Dim> P = mesh_->volumes()[e] * density(e).P(deformation_gradient(e, displacement));
            const auto g = mesh_->gradients(e);
            for (int a = 0; a < corners; ++a) force.col(mesh_->simplices()(a, e)).noalias() += P * g.col(a);
        }
    } catch (Diverged& diverged) {
        diverged.failure.index = e;
        throw Diverged(diverged.failure);
    }
}

template <int Dim>
void HyperelasticFem<Dim>::stiffness(const Points<Dim>& displacement, bool definite, SparseMatrix& matrix) const {
    std::fill_n(matrix.valuePtr(), static_cast<std::size_t>(matrix.nonZeros()), Real{0});
    for (Index e = 0; e < mesh_->simplex_count(); ++e) assembly_.add(e, element_stiffness(e, displacement, definite), matrix);
}

// Both ends of a step may be admitted with a mirror image between them: two axes turned over make a proper body again.
template <int Dim>
Real HyperelasticFem<Dim>::admissible_share(const Points<Dim>& displacement, const Points<Dim>& change) const {
    constexpr Real margin = 0.9;
    Real share = 1;
    for (Index e = 0; e < mesh_->simplex_count(); ++e) {
        if (density(e).admits(Mat<Dim>::Zero())) continue;
        const Mat<Dim> F = deformation_gradient(e, displacement), dF = mesh_->field_gradient(e, change);
        const Real relative = (cofactor<Dim>(F).transpose() * dF).norm() / volume_ratio<Dim>(F);
        if (share * relative > margin) share = margin / relative;
    }
    return share;
}

// V B^T (dP/dF) B with B: corner displacements to F in columns; block (a, b) contracts the tangent with both gradients.
template <int Dim>
typename HyperelasticFem<Dim>::ElementMatrix HyperelasticFem<Dim>::element_stiffness(Index element,
                                                                                     const Points<Dim>& displacement,
                                                                                     bool definite) const {
    Mat<Dim* Dim> T = density(element).tangent(deformation_gradient(element, displacement));
    if (definite) remove_negative_part<Dim * Dim>(T);
    const typename SimplexMesh<Dim>::Gradients g = mesh_->gradients(element);
    Eigen::Matrix<Real, Dim * Dim, Dim * corners> TB;
    TB.setZero();
    for (int b = 0; b < corners; ++b)
        for (int l = 0; l < Dim; ++l) TB.template middleCols<Dim>(Dim * b) += g(l, b) * T.template middleCols<Dim>(Dim * l);
    ElementMatrix K = ElementMatrix::Zero();
    for (int a = 0; a < corners; ++a)
        for (int j = 0; j < Dim; ++j) K.template middleRows<Dim>(Dim * a) += g(j, a) * TB.template middleRows<Dim>(Dim * j);
    // Symmetric to the bit, as the solvers expect.
    return (0.5 * mesh_->volumes()[element]) * (K + K.transpose()).eval();
}

template class HyperelasticFem<2>;
template class HyperelasticFem<3>;

}  // namespace pliant
