#include "integration.h"

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
    constexpr Real far = 1e12;  // times what is possible: of a trial, which need not be near the motion
    const auto furthest = [this] { return motion_->can_leave() ? 1e300 : SchemeRun::blown_up * motion_->scale(); };
    const auto fastest = [this] { return SchemeRun::blown_up * motion_->top_speed(); };
    const auto strongest = [this] {
        const Real w = motion_->fast_rate();
        return 4 * SchemeRun::blown_up * ((1 + w) * w * motion_->scale() + 2 * zeta * w * motion_->top_speed());
    };
    const auto of_mass = [](std::string_view name, std::string_view symbol, std::string_view unit, const VecX& numbers,
                            std::string_view help, std::function<Real()> bound) {
        return scalar_field(name, symbol, unit, On::node, numbers, help).of_both_signs().stops_at(std::move(bound));
    };
    fields = {
        of_mass("position", "x", "m", x_, "of each mass; of the pendulum along its arc", furthest),
        of_mass("velocity", "v", "m/s", v_, "of each mass", fastest),
        of_mass("force", "f", "N", force_, "at the start of the step", strongest),
        of_mass("trial_position", "X", "m", trial_x_,
                "where the next force is evaluated, or the end of the step; the iterate of an implicit scheme",
                [this, furthest] { return motion_->can_leave() ? 1e300 : far * furthest(); }),
        of_mass("trial_velocity", "V", "m/s", trial_v_, "the velocity there", [fastest] { return far * fastest(); }),
        of_mass("pass_force", "f_k", "N", pass_force_, "that this pass has evaluated", [strongest] { return far * strongest(); })
            .when([this] { return !implicit(); }),
        of_mass("residual", "r", "N", residual_, "what the iterate before this pass left of the equation: m a − f(X, V)",
                [this, strongest, fastest] { return strongest() + 100 * fastest() / dt; })
            .when([this] { return implicit(); })};
}

void IntegrationLesson::declare_stages() {
    formula_symbols = {{"m", "kg"}, {"g", "m/s²"}, {"l", "m"}, {"K", "N/m"}, {"C", "N s/m"}, {"H", "N/m"}};
    stages = {stage_of("force", "spring: f = −m (ω²x + 2ζωv);  pendulum: f = −m (g sin(x/l) + 2ζωv);  pair: f = −Kx − Cv",
                       "lecture S: time integration, F(v(t), x(t), t)", [this] { force_stage(); })
                  .maps({"position", "velocity"}, {"force"})
                  .because([this](const Question& q) { return why_force(q.index, "position", "velocity", Input::now, ""); })
                  .done_in("core/pliant/time/swinging.cpp: Swinging::force")
                  .shows([this]() -> std::string_view {
                      return system == SwingingKind::oscillator ? "f = −m (ω²x + 2ζωv)"
                             : system == SwingingKind::pendulum ? "f = −m (g sin(x/l) + 2ζωv)"
                                                                : "f = −Kx − Cv";
                  }),
              stage_of("predict", "explicit: X = x, V = v;  implicit: a first guess, X = x + Δt v or X = x",
                       "Hairer1993 §II.14; Baraff1998", [this] { predict(); })
                  .maps({"position", "velocity"}, {"trial_position", "trial_velocity"})
                  .because([this](const Question& q) { return why_predicted(q); })
                  .done_in("core/pliant/time/time_integrator.cpp: begin_explicit, begin_implicit")
                  .shows([this]() -> std::string_view {
                      return implicit() ? "a first guess, X = x + Δt v or X = x" : "X = x,  V = v";
                  }),
              stage_of("passes", "explicit: f_k at X, V, then the next X, V;  implicit, Newton: X ← X − r/H",
                       "lecture S: time integration; Hairer1993 §II.14; Nocedal2006", [this] { pass(); })
                  .done_in("core/pliant/time/time_integrator.cpp: explicit_pass; core/pliant/time/implicit.cpp: iterate")
                  .maps({"position", "velocity", "force"}, {"trial_position", "trial_velocity", "pass_force", "residual"})
                  .repeats([this] { return integrator_->again(); })
                  .shows([this]() -> std::string_view {
                      return is_implicit(scheme) ? "Newton: X ← X − r/H" : "f_k at X, V, then the next X, V";
                  })
                  .because([this](const Question& q) { return why_pass(q); }),
              stage_of("advance", "v′ = v + Δt f/m;  explicit: x′ = x + Δt v;  semi-implicit: x + Δt v′;  implicit: f(x′, v′)",
                       "lecture S: time integration", [this] { advance(); })
                  .maps({"trial_position", "trial_velocity"}, {"position", "velocity"})
                  .because([this](const Question& q) { return why_advanced(q); })
                  .done_in("core/pliant/time/time_integrator.cpp: finish")
                  .shows([this] { return info_of(scheme).formula; })};
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
