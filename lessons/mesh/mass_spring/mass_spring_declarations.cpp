// Fields and stages.
#include "mass_spring.h"

namespace pliant::mass_spring {

void MassSpringLesson::declare_fields() {
    const auto nodal = [](std::string_view name, std::string_view symbol, std::string_view unit, std::string_view help,
                          const Points<3>& values) {
        return Field{.name = name,
                     .symbol = symbol,
                     .unit = unit,
                     .on = On::node,
                     .rank = Rank::vector,
                     .components = 3,
                     .view = view_of(values),
                     .help = help,
                     .used = [&values] { return values.size() > 0; }};
    };
    const auto of_springs = [](std::string_view name, std::string_view symbol, std::string_view unit, std::string_view help,
                               const VecX& values) {
        return Field{.name = name,
                     .symbol = symbol,
                     .unit = unit,
                     .on = On::edge,
                     .view = view_of(values),
                     .help = help,
                     .used = [&values] { return values.size() > 0; }};
    };
    state = {state_array("position", "m", position_), state_array("velocity", "m/s", velocity_),
             state_array("integrator_memory", "", memory_), state_array("clock", "s", clock_),
             state_array("rhythm", "", rhythm_.memory())};
    fields = {nodal("position", "x", "m", "of the nodes", position_),
              nodal("velocity", "v", "m/s", "of the nodes", velocity_),
              nodal("spring_force", "f", "N", "sum of the springs of a node", spring_force_),
              nodal("damping_force", "fᵈ", "N", "sum of the dampers of a node", damping_force_),
              nodal("external_force", "fᵉ", "N", "weight, and the pull of the hand", external_force_),
              of_springs("tension", "T", "N", "k (|xᵢⱼ| − l): positive where a spring pulls", tension_),
              of_springs("strain", "ε", "", "(|xᵢⱼ| − l)/l: positive where a spring is longer than at rest", strain_)};
    // Springs a hundred times their length are those of a run that has blown up.
    fields.back().bound = [] { return 100.0; };
    // So are nodes that cross the block a thousand times in one step.
    fields[1].bound = [this] { return 1000 * size / dt; };
}

void MassSpringLesson::declare_stages() {
    stages = {
        {.name = "spring_forces",
         .formula = "fᵢ = k (|xᵢⱼ| − l) xᵢⱼ/|xᵢⱼ|,  xᵢⱼ = xⱼ − xᵢ",
         .source = "lecture: mass–spring system; [Nealen2006 §3]",
         .run = [this] { spring_stage(); },
         .reads = {"position"},
         .writes = {"spring_force", "tension", "strain"},
         .active = [this] { return !tested(); },
         .explain = [this](const Question& q) { return why_spring_stage(q); }},
        {.name = "damping_forces",
         .formula = "naive: fᵢ = kᵈ vᵢⱼ;  projected: fᵢ = kᵈ (vᵢⱼ·xᵢⱼ / (xᵢⱼ·xᵢⱼ)) xᵢⱼ,  vᵢⱼ = vⱼ − vᵢ",
         .formula_in_force = [this] { return formula_of(damping_mode); },
         .source = "lecture: mass–spring system; [Nealen2006 §3]",
         .run = [this] { damping_stage(); },
         .reads = {"position", "velocity"},
         .writes = {"damping_force"},
         .active = [this] { return damped(); },
         .explain = [this](const Question& q) { return why_damping_force(q.index, q.component, Input::now); }},
        {.name = "external_forces",
         .formula = "fᵢ = mᵢ g;  at a pulled node + kₕ (x_hand − xᵢ)",
         .source = "gravity, and a spring to the pointer",
         .run = [this] { external_stage(); },
         .reads = {"position"},
         .writes = {"external_force"},
         .active = [this] { return loaded() && !tested(); },
         .explain = [this](const Question& q) { return why_external_force(q.index, q.component); }},
        {.name = "integrate",
         .formula = "explicit: x′ = x + Δt v, v′ = v + Δt f/m;  semi-implicit: v′ = v + Δt f/m, x′ = x + Δt v′;  "
                    "implicit: m (v′ − v) = Δt f(x′, v′), x′ = x + Δt v′, by Newton's method;  others: their table or form",
         .formula_in_force = [this] { return info_of(integrator).formula; },
         .source = "lecture: time integration; [Baraff1998], [Nocedal2006], [Hairer2006]",
         .run = [this] { integrate(); },
         .reads = {"position", "velocity", "spring_force", "damping_force", "external_force"},
         .writes = {"position", "velocity"},
         .active = [this] { return !tested(); },
         .again = [this] { return integrator_->again(); },
         .begin = [this] { begin_integration(); },
         .end = [this] { end_integration(); },
         .explain = [this](const Question& q) { return why_integrated(q); }},
        {.name = "contact",
         .formula = "y ≥ 0;  v_y′ = e w,  w² = u² + 2 h a;  |Δv_t| ≤ μ |Δv_y|",
         .source = "[Bridson2002]",
         .run = [this] { contact_stage(); },
         .reads = {"position", "velocity"},
         .writes = {"position", "velocity"},
         .active = [this] { return grounded(); },
         .explain = [this](const Question& q) { return why_contact(q); }},
        {.name = "static_test",
         .formula = "K u = 0 at the free nodes,  K = Σ k n nᵀ,  u given at the plates",
         .source = "[BornHuang1954 §11], [Hughes2000 §1.6]",
         .run = [this] { static_stage(); },
         .writes = {"position", "strain", "tension"},
         .active = [this] { return tested(); },
         .explain = [this](const Question& q) { return why_static(q); }},
    };
}

}  // namespace pliant::mass_spring
