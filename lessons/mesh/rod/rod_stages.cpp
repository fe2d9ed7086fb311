// Fields, their bounds, and the stages of a step in the order of the lecture.
#include "rod.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant::rod {
void RodLesson::declare_fields() {
    state = {state_array("position", "m", position_),
             state_array("velocity", "m/s", velocity_),
             state_array("clock", "s", clock_),
             state_array("rhythm", "s, m", rhythm_.memory()),
             state_array("history", "", history_),
             {"integrator", "", [this] {
                  if (!integrator_) return std::span<Real>();
                  integrator_->set_scheme(scheme);  // each remembers as much as it needs
                  VecX& memory = integrator_->memory();
                  return std::span<Real>(memory.data(), static_cast<std::size_t>(memory.size()));
              }}};
    // Of the strain, and what follows from it.
    const auto strain = [this] { return largest_strain(); };
    const auto force = [this, strain] { return 2 * chain_axial_stiffness() * strain() + total_mass * weight_acceleration(); };
    const auto reach = [this, strain] { return length * (2 + strain()); };
    const auto density = [this, strain] { return 0.5 * chain_axial_stiffness() * strain() * strain(); };
    const auto moves = [this] { return !hangs_still(); };
    fields = {
        plane_vector_field("position", "x", "m", On::node, position_, "of the nodes").stops_at(reach),
        plane_vector_field("velocity", "v", "m/s", On::node, velocity_, "of the nodes")
            .stops_at([this, reach] { return reach() * (1 / dt + 2 * fastest()); })
            .when(moves),
        scalar_field("displacement", "u", "m", On::node, displacement_, "along the rod, from where the node is at rest")
            .of_both_signs()
            .stops_at(reach),
        plane_vector_field("slope", "∂x/∂s", "", On::edge, slope_, "of each segment: how fast x runs along the rod at rest")
            .stops_at([strain] { return 1 + strain(); }),
        scalar_field("strain", "ε", "", On::edge, strain_, "|∂x/∂s| − 1: positive where the rod is stretched")
            .of_both_signs()
            .stops_at(strain),
        scalar_field("energy_density", "½EAε²", "J/m", On::edge, energy_density_, "elastic energy per length of the rod at rest")
            .stops_at(density),
        scalar_field("segment_energy", "Uᵢ", "J", On::edge, segment_energy_, "of each segment: ½EAε² Δs")
            .stops_at([this, density] { return density() * segment(); }),
        scalar_field("spring_stiffness", "k", "N/m", On::edge, stiffness_, "of each spring").stops_at([this] {
            return 2 * stiffness();
        }),
        scalar_field("tension", "T", "N", On::edge, tension_, "k (|xᵢ₊₁ − xᵢ| − Δs): positive where a spring pulls")
            .of_both_signs()
            .stops_at(force),
        plane_vector_field("gradient_force", "−∂U/∂x", "N", On::node, gradient_force_,
                           "negative gradient of the energy of all segments")
            .stops_at(force),
        plane_vector_field("spring_force", "f", "N", On::node, spring_force_, "sum of the springs of a node").stops_at(force),
        plane_vector_field("damping_force", "fᵈ", "N", On::node, damping_force_, "sum of the dampers of a node")
            .stops_at([] { return std::numeric_limits<Real>::max(); })
            .when([this] { return damped(); }),
        plane_vector_field("external_force", "fᵉ", "N", On::node, external_force_, "weight of the node")
            .stops_at([this] { return 2 * total_mass * weight_acceleration(); })
            .when([this] { return loaded(); }),
    };
    // What a stage does not write.
    Field& displacement = fields[2];
    displacement.defined_by = {"position"};
    displacement.view = [this] { return follow_positions(), view_of(displacement_)(); };
    displacement.explain = [this](const Question& q) { return why_field(q); };
}

