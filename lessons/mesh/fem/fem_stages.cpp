// Fields and stages, in the order of the lecture.
#include "fem.h"

namespace pliant::fem {
namespace {

// In sizes of the body, moduli and their products: beyond any that an equilibrium has.
constexpr Real far = 1e6, strained = 1e6;

}  // namespace

void FemLesson::declare_fields() {
    // Each solve begins anew from the parameters; what moves goes on from where it is.
    state = {state_array("done", "", done_), state_array("position", "m", position_), state_array("velocity", "m/s", velocity_),
             state_array("clock", "s", clock_)};
    const auto moves = [this] { return moving(); };
    const auto stands = [this] { return !moving(); };
    const auto reach = [this] { return far * solid_mesh::size_at_rest(*solid_); };
    const auto largest_stress = [this] { return 1e15 * (std::abs(solid_->lame().lambda) + solid_->lame().mu); };
    const auto largest_force = [this, largest_stress] {
        const Real size = solid_mesh::size_at_rest(*solid_);
        return largest_stress() * size * std::max<Real>(1, size);
    };
    const auto at_nodes = [](std::string_view name, std::string_view symbol, std::string_view unit, const MatX& numbers,
                             std::string_view help, std::function<Real()> bound) {
        return vector_field(name, symbol, unit, On::node, numbers, help).stops_at(std::move(bound));
    };
    const auto in_elements = [](std::string_view name, std::string_view symbol, std::string_view unit, const MatX& numbers,
                                std::string_view help, std::function<Real()> bound) {
        return tensor_field(name, symbol, unit, On::element, numbers, help).stops_at(std::move(bound));
    };
    const auto by_pure_numbers = [] { return strained; };
    fields = {
        at_nodes("displacement", "u", "m", displacement_, "of the nodes from their places at rest", reach),
        scalar_field("von_mises", "σ_v", "Pa", On::element, mises_,
                     "one number for how hard an element is sheared: √(3/2) times the norm of the deviator of its stress")
            .stops_at(largest_stress),
        in_elements("deformation_gradient", "F", "", deformation_, "∂x/∂X of an element; of second order in its middle",
                    by_pure_numbers),
        in_elements("rotation", "R", "", rotation_, "the rotation nearest to F", by_pure_numbers).when([this] {
            return turns();
        }),
        in_elements("strain", "ε, e, E", "", strain_,
                    "the strain that the model is made of; Green's for the neo-Hookean, which takes F",
                    [] { return strained * strained; }),
        in_elements("stress", "P", "Pa", stress_, "force per area at rest, first Piola–Kirchhoff", largest_stress),
        in_elements("element_stiffness", "Kₑ", "N/m", block_, "of each element the block of its first corner with itself",
                    largest_force)
            .when(stands),
        at_nodes("assembled", "K_aa", "N/m", assembled_, "diagonal of K, from the elements that are assembled so far",
                 largest_force)
            .when(stands),
        at_nodes("internal_force", "fⁱ", "N", internal_, "with which the body resists at its nodes", largest_force),
        at_nodes("load", "f", "N", load_, "the part of the load that is on now, as forces on nodes", largest_force).when(stands),
        at_nodes("prescribed", "ū", "m", prescribed_, "where the supports hold their nodes", reach).when(stands),
        at_nodes("residual", "r", "N", residual_, "load less internal force, at nodes that are free", largest_force).when(stands),
        at_nodes("newton_step", "d", "m", newton_step_, "of the latest iteration, before the line search shortens it", reach)
            .when(stands),
        at_nodes("reaction", "fʳ", "N", reaction_, "with which the supports hold the body", largest_force).when(stands),
        scalar_field("rest_volume", "V", "m³", On::element, volume_, "of each element at rest; in the plane 1 m thick")
            .stops_at([this] { return far * std::pow(solid_mesh::size_at_rest(*solid_), 3) + far; }),
        at_nodes("position", "x", "m", position_, "of the nodes", [this, reach] { return reach() + far * drop_height; })
            .when(moves),
        at_nodes("velocity", "v", "m/s", velocity_, "of the nodes",
                 [this] { return 1e4 * solid_mesh::size_at_rest(*solid_) / dt + 1e3 * std::abs(spin_rate); })
            .when(moves),
        at_nodes("damping_force", "fᵈ", "N", damping_force_, "Rayleigh's damping, at the start of the step", largest_force)
            .when([this] { return moving() && damped(); }),
        at_nodes("external_force", "fᵉ", "N", external_force_, "weight, load, and the pull of the hand, at the start of the step",
                 largest_force)
            .when(moves)};
}

void FemLesson::declare_stages() {
    formula_symbols = {{"N"},        {"X", "m"},   {"F"},       {"I"},         {"R"},       {"S"},           {"ε"},
                       {"e"},        {"E"},        {"P", "Pa"}, {"μ", "Pa"},   {"λ", "Pa"}, {"J"},           {"A", "Pa"},
                       {"dV", "m³"}, {"dA", "m²"}, {"t", "Pa"}, {"b", "N/m³"}, {"α"},       {"K_ab", "N/m"}, {"K", "N/m"}};
    const auto element = [this](const Question& q) { return why_element(q); };
    const auto node = [this](const Question& q) { return why_node(q); };
    stages = {
        stage_of("shape_functions", "u = Σ_a N_a u_a,  Σ_a N_a = 1", "lecture: basis functions bᵢ(m) [Hughes2000 §3.2]",
                 [this] { shape_functions(); })
            .done_in("core/pliant/mesh/simplex_elements.h: simplex_shape; core/pliant/mesh/simplex_elements.cpp: gradients_at")
            .maps({}, {"rest_volume"})
            .when([this] { return !moving(); })
            .because(element),
        stage_of("deformation", "F = I + ∇u,  ∇u = Σ_a u_a ∇N_aᵀ", "lecture: deformation gradient [Bonet2008 §4.2]",
                 [this] { deform(); })
            .done_in("core/pliant/mesh/simplex_elements.cpp: field_gradient")
            .maps({"displacement"}, {"deformation_gradient"})
            .because(element),
        stage_of("rotation", "F = R S,  RᵀR = I,  S = Sᵀ", "lecture: the rotation is taken out of linear elements [Mueller2002]",
                 [this] { turn(); })
            .done_in("core/pliant/continuum/deformation.cpp: nearest_rotation")
            .maps({"deformation_gradient"}, {"rotation"})
            .when([this] { return turns(); })
            .because(element),
        stage_of("strain", "linear: ε = ½ (F + Fᵀ) − I;  corotational: e = RᵀF − I;  others: E = ½ (FᵀF − I)",
                 "lecture: Cauchy's strain, Green's strain [Sifakis2012 §3]", [this] { measure_strain(); })
            .done_in("core/pliant/continuum/strain.h: cauchy_strain, green_strain")
            .maps({"deformation_gradient"}, {"strain"})
            .shows([this]() -> std::string_view {
                if (law() == Law::linear) return "ε = ½ (F + Fᵀ) − I";
                return turns() ? "e = RᵀF − I" : "E = ½ (FᵀF − I)";
            })
            .because(element),
        stage_of(
            "stress",
            "linear: P = 2 μ ε + λ tr(ε) I;  corotational: P = R (2 μ e + λ tr(e) I);  St. Venant–Kirchhoff: P = F (2 μ E + λ "
            "tr(E) I);  neo-Hookean: P = μ (F − F⁻ᵀ) + λ ln J F⁻ᵀ",
            "lecture: Hooke's law, energy densities [Sifakis2012 §3]", [this] { evaluate_stress(); })
            .done_in("core/pliant/continuum/energy_density.cpp: P")
            .maps({"strain", "deformation_gradient"}, {"stress", "von_mises"})
            .shows([this]() -> std::string_view {
                switch (law()) {
                    case Law::linear:
                        return "P = 2 μ ε + λ tr(ε) I";
                    case Law::corotational:
                        return "P = R (2 μ e + λ tr(e) I)";
                    case Law::stvk:
                        return "P = F (2 μ E + λ tr(E) I)";
                    default:
                        return "P = μ (F − F⁻ᵀ) + λ ln J F⁻ᵀ";
                }
            })
            .because(element),
        stage_of("internal_force", "fⁱ_a = Σ_e ∫ P ∇N_a dV",
                 "lecture: nodal forces as derivatives of the energy [Sifakis2012 §4]", [this] { internal_forces(); })
            .done_in("core/pliant/solids/hyperelastic_fem.cpp: internal_force")
            .maps({"stress"}, {"internal_force"})
            .because(node),
        stage_of("assembly", "K_ab = Σ_e ∫ ∇N_aᵀ A ∇N_b dV,  A = ∂P/∂F",
                 "lecture: f_e = K_e u_e, element by element [Hughes2000 §2.8]", [this] { assemble(); })
            .done_in("core/pliant/solids/hyperelastic_fem.cpp: element_stiffness; core/pliant/math/element_assembly.cpp: add")
            .maps({"displacement"}, {"element_stiffness", "assembled"})
            .repeats([this] { return next_element_ < solid_->element_count(); }, [this] { begin_assembly(); })
            .when([this] { return !moving(); })
            .because(node),
        stage_of("load", "on a face: f_a = ∫ N_a t dA;  in the body: f_a = ∫ N_a b dV",
                 "loads that do the same work [Hughes2000 §2.9]", [this] { apply_load(); })
            .done_in("lessons/mesh/fem/fem.cpp: full_load")
            .maps({}, {"load", "prescribed"})
            .shows([this]() -> std::string_view {
                return is(Setting::manufactured) ? "f_a = ∫ N_a b dV" : is(Setting::twist) ? "ū = (R − I) X" : "f_a = ∫ N_a t dA";
            })
            .when([this] { return !moving(); })
            .because(node),
        stage_of("supports", "r = f − fⁱ at free nodes,  u = ū at the others", "essential boundary conditions [Hughes2000 §2.6]",
                 [this] { support(); })
            .done_in("core/pliant/math/constrained_system.cpp: reduce")
            .maps({"load", "internal_force", "prescribed"}, {"residual"})
            .when([this] { return !moving(); })
            .because(node),
        stage_of("solve", "K d = r,  u ← u + α d",
                 "Newton's method with a line search [Nocedal2006 §3]; a linear body takes one round", [this] { solve(); })
            .done_in("core/pliant/solids/newton_equilibrium.cpp: find_direction, iterate")
            .maps({"residual", "displacement"}, {"newton_step", "displacement"})
            .loops_from("deformation", [this] { return advancing_; })
            .when([this] { return !moving(); })
            .because([this](const Question& q) { return why_solved(q); }),
        stage_of("reactions", "fʳ = fⁱ − f at the supports", "what the supports carry [Hughes2000 §2.6]", [this] { react(); })
            .done_in("lessons/mesh/fem/fem.cpp: react")
            .maps({"internal_force", "load"}, {"reaction"})
            .when([this] { return !moving(); })
            .because(node)};
    add_moving_stages();
}

void FemLesson::add_moving_stages() {
    const auto moves = [this] { return moving(); };
    stages.push_back(stage_of("damping_force", "fᵈ = −(α M + β K) v", "Rayleigh's damping [Hughes2000 §7.2]", [this] { damp(); })
                         .done_in("core/pliant/solids/elastic_system.cpp: force")
                         .maps({"velocity"}, {"damping_force"})
                         .where({{"M", "kg"}, {"v", "m/s"}, {"α", "1/s"}, {"β", "s"}})
                         .when([this] { return moving() && damped(); })
                         .because([this](const Question& q) { return why_outer(q); }));
    stages.push_back(stage_of("external_force", "fᵉ_a = m_a g + ∫ N_a t dA;  at a pulled node + kₕ (x_hand − x_a)",
                              "gravity, the load on its face, and a spring to the pointer", [this] { act_from_outside(); })
                         .done_in("core/pliant/solids/external_load.cpp: add_external_forces")
                         .maps({"position"}, {"external_force"})
                         .where({{"m", "kg"}, {"x", "m"}})
                         .shows([]() -> std::string_view { return "fᵉ_a = m_a g + ∫ N_a t dA"; })
                         .when(moves)
                         .because([this](const Question& q) { return why_outer(q); }));
    stages.push_back(
        stage_of("integrate",
                 "explicit: x′ = x + Δt v, v′ = v + Δt f/m;  semi-implicit: v′ = v + Δt f/m, x′ = x + Δt v′;  "
                 "implicit: m (v′ − v) = Δt f(x′, v′), x′ = x + Δt v′, by Newton's method",
                 "lecture: time integration, ρ ẍ = ∇·σ + f with lumped masses [Baraff1998]", [this] { integrate(); })
            .done_in("core/pliant/time/time_integrator.cpp: explicit_pass; core/pliant/time/implicit.cpp: iterate")
            .maps({"position", "velocity", "internal_force", "damping_force", "external_force"},
                  {"position", "velocity", "displacement"})
            .where({{"m", "kg"}, {"x", "m"}, {"v", "m/s"}})
            .repeats([this] { return motion_->again(); }, [this] { begin_integration(); }, [this] { end_integration(); })
            .shows([this] { return info_of(scheme()).formula; })
            .when(moves)
            .because([this](const Question& q) { return why_integrated(q); }));
    stages.push_back(
        stage_of("contact", "y ≥ 0;  v_y′ = 0,  |Δv_t| ≤ μ_g |Δv_y| on the ground", "[Bridson2002]", [this] { meet_ground(); })
            .done_in("core/pliant/solids/contact.cpp: resolve")
            .maps({"position", "velocity"}, {"position", "velocity", "displacement"})
            .where({{"y", "m"}, {"v", "m/s"}})
            .when([this] { return is(Setting::drop); })
            .because([this](const Question& q) { return why_contact(q); }));
}

}  // namespace pliant::fem
