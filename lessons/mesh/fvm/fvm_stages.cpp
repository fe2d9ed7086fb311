// Fields and stages, in the order of the lecture.
#include "fvm.h"

#include <fmt/format.h>

#include <array>

namespace pliant::fvm {
namespace {

// In sizes of the body, and moduli: beyond any that a motion has.
constexpr Real far_off = 1e4, much_strained = 1e4;
// A linear body that spins freely grows for ever: until there.
constexpr Real grown = 5;

}  // namespace

void FvmLesson::declare_fields() {
    state = {state_array("position", "m", position_), state_array("velocity", "m/s", velocity_),
             state_array("clock", "s", clock_)};
    const auto largest_stress = [this] { return 1e12 * (std::abs(solid_->lame().lambda) + solid_->lame().mu); };
    const auto far = [this] { return (flies_apart() ? grown : far_off) * solid_mesh::size_at_rest(*solid_); };
    const auto on = [](On kind) {
        return [kind](std::string_view name, std::string_view symbol, std::string_view unit, const MatX& numbers,
                      std::string_view help) { return vector_field(name, symbol, unit, kind, numbers, help); };
    };
    const auto nodal = on(On::node), of_face = on(On::face);
    const auto in_elements = [](std::string_view name, std::string_view symbol, std::string_view unit, const MatX& numbers,
                                std::string_view help) { return tensor_field(name, symbol, unit, On::element, numbers, help); };
    const auto strained = [] { return much_strained; };
    fields = {
        nodal("position", "x", "m", position_, "of the nodes").stops_at(far),
        nodal("velocity", "v", "m/s", velocity_, "of the nodes").stops_at([this] {
            return 1000 * solid_mesh::size_at_rest(*solid_) / dt;
        }),
        vector_field(
            "displacement", "u", "m", On::node,
            [this] {
                const MatX& u = displacement();
                return std::span<const Real>(u.data(), static_cast<std::size_t>(u.size()));
            },
            "of the nodes from their places at rest")
            .follows({"position"},
                     [this](const Question& q) {
                         Input at_rest = why().place_at_rest(q.index, q.component);
                         const std::string formula = fmt::format("u = x − {}", at_rest.symbol);
                         return Explanation{formula, {Input::now("x", "position", q.index, q.component), std::move(at_rest)}};
                     }),
        in_elements("deformation_gradient", "F", "", deformation_, "∂x/∂X, the same all over an element").stops_at(strained),
        in_elements("rotation", "R", "", rotation_, "the rotation nearest to F").when([this] { return turns(); }),
        in_elements("strain", "ε, e, E", "", strain_,
                    "the strain that the law is made of; Green's for the neo-Hookean, which takes F")
            .stops_at([] { return much_strained * much_strained; }),
        in_elements("stress", "P", "Pa", stress_, "force per area at rest, first Piola–Kirchhoff").stops_at(largest_stress),
        in_elements("cauchy_stress", "σ", "Pa", cauchy_, "force per area of the deformed body; 0 where an element is flat"),
        of_face("rest_area", "N", "m²", rest_area_, "outward, as long as the face is large, at rest"),
        of_face("deformed_area", "a", "m²", deformed_area_, "outward, as long as the face is large, of the deformed body"),
        of_face("face_force", "f_A", "N", face_force_, "with which the rest of the body pulls at the element through a face: P N")
            .stops_at([this, largest_stress] { return largest_stress() * rest_area_.colwise().norm().maxCoeff(); }),
        of_face("true_face_force", "f_σ", "N", true_face_force_, "the same by the lecture's formula, σ a on the deformed face"),
        nodal("force", "f", "N", force_, "of its elements on a node, from the forces on their faces"),
        nodal("finite_element_force", "f_FEM", "N", fem_force_, "of finite elements: minus the derivative of the energy"),
        nodal("external_force", "fᵉ", "N", outer_force_, "load, weight, and the pull of the hand").when([this] {
            return loaded();
        }),
        nodal("damping_force", "fᵈ", "N", damping_force_, "against the velocity").when([this] { return damped(); }),
        scalar_field("rest_volume", "V", "m³", On::element, volume_, "of each element at rest; in the plane 1 m thick")};
}

void FvmLesson::declare_stages() {
    formula_symbols = {{"φ"},       {"X", "m"},  {"F"},       {"I"}, {"R"}, {"S"}, {"ε"}, {"e"},       {"E"},
                       {"P", "Pa"}, {"μ", "Pa"}, {"λ", "Pa"}, {"J"}, {"d"}, {"A"}, {"n"}, {"m", "kg"}, {"a", "m²"}};
    const auto element = [this](const Question& q) { return why_element(q); };
    const auto face = [this](const Question& q) { return why_face(q); };
    const auto shared = [this](const Question& q) { return why_shared(q); };
    const auto law_now = [this](std::array<std::string_view, 4> of_laws) {
        return [this, of_laws]() -> std::string_view { return of_laws[static_cast<std::size_t>(Law(body.law))]; };
    };
    stages = {
        stage_of("areas", "N = |N| n,  Σ_A N_A = 0", "outward area vectors at rest; the faces of an element close [Teran2003]",
                 [this] { measure_areas(); })
            .done_in("core/pliant/solids/face_forces.cpp: rest_face_area")
            .maps({}, {"rest_area", "rest_volume"})
            .because(face),
        stage_of("deformation", "F = I + ∇u,  ∇u = Σ_a u_a ∇φ_aᵀ", "lecture: deformation gradient [Bonet2008 §4.2]",
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
            .shows(law_now({"ε = ½ (F + Fᵀ) − I", "e = RᵀF − I", "E = ½ (FᵀF − I)", "E = ½ (FᵀF − I)"}))
            .because(element),
        stage_of(
            "stress",
            "linear: P = 2 μ ε + λ tr(ε) I;  corotational: P = R (2 μ e + λ tr(e) I);  St. Venant–Kirchhoff: P = F (2 μ E + λ "
            "tr(E) I);  neo-Hookean: P = μ (F − F⁻ᵀ) + λ ln J F⁻ᵀ",
            "lecture: Hooke's law, energy densities [Sifakis2012 §3]", [this] { evaluate_stress(); })
            .done_in("core/pliant/continuum/energy_density.cpp: P")
            .maps({"strain", "deformation_gradient"}, {"stress"})
            .shows(law_now({"P = 2 μ ε + λ tr(ε) I", "P = R (2 μ e + λ tr(e) I)", "P = F (2 μ E + λ tr(E) I)",
                            "P = μ (F − F⁻ᵀ) + λ ln J F⁻ᵀ"}))
            .because(element),
        stage_of("true_stress", "σ = P Fᵀ / J,  a = J F⁻ᵀ N",
                 "the stress that the lecture takes belongs to the deformed body, and so do its faces [Bonet2008 §5.5, §4.6]",
                 [this] { true_stress(); })
            .done_in("core/pliant/solids/face_forces.cpp: deformed_face_area")
            .maps({"stress", "deformation_gradient", "rest_area"}, {"cauchy_stress", "deformed_area"})
            .because(element),
        stage_of("face_forces", "f_A = P N = σ a", "lecture: f_A = ∫ σ dA = A σ n, on plane faces [Teran2003]",
                 [this] { face_forces(); })
            .done_in("core/pliant/solids/face_forces.h: face_force")
            .maps({"stress", "rest_area", "cauchy_stress", "deformed_area"}, {"face_force", "true_face_force"})
            .where({{"f_A", "N"}})
            .because(face),
        stage_of("share", "f = − Σ_A f_A / d", "lecture: the force is distributed evenly among the nodes of the face [Teran2003]",
                 [this] { share(); })
            .done_in("core/pliant/solids/face_forces.cpp: add_shared_face_forces")
            .maps({"face_force"}, {"force"})
            .where({{"f_A", "N"}})
            .loops_from("face_forces", [this] { return next_element_ < solid_->element_count(); })
            .because(shared),
        stage_of("finite_element_force", "f_FEM = − Σ_e V P ∇φ",
                 "lecture: nodal forces as derivatives of the energy [Sifakis2012 §4]", [this] { fem_forces(); })
            .done_in("core/pliant/solids/hyperelastic_fem.cpp: internal_force")
            .maps({"displacement"}, {"finite_element_force"})
            .because(shared),
        stage_of("external_forces", "fᵉ = m g + F A_a / A;  fᵈ = − α m v", "a load spread evenly, weight, the hand; damping",
                 [this] { outer_forces(); })
            .done_in("lessons/mesh/fvm/fvm.cpp: outer_forces")
            .maps({"position", "velocity"}, {"external_force", "damping_force"})
            .where({{"F", "N"}, {"A_a", "m²"}, {"A", "m²"}})
            .when([this] { return loaded() || damped(); })
            .because([this](const Question& q) { return why_outer(q); }),
        stage_of("integrate",
                 "explicit: x′ = x + Δt v, v′ = v + Δt f/m;  semi-implicit: v′ = v + Δt f/m, x′ = x + Δt v′;  "
                 "implicit: m (v′ − v) = Δt f(x′, v′), x′ = x + Δt v′, by Newton's method",
                 "lecture: time integration; [Baraff1998], [Nocedal2006]", [this] { integrate(); })
            .done_in("core/pliant/time/time_integrator.cpp: explicit_pass; core/pliant/time/implicit.cpp: iterate")
            .maps({"position", "velocity", "force", "external_force", "damping_force"}, {"position", "velocity"})
            .repeats([this] { return motion_->integrator().again(); }, [this] { begin_integration(); },
                     [this] { end_integration(); })
            .shows([this] { return info_of(scheme).formula; })
            .because([this](const Question& q) { return why_integrated(q); })};
}

}  // namespace pliant::fvm