void RodLesson::declare_stages() {
    const auto why = [this](const Question& q) { return why_field(q); };
    const auto moves = [this] { return !hangs_still(); };
    formula_symbols = {{"s", "m"}, {"x̂"}, {"m", "kg"}};
    stages = {
        stage_of("positions", "∂x/∂s ≈ (xᵢ₊₁ − xᵢ)/Δs", "lecture C: the deformable rod, sample points s₀ … s_N",
                 [this] { slope_stage(); })
            .maps({"position"}, {"slope"})
            .because(why)
            .done_in("core/pliant/solids/rod.cpp: rod_slopes"),
        stage_of("strain", "ε = |∂x/∂s| − 1", "lecture C: strain of the rod", [this] { rod_strains(slope_, strain_); })
            .maps({"slope"}, {"strain"})
            .because(why)
            .done_in("core/pliant/solids/rod.cpp: rod_strains"),
        stage_of("energy_density", "½ EA ε²  in  U = ∫ ½ EA ε² ds;  springs picked by hand are a rod of EA = k₀ Δs",
                 "lecture C: potential energy U = ∫ ½ k ε² ds; its k is EA",
                 [this] { energy_density_ = 0.5 * chain_axial_stiffness() * strain_.array().square(); })
            .maps({"strain"}, {"energy_density"})
            .because(why)
            .done_in("core/pliant/solids/rod.cpp: rod_energy"),
        stage_of("discrete_energy", "U ≈ Σ ½ EA ε² Δs", "lecture C: the integral as a sum over the segments",
                 [this] { segment_energy_ = segment() * energy_density_; })
            .maps({"energy_density"}, {"segment_energy"})
            .because(why)
            .done_in("core/pliant/solids/rod.cpp: rod_energy"),
        stage_of("springs", "Uᵢ = ½ k (|xᵢ₊₁ − xᵢ| − Δs)²  with  k = EA/Δs;  tension T = k (|xᵢ₊₁ − xᵢ| − Δs)",
                 "lecture C: we have just reinvented mass–spring systems",
                 [this] {
                     stiffness_ = springs_.stiffness();
                     spring_tension<2>(springs_, position_, tension_);
                 })
            .maps({"position", "segment_energy"}, {"spring_stiffness", "tension"})
            .because(why)
            .done_in("core/pliant/solids/rod.cpp: rod_springs; core/pliant/solids/springs.cpp: spring_tension"),
        stage_of("forces", "fᵢ = −∂U/∂xᵢ = Σ EA ε x̂ᵢⱼ;  as springs: fᵢ = Σ k (|xᵢⱼ| − Δs) x̂ᵢⱼ",
                 "lecture C: net force on particle i; [Nealen2006 §3]",
                 [this] {
                     gradient_force_.setZero();
                     add_rod_forces(chain_axial_stiffness(), slope_, strain_, gradient_force_);
                     spring_force_.setZero();
                     add_spring_forces<2>(springs_, position_, spring_force_);
                 })
            .maps({"position", "slope", "strain"}, {"gradient_force", "spring_force"})
            .because(why)
            .done_in("core/pliant/solids/rod.cpp: add_rod_forces; core/pliant/solids/springs.cpp: add_spring_forces"),
        stage_of("damping_forces", "fᵢ = Σ τ k (vᵢⱼ·x̂ᵢⱼ) x̂ᵢⱼ,  vᵢⱼ = vⱼ − vᵢ", "[Nealen2006 §3]: along the spring",
                 [this] {
                     damping_force_.setZero();
                     add_damping_forces<2>(springs_, SpringDamping::projected, position_, velocity_, damping_force_);
                 })
            .maps({"position", "velocity"}, {"damping_force"})
            .because(why)
            .when([this] { return damped(); })
            .done_in("core/pliant/solids/springs.cpp: add_damping_forces"),
        stage_of("external_forces", "fᵢ = (M/N) g", "gravity",
                 [this] {
                     external_force_.setZero();
                     add_external_forces<2>({weight_acceleration() * along(), {}}, node_masses_, position_, external_force_);
                 })
            .maps({}, {"external_force"})
            .because(why)
            .when([this] { return loaded(); })
            .done_in("core/pliant/solids/external_load.cpp: add_external_forces"),
        stage_of("integrate", "M x″ = f + fᵈ + fᵉ, a step of Δt by the chosen scheme",
                 "lecture C: d²xᵢ/dt² = −mᵢ⁻¹ ∂U/∂xᵢ; [Hairer2006]", [this] { integrate(); })
            .done_in("core/pliant/time/time_integrator.cpp: explicit_pass; core/pliant/time/implicit.cpp: iterate")
            .maps({"position", "velocity", "spring_force", "damping_force", "external_force"}, {"position", "velocity"})
            .repeats([this] { return integrator_->again(); }, [this] { begin_integration(); }, [this] { end_integration(); })
            .when(moves)
            .shows([this] { return info_of(scheme).formula; })
            .because([this](const Question& q) { return why_integrated(q); }),
        stage_of("equilibrium",
                 "ΔTᵢ = Σ (f + fᵉ) of all nodes beyond;  every node moves by Σ ΔT/k of the springs above it, until f + fᵉ = 0",
                 "each spring carries what hangs below it", [this] { equilibrium_stage(); })
            .done_in("core/pliant/solids/rod.cpp: balance_chain")
            .maps({"position", "spring_force", "external_force"}, {"position"})
            .loops_from("positions", [this] { return clock_[balanced] == 0; })
            .when([this] { return hangs_still(); })
            .because(why),
    };
}

