#include "cloth.h"
#include "kits/springs/net_picture.h"
#include "kits/springs/net_stages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::cloth {
namespace {

// Stiffness of the planes that nodes rest on, in inertias M / dt^2 of a node: a node sinks in by this part of what it would fall
// in a step.
constexpr Real plane_stiffness = 100;

}  // namespace

void ClothLesson::declare_fields() {
    const auto has = [](const auto& values) { return [&values] { return values.size() > 0; }; };
    const auto strained = [] { return 100.0; };
    state = {state_array("position", "m", position_), state_array("velocity", "m/s", velocity_),
             state_array("contact_force", "N", contact_force_), state_array("gust_time", "s", gust_time_),
             state_array("pace", "m/s, m/s²", pace_)};
    fields = {
        vector_field("position", "x", "m", On::node, position_, "of the nodes"),
        vector_field("velocity", "v", "m/s", On::node, velocity_, "of the nodes"),
        vector_field("spring_force", "f", "N", On::node, spring_force_, "sum of the springs of a node"),
        vector_field("damping_force", "fᵈ", "N", On::node, damping_force_, "sum of the dampers of a node")
            .when(has(damping_force_)),
        vector_field("external_force", "fᵉ", "N", On::node, external_force_, "weight, and the pull of the hand")
            .when(has(external_force_)),
        tensor_field("wind_drag", "C", "N s/m", On::node, drag_numbers_,
                     "force of the air on a node for each m/s of the wind against it")
            .when(has(drag_numbers_)),
        vector_field("wind_force", "fʷ", "N", On::node, wind_force_, "of the air, at the start of the step")
            .when(has(wind_force_)),
        scalar_field("contact_force", "N", "N", On::node, contact_force_, "with which the sphere presses a node outwards")
            .when(has(contact_force_)),
        scalar_field("strain", "ε", "", On::edge, strain_, "(|xᵢⱼ| − l)/l: positive where a spring is longer than at rest")
            .of_both_signs()
            .stops_at(strained),
        scalar_field("stretch", "ε_s", "", On::node, stretch_,
                     "of the strains of a node's structural springs the one farthest from 0: red where it is stretched")
            .of_both_signs()
            .stops_at(strained),
        scalar_field("bending", "β", "", On::node, bending_, "largest shortening of a node's bending springs: 0 where it is flat")
            .stops_at(strained),
    };
    fields[0].bound = [this] { return 1e4 * size + 1e3 * (std::abs(wind) + 1) * std::max(Real{1}, Real{dt}); };
    fields[1].bound = [this] { return 1000 * size / dt + 10 * (std::abs(wind) * (1 + gust) + gravity * dt); };
}

