#include "integration.h"
#include "time/schemes/scheme_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::integration {
namespace {

constexpr Real least_swing = 1e-6;  // of the scale: what is smaller is no swing

const Registration<IntegrationLesson> registration{
    {.id = "time/integration",
     .title = "Time integration",
     .summary = "Explicit, semi-implicit and implicit Euler, and five better schemes, on motions that are known exactly.",
     .demo_steps = 200}};

}  // namespace

IntegrationLesson::IntegrationLesson()
    : system(*this, {.key = "system", .help = "what moves; every mass is 1 kg", .effect = Effect::rebuild},
             {{"oscillator", "mass on a spring"}, {"pendulum", "pendulum"}, {"stiff_pair", "soft and stiff spring"}}),
      scheme(*this, {.key = "scheme", .help = "how a force becomes motion", .initial = 1, .effect = Effect::rebuild},
             scheme_options()),
      omega(*this,
            {.key = "omega",
             .symbol = "ω",
             .unit = "rad/s",
             .help = "angular frequency: of the mass on the spring, of the soft spring of the pair, of small swings of the "
                     "pendulum, whose length is g/ω²",
             .initial = 2,
             .useful = {0.1, 100},
             .accepted = Interval{0, 1e9},
             .scale = Scale::log,
             .effect = Effect::rebuild}),
      zeta(*this, {.key = "damping_ratio",
                   .symbol = "ζ",
                   .help = "of the drag −2ζω m v: from 1 on nothing swings any more; in the pair the same of both modes",
                   .initial = 0,
                   .useful = {0, 1.5},
                   .accepted = Interval{0, 1e9},
                   .effect = Effect::rebuild}),
      dt(*this, {.key = "time_step",
                 .symbol = "Δt",
                 .unit = "s",
                 .help = "fixed",
                 .initial = 0.05,
                 .useful = {1e-3, 10},
                 .accepted = Interval{0, 1e6, true},
                 .scale = Scale::log,
                 .effect = Effect::rebuild}),
      x0(*this, {.key = "x0",
                 .symbol = "x₀",
                 .unit = "m",
                 .help = "place at the start; of the pendulum along its arc, of the pair of both masses",
                 .initial = 1,
                 .useful = {-2, 2},
                 .accepted = Interval{-1e6, 1e6},
                 .effect = Effect::rebuild}),
      v0(*this, {.key = "v0",
                 .symbol = "v₀",
                 .unit = "m/s",
                 .help = "velocity at the start",
                 .initial = 0,
                 .useful = {-5, 5},
                 .accepted = Interval{-1e6, 1e6},
                 .effect = Effect::rebuild}),
      ratio(*this, {.key = "stiffness_ratio",
                    .symbol = "κ",
                    .help = "stiffness of the spring between the two masses over that of the soft one",
                    .initial = 400,
                    .useful = {1, 1e4},
                    .accepted = Interval{0, 1e8, true},
                    .scale = Scale::log,
                    .effect = Effect::rebuild,
                    .used = [this] { return is(System::stiff_pair); }}),
      compare(*this, {.key = "compare", .help = "schemes that run beside the chosen one, from the same start", .initial = 1},
              {{"none", "none"}, {"lecture", "the lecture's three"}, {"all", "all eight"}}),
      newton_tolerance(*this, {.key = "newton_tolerance",
                               .symbol = "τ",
                               .help = "Newton's method stops when its step is shorter than this part of the swing",
                               .initial = 1e-9,
                               .useful = {1e-12, 1e-2},
                               .accepted = Interval{1e-14, 1, false, true},
                               .scale = Scale::log,
                               .effect = Effect::rebuild,
                               .used = [this] { return solves(); }}),
      newton_cap(*this, {.key = "newton_iterations",
                         .help = "most iterations of a time step; a step that needs more is reported, not accepted",
                         .initial = 100,
                         .useful = {1, 100},
                         .accepted = Interval{1, 10000},
                         .effect = Effect::rebuild,
                         .used = [this] { return solves(); }}) {
    declare_fields();
    declare_stages();
    declare_probes();
    declare_growth_probes();
    declare_work_probes();
    declare_lines();
    declare_checks();
}