void RodLesson::follow_positions() {
    displacement_.resize(position_.cols());
    for (Index i = 0; i < position_.cols(); ++i) displacement_[i] = displacement_of(i);
}

// ----------------------------------------------------------------------------------------------------- time, or none

void RodLesson::begin_integration() {
    total_force_ = spring_force_;
    if (damped()) total_force_ += damping_force_;
    if (loaded()) total_force_ += external_force_;
    integrator_->set_scheme(scheme);
    const VecX force = flat(total_force_);
    integrator_->begin(dt, flat(position_), flat(velocity_), &force);
}

// Behind each pass of an explicit scheme the nodes are where the next force is evaluated.
void RodLesson::integrate() {
    integrator_->pass();
    if (is_implicit(scheme)) return;
    flat(position_) = integrator_->position();
    flat(velocity_) = integrator_->velocity();
}

void RodLesson::end_integration() {
    integrator_->finish(flat(position_), flat(velocity_));
    clock_[elapsed] += dt;
    if (history_.size() > 0) note_history(clock_[elapsed] - dt);
    if (setting == Setting::wave) rhythm_.note(clock_[elapsed], mode_amplitude(), least_swing());
}

// None, where rounding would hide it.
Real RodLesson::least_swing() const {
    const Real least = 1e-3 * amplitude;
    return least > strain_rounding() * segment() / 100 ? least : 0;
}

// The strain now, at all moments since `before`; a new span begins with an empty picture.
void RodLesson::note_history(Real before) {
    const auto moment = [this](Real t) { return std::floor(t / history_span() * history_rows); };
    const auto span = [](Real m) { return std::floor(m / history_rows); };
    const Real now = moment(clock_[elapsed]), last = moment(before);
    if (!std::isfinite(now)) return;
    if (span(now) != span(last)) history_.setZero();
    Points<2> slope(2, count());
    VecX strain(count());
    rod_slopes(segment(), position_, slope);
    rod_strains(slope, strain);
    const auto newest = static_cast<Index>(std::fmod(now, history_rows));
    for (Index k = 0; k <= newest && static_cast<Real>(k) < now - last; ++k) history_.col(newest - k) = strain;
}

// The rod lies along a line: its springs take up at once what is unbalanced. A second round finds that nothing is.
void RodLesson::equilibrium_stage() {
    total_force_ = spring_force_;
    if (loaded()) total_force_ += external_force_;
    move_.setZero(position_.cols());
    clock_[balanced] = imbalance() <= imbalance_rounding() ? 1 : 0;
    if (clock_[balanced] == 1) return;
    const VecX force = total_force_.transpose() * along();
    balance_chain(springs_.stiffness(), force, added_tension_, move_);
    for (Index i = 0; i < position_.cols(); ++i) position_.col(i) += move_[i] * along();
}

}  // namespace pliant::rod
