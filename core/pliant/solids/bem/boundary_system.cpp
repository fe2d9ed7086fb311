#include <pliant/math/dense_lu.h>
#include <pliant/math/dense_matrix.h>
#include <pliant/math/error.h>
#include <pliant/solids/bem/boundary_system.h>
#include <pliant/solids/displacement_constraints.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace pliant {
namespace {

// "(1, 0, 2.5)"
template <class Vector>
std::string in_brackets(const Vector& v) {
    return fmt::format("({:.6g})", fmt::join(v.data(), v.data() + v.size(), ", "));
}

// About the origin: a number in the plane, a vector in space.
Vec<1> moment_of(const Vec<2>& X, const Vec<2>& f) { return Vec<1>(X.x() * f.y() - X.y() * f.x()); }
Vec<3> moment_of(const Vec<3>& X, const Vec<3>& f) {
    return Vec<3>(X.y() * f.z() - X.z() * f.y(), X.z() * f.x() - X.x() * f.z(), X.x() * f.y() - X.y() * f.x());
}

}  // namespace

template <int Dim>
BoundarySystem<Dim>::BoundarySystem(Points<Dim> nodes, std::vector<Element> elements, const Lame& material, bool unbounded)
    : nodes_(std::move(nodes)), elements_(std::move(elements)), shear_(material.mu), unbounded_(unbounded) {
    for (const Element& e : elements_) {
        first_slot_.push_back(slot_count());
        for (int a = 0; a < e.count; ++a) node_of_slot_.push_back(e.nodes[static_cast<std::size_t>(a)]);
    }
    H_ = MatX::Zero(unknowns(), unknowns());
    G_ = MatX::Zero(unknowns(), Dim * slot_count());
}

template <int Dim>
void BoundarySystem<Dim>::clear() {
    H_.setZero();
    G_.setZero();
}

template <int Dim>
void BoundarySystem<Dim>::begin_rows(Index node) {
    H_.template middleRows<Dim>(Dim * node).setZero();
    G_.template middleRows<Dim>(Dim * node).setZero();
}

template <int Dim>
void BoundarySystem<Dim>::end_rows(Index node) {
    Mat<Dim> missing = (unbounded_ ? 1.0 : 0.0) * Mat<Dim>::Identity();
    for (Index n = 0; n < node_count(); ++n) missing -= H_.template block<Dim, Dim>(Dim * node, Dim * n);
    H_.template block<Dim, Dim>(Dim * node, Dim * node) += missing;
}

template <int Dim>
BoundaryConditions BoundarySystem<Dim>::free_boundary() const {
    return {std::vector<char>(static_cast<std::size_t>(Dim * slot_count()), 0), VecX::Zero(Dim * slot_count())};
}

template <int Dim>
typename BoundarySystem<Dim>::Held BoundarySystem<Dim>::find_held(const BoundaryConditions& conditions) const {
    Held found{std::vector<char>(static_cast<std::size_t>(unknowns()), 0), VecX::Zero(unknowns())};
    for (Index s = 0; s < Dim * slot_count(); ++s) {
        const Index node = node_of_slot_[static_cast<std::size_t>(s / Dim)], dof = Dim * node + s % Dim;
        const Real value = conditions.value[s];
        if (!std::isfinite(value))
            throw Refused(fmt::format("node {} of the boundary has the condition {}, which is no finite number", node, value));
        if (!conditions.held[static_cast<std::size_t>(s)]) continue;
        char& held = found.held[static_cast<std::size_t>(dof)];
        if (held && found.displacement[dof] != value)
            throw Refused(
                fmt::format("node {} of the boundary is held at {} m and at {} m", node, found.displacement[dof], value));
        held = 1, found.displacement[dof] = value;
    }
    return found;
}

// Combinations of the rigid motions that leave what is held where it is, each of size 1: the null space of those rows.
template <int Dim>
MatX BoundarySystem<Dim>::free_rigid_motions(const Held& held) const {
    Points<Dim> scaled = nodes_.colwise() - Vec<Dim>(nodes_.rowwise().mean());
    scaled /= scaled.cwiseAbs().maxCoeff();
    const MatX all = rigid_modes<Dim>(scaled);
    MatX gram = MatX::Zero(all.cols(), all.cols());
    for (Index i = 0; i < all.rows(); ++i)
        if (held.held[static_cast<std::size_t>(i)]) gram += all.row(i).transpose() * all.row(i);
    const DenseEigen eigen = dense_eigen(gram);
    Index null = 0;
    while (null < eigen.values.size() && eigen.values[null] <= 1e-12 * static_cast<Real>(node_count())) ++null;
    MatX free = all * eigen.vectors.leftCols(null);
    for (Index k = 0; k < null; ++k) free.col(k).normalize();
    return free;
}