void IntegrationLesson::reset() {
    integrator_.reset();
    motion_ = std::make_unique<Swinging>(SwingingOptions{system, omega, zeta, ratio, {x0, v0}});
    const Index n = motion_->size();
    mass_ = std::make_unique<DiagonalMass>(VecX::Ones(n), 1);
    integrator_ = std::make_unique<TimeIntegrator>(*motion_, *mass_, scheme, newton());
    x_ = motion_->start_position();
    v_ = motion_->start_velocity();
    trial_x_ = x_, trial_v_ = v_;
    for (VecX* values : {&force_, &pass_force_, &residual_}) values->setZero(n);
    before_.setZero(4 * n);
    counts_.setZero();
    rhythm_.reset();
    rhythm_.note(0, x_[watched()], least_swing * motion_->scale());
}

void IntegrationLesson::declare_fields() {
    state = {state_array("position", "m", x_),
             state_array("velocity", "m/s", v_),
             state_array("before", "m, m/s", before_),
             state_array("counts", "", counts_),
             state_array("rhythm", "s, m", rhythm_.memory()),
             StateArray{"memory", "m, m/s, m/s²", [this] {
                            VecX& memory = integrator_->memory();
                            return std::span<Real>(memory.data(), static_cast<std::size_t>(memory.size()));
                        }}};
    fields = {scalar_field("position", "x", "m", On::node, x_, "of each mass; of the pendulum along its arc"),
              scalar_field("velocity", "v", "m/s", On::node, v_, "of each mass"),
              scalar_field("force", "f", "N", On::node, force_, "at the start of the step"),
              scalar_field("trial_position", "X", "m", On::node, trial_x_,
                           "where the next force is evaluated, or the end of the step; the iterate of an implicit scheme"),
              scalar_field("trial_velocity", "V", "m/s", On::node, trial_v_, "the velocity there"),
              scalar_field("pass_force", "f_k", "N", On::node, pass_force_, "that this pass has evaluated"),
              scalar_field("residual", "r", "N", On::node, residual_,
                           "what the iterate before this pass left of the equation: m a − f(X, V)")};
    fields[5].used = [this] { return !implicit(); };
    fields[6].used = [this] { return implicit(); };
    constexpr Real far = 1e12;  // times what is possible: of a trial, which need not be near the motion
    const auto furthest = [this] { return motion_->can_leave() ? 1e300 : SchemeRun::blown_up * motion_->scale(); };
    const auto fastest = [this] { return SchemeRun::blown_up * motion_->top_speed(); };
    const auto strongest = [this] {
        const Real w = motion_->fast_rate();
        return 4 * SchemeRun::blown_up * ((1 + w) * w * motion_->scale() + 2 * zeta * w * motion_->top_speed());
    };
    fields[0].bound = furthest;
    fields[1].bound = fastest;
    fields[2].bound = strongest;
    fields[3].bound = [this, furthest] { return motion_->can_leave() ? 1e300 : far * furthest(); };
    fields[4].bound = [fastest] { return far * fastest(); };
    fields[5].bound = [strongest] { return far * strongest(); };
    fields[6].bound = [this, strongest, fastest] { return strongest() + 100 * fastest() / dt; };
}

