#include "mass_spring.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
    state = {state_array("position", "m", position_), state_array("velocity", "m/s", velocity_)};
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
         .explain = [this](const Question& q) { return why_spring_stage(q); }},
        {.name = "damping_forces",
         .formula = "naive: fᵢ = kᵈ vᵢⱼ;  projected: fᵢ = kᵈ (vᵢⱼ·xᵢⱼ / xᵢⱼ·xᵢⱼ) xᵢⱼ,  vᵢⱼ = vⱼ − vᵢ",
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
         .active = [this] { return loaded(); },
         .explain = [this](const Question& q) { return why_external_force(q.index, q.component); }},
        {.name = "integrate",
         .formula = "explicit: x' = x + Δt v, v' = v + Δt f/m;  semi-implicit: v' = v + Δt f/m, x' = x + Δt v';  "
                    "implicit: m (v' − v) = Δt f(x', v'), x' = x + Δt v', by Newton's method",
         .source = "lecture: time integration; [Baraff1998], [Nocedal2006]",
         .run = [this] { integrate(); },
         .reads = {"position", "velocity", "spring_force", "damping_force", "external_force"},
         .writes = {"position", "velocity"},
         .again = [this] { return implicit() && solver_->again(); },
         .begin = [this] { begin_integration(); },
         .end = [this] { end_integration(); },
         .explain = [this](const Question& q) { return why_integrated(q); }},
        {.name = "contact",
         .formula = "y ≥ 0;  v_y ← −e v_y;  |Δv_t| ≤ μ |Δv_y|",
         .source = "[Bridson2002]",
         .run = [this] { contact_stage(); },
         .reads = {"position", "velocity"},
         .writes = {"position", "velocity"},
         .active = [this] { return grounded(); },
         .explain = [this](const Question& q) { return why_contact(q); }},
    };
}

// Brings springs, masses and loads up to the parameters of this step. What the scene does not use has no memory.
void MassSpringLesson::follow_parameters() {
    const bool new_springs = block_->set_springs({k_structural, k_shear, k_bending}, damping);
    block_->set_mass(total_mass, held_nodes());
    load_.gravity = Vec<3>(0, -weight_acceleration(), 0);
    load_.pull.stiffness = pull_stiffness;
    interfered_ = interfered_ || gravity != start_gravity_ || total_mass != start_mass_;
    if (new_springs || !implicit()) {
        solver_.reset();
        system_.reset();
    }
    const Index nodes = block_->rest().cols(), springs = block_->springs().size();
    const auto keep = [nodes](Points<3>& force, bool used) {
        if (force.cols() != (used ? nodes : 0)) force.setZero(3, used ? nodes : 0);
    };
    keep(damping_force_, damped());
    keep(external_force_, loaded());
    for (VecX* values : {&tension_, &strain_})
        if (values->size() != springs) values->setZero(springs);
}

void MassSpringLesson::pull(const std::optional<Pull>& hand) {
    load_.pull.node = -1;
    if (!hand || hand->index < 0) return;
    if (hand->index >= position_.cols())
        throw Refused(fmt::format("pull: node {} does not exist, there are {} nodes", hand->index, position_.cols()));
    if (!hand->to.allFinite()) throw Refused("pull: give a finite place in m");
    load_.pull.node = hand->index;
    load_.pull.target = hand->to;
    interfered_ = true;
}

void MassSpringLesson::spring_stage() {
    follow_parameters();
    spring_force_.setZero();
    add_spring_forces<3>(block_->springs(), position_, spring_force_);
    spring_tension<3>(block_->springs(), position_, tension_);
    spring_strain<3>(block_->springs(), position_, strain_);
    // Lengths are known to their rounding, which would be all there is to see in free fall.
    for (Index s = 0; s < strain_.size(); ++s)
        if (std::abs(strain_[s]) < strain_rounding) tension_[s] = strain_[s] = 0;
}

void MassSpringLesson::damping_stage() {
    damping_force_.setZero();
    add_damping_forces<3>(block_->springs(), damping_mode, position_, velocity_, damping_force_);
}

void MassSpringLesson::external_stage() {
    external_force_.setZero();
    add_external_forces<3>(load_, block_->mass(), position_, external_force_);
}

void MassSpringLesson::begin_integration() {
    total_force_ = spring_force_;
    if (damped()) total_force_ += damping_force_;
    if (loaded()) total_force_ += external_force_;
    energy_wobble_ = std::max(energy_wobble_, 0.5 * dt * std::abs(flat(velocity_).dot(flat(total_force_))));
    if (!implicit()) return;

    if (!solver_) {
        system_ = std::make_unique<SpringSystem<3>>(block_->springs(), block_->mass());
        solver_ = std::make_unique<ImplicitSolver>(*system_, block_->inertia());
    }
    system_->damping = damping_mode;
    system_->load = load_;
    solver_->set_options({newton_tolerance, static_cast<int>(Index(newton_cap))});
    ImplicitForm& form = solver_->form();
    implicit_euler(dt, flat(position_), flat(velocity_), form);
    if (grounded())
        set_ground_bounds<3>({0, restitution, friction}, position_, form.lower_bound);
    else
        form.lower_bound.resize(0);
    solver_->begin(flat(position_));
}

void MassSpringLesson::integrate() {
    const DiagonalMass& inertia = block_->inertia();
    if (integrator == Scheme::explicit_euler) explicit_euler(dt, inertia, flat(total_force_), flat(position_), flat(velocity_));
    if (semi_implicit()) semi_implicit_euler(dt, inertia, flat(total_force_), flat(position_), flat(velocity_));
    if (!implicit()) return;
    // One Newton iteration; its iterate can be looked at.
    solver_->iterate();
    flat(position_) = solver_->position();
    flat(velocity_) = solver_->velocity();
}

void MassSpringLesson::end_integration() {
    if (implicit()) solver_->finish(flat(position_), flat(velocity_));
}

void MassSpringLesson::contact_stage() {
    arrested_.clear();
    if (implicit()) arrested_speeds<3>(*solver_, block_->inertia(), dt, arrested_);
    const Real moved_for = semi_implicit() ? Real(dt) : 0;
    const Ground floor{0, restitution, friction};
    touches_.resize(static_cast<std::size_t>(position_.cols()));
    for (Index n = 0; n < position_.cols(); ++n)
        touches_[static_cast<std::size_t>(n)] = touch_of<3>(floor, block_->inertia(), position_, arrested_, n);
    touching_ = resolve_ground_contact<3>(floor, block_->inertia(), moved_for, position_, velocity_, arrested_);
}

}  // namespace pliant::mass_spring
