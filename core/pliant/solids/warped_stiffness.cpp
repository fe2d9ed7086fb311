#include <pliant/continuum/deformation.h>
#include <pliant/solids/linear_element.h>
#include <pliant/solids/warped_stiffness.h>

namespace pliant {
namespace {

// S - I with R^T F made symmetric.
template <int Dim>
Mat<Dim> turned_strain(const Mat<Dim>& R, const Mat<Dim>& F) {
    const Mat<Dim> product = R.transpose() * F;
    return 0.5 * (product + product.transpose()) - Mat<Dim>::Identity();
}

}  // namespace

template <int Dim>
Mat<Dim> WarpedStiffness<Dim>::rotation(Index element, const Points<Dim>& displacement) const {
    return nearest_rotation<Dim>(body_.deformation_gradient(element, displacement));
}

template <int Dim>
typename WarpedStiffness<Dim>::ElementMatrix WarpedStiffness<Dim>::rest_stiffness(Index element) const {
    return linear_element_stiffness<Dim>(mesh().gradients(element), mesh().volumes()[element], body_.density(element).material());
}

template <int Dim>
typename WarpedStiffness<Dim>::ElementMatrix WarpedStiffness<Dim>::turned_stiffness(Index element, const Mat<Dim>& R) const {
    return linear_element_stiffness<Dim>(R * mesh().gradients(element), mesh().volumes()[element],
                                         body_.density(element).material());
}

template <int Dim>
const std::vector<Mat<Dim>>& WarpedStiffness<Dim>::rotations(const Points<Dim>& displacement) const {
    for (std::size_t k = 0; k < 2; ++k)
        if (kept_[k].displacement.cols() == displacement.cols() && kept_[k].displacement == displacement)
            return latest_ = k, kept_[k].of;
    latest_ = 1 - latest_;
    Rotations& fresh = kept_[latest_];
    fresh.displacement = displacement;
    fresh.of.resize(static_cast<std::size_t>(mesh().simplex_count()));
    parallel_parts(mesh().simplex_count(), 16 * Dim * Dim, [&](Index first, Index last, int) {
        for (Index e = first; e < last; ++e) fresh.of[static_cast<std::size_t>(e)] = rotation(e, displacement);
    });
    return fresh.of;
}

template <int Dim>
Real WarpedStiffness<Dim>::energy(const Points<Dim>& displacement) const {
    const auto& R = rotations(displacement);
    return parallel_sum(mesh().simplex_count(), [&](Index first, Index last) {
        Real sum = 0;
        for (Index e = first; e < last; ++e)
            sum += mesh().volumes()[e] *
                   hooke_energy_density<Dim>(
                       body_.density(e).material(),
                       turned_strain<Dim>(R[static_cast<std::size_t>(e)], body_.deformation_gradient(e, displacement)));
        return sum;
    });
}

template <int Dim>
void WarpedStiffness<Dim>::internal_force(const Points<Dim>& displacement, Points<Dim>& force) const {
    const auto& all = rotations(displacement);
    const auto stress = [&](Index e, int) -> Mat<Dim> {
        const Mat<Dim>& R = all[static_cast<std::size_t>(e)];
        return R *
               hooke_stress<Dim>(body_.density(e).material(), turned_strain<Dim>(R, body_.deformation_gradient(e, displacement)));
    };
    body_.collect(stress, force);
}

template <int Dim>
void WarpedStiffness<Dim>::stiffness(const Points<Dim>& displacement, bool, SparseMatrix& matrix) const {
    const auto& R = rotations(displacement);
    body_.assemble([&](Index e) { return turned_stiffness(e, R[static_cast<std::size_t>(e)]); }, matrix);
}

template class WarpedStiffness<2>;
template class WarpedStiffness<3>;

}  // namespace pliant