void IntegrationLesson::declare_stages() {
    stages = {{.name = "force",
               .formula = "spring: f = −m (ω²x + 2ζωv);  pendulum: f = −m (g sin(x/l) + 2ζωv);  pair: f = −Kx − Cv",
               .formula_in_force = [this]() -> std::string_view {
                   return system == System::oscillator ? "f = −m (ω²x + 2ζωv)"
                          : system == System::pendulum ? "f = −m (g sin(x/l) + 2ζωv)"
                                                       : "f = −Kx − Cv";
               },
               .source = "lecture S: time integration, F(v(t), x(t), t)",
               .run = [this] { force_stage(); },
               .reads = {"position", "velocity"},
               .writes = {"force"},
               .explain = [this](const Question& q) -> std::optional<Explanation> {
                   return why_force(q.index, "position", "velocity", Input::now, "");
               }},
              {.name = "predict",
               .formula = "explicit: X = x, V = v;  implicit: a first guess, X = x + Δt v or X = x",
               .formula_in_force = [this]() -> std::string_view {
                   return is_implicit(scheme) ? "a first guess, X = x + Δt v or X = x" : "X = x,  V = v";
               },
               .source = "Hairer1993 §II.14; Baraff1998",
               .run = [this] { predict(); },
               .reads = {"position", "velocity"},
               .writes = {"trial_position", "trial_velocity"},
               .explain = [this](const Question& q) { return why_predicted(q); }},
              {.name = "passes",
               .formula = "explicit: f_k at X, V, then the next X, V;  implicit, Newton: X ← X − r/H",
               .formula_in_force = [this]() -> std::string_view {
                   return is_implicit(scheme) ? "Newton: X ← X − r/H" : "f_k at X, V, then the next X, V";
               },
               .source = "lecture S: time integration; Hairer1993 §II.14; Nocedal2006",
               .run = [this] { pass(); },
               .reads = {"position", "velocity", "force"},
               .writes = {"trial_position", "trial_velocity", "pass_force", "residual"},
               .again = [this] { return integrator_->again(); },
               .explain = [this](const Question& q) { return why_pass(q); }},
              {.name = "advance",
               .formula = "v′ = v + Δt f/m;  explicit: x′ = x + Δt v;  semi-implicit: x + Δt v′;  implicit: f(x′, v′)",
               .formula_in_force = [this] { return info_of(scheme).formula; },
               .source = "lecture S: time integration",
               .run = [this] { advance(); },
               .reads = {"trial_position", "trial_velocity"},
               .writes = {"position", "velocity"},
               .explain = [this](const Question& q) -> std::optional<Explanation> { return why_advanced(q); }}};
}

void IntegrationLesson::force_stage() {
    motion_->force(x_, v_, force_);
    counts_[3] = force_known;
}

void IntegrationLesson::predict() {
    evaluated_before_ = integrator_->force_evaluations();
    integrator_->begin(dt, x_, v_);
    counts_[3] = predicted;
    trial_x_ = implicit() ? integrator_->position() : x_;
    trial_v_ = implicit() ? integrator_->velocity() : v_;
}

void IntegrationLesson::pass() {
    integrator_->pass();
    trial_x_ = integrator_->position();
    trial_v_ = integrator_->velocity();
    if (implicit())
        residual_ = integrator_->solver().gradient();
    else
        pass_force_ = integrator_->acceleration(integrator_->passes() - 1);
}

void IntegrationLesson::advance() {
    const Index n = x_.size();
    before_.tail(2 * n) = before_.head(2 * n);
    before_.head(n) = x_;
    before_.segment(n, n) = v_;
    integrator_->finish(x_, v_);
    const Index iterations = implicit() ? integrator_->passes() : 0;
    const Index evaluations = integrator_->force_evaluations() - evaluated_before_ + iterations;
    counts_ += Eigen::Array4d(1, 0, static_cast<Real>(evaluations), 0);
    counts_[1] = static_cast<Real>(evaluations);
    counts_[3] = between_steps;
    rhythm_.note(time(), x_[watched()], least_swing * motion_->scale());
}

// ------------------------------------------------------------------------------------------------------- the handles

std::vector<Scheme> IntegrationLesson::companions() const {
    std::vector<Scheme> beside;
    for (const SchemeInfo& info : schemes())
        if (compared(info.scheme) && info.scheme != scheme) beside.push_back(info.scheme);
    return beside;
}

bool IntegrationLesson::compared(Scheme one) const {
    return one == scheme || compare == Compare::all || (compare == Compare::lecture && one <= Scheme::implicit_euler);
}

}  // namespace pliant::integration