template <int Dim>
void BoundarySystem<Dim>::require_balance(const BoundaryConditions& conditions, const MatX& modes) const {
    if (modes.cols() == 0) return;
    Vec<Dim> force = Vec<Dim>::Zero();
    VecX work = VecX::Zero(modes.cols());
    auto moment = moment_of(force, force);
    Real size = 0;
    for (std::size_t e = 0; e < elements_.size(); ++e)
        for (int b = 0; b < elements_[e].count; ++b) {
            // What the traction does at node b.
            Vec<Dim> f = Vec<Dim>::Zero();
            for (int a = 0; a < elements_[e].count; ++a)
                for (int k = 0; k < Dim; ++k)
                    if (const Index s = Dim * slot_of(static_cast<Index>(e), a) + k;
                        !conditions.held[static_cast<std::size_t>(s)])
                        f[k] += elements_[e].products(a, b) * conditions.value[s];
            const int node = elements_[e].nodes[static_cast<std::size_t>(b)];
            force += f, size += f.norm();
            moment += moment_of(Vec<Dim>(nodes_.col(node)), f);
            work += modes.template middleRows<Dim>(Dim * node).transpose() * f;
        }
    constexpr Real tolerance = 1e-3;  // flat elements on a smooth surface balance to their own error
    if (work.cwiseAbs().maxCoeff() <= tolerance * size * modes.cwiseAbs().maxCoeff()) return;
    throw Refused(fmt::format(
        "the tractions do not balance, and nothing holds the body against them: their resultant is {} N{}, with a moment "
        "of {} N{} about the origin; balance them, or hold a part of the boundary",
        in_brackets(force), Dim == 2 ? " per metre of thickness" : "", in_brackets(moment), Dim == 2 ? "" : " m"));
}

template <int Dim>
BoundarySolution<Dim> BoundarySystem<Dim>::solve(const BoundaryConditions& conditions) const {
    const Held held = find_held(conditions);
    const MatX modes = unbounded_ ? MatX(unknowns(), 0) : free_rigid_motions(held);
    require_balance(conditions, modes);

    // Displacements are solved for in m, tractions in shear moduli; the free motions border the matrix.
    const Index n = unknowns();
    MatX A = MatX::Zero(n + modes.cols(), n + modes.cols());
    VecX b = VecX::Zero(n + modes.cols());
    if (conditions.remote.size() > 0) b.head(n) = conditions.remote;
    for (Index dof = 0; dof < n; ++dof)
        held.held[static_cast<std::size_t>(dof)] ? void(b.head(n) -= held.displacement[dof] * H_.col(dof))
                                                 : void(A.col(dof).head(n) = H_.col(dof));
    const auto dof_of = [&](Index s) { return Dim * node_of_slot_[static_cast<std::size_t>(s / Dim)] + s % Dim; };
    for (Index s = 0; s < Dim * slot_count(); ++s)
        conditions.held[static_cast<std::size_t>(s)] ? void(A.col(dof_of(s)).head(n) -= shear_ * G_.col(s))
                                                     : void(b.head(n) += conditions.value[s] * G_.col(s));
    A.topRightCorner(n, modes.cols()) = modes;
    A.bottomLeftCorner(modes.cols(), n) = modes.transpose();
    const VecX x = DenseLu(std::move(A)).solve(b);

    BoundarySolution<Dim> solution{Points<Dim>(Dim, node_count()),
                                   Points<Dim>(Dim, slot_count()),
                                   modes.cols(),
                                   modes,
                                   VecX(x.tail(modes.cols())),
                                   VecX(b.head(n))};
    for (Index dof = 0; dof < n; ++dof)
        solution.displacement.data()[dof] = held.held[static_cast<std::size_t>(dof)] ? held.displacement[dof] : x[dof];
    for (Index s = 0; s < Dim * slot_count(); ++s)
        solution.traction.data()[s] = conditions.held[static_cast<std::size_t>(s)] ? shear_ * x[dof_of(s)] : conditions.value[s];
    return solution;
}

template class BoundarySystem<2>;
template class BoundarySystem<3>;

}  // namespace pliant
