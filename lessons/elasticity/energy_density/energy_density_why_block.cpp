// Why the nodes of the block move as they do: a row of Newton's equations, and the forces of the tetrahedra about a node.
#include "energy_density.h"
#include "kits/linear_body/linear_body_why.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace pliant::energies {
namespace {

// The displacements of the corners of all tetrahedra about some nodes, as inputs, and the force on a component of these nodes
// that follows from them.
struct Patch {
    std::vector<Input> inputs;
    std::function<Real(Values)> force;
    std::size_t tetrahedra = 0;
};

Patch patch_about(const StretchedBlock& block, const std::vector<Index>& nodes, int component, Index first_row) {
    const SimplexMesh<3>& mesh = block.mesh();
    const std::set<Index> wanted(nodes.begin(), nodes.end());
    std::vector<Index> elements;
    std::set<Index> around;
    for (Index e = 0; e < mesh.simplex_count(); ++e) {
        const auto corners = mesh.simplices().col(e);
        if (std::ranges::none_of(corners, [&](int n) { return wanted.contains(n); })) continue;
        elements.push_back(e);
        around.insert(corners.begin(), corners.end());
    }
    Patch patch;
    patch.tetrahedra = elements.size();
    for (const Index n : around)
        for (int c = 0; c < 3; ++c)
            patch.inputs.push_back(
                Input::now(fmt::format("u{}_{}", axis_name(c), n), "displacement", first_row + n, c).in("u_n"));
    patch.force = [&block, elements, wanted, component,
                   order = std::vector<Index>(around.begin(), around.end())](std::span<const Real> x) {
        const SimplexMesh<3>& m = block.mesh();
        Points<3> u = Points<3>::Zero(3, m.node_count());
        for (std::size_t k = 0; k < order.size(); ++k) u.col(order[k]) << x[3 * k], x[3 * k + 1], x[3 * k + 2];
        Real sum = 0;
        for (const Index e : elements) {
            const Mat<3> P = block.body().density(e).P(block.body().deformation_gradient(e, u));
            for (int a = 0; a < 4; ++a)
                if (wanted.contains(m.simplices()(a, e))) sum += m.volumes()[e] * P.row(component).dot(m.gradients(e).col(a));
        }
        return sum;
    };
    return patch;
}

}  // namespace

std::optional<Explanation> EnergyDensityLesson::why_block(const Question& q) const {
    if (q.index < corners)
        return q.field == "displacement" ? std::nullopt
                                         : std::optional(fixed_value("0: the cube is deformed by F, nothing is solved for it"));
    const Index node = q.index - corners;
    if (q.field == "newton_step") return why_direction(node, q.component);
    if (q.field == "unbalanced_force") return why_unbalanced(node, q.component);
    return Explanation{"u′ = u + α d",
                       {Input::earlier("u", "displacement", q.index, q.component),
                        Input::constant("α", block_->step_length(), "", "share of the step that the line search takes"),
                        Input::now("d", "newton_step", q.index, q.component)}};
}

Explanation EnergyDensityLesson::why_direction(Index node, int component) const {
    if (block_->failed()) return fixed_value("d = 0: no direction was found");
    if (block_->supports().prescribed(node, component))
        return {"d = w − u",
                {Input::constant("w", block_->supports().values()(component, node), "m", "where the support shall be"),
                 Input::earlier("u", "displacement", corners + node, component)}};
    SparseMatrix K = block_->body().pattern();
    block_->body().stiffness(block_->before(), !block_->newton().tangent_was_definite(), K);
    return linear_body::why_unknown<3>({.matrix = &K,
                                        .row = 3 * node + component,
                                        .unknown = "d",
                                        .field = "newton_step",
                                        .first_row = corners,
                                        .added_to_diagonal = block_->newton().diagonal_shift()},
                                       {Input::earlier("r_a", "unbalanced_force", corners + node, component)});
}

Explanation EnergyDensityLesson::why_unbalanced(Index node, int component) const {
    if (block_->supports().prescribed(node, component)) return fixed_value("r = 0: the support takes what is left");
    Patch patch = patch_about(*block_, {node}, component, corners);
    return Explanation{fmt::format("r = − f(u_n), f = Σ V P·∇N over the {} tetrahedra about the node", patch.tetrahedra),
                       std::move(patch.inputs)}
        .by("f", "N", std::move(patch.force));
}

Explanation EnergyDensityLesson::why_block_stress() const {
    Patch patch = patch_about(*block_, block_->mesh().nodes("x_max"), 0, corners);
    const Real area = StretchedBlock::width_at_rest * StretchedBlock::width_at_rest;
    patch.inputs.push_back(Input::constant("A", area, "m²", "area of the end at rest"));
    return Explanation{"F/A = f(u_n) / A, f = Σ V P_x·∇N over the tetrahedra at the end", std::move(patch.inputs)}.by(
        "f", "N", std::move(patch.force));
}

Explanation EnergyDensityLesson::why_block_width() const {
    const auto mean = [this](const char* end) {
        return linear_body::mean_displacement(end, block_->middle(std::string_view(end) == "max"), 2, corners);
    };
    return {"w/w₀ = 1 + (ū_max − ū_min) / w₀",
            {mean("max"), mean("min"), Input::constant("w₀", StretchedBlock::width_at_rest, "m", "width at rest")}};
}

}  // namespace pliant::energies
