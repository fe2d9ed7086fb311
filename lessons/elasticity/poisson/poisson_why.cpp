// Why nodes and elements of the cube and the panel have the numbers that they have.
#include "poisson.h"

#include "kits/tensors/tensor_why.h"

namespace pliant::poisson {

// A stretch that is over changes nothing.
std::optional<Explanation> PoissonLesson::why_number(const Question& q) const {
    if (!advancing_) return std::nullopt;
    if (bends()) return why_bent(q.index, q.component);
    if (q.field == "element_volume") return why_volume(q.index);
    if (q.field == "increment") return why_increment(q.index, q.component);
    if (q.field == "displacement")
        return Explanation{
            "u′ = u + Δu",
            {Input::before("u", "displacement", q.index, q.component), Input::now("Δu", "increment", q.index, q.component)}};
    if (!cube_->pulled(q.index, q.component)) return fixed_value("Δx = 0: only the far face is pulled");
    return Explanation{"Δx = s L / N", {Input::of(axial_strain, "s"), length, number_of_steps()}};
}

Explanation PoissonLesson::why_increment(Index node, int component) const {
    if (cube_->pulled(node, component)) return {"Δu = Δx", {Input::now("Δx", "prescribed", node, component)}};
    if (cube_->held(node, component)) return fixed_value("Δu = 0: the face slides on rollers");
    return linear_body::why_unknown<3>({&cube_->body().stiffness(), 3 * node + component, "u", "increment"},
                                       {Input::constant("f_a", 0, "N", "no load on the node")});
}

// The determinant of F = I + Σ u ⊗ ∇N over the corners of the tetrahedron.
Explanation PoissonLesson::why_volume(Index element) const {
    const SimplexMesh<3>& mesh = cube_->rest();
    std::vector<Input> F;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            std::vector<std::pair<Input, Input>> terms;
            for (int a = 0; a < 4; ++a) {
                const Index node = mesh.simplices()(a, element);
                terms.emplace_back(Input::now(fmt::format("u{}_{}", axis_name(i), node), "displacement", node, i),
                                   Input::constant(fmt::format("∂N_{}/∂{}", node, axis_name(j)), mesh.gradients(element)(j, a),
                                                   "1/m", "slope of the corner's shape function"));
            }
            const std::string name = why::entry("F", i, j);
            F.push_back(Input::part(
                name, "", weighted_sum(fmt::format("{} = {}Σ_a u_a ∂N_a", name, i == j ? "1 + " : ""), "u_a", "∂N_a", terms)));
        }
    return why::determinant("V/V₀", std::move(F));
}

Explanation PoissonLesson::why_bent(Index node, int component) const {
    if (component == 2) return fixed_value("u_z = 0: plane strain");
    if (membrane_->mesh().points()(0, node) == 0) return fixed_value("u = 0: clamped");
    const LinearFem<2> body(membrane_->mesh(), IsotropicModuli::from_young_poisson(1, ratio_of_round(done())).lame());
    return linear_body::why_unknown<2>(
        {&body.stiffness(), 2 * node + component, "u", "displacement"},
        {Input::constant("f_a", membrane_->unit_load()(component, node), "N", "load on the node")});
}

// How far the cube is stretched.
Input PoissonLesson::why_reached() const {
    return part("s = S k / N",
                {Input::of(axial_strain, "S"), Input::live("k", "", "steps that are done", [this] { return done_[0]; }),
                 Input::live("N", "", "number of steps", [this] { return static_cast<Real>(steps()); })});
}

void PoissonLesson::explain_probes() {
    // How far two faces have moved apart.
    const auto widening = [this](std::string_view symbol, const char* from, const char* to, int component) {
        const auto mean = [&](const char* face) {
            return linear_body::mean_displacement(std::string_view(face).substr(2), cube_->rest().nodes(face), component);
        };
        return Explanation{fmt::format("{} = (ū_{} − ū_{}) / L", symbol, to + 2, from + 2), {mean(to), mean(from), length}};
    };
    explain_probe("narrowing", [=] { return widening("ΔL′/L", "z_max", "z_min", 2); });
    explain_probe("strain", [=] { return widening("ΔL/L", "x_min", "x_max", 0); });
    explain_probe("narrowing_by_law", [this] { return Explanation{"ΔL′/L = 1 − (1 + s)^(−ν)", {why_reached(), poisson_ratio}}; });
    explain_probe("volume_ratio", [this] {
        const SimplexMesh<3>& mesh = cube_->rest();
        std::vector<std::pair<Input, Input>> terms;
        for (Index e = 0; e < mesh.simplex_count(); ++e)
            terms.emplace_back(
                Input::constant(fmt::format("w_{}", e), mesh.volumes()[e] / mesh.volume(), "", "share of the volume"),
                Input::now(fmt::format("v_{}", e), "element_volume", e));
        return weighted_sum("V/V₀ = Σ_e w_e v_e", "w_e", "v_e", terms);
    });
    explain_probe("deflection", [this] {
        return Explanation{"u_y = u", {Input::now("u", "displacement", membrane_->tip(), 1)}};
    });
    explain_probe("times_too_stiff", [this] {
        const Real right = converged_deflection(ratio_of_round(done() - 1)).value_or(0);
        return Explanation{"ratio = u_ref / u",
                           {Input::constant("u_ref", right, "m", "converged deflection"), Input::now("u", "deflection", 0)}};
    });
}

}  // namespace pliant::poisson