void ClothLesson::declare_stages() {
    const auto why = [this](const Question& q) { return why_force(q); };
    formula_symbols = springs::symbols_and({{"w", "m/s"}, {"u", "m/s"}, {"ρ", "kg/m³"}, {"A", "m²"}, {"p", "kg m"}});
    stages = {
        springs::spring_forces_stage([this] { spring_stage(); }, {"spring_force", "strain", "stretch", "bending"}, why),
        springs::damping_forces_stage(
            [this] {
                damping_force_.setZero();
                add_damping_forces<3>(sheet_->springs(), damping_mode, position_, velocity_, damping_force_);
            },
            why, [this] { return SpringDamping(damping_mode); }, [this] { return damped(); }),
        springs::external_forces_stage(
            [this] {
                external_force_.setZero();
                add_external_forces<3>(load_, sheet_->mass(), position_, external_force_);
            },
            why, [this] { return loaded(); }),
        stage_of("wind", "fᵢ = Cᵢ (w − vᵢ),  Cᵢ = Σ ρ c A |u·n| n nᵀ / 6 over its triangles,  u = w − v",
                 "pressure on a plate across the wind; [Ling1996]", [this] { wind_stage(); })
            .maps({"position", "velocity"}, {"wind_drag", "wind_force"})
            .because([this](const Question& q) { return why_force(q); })
            .when([this] { return in_air(); })
            .done_in("core/pliant/solids/sheet_wind.cpp: triangle_drag, wind_drag"),
        stage_of("integrate",
                 "explicit: x′ = x + Δt v, v′ = v + Δt f/m;  semi-implicit: v′ = v + Δt f/m, x′ = x + Δt v′;  "
                 "implicit: m (v′ − v) = Δt f(x′, v′), x′ = x + Δt v′, by Newton's method",
                 "lecture: time integration; [Baraff1998], [Nocedal2006 §7.1]", [this] { integrate(); })
            .done_in("core/pliant/time/time_integrator.cpp: explicit_pass; core/pliant/time/implicit.cpp: iterate")
            .maps({"position", "velocity", "spring_force", "damping_force", "external_force", "wind_drag", "wind_force",
                   "contact_force"},
                  {"position", "velocity"})
            .repeats([this] { return integrator_->again(); }, [this] { begin_integration(); }, [this] { end_integration(); })
            .shows([this] { return info_of(scheme).formula; })
            .because([this](const Question& q) { return why_integrated(q); }),
        stage_of(
            "strain_limiting",
            "|xᵢⱼ| > (1 + ε_max) l:  xᵢ += p/mᵢ, xⱼ −= p/mⱼ, v += Δx/Δt,  p = (|xᵢⱼ| − (1 + ε_max) l) xᵢⱼ/|xᵢⱼ| / (1/mᵢ + 1/mⱼ)",
            "[Provot1995], [Bridson2002 §4]",
            [this] { limiter_excess_ = limiter_->pass(sheet_->inertia(), strain_limit, dt, position_, velocity_); })
            .done_in("core/pliant/solids/strain_limiter.cpp: pass")
            .maps({"position", "velocity"}, {"position", "velocity"})
            .repeats([this] { return limiter_excess_ > 1e-3 && limiter_->passes() < limit_passes; },
                     [this] {
                         const Index limited = sheet_->last(shear);
                         if (!limiter_) limiter_ = std::make_unique<StrainLimiter>(sheet_->springs(), limited);
                         limiter_->begin();
                         stretch_before_limiting_ = largest_stretch(sheet_->springs(), limited, position_);
                     },
                     [this] { note_pace(); })
            .when([this] { return bool(strain_limiting); })
            .because([this](const Question& q) { return why_limited(q); }),
        stage_of("sphere_contact",
                 "|x − x_c| ≥ R;  v·n ≥ 0;  |Δv_t| ≤ μ |Δv_n|;  N = m |Δv_n| / Δt, or the force of the plane that held it",
                 "[Baraff1998 §5], [Bridson2002]",
                 [this] {
                     touching_ = resolve_sphere_contact(sphere(), sheet_->inertia(), dt, held_, position_, velocity_,
                                                        contact_force_, touches_);
                     note_pace();
                 })
            .maps({"position", "velocity"}, {"position", "velocity", "contact_force"})
            .because([this](const Question& q) { return why_contact(q); })
            .when([this] { return has_sphere(); })
            .done_in("core/pliant/solids/sphere_contact.cpp: resolve_sphere_contact"),
    };
}

// Brings springs, masses and loads up to the parameters of this step. What the scene does not use has no memory.
void ClothLesson::follow_parameters() {
    sheet_->set_springs({k_structural, k_shear, k_bending}, damping);
    sheet_->set_mass(total_mass, held_nodes());
    load_.gravity = Vec<3>(0, -gravity, 0);
    load_.pull.stiffness = pull_stiffness;
    const Index count = sheet_->rest().cols();
    const auto keep = [count](Points<3>& force, bool used) {
        if (force.cols() != (used ? count : 0)) force.setZero(3, used ? count : 0);
    };
    keep(damping_force_, damped());
    keep(external_force_, loaded());
    keep(wind_force_, in_air());
    drag_numbers_.resize(in_air() ? 9 * static_cast<std::size_t>(count) : 0, Real{0});
}

void ClothLesson::pull(const std::optional<Pull>& hand) { springs::take_hold(load_, hand, position_.cols()); }

