#include <pliant/solids/springs_system.h>

namespace pliant {
namespace {

template <int Dim>
Eigen::Map<const Points<Dim>> points(ConstDofs dofs) {
    return {dofs.data(), Dim, dofs.size() / Dim};
}

}  // namespace

template <int Dim>
SpringSystem<Dim>::SpringSystem(const Springs& springs, const VecX& mass) : springs_(springs), mass_(mass) {}

template <int Dim>
Real SpringSystem<Dim>::potential(ConstDofs x) const {
    return spring_energy<Dim>(springs_, points<Dim>(x)) + external_energy<Dim>(load, mass_, points<Dim>(x)) +
           terms.potential(points<Dim>(x));
}

template <int Dim>
Real SpringSystem<Dim>::dissipation(ConstDofs v) const {
    return 0.5 * (damping_power<Dim>(springs_, damping, points<Dim>(start_), points<Dim>(v)) + terms.drag_power(points<Dim>(v)));
}

template <int Dim>
void SpringSystem<Dim>::force(ConstDofs x, ConstDofs v, Dofs f) const {
    f.setZero();
    Eigen::Map<Points<Dim>> forces(f.data(), Dim, f.size() / Dim);
    add_spring_forces<Dim>(springs_, points<Dim>(x), forces);
    add_damping_forces<Dim>(springs_, damping, points<Dim>(start_), points<Dim>(v), forces);
    add_external_forces<Dim>(load, mass_, points<Dim>(x), forces);
    terms.add_forces(points<Dim>(x), points<Dim>(v), forces);
}

template <int Dim>
const SparseMatrix& SpringSystem<Dim>::stiffness(ConstDofs x, Real velocity_rate, Curvature curvature) {
    if (!matrix_) matrix_.emplace(springs_);
    matrix_->set_zero();
    matrix_->add_stiffness(springs_, points<Dim>(x),
                           curvature == Curvature::exact ? SpringCurvature::exact : SpringCurvature::positive);
    matrix_->add_damping(springs_, damping, points<Dim>(start_), velocity_rate);
    if (load.pull.active()) matrix_->add_at_node(load.pull.node, load.pull.stiffness * Mat<Dim>::Identity());
    terms.add_stiffness(velocity_rate, [this](Index node, const Mat<Dim>& block) { matrix_->add_at_node(node, block); });
    return matrix_->matrix();
}

template <int Dim>
SpringTangent& SpringSystem<Dim>::tangent() {
    if (!tangent_) tangent_ = std::make_unique<SpringTangent>(springs_);
    return *tangent_;
}

template <int Dim>
const LinearisedSystem* SpringSystem<Dim>::linearise(ConstDofs x, Real velocity_rate, Real acceleration_rate, const Mass& mass) {
    if constexpr (Dim != 3) {
        return nullptr;
    } else {
        if (mass.matrix()) return nullptr;
        tangent().fill(points<3>(x), points<3>(start_), damping, velocity_rate);
        const auto add = [this](Index node, const Mat<3>& block) { tangent_->add_at_node(node, block); };
        for (Index n = 0; n < mass.size() / 3; ++n)
            add(n, (acceleration_rate * mass.diagonal().segment<3>(3 * n)).asDiagonal().toDenseMatrix());
        if (load.pull.active()) add(load.pull.node, load.pull.stiffness * Mat<3>::Identity());
        terms.add_stiffness(velocity_rate, add);
        tangent_->prepare();
        return tangent_.get();
    }
}

template <int Dim>
Real SpringSystem<Dim>::length_scale(ConstDofs x) const {
    const Real mean = springs_.size() ? springs_.rest_length().mean() : 0;
    if (mean > 0 || x.size() == 0) return mean;
    const auto at = points<Dim>(x);
    return (at.rowwise().maxCoeff() - at.rowwise().minCoeff()).norm();
}

template class SpringSystem<2>;
template class SpringSystem<3>;

}  // namespace pliant
