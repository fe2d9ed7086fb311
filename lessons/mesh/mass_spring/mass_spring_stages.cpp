// Fields, stages and what they do; curves: a rotation that dampers brake, moduli and couplings of a static test, the mode of a
// chain.
#include "kits/springs/net_picture.h"
#include "kits/springs/net_stages.h"
#include "mass_spring.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::mass_spring {

void MassSpringLesson::declare_fields() {
    const auto nodal = [](std::string_view name, std::string_view symbol, std::string_view unit, std::string_view help,
                          const Points<3>& values) {
        return vector_field(name, symbol, unit, On::node, values, help).when([&values] { return values.size() > 0; });
    };
    const auto of_springs = [](std::string_view name, std::string_view symbol, std::string_view unit, std::string_view help,
                               const VecX& values) {
        return scalar_field(name, symbol, unit, On::edge, values, help).of_both_signs().when([&values] {
            return values.size() > 0;
        });
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
    const auto why = [this](const Question& q) { return why_force(q); };
    formula_symbols = springs::symbols_and({{"w", "m/s"}, {"a", "m/s²"}});
    stages = {
        springs::spring_forces_stage([this] { spring_stage(); }, {"spring_force", "tension", "strain"}, why,
                                     [this] { return !tested(); }),
        springs::damping_forces_stage(
            [this] {
                damping_force_.setZero();
                add_damping_forces<3>(block_->springs(), damping_mode, position_, velocity_, damping_force_);
            },
            why, [this] { return SpringDamping(damping_mode); }, [this] { return damped(); }),
        springs::external_forces_stage(
            [this] {
                external_force_.setZero();
                add_external_forces<3>(load_, block_->mass(), position_, external_force_);
            },
            why, [this] { return loaded() && !tested(); }),
        stage_of("integrate",
                 "explicit: x′ = x + Δt v, v′ = v + Δt f/m;  semi-implicit: v′ = v + Δt f/m, x′ = x + Δt v′;  "
                 "implicit: m (v′ − v) = Δt f(x′, v′), x′ = x + Δt v′, by Newton's method;  others: their table or form",
                 "lecture: time integration; [Baraff1998], [Nocedal2006], [Hairer2006]", [this] { integrate(); })
            .done_in("core/pliant/time/time_integrator.cpp: explicit_pass; core/pliant/time/implicit.cpp: iterate")
            .maps({"position", "velocity", "spring_force", "damping_force", "external_force"}, {"position", "velocity"})
            .repeats([this] { return integrator_->again(); }, [this] { begin_integration(); }, [this] { end_integration(); })
            .when([this] { return !tested(); })
            .shows([this] { return info_of(integrator).formula; })
            .because([this](const Question& q) { return why_integrated(q); }),
        stage_of("contact", "y ≥ 0;  v_y′ = e w,  w² = u² + 2 h a;  |Δv_t| ≤ μ |Δv_y|", "[Bridson2002]",
                 [this] { contact_stage(); })
            .maps({"position", "velocity"}, {"position", "velocity"})
            .because([this](const Question& q) { return why_contact(q); })
            .when([this] { return grounded(); })
            .done_in("core/pliant/solids/contact.cpp: resolve")
            .where({{"y", "m"}, {"u", "m/s"}, {"h", "m"}}),
        stage_of("static_test", "K u = 0 at the free nodes,  K = Σ k n nᵀ,  u given at the plates",
                 "[BornHuang1954 §11], [Hughes2000 §1.6]", [this] { static_stage(); })
            .maps({}, {"position", "strain", "tension"})
            .because([this](const Question& q) { return why_static(q); })
            .when([this] { return tested(); })
            .done_in("core/pliant/solids/lattice_elasticity.cpp: solve, test_block")
            .where({{"K", "N/m"}, {"u", "m"}}),
    };
}

namespace {

// What naive damping leaves of the angular momentum of a rigid body that turns about the vertical: exp(-lambda t), with
// lambda = k_d sum of the squared distances between the ends of the springs, seen from above, over the moment of inertia.
Real rotation_after(const MassSpringLesson& l, Real t) {
    const Points<3>& rest = l.block_->rest();
    const auto level = [](const Vec<3>& r) { return r[0] * r[0] + r[2] * r[2]; };
    Real spread = 0, inertia = 0;
    const Vec<3> centre = rest.rowwise().mean();
    for (Index s = 0; s < l.block_->springs().size(); ++s)
        spread += level(rest.col(l.block_->springs().j(s)) - rest.col(l.block_->springs().i(s)));
    for (Index n = 0; n < rest.cols(); ++n) inertia += l.block_->mass()[n] * level(rest.col(n) - centre);
    return l.start_angular_momentum_ * std::exp(inertia > 0 ? -l.damping * spread / inertia * t : 0);
}

}  // namespace

void MassSpringLesson::declare_lines() {
    const auto to_now = [this](Curve& curve, const std::function<Real(Real)>& value) {
        curve.add_range(0, std::max(clock_[0], Real{1}), 61, value);
    };
    const auto spins = [this] { return setting == Setting::spin && start_angular_momentum_ > 0; };
    const auto coupling = [this](Curve& curve, BlockTest row) {
        if (!test_done_) return;
        curve.position = {1, 2, 3};
        for (int family = 0; family < spring_families; ++family)
            curve.value.push_back(tests_.coupling()(static_cast<int>(row), family));
    };
    lines = {
        line_of("rotation", "kg m²/s", "t", "s",
                "angular momentum of a rigid body that turns: what naive dampers leave, what projected ones do, and this run", {})
            .against("projected dampers",
                     [this, to_now](Curve& c) { to_now(c, [this](Real) { return start_angular_momentum_; }); })
            .beside({{.name = "naive dampers",
                      .sample = [this, to_now](Curve& c) { to_now(c, [this](Real t) { return rotation_after(*this, t); }); }},
                     {.name = "this run",
                      .sample = [this](Curve& c) { c.add(clock_[0], *probe("angular_momentum").value()); },
                      .points = true}})
            .measures("angular momentum")
            .when(spins),
        line_of("modulus_by_cells", "", "cells along each axis", "",
                "Young's modulus of pieces of this lattice over that of the endless one: what more cells change",
                [this](Curve& c) {
                    for (const Real ratio : tests_.modulus_by_cells()) c.add(Real(c.position.size() + 1), ratio);
                })
            .against("endless lattice",
                     [](Curve& c) {
                         c = {{1, Real(StaticTests::most_cells)}, {1, 1}};
                     })
            .measures("E/E of the endless lattice")
            .when([this] { return tested() && lattice() != LatticeKind::chain; }),
        line_of("coupling", "", "1 structural, 2 shear, 3 bending", "",
                "∂ ln K/∂ ln k: what one per cent more of a family's stiffness changes, in per cent, of each test",
                [coupling](Curve& c) { coupling(c, BlockTest::stretch); })
            .against(
                "shear", [coupling](Curve& c) { coupling(c, BlockTest::shear); }, true)
            .beside({{.name = "bend", .sample = [coupling](Curve& c) { coupling(c, BlockTest::bend); }, .points = true}})
            .measures("stretch")
            .when([this] { return tested() && lattice() != LatticeKind::chain; }),
        line_of("mode", "m", "mass", "", "displacement of each mass of a swinging chain, from the top, and where it began",
                [this](Curve& c) {
                    for (Index n = position_.cols() - 1; n >= 0; --n)
                        c.add(Real(cells_y - n), position_(1, n) - block_->rest()(1, n));
                })
            .against("start",
                     [this](Curve& c) {
                         for (Index n = position_.cols() - 1; n >= 0; --n)
                             c.add(Real(cells_y - n), swing_amplitude * edge() * mode_shape(n));
                     })
            .measures("displacement")
            .when([this] { return setting == Setting::swing; })};
}

// Brings springs, masses and loads up to the parameters of this step. What the scene does not use has no memory.
void MassSpringLesson::follow_parameters() {
    const bool new_springs = block_->set_springs(stiffnesses(), damping, tested() ? Real{1} : Real{rest_length_scale});
    block_->set_mass(total_mass, held_nodes());
    load_.gravity = Vec<3>(0, -weight_acceleration(), 0);
    load_.pull.stiffness = pull_stiffness;
    interfered_ = interfered_ || gravity != start_gravity_ || total_mass != start_mass_;
    if (new_springs) {
        integrator_.reset();
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
    if (springs::take_hold(load_, hand, position_.cols())) interfered_ = true;
}

void MassSpringLesson::spring_stage() {
    follow_parameters();
    spring_force_.setZero();
    add_spring_forces<3>(block_->springs(), position_, spring_force_);
    spring_tension<3>(block_->springs(), position_, tension_);
    spring_strain<3>(block_->springs(), position_, strain_);
    // Lengths are known to their rounding, which would be all there is to see in free fall.
    for (Index s = 0; s < strain_.size(); ++s)
        if (block_->springs().rest_length()[s] > 0 && std::abs(strain_[s]) < strain_rounding) tension_[s] = strain_[s] = 0;
}

void MassSpringLesson::begin_integration() {
    total_force_ = flat(spring_force_);
    if (damped()) total_force_ += flat(damping_force_);
    if (loaded()) total_force_ += flat(external_force_);

    const NewtonOptions options{newton_tolerance, static_cast<int>(Index(newton_cap))};
    if (!integrator_) {
        system_ = std::make_unique<SpringSystem<3>>(block_->springs(), block_->mass());
        integrator_ = std::make_unique<TimeIntegrator>(*system_, block_->inertia(), integrator, options);
    }
    integrator_->set_scheme(integrator);
    integrator_->set_options(options);
    recall_memory();
    system_->damping = damping_mode;
    system_->load = load_;
    if (grounded())
        set_ground_bounds<3>(ground_plane(), position_, integrator_->lower_bound());
    else
        integrator_->lower_bound().resize(0);
    contact_.begin(dt, position_, velocity_);
    integrator_->begin(dt, flat(position_), flat(velocity_), &total_force_);
}

// What lives between steps is part of the state, of one size for all schemes, since a run may go back: the number of the scheme
// from 1 on, 0 where nothing is remembered, then its memory.
void MassSpringLesson::store_memory() {
    memory_.setZero();
    const VecX& memory = integrator_->memory();
    if (memory.size() == 0) return;
    memory_[0] = integrator.value() + 1;
    memory_.segment(1, memory.size()) = memory;
}

void MassSpringLesson::recall_memory() {
    VecX& memory = integrator_->memory();
    if (memory_[0] == integrator.value() + 1)
        memory = memory_.segment(1, memory.size());
    else
        integrator_->forget();
}

// One Newton iteration, or one evaluation of the forces; where it has led to can be looked at.
void MassSpringLesson::integrate() {
    integrator_->pass();
    flat(position_) = integrator_->position();
    flat(velocity_) = integrator_->velocity();
    for (Index d = 0; d < velocity_.size(); ++d)
        if (block_->inertia().fixed(d)) velocity_.data()[d] = 0;
}

void MassSpringLesson::end_integration() {
    integrator_->finish(flat(position_), flat(velocity_));
    store_memory();
    clock_[0] += dt;
    note_swing();
}

void MassSpringLesson::contact_stage() {
    if (implicit()) contact_.arrest(*integrator_, block_->inertia());
    const auto force = [this](ConstDofs x, ConstDofs v, Dofs f) {
        system_->begin_step(x);
        system_->force(x, v, f);
    };
    touching_ = contact_.resolve(ground_plane(), block_->inertia(), integrator, force, position_, velocity_);
    // A step that starts from what the ground has changed does not follow from the one before.
    if (touching_ > 0) memory_[0] = 0;
}

}  // namespace pliant::mass_spring
