#include <pliant/math/error.h>
#include <pliant/solids/displacement_constraints.h>

#include <pliant/math/dense_matrix.h>
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace pliant {
namespace {

// Rows of the rigid modes that belong to prescribed components of the given nodes.
template <int Dim>
MatX prescribed_rows(const MatX& modes, const std::vector<Index>& nodes, const DisplacementConstraints<Dim>& constraints) {
    std::vector<Index> rows;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (int k = 0; k < Dim; ++k)
            if (constraints.prescribed(nodes[i], k)) rows.push_back(Dim * static_cast<Index>(i) + k);
    return modes(rows, Eigen::all);
}

// Nodes of each disconnected part, ascending.
template <int Dim>
std::vector<std::vector<Index>> nodes_of_parts(const SimplexMesh<Dim>& mesh) {
    const std::vector<int> parts = mesh.connected_parts();
    std::vector<std::vector<Index>> nodes;
    std::vector<int> part_of(static_cast<std::size_t>(mesh.node_count()), 0);
    for (Index e = 0; e < mesh.simplex_count(); ++e)
        for (int a = 0; a <= Dim; ++a)
            part_of[static_cast<std::size_t>(mesh.simplices()(a, e))] = parts[static_cast<std::size_t>(e)];
    for (Index n = 0; n < mesh.node_count(); ++n) {
        const auto part = static_cast<std::size_t>(part_of[static_cast<std::size_t>(n)]);
        if (nodes.size() <= part) nodes.resize(part + 1);
        nodes[part].push_back(n);
    }
    return nodes;
}

}  // namespace

template <int Dim>
DisplacementConstraints<Dim>::DisplacementConstraints(Index node_count)
    : flags_(static_cast<std::size_t>(Dim * node_count), 0), values_(Points<Dim>::Zero(Dim, node_count)) {}

template <int Dim>
void DisplacementConstraints<Dim>::prescribe(Index node, int component, Real value) {
    if (node < 0 || node >= values_.cols() || component < 0 || component >= Dim)
        throw Refused(
            fmt::format("component {} of node {} cannot be prescribed: there are {} nodes with {} components, counted from 0",
                        component, node, values_.cols(), Dim));
    if (!std::isfinite(value))
        throw Refused(fmt::format("displacement {} of node {}", component, node), value, "m", "a finite value");
    char& flag = flags_[static_cast<std::size_t>(Dim * node + component)];
    if (flag && values_(component, node) != value)
        throw Refused(fmt::format("displacement {} of node {} is prescribed twice: {} m and {} m", component, node,
                                  values_(component, node), value));
    flag = 1;
    values_(component, node) = value;
}

template <int Dim>
void DisplacementConstraints<Dim>::prescribe(const std::vector<Index>& nodes, int component, Real value) {
    for (const Index node : nodes) prescribe(node, component, value);
}

template <int Dim>
void DisplacementConstraints<Dim>::prescribe(const std::vector<Index>& nodes, const Vec<Dim>& value) {
    for (int k = 0; k < Dim; ++k) prescribe(nodes, k, value[k]);
}

template <int Dim>
Real DisplacementConstraints<Dim>::distance_from(const Points<Dim>& displacement) const {
    Real largest = 0;
    for (Index i = 0; i < displacement.size(); ++i)
        if (flags_[static_cast<std::size_t>(i)])
            largest = std::max(largest, std::abs(values_.data()[i] - displacement.data()[i]));
    return largest;
}

template <int Dim>
MatX rigid_modes(const Points<Dim>& points) {
    constexpr int rotations = Dim * (Dim - 1) / 2;
    MatX modes = MatX::Zero(points.size(), Dim + rotations);
    if (points.cols() == 0) return modes;
    const Vec<Dim> centre = points.rowwise().mean();
    for (Index n = 0; n < points.cols(); ++n) {
        const Vec<Dim> r = points.col(n) - centre;
        modes.block(Dim * n, 0, Dim, Dim).setIdentity();
        // A rotation from axis i towards axis j moves r by r_i along j and by -r_j along i.
        for (int m = 0; m < rotations; ++m) {
            const int i = Dim == 2 ? 0 : (m + 1) % 3, j = Dim == 2 ? 1 : (m + 2) % 3;
            modes(Dim * n + j, Dim + m) = r[i];
            modes(Dim * n + i, Dim + m) = -r[j];
        }
    }
    return modes;
}

template <int Dim>
Index unconstrained_rigid_modes(const SimplexMesh<Dim>& mesh, const DisplacementConstraints<Dim>& constraints) {
    return unconstrained_rigid_modes(mesh.points(), nodes_of_parts(mesh), constraints);
}

template <int Dim>
Index unconstrained_rigid_modes(const Points<Dim>& all_points, const std::vector<std::vector<Index>>& parts,
                                const DisplacementConstraints<Dim>& constraints) {
    // What is rounding, and what a lever arm, relative to the size of a part.
    constexpr Real tolerance = 1e-9;
    Index count = 0;
    for (const std::vector<Index>& nodes : parts) {
        Points<Dim> points = all_points(Eigen::all, nodes);
        const Vec<Dim> centre = points.rowwise().mean();
        points.colwise() -= centre;
        points /= points.cwiseAbs().maxCoeff();
        const MatX modes = rigid_modes<Dim>(points);
        const MatX rows = prescribed_rows<Dim>(modes, nodes, constraints);
        count += modes.cols() - (rows.rows() > 0 ? rank(rows, tolerance) : 0);
    }
    return count;
}

template <int Dim>
void require_support(const SimplexMesh<Dim>& mesh, const DisplacementConstraints<Dim>& constraints) {
    require_support(mesh.points(), nodes_of_parts(mesh), constraints);
}

template <int Dim>
void require_support(const Points<Dim>& points, const std::vector<std::vector<Index>>& parts,
                     const DisplacementConstraints<Dim>& constraints) {
    const Index count = unconstrained_rigid_modes(points, parts, constraints);
    if (count == 0) return;
    throw Refused(
        fmt::format("singular: {} rigid mode{} unconstrained; prescribe more displacements", count, count == 1 ? "" : "s"));
}

#define PLIANT_INSTANTIATE(Dim)                                                                             \
    template class DisplacementConstraints<Dim>;                                                            \
    template MatX rigid_modes<Dim>(const Points<Dim>&);                                                     \
    template Index unconstrained_rigid_modes(const SimplexMesh<Dim>&, const DisplacementConstraints<Dim>&); \
    template Index unconstrained_rigid_modes(const Points<Dim>&, const std::vector<std::vector<Index>>&,    \
                                             const DisplacementConstraints<Dim>&);                          \
    template void require_support(const SimplexMesh<Dim>&, const DisplacementConstraints<Dim>&);            \
    template void require_support(const Points<Dim>&, const std::vector<std::vector<Index>>&, const DisplacementConstraints<Dim>&)
PLIANT_INSTANTIATE(2);
PLIANT_INSTANTIATE(3);
#undef PLIANT_INSTANTIATE

}  // namespace pliant
