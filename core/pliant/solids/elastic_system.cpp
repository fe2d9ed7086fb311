#include <pliant/math/error.h>
#include <pliant/math/parallel.h>
#include <pliant/solids/elastic_system.h>
#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <cmath>

#include <fmt/format.h>

namespace pliant {
namespace {

template <int Dim>
Eigen::Map<const Points<Dim>> columns(ConstDofs dofs) {
    return {dofs.data(), Dim, dofs.size() / Dim};
}

template <int Dim>
Real mean_spacing(const Points<Dim>& rest) {
    const Vec<Dim> extent = rest.rowwise().maxCoeff() - rest.rowwise().minCoeff();
    return extent.norm() / std::pow(static_cast<Real>(rest.cols()), Real{1} / Dim);
}

}  // namespace

template <int Dim>
void BlockTangent<Dim>::set(const NodeBlocks<Dim>& blocks, const SparseMatrix& matrix) {
    blocks_ = &blocks;
    matrix_ = &matrix;
    inverse_.resize(static_cast<std::size_t>(blocks.node_count()));
    for (Index n = 0; n < blocks.node_count(); ++n) {
        const Mat<Dim> block = blocks.at_node(n, matrix);
        if (Eigen::LLT<Mat<Dim>>(block).info() != Eigen::Success) {
            Failure failure;
            failure.kind = FailureKind::not_converged;
            failure.index = n;
            failure.what = fmt::format("the matrix of the Newton iteration has no positive diagonal block at node {}", n);
            throw Diverged(failure);
        }
        inverse_[static_cast<std::size_t>(n)] = block.inverse();
    }
}

template <int Dim>
void BlockTangent<Dim>::precondition(const VecX& r, VecX& z) const {
    parallel_parts(blocks_->node_count(), Dim * Dim, [&](Index first, Index last, int) {
        for (Index n = first; n < last; ++n)
            z.template segment<Dim>(Dim * n).noalias() = inverse_[static_cast<std::size_t>(n)] * r.template segment<Dim>(Dim * n);
    });
}

template <int Dim>
ElasticSystem<Dim>::ElasticSystem(const ElasticBody<Dim>& body, const Points<Dim>& rest, const Mass& mass)
    : body_(body), rest_(rest), mass_(mass), blocks_(body.pattern()), matrix_(body.pattern()), frozen_(body.pattern()) {
    if (rest.cols() != body.node_count() || mass.size() != Dim * body.node_count())
        throw Refused(fmt::format("a body of {} nodes, {} positions at rest and masses of {} nodes: give one for each node",
                                  body.node_count(), rest.cols(), mass.size() / Dim));
    if (mass.matrix() && mass.matrix()->nonZeros() != body.pattern().nonZeros())
        throw Refused("a mass matrix with another pattern than the stiffness of its body");
    VecX weight;
    mass.multiply(VecX::Ones(mass.size()), weight);
    node_mass_ = weight(Eigen::seqN(0, body.node_count(), Dim));
    spacing_ = mean_spacing<Dim>(rest);
    displacement_ = internal_ = Points<Dim>::Zero(Dim, body.node_count());
    product_ = velocity_ = VecX::Zero(mass.size());
    start_ = flat(rest);
}

template <int Dim>
const Points<Dim>& ElasticSystem<Dim>::displacement(ConstDofs x) const {
    displacement_ = columns<Dim>(x) - rest_;
    return displacement_;
}

template <int Dim>
void ElasticSystem<Dim>::begin_step(ConstDofs x) {
    start_ = x;
    if (!body_.is_linear()) frozen_known_ = false;
    pressing_.setZero(Dim, pressure ? body_.node_count() : 0);
    if (pressure) pressure->add_forces(columns<Dim>(x), pressing_);
}

template <int Dim>
const SparseMatrix& ElasticSystem<Dim>::damping_stiffness() const {
    if (!frozen_known_) body_.stiffness(displacement(start_), !body_.is_linear(), frozen_);
    frozen_known_ = true;
    return frozen_;
}

// K v, in product_.
template <int Dim>
void ElasticSystem<Dim>::multiply_damping_stiffness(ConstDofs v) const {
    velocity_ = v;
    blocks_.multiply(damping_stiffness(), velocity_, product_);
}

template <int Dim>
Real ElasticSystem<Dim>::potential(ConstDofs x) const {
    const Real pressed = pressing_.size() > 0 ? -flat(pressing_).dot(x) : Real{0};
    return body_.energy(displacement(x)) + external_energy<Dim>(load, node_mass_, columns<Dim>(x)) +
           terms.potential(columns<Dim>(x)) + pressed;
}

template <int Dim>
Real ElasticSystem<Dim>::dissipation(ConstDofs v) const {
    Real power = terms.drag_power(columns<Dim>(v));
    if (mass_damping > 0) {
        velocity_ = v;
        power += mass_damping * mass_.square(velocity_);
    }
    if (stiffness_damping > 0) {
        multiply_damping_stiffness(v);
        power += stiffness_damping * v.dot(product_);
    }
    return power / 2;
}

template <int Dim>
void ElasticSystem<Dim>::force(ConstDofs x, ConstDofs v, Dofs f) const {
    Eigen::Map<Points<Dim>> forces(f.data(), Dim, f.size() / Dim);
    body_.internal_force(displacement(x), internal_);
    forces = -internal_;
    if (stiffness_damping > 0) {
        multiply_damping_stiffness(v);
        f -= stiffness_damping * product_;
    }
    if (mass_damping > 0) {
        mass_.multiply(v, product_);
        f -= mass_damping * product_;
    }
    add_external_forces<Dim>(load, node_mass_, columns<Dim>(x), forces);
    terms.add_forces(columns<Dim>(x), columns<Dim>(v), forces);
    if (pressing_.size() > 0) forces += pressing_;
}

template <int Dim>
void ElasticSystem<Dim>::add_mass(Real rate, const Mass& mass) {
    if (mass.matrix()) {
        matrix_.coeffs() += rate * mass.matrix()->coeffs();
        return;
    }
    for (Index n = 0; n < node_mass_.size(); ++n)
        blocks_.add_at_node(n, (rate * mass.diagonal().segment<Dim>(Dim * n)).asDiagonal().toDenseMatrix(), matrix_);
}

template <int Dim>
const SparseMatrix& ElasticSystem<Dim>::stiffness(ConstDofs x, Real velocity_rate, Curvature curvature) {
    const Real damping = velocity_rate * stiffness_damping;
    if (body_.is_linear()) {
        matrix_.coeffs() = (1 + damping) * damping_stiffness().coeffs();
    } else {
        if (damping > 0) damping_stiffness();
        body_.stiffness(displacement(x), curvature == Curvature::positive, matrix_);
        if (damping > 0) matrix_.coeffs() += damping * frozen_.coeffs();
    }
    if (mass_damping > 0) add_mass(velocity_rate * mass_damping, mass_);
    const auto add = [this](Index node, const Mat<Dim>& block) { blocks_.add_at_node(node, block, matrix_); };
    if (load.pull.active()) add(load.pull.node, load.pull.stiffness * Mat<Dim>::Identity());
    terms.add_stiffness(velocity_rate, add);
    return matrix_;
}

template <int Dim>
const LinearisedSystem* ElasticSystem<Dim>::linearise(ConstDofs x, Real velocity_rate, Real acceleration_rate, const Mass& mass) {
    stiffness(x, velocity_rate, Curvature::positive);
    add_mass(acceleration_rate, mass);
    tangent_.set(blocks_, matrix_);
    return &tangent_;
}

template class BlockTangent<2>;
template class BlockTangent<3>;
template class ElasticSystem<2>;
template class ElasticSystem<3>;

}  // namespace pliant
