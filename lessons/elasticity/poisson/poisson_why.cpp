// Why nodes and elements of the cube and the panel have the numbers that they have.
#include "poisson.h"

#include "kits/linear_body/linear_body_why.h"

#include <pliant/continuum/contraction_law.h>
#include <pliant/solids/cooks_membrane_table.h>

#include <pliant/continuum/deformation.h>

#include <fmt/format.h>

#include <algorithm>

namespace pliant::poisson {

// A stretch that is over changes nothing.
std::optional<Explanation> PoissonLesson::why_step(const Question& q) const {
    if (!advancing_) return std::nullopt;
    if (q.field == "element_volume") return why_volume(q.index);
    if (q.field == "increment") return why_increment(q.index, q.component);
    if (q.field == "displacement")
        return Explanation{
            "u′ = u + Δu",
            {Input::before("u", "displacement", q.index, q.component), Input::now("Δu", "increment", q.index, q.component)}};
    if (!cube_->pulled(q.index, q.component)) return fixed_value("Δx = 0: only the far face is pulled", 0);
    return Explanation{
        "Δx = s L / N",
        {Input::of(axial_strain, "s"), length, Input::constant("N", static_cast<Real>(steps()), "", "number of steps")}};
}

Explanation PoissonLesson::why_increment(Index node, int component) const {
    if (cube_->pulled(node, component)) return {"Δu = Δx", {Input::now("Δx", "prescribed", node, component)}};
    if (cube_->held(node, component)) return fixed_value("Δu = 0: the face slides on rollers", 0);
    return linear_body::why_unknown<3>({&cube_->body().stiffness(), 3 * node + component, "u", "increment"},
                                       {Input::constant("f_a", 0, "N", "no load on the node")});
}

// det(I + Σ u ⊗ ∇N) over the corners of the tetrahedron.
Explanation PoissonLesson::why_volume(Index element) const {
    const SimplexMesh<3>& mesh = cube_->rest();
    Explanation e{"V/V₀ = det(I + Σ u_a ∇N_aᵀ)", {}};
    for (int a = 0; a < 4; ++a)
        for (int c = 0; c < 3; ++c) {
            const Index node = mesh.simplices()(a, element);
            e.inputs.push_back(Input::now(fmt::format("u{}_{}", axis_name(c), node), "displacement", node, c));
        }
    const Eigen::Matrix<Real, 3, 4> gradients = mesh.gradients(element);
    const auto F = [gradients](std::span<const Real> x) -> Mat<3> {
        return Mat<3>::Identity() + Eigen::Map<const Eigen::Matrix<Real, 3, 4>>(x.data()) * gradients.transpose();
    };
    e.evaluate = [F](std::span<const Real> x) { return volume_ratio<3>(F(x)); };
    e.substitute = [F](std::span<const Real> x) {
        const Mat<3> f = F(x);
        return fmt::format("det with the diagonal {}, {}, {}", as_factor(f(0, 0)), as_factor(f(1, 1)), as_factor(f(2, 2)));
    };
    return e;
}

std::optional<Explanation> PoissonLesson::why_bent(const Question& q) const {
    if (!advancing_) return std::nullopt;
    if (q.component == 2) return fixed_value("u_z = 0: plane strain", 0);
    if (membrane_->mesh().points()(0, q.index) == 0) return fixed_value("u = 0: clamped", 0);
    const Real nu = ratios()[static_cast<std::size_t>(done())];
    const LinearFem<2> body(membrane_->mesh(), IsotropicModuli::from_young_poisson(1, nu).lame());
    return linear_body::why_unknown<2>(
        {&body.stiffness(), 2 * q.index + q.component, "u", "displacement"},
        {Input::constant("f_a", membrane_->unit_load()(q.component, q.index), "N", "load on the node")});
}

// -------------------------------------------------------------------------------------------------------------- probes

void PoissonLesson::explain_probes() {
    const auto give = [this](std::string_view name, std::function<Explanation()> why) {
        std::ranges::find(probes, name, &Probe::name)->explain = std::move(why);
    };
    const auto reached_part = [this] {
        return part("s = S k / N", {Input::of(axial_strain, "S"), Input::constant("k", done_[0], "", "steps that are done"),
                                    Input::constant("N", static_cast<Real>(steps()), "", "number of steps")});
    };
    const auto means = [this](std::string_view symbol, const char* from, const char* to, int component) {
        const auto mean = [&](const char* face) {
            const auto& nodes = cube_->rest().nodes(face);
            std::vector<std::pair<Input, Input>> terms;
            for (const Index n : nodes)
                terms.emplace_back(Input::constant("w", 1 / static_cast<Real>(nodes.size()), "", "share of the node in the face"),
                                   Input::now(fmt::format("u_{}", n), "displacement", n, component));
            const std::string name = fmt::format("ū_{}", std::string_view(face).substr(2));
            return Input::part(name, "m", weighted_sum(name + " = Σ w u", terms));
        };
        return Explanation{fmt::format("{} = (ū_{} − ū_{}) / L", symbol, to + 2, from + 2), {mean(to), mean(from), length}};
    };
    give("transverse_fem", [=] { return means("ΔL′/L", "z_max", "z_min", 2); });
    give("strain", [=] { return means("ΔL/L", "x_min", "x_max", 0); });
    give("transverse_exact", [=, this] { return Explanation{"ΔL′/L = 1 − (1 + s)^(−ν)", {reached_part(), poisson_ratio}}; });
    give("transverse_linear", [=, this] { return Explanation{"ΔL′/L = ν s", {poisson_ratio, reached_part()}}; });
    give("transverse_error", [] {
        return Explanation{"error = |c − e|", {Input::now("c", "transverse_fem", 0), Input::now("e", "transverse_exact", 0)}};
    });
    give("volume_ratio", [this] {
        const SimplexMesh<3>& mesh = cube_->rest();
        std::vector<std::pair<Input, Input>> terms;
        for (Index e = 0; e < mesh.simplex_count(); ++e)
            terms.emplace_back(
                Input::constant(fmt::format("w_{}", e), mesh.volumes()[e] / mesh.volume(), "", "share of the volume"),
                Input::now(fmt::format("v_{}", e), "element_volume", e));
        return weighted_sum("V/V₀ = Σ w v", terms);
    });
    give("times_too_stiff", [this] {
        const Real right = converged_deflection(ratios()[static_cast<std::size_t>(done() - 1)]).value_or(0);
        return Explanation{"ratio = u_ref / u",
                           {Input::constant("u_ref", right, "m", "converged deflection"), Input::now("u", "deflection", 0)}};
    });
}

}  // namespace pliant::poisson
