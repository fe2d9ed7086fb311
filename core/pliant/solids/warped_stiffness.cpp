#include <pliant/continuum/deformation.h>
#include <pliant/solids/linear_element.h>
#include <pliant/solids/warped_stiffness.h>

namespace pliant {

template <int Dim>
Mat<Dim> WarpedStiffness<Dim>::rotation(Index element, const Points<Dim>& displacement) const {
    return nearest_rotation<Dim>(body_.deformation_gradient(element, displacement));
}

template <int Dim>
typename WarpedStiffness<Dim>::ElementMatrix WarpedStiffness<Dim>::rest_stiffness(Index element) const {
    return linear_element_stiffness<Dim>(mesh().gradients(element), mesh().volumes()[element], body_.density(element).material());
}

template <int Dim>
typename WarpedStiffness<Dim>::ElementMatrix WarpedStiffness<Dim>::element_stiffness(Index element,
                                                                                     const Points<Dim>& displacement) const {
    return linear_element_stiffness<Dim>(rotation(element, displacement) * mesh().gradients(element), mesh().volumes()[element],
                                         body_.density(element).material());
}

template <int Dim>
void WarpedStiffness<Dim>::stiffness(const Points<Dim>& displacement, bool, SparseMatrix& matrix) const {
    body_.assemble([&](Index e) { return element_stiffness(e, displacement); }, matrix);
}

template class WarpedStiffness<2>;
template class WarpedStiffness<3>;

}  // namespace pliant