void ClothLesson::spring_stage() {
    follow_parameters();
    const Springs& springs = sheet_->springs();
    spring_force_.setZero();
    add_spring_forces<3>(springs, position_, spring_force_);
    spring_strain<3>(springs, position_, strain_);
    stretch_.setZero();
    bending_.setZero();
    for (Index s = 0; s < strain_.size(); ++s) {
        if (std::abs(strain_[s]) < strain_rounding) strain_[s] = 0;
        const SpringFamily family = sheet_->family_of(s);
        for (const Index n : {springs.i(s), springs.j(s)}) {
            if (family == structural && std::abs(strain_[s]) > std::abs(stretch_[n])) stretch_[n] = strain_[s];
            if (family == bending) bending_[n] = std::max(bending_[n], -strain_[s]);
        }
    }
}

void ClothLesson::wind_stage() {
    gust_at_ = gust_time_[0];
    const Air air{.velocity = wind_at(gust_at_), .drag = air_drag};
    wind_drag(sheet_->triangles(), air, position_, velocity_, drag_);
    for (std::size_t n = 0; n < drag_.size(); ++n) {
        const auto node = static_cast<Index>(n);
        wind_force_.col(node) = drag_[n] * (air.velocity - velocity_.col(node));
        Eigen::Map<Mat<3>>(drag_numbers_.data() + 9 * n) = drag_[n].transpose();  // row by row
    }
}

const ImplicitSolver* ClothLesson::solver() const {
    return integrator_ && is_implicit(integrator_->scheme()) ? &integrator_->solver() : nullptr;
}

NewtonOptions ClothLesson::newton_options() const {
    return {.relative_step = newton_tolerance,
            .max_iterations = capped() ? static_cast<int>(Index(newton_cap)) : full_iterations,
            .at_cap = capped() ? AtCap::accept : AtCap::fail,
            .linear_solve = linear_solver,
            .linear_tolerance = linear_tolerance,
            .linear_iterations = capped() ? static_cast<int>(Index(linear_iterations)) : full_linear_iterations};
}

void ClothLesson::begin_integration() {
    if (!integrator_) {
        system_ = std::make_unique<SpringSystem<3>>(sheet_->springs(), sheet_->mass());
        system_->set_sheet(nodes, nodes);
        integrator_ = std::make_unique<TimeIntegrator>(*system_, sheet_->inertia(), scheme, newton_options());
    }
    integrator_->set_scheme(scheme);
    integrator_->set_options(newton_options());
    if (implicit()) prepare_implicit_step();
    total_force_ = flat(spring_force_);
    if (damped()) total_force_ += flat(damping_force_);
    if (loaded()) total_force_ += flat(external_force_);
    if (in_air()) total_force_ += flat(wind_force_);
    start_velocity_ = velocity_;
    integrator_->begin(dt, flat(position_), flat(velocity_), &total_force_);
}

// What the solver needs to know of the load, of the air and of the sphere.
void ClothLesson::prepare_implicit_step() {
    system_->damping = damping_mode;
    system_->load = load_;
    NodalTerms<3>& terms = system_->terms;
    terms.planes.clear();
    terms.drag.clear();
    if (!in_air()) terms.force.resize(3, 0);
    if (in_air()) {
        terms.drag = drag_;
        terms.force.resize(3, position_.cols());
        const Vec<3> wind_now = wind_at(gust_at_);
        for (std::size_t n = 0; n < drag_.size(); ++n) terms.force.col(static_cast<Index>(n)) = drag_[n] * wind_now;
    }
    if (has_sphere()) {
        const Real stiffness = plane_stiffness * (sheet_->mass()[0] / (dt * dt));
        rest_on_sphere(sphere(), sheet_->inertia(), dt, position_, velocity_, contact_force_, stiffness, terms);
    }
}

// One pass; its iterate can be looked at.
void ClothLesson::integrate() {
    integrator_->pass();
    flat(position_) = integrator_->position();
    flat(velocity_) = integrator_->velocity();
}

void ClothLesson::end_integration() {
    gust_time_[0] += dt;
    held_.setZero();
    integrator_->finish(flat(position_), flat(velocity_));
    note_pace();
    if (!implicit()) return;
    integrator_->solver().imbalance(imbalance_);
    plane_forces(system_->terms.planes, position_, held_);
}

// Behind every stage that changes velocities: the last one has the last word.
void ClothLesson::note_pace() {
    pace_[0] = std::max(pace_[0], velocity_.colwise().norm().maxCoeff());
    pace_[1] = (velocity_ - start_velocity_).colwise().norm().maxCoeff() / dt;
}

}  // namespace pliant::cloth
