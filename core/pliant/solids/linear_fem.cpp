#include <pliant/solids/element_materials.h>
#include <pliant/solids/linear_element.h>
#include <pliant/solids/linear_fem.h>

#include <algorithm>

namespace pliant {
template <int Dim>
LinearFem<Dim>::LinearFem(const SimplexMesh<Dim>& mesh, const Lame& material)
    : LinearFem(mesh, std::vector<Lame>(static_cast<std::size_t>(mesh.simplex_count()), material)) {}

template <int Dim>
LinearFem<Dim>::LinearFem(const SimplexMesh<Dim>& mesh, std::vector<Lame> materials)
    : mesh_(&mesh),
      materials_(std::move(materials)),
      assembly_(mesh.simplices(), mesh.node_count()),
      stiffness_(assembly_.pattern()) {
    check_materials<Dim>(materials_, mesh_->simplex_count());
    assemble();
}

template <int Dim>
void LinearFem<Dim>::assemble() {
    std::fill_n(stiffness_.valuePtr(), static_cast<std::size_t>(stiffness_.nonZeros()), 0.0);
    for (Index e = 0; e < mesh_->simplex_count(); ++e) assembly_.add(e, element_stiffness(e), stiffness_);
}

template <int Dim>
typename LinearFem<Dim>::ElementMatrix LinearFem<Dim>::element_stiffness(Index element) const {
    return linear_element_stiffness<Dim>(mesh_->gradients(element), mesh_->volumes()[element], material(element));
}

template <int Dim>
Mat<Dim> LinearFem<Dim>::element_strain(Index element, const Points<Dim>& displacement) const {
    return cauchy_strain<Dim>(mesh_->field_gradient(element, displacement));
}

template <int Dim>
Mat<Dim> LinearFem<Dim>::element_stress(Index element, const Points<Dim>& displacement) const {
    return hooke_stress<Dim>(material(element), element_strain(element, displacement));
}

template <int Dim>
void LinearFem<Dim>::strain(const Points<Dim>& displacement, Tensors<Dim>& strain) const {
    strain.resize(Dim * Dim, mesh_->simplex_count());
    for (Index e = 0; e < mesh_->simplex_count(); ++e) tensor<Dim>(strain, e) = element_strain(e, displacement);
}

template <int Dim>
void LinearFem<Dim>::stress(const Points<Dim>& displacement, Tensors<Dim>& stress) const {
    stress.resize(Dim * Dim, mesh_->simplex_count());
    for (Index e = 0; e < mesh_->simplex_count(); ++e) tensor<Dim>(stress, e) = element_stress(e, displacement);
}

template <int Dim>
void LinearFem<Dim>::internal_force(const Points<Dim>& displacement, Points<Dim>& force) const {
    force.setZero(Dim, mesh_->node_count());
    for (Index e = 0; e < mesh_->simplex_count(); ++e) {
        const Mat<Dim> stress = mesh_->volumes()[e] * element_stress(e, displacement);
        const auto g = mesh_->gradients(e);
        for (int a = 0; a < corners; ++a) force.col(mesh_->simplices()(a, e)).noalias() += stress * g.col(a);
    }
}

template <int Dim>
Real LinearFem<Dim>::strain_energy(const Points<Dim>& displacement) const {
    Real energy = 0;
    for (Index e = 0; e < mesh_->simplex_count(); ++e)
        energy += mesh_->volumes()[e] * hooke_energy_density<Dim>(material(e), element_strain(e, displacement));
    return energy;
}

template class LinearFem<2>;
template class LinearFem<3>;

}  // namespace pliant
