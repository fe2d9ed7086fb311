#include "rod.h"
#include "time/schemes/scheme_options.h"

#include <pliant/solids/point_masses.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

namespace pliant::rod {
namespace {

constexpr Real widest_pulse = 2;  // in lengths of the rod: the images behind its ends take off what reaches further

const Registration<RodLesson> registration{
    {.id = "mesh/rod",
     .title = "Elastic rod",
     .summary = "A rod's energy turns into springs that agree at every N; springs picked by hand do not.",
     .demo_steps = 150}};

}  // namespace

RodLesson::RodLesson()
    : setting(*this, {.key = "scene", .help = "what happens to the rod", .effect = Effect::rebuild},
              {{"hanging", "hangs at rest: solved at once"},
               {"released", "let go: it swings up and down"},
               {"wave", "one mode of a free end"},
               {"free_end", "a pulse runs to a free end"},
               {"fixed_end", "a pulse runs to a fixed end"}}),
      segments(*this, {.key = "segments",
                       .symbol = "N",
                       .help = "into which the rod is divided: as many springs, and as many masses below the support",
                       .initial = 10,
                       .useful = {2, 200},
                       .accepted = Interval{1, 200},
                       .scale = Scale::log,
                       .effect = Effect::rebuild}),
      spring_rule(*this,
                  {.key = "spring_rule",
                   .help = "derived: k = EA/Δs, from the energy of the rod. constant: one k picked by hand, whatever N is",
                   .effect = Effect::rebuild},
                  {{"derived", "derived from the energy"}, {"constant", "picked by hand"}}),
      axial_stiffness(*this,
                      {.key = "axial_stiffness",
                       .symbol = "EA",
                       .unit = "N",
                       .help = "of the rod: Young's modulus times cross-section, the force per strain. The lecture calls it k",
                       .initial = 20,
                       .useful = {1, 1e5},
                       .accepted = Interval{0, 1e12, true},
                       .scale = Scale::log,
                       .effect = Effect::rebuild}),
      picked_stiffness(*this, {.key = "picked_stiffness",
                               .symbol = "k₀",
                               .unit = "N/m",
                               .help = "of each spring of the rod that is picked by hand",
                               .initial = 200,
                               .useful = {1, 1e5},
                               .accepted = Interval{0, 1e12, true},
                               .scale = Scale::log,
                               .effect = Effect::rebuild,
                               .used = [this] { return hangs() || by_hand(); }}),
      total_mass(*this, {.key = "mass",
                         .symbol = "M",
                         .unit = "kg",
                         .help = "of the whole rod; each of the N points below the support carries M/N",
                         .initial = 1,
                         .useful = {0.01, 100},
                         .accepted = Interval{0, 1e9, true},
                         .scale = Scale::log,
                         .effect = Effect::rebuild}),
      length(*this, {.key = "length",
                     .symbol = "L",
                     .unit = "m",
                     .help = "of the rod at rest; Δs = L/N",
                     .initial = 1,
                     .useful = {0.1, 10},
                     .accepted = Interval{1e-6, 1e6},
                     .scale = Scale::log,
                     .effect = Effect::rebuild}),
      gravity(*this, {.key = "gravity",
                      .symbol = "g",
                      .unit = "m/s²",
                      .help = "acceleration of gravity, downwards",
                      .initial = 9.81,
                      .useful = {0, 20},
                      .accepted = Interval{0, 1e6},
                      .effect = Effect::rebuild,
                      .used = [this] { return hangs(); }}),
      mode(*this, {.key = "mode",
                   .symbol = "j",
                   .help = "which mode swings; a chain of N masses has N of them, and the highest stands for what lies beyond",
                   .initial = 1,
                   .useful = {1, 10},
                   .accepted = Interval{1, 200},
                   .effect = Effect::rebuild,
                   .used = [this] { return setting == Setting::wave; }}),
      amplitude(*this, {.key = "amplitude",
                        .symbol = "A",
                        .unit = "m",
                        .help = "largest displacement at the start, along the rod",
                        .initial = 0.03,
                        .useful = {1e-3, 0.1},
                        .accepted = Interval{0, 1e3},
                        .scale = Scale::log,
                        .effect = Effect::rebuild,
                        .used = [this] { return !hangs(); }}),
      pulse_width(*this, {.key = "pulse_width",
                          .symbol = "w",
                          .unit = "m",
                          .help = "of the pulse A exp(−((s − s₀)/w)²), which starts at s₀ = 0.35 L",
                          .initial = 0.12,
                          .useful = {0.02, 0.2},
                          .accepted = Interval{1e-6, 1e6},
                          .scale = Scale::log,
                          .effect = Effect::rebuild,
                          .used = [this] { return runs_a_pulse(); }}),
      scheme(*this,
             {.key = "scheme",
              .help = "how forces become motion",
              .initial = Real(static_cast<int>(Scheme::velocity_verlet)),
              .used = [this] { return !hangs_still(); }},
             scheme_options()),
      dt(*this, {.key = "time_step",
                 .symbol = "Δt",
                 .unit = "s",
                 .help = "fixed",
                 .initial = 2e-3,
                 .useful = {1e-4, 0.1},
                 .accepted = Interval{0, 10, true},
                 .scale = Scale::log,
                 .used = [this] { return !hangs_still(); }}),
      damping(*this, {.key = "damping",
                      .symbol = "τ",
                      .unit = "s",
                      .help = "each spring's damper is τ k, along the spring: a property of the material, whatever N is. 0: none",
                      .initial = 0,
                      .useful = {0, 0.1},
                      .accepted = Interval{0, 1e6},
                      .effect = Effect::rebuild,
                      .used = [this] { return !hangs_still(); }}) {
    declare_fields();
    declare_bounds();
    declare_stages();
    declare_probes();
    declare_wave_probes();
    explain_probes();
    declare_lines();
    declare_wave_lines();
    declare_checks();
}

// ------------------------------------------------------------------------------------------------- the rod and its chains

Real RodLesson::stiffness_of(Rule rule, Index n) const {
    return rule == Rule::constant ? Real{picked_stiffness} : axial_stiffness * static_cast<Real>(n) / length;
}

MassChain RodLesson::chain_of(Rule rule, Index n) const { return {n, stiffness_of(rule, n), total_mass / static_cast<Real>(n)}; }

RunningPulse RodLesson::pulse(Real speed) const { return {amplitude, pulse_width, 0.35 * length, length, speed, end()}; }

// ------------------------------------------------------------------------------------------------------ the start

VecX RodLesson::start_displacements() const {
    if (setting == Setting::wave) return amplitude * mode_shape();
    VecX u = VecX::Zero(count() + 1);
    if (!runs_a_pulse()) return u;
    for (Index i = 1; i <= count(); ++i) u[i] = pulse(chain_speed()).displacement(rest_place(i), 0);
    if (end() == RodEnd::fixed) u[count()] = 0;
    return u;
}

// A segment that is turned over when it starts has no strain that |∂x/∂s| could tell, and no wave runs along it.
void RodLesson::check() const {
    if (runs_a_pulse() && pulse_width > widest_pulse * length)
        throw Refused(
            fmt::format("pulse_width = {} is not accepted: give at most twice the length of the rod, {}; a wider pulse is "
                        "none",
                        format_quantity(pulse_width, "m"), format_quantity(widest_pulse * length, "m")));
    const VecX u = start_displacements();
    Index at = 0;
    const Real slope = (u.tail(count()) - u.head(count())).minCoeff(&at) / segment();
    if (slope > -1) return;
    throw Refused(
        fmt::format("amplitude = {} is not accepted: segment {} would be turned over at the start, with ∂u/∂s = {}, and "
                    "must stay above −1; give at most {}",
                    format_quantity(amplitude, "m"), at, format_quantity(slope, "", 3),
                    format_quantity(rounded_down(-0.99 * amplitude / slope, 2), "m")));
}

void RodLesson::reset() {
    integrator_.reset();
    system_.reset();
    const Index n = segments;
    springs_ = rod_springs(n, segment(), stiffness(), damped() ? damping * stiffness() : Real{0});
    node_masses_ = VecX::Constant(n + 1, node_mass());
    std::vector<Index> held{0};
    if (end() == RodEnd::fixed) held.push_back(n);
    inertia_ = DiagonalMass(node_masses_, 2, held);
    clock_.setZero();
    rhythm_.reset();
    history_.setZero(n, hangs() ? 0 : history_rows);

    position_.resize(2, n + 1);
    velocity_.setZero(2, n + 1);
    const VecX u = start_displacements();
    for (Index i = 0; i <= n; ++i) {
        position_.col(i) = (rest_place(i) + u[i]) * along();
        if (runs_a_pulse() && !inertia_.fixed(2 * i))
            velocity_.col(i) = pulse(chain_speed()).velocity(rest_place(i), 0) * along();
    }
    for (Points<2>* field : {&gradient_force_, &spring_force_}) field->setZero(2, n + 1);
    damping_force_.setZero(2, damped() ? n + 1 : 0);
    external_force_.setZero(2, loaded() ? n + 1 : 0);
    slope_.resize(2, n);
    for (VecX* values : {&strain_, &energy_density_, &segment_energy_, &stiffness_, &tension_}) values->setZero(n);
    for (VecX* values : {&added_tension_, &move_}) values->setZero(n + 1);
    slope_stage();
    if (history_.size() > 0) rod_strains(slope_, history_.col(0));
    follow_positions();
    start_energy_ = total_energy();
    start_motion_ = motion_energy();
    start_position_ = runs_a_pulse() ? pulse_position() : Real{0};
    if (hangs_still()) return;

    system_ = std::make_unique<SpringSystem<2>>(springs_, node_masses_);
    system_->damping = damped() ? SpringDamping::projected : SpringDamping::none;
    system_->load.gravity = weight_acceleration() * along();
    integrator_ = std::make_unique<TimeIntegrator>(*system_, inertia_, scheme);
}

}  // namespace pliant::rod
