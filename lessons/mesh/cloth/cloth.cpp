#include "cloth.h"
#include "time/schemes/scheme_options.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace pliant::cloth {
namespace {

// Height of a sheet above the sphere at the start, in sides of the sheet.
constexpr Real gap = 0.02;
// Amplitude of the wave in a flag at the start, in sides of the sheet.
constexpr Real start_wave = 0.01;

ParameterInfo stiffness_of(std::string_view key, std::string_view symbol, std::string_view help, Real initial) {
    return {.key = key,
            .symbol = symbol,
            .unit = "N/m",
            .help = help,
            .initial = initial,
            .useful = {0.01, 1e4},
            .accepted = Interval{0, 1e15},
            .scale = Scale::log};
}

}  // namespace

ClothLesson::ClothLesson()
    : setting(*this, {.key = "scene", .help = "what happens to the sheet", .initial = 0, .effect = Effect::rebuild},
              {{"hanging_corners", "held at two corners"},
               {"hanging_edge", "held at one edge"},
               {"drape", "falls on a sphere"},
               {"flag", "a flag in the wind"},
               {"pedestal", "drape test: its middle lies on a disc"}}),
      nodes(*this, {.key = "nodes",
                    .symbol = "n",
                    .help = "nodes along each side of the sheet",
                    .initial = 25,
                    .useful = {2, 64},
                    .accepted = Interval{2, 96},
                    .effect = Effect::rebuild}),
      size(*this, {.key = "size",
                   .symbol = "L",
                   .unit = "m",
                   .help = "side of the square sheet",
                   .initial = 1,
                   .useful = {0.1, 5},
                   .accepted = Interval{1e-6, 1e6},
                   .scale = Scale::log,
                   .effect = Effect::rebuild}),
      total_mass(*this, {.key = "mass",
                         .symbol = "M",
                         .unit = "kg",
                         .help = "of the whole sheet, shared equally by its nodes; a square metre of cotton weighs 0.2 kg",
                         .initial = 0.2,
                         .useful = {0.01, 10},
                         .accepted = Interval{1e-9, 1e9},
                         .scale = Scale::log}),
      k_structural(*this, stiffness_of("k_structural", "kₛ", "of the springs along the threads: they resist stretching", 1000)),
      k_shear(*this, stiffness_of("k_shear", "k_d", "of the springs along the diagonals: they resist shear", 100)),
      k_bending(*this, stiffness_of("k_bending", "k_b", "of the springs to the next node but one: they resist bending", 1)),
      damping_mode(*this, {.key = "damping_mode", .help = "which relative velocity of a spring's ends is damped", .initial = 2},
                   {{"none", "none"}, {"naive", "naive: k_d (vⱼ − vᵢ)"}, {"projected", "projected: along the spring"}}),
      damping(*this, {.key = "damping",
                      .symbol = "kᵈ",
                      .unit = "N s/m",
                      .help = "of every spring whose stiffness is not 0",
                      .initial = 0.01,
                      .useful = {1e-4, 1},
                      .accepted = Interval{0, 1e12},
                      .scale = Scale::log,
                      .used = [this] { return damped(); }}),
      gravity(*this, {.key = "gravity",
                      .symbol = "g",
                      .unit = "m/s²",
                      .help = "acceleration of gravity, downwards",
                      .initial = 9.81,
                      .useful = {0, 20},
                      .accepted = Interval{0, 1e6}}),
      wind(*this, {.key = "wind",
                   .symbol = "W",
                   .unit = "m/s",
                   .help = "speed of the wind: along x for the flag, else towards you",
                   .initial = 0,
                   .useful = {0, 20},
                   .accepted = Interval{-1e6, 1e6},
                   .used = [this] { return in_air(); }}),
      gust(*this, {.key = "gust",
                   .symbol = "γ",
                   .help = "how far the wind swings to its side, once in a second, as a part of its speed",
                   .initial = 0.3,
                   .useful = {0, 1},
                   .accepted = Interval{0, 10},
                   .used = [this] { return in_air() && wind != 0; }}),
      air_drag(*this, {.key = "air_drag",
                       .symbol = "c",
                       .help = "drag coefficient of a small plate across the wind, also of still air; 0: no air",
                       .initial = 1,
                       .useful = {0, 2},
                       .accepted = Interval{0, 1e6}}),
      sphere_radius(*this, {.key = "sphere_radius",
                            .symbol = "R",
                            .unit = "m",
                            .help = "of the sphere, or of the disc of the drape test",
                            .initial = 0.25,
                            .useful = {0, 1},
                            .accepted = Interval{0, 1e6},
                            .effect = Effect::rebuild,
                            .used = [this] { return drapes(); }}),
      friction(*this, {.key = "friction",
                       .symbol = "μ",
                       .help = "Coulomb's coefficient of the sphere",
                       .initial = 0.3,
                       .useful = {0, 1.5},
                       .accepted = Interval{0, 1e6},
                       .used = [this] { return has_sphere(); }}),
      scheme(*this, {.key = "scheme", .help = "how forces become motion", .initial = 2}, scheme_options(3)),
      dt(*this, {.key = "time_step",
                 .symbol = "Δt",
                 .unit = "s",
                 .help = "fixed",
                 .initial = 1.0 / 60,
                 .useful = {1e-5, 0.1},
                 .accepted = Interval{0, 10, true},
                 .scale = Scale::log}),
      newton(*this, {.key = "newton", .help = "how far a step is solved", .used = [this] { return implicit(); }},
             {{"capped", "newton_cap iterations, taken as they are"}, {"full", "until it converges, or stop and report"}}),
      newton_cap(*this,
                 {.key = "newton_cap",
                  .help = "most Newton iterations of a time step; what they leave unbalanced is shown; 1: linearly implicit",
                  .initial = 1,
                  .useful = {1, 50},
                  .accepted = Interval{1, 10000},
                  .used = [this] { return implicit() && capped(); }}),
      newton_tolerance(*this, {.key = "newton_tolerance",
                               .symbol = "τ",
                               .help = "Newton's method has converged when its step is shorter than this fraction of a spring",
                               .initial = 1e-4,
                               .useful = {1e-12, 1e-2},
                               .accepted = Interval{1e-14, 1, false, true},
                               .scale = Scale::log,
                               .used = [this] { return implicit() && (!capped() || newton_cap > 1); }}),
      linear_solver(*this,
                    {.key = "linear_solver",
                     .help = "how each Newton iteration solves its linear system",
                     .initial = 1,
                     .used = [this] { return implicit(); }},
                    {{"direct", "direct: sparse factors"}, {"conjugate_gradients", "conjugate gradients, coarser sheets help"}}),
      linear_iterations(*this, {.key = "linear_iterations",
                                .help = "most iterations of conjugate gradients in a Newton iteration: bounds the cost of a step",
                                .initial = 20,
                                .useful = {1, 200},
                                .accepted = Interval{1, 100000},
                                .used = [this] { return iterative() && capped(); }}),
      linear_tolerance(*this, {.key = "linear_tolerance",
                               .symbol = "η",
                               .help = "conjugate gradients stop when their residual is below this part of the right side",
                               .initial = 1e-4,
                               .useful = {1e-10, 0.1},
                               .accepted = Interval{1e-15, 1, false, true},
                               .scale = Scale::log,
                               .used = [this] { return iterative(); }}),
      strain_limiting(*this, {.key = "strain_limiting", .help = "draw overlong springs together after each step?", .initial = 0}),
      strain_limit(*this, {.key = "strain_limit",
                           .symbol = "ε_max",
                           .help = "largest strain that structural and shear springs keep",
                           .initial = 0.05,
                           .useful = {0, 0.3},
                           .accepted = Interval{0, 10},
                           .used = [this] { return bool(strain_limiting); }}),
      limit_passes(*this, {.key = "limit_passes",
                           .help = "most passes over all springs in a step; each pass undoes a part of its neighbours'",
                           .initial = 50,
                           .useful = {1, 200},
                           .accepted = Interval{1, 10000},
                           .used = [this] { return bool(strain_limiting); }}),
      pull_stiffness(*this, {.key = "pull_stiffness",
                             .symbol = "kₕ",
                             .unit = "N/m",
                             .help = "of the spring of length 0 from a node to the pointer that pulls it",
                             .initial = 20,
                             .useful = {1, 1000},
                             .accepted = Interval{0, 1e12},
                             .scale = Scale::log}) {
    declare_fields();
    declare_stages();
    declare_probes();
    explain_probes();
    declare_checks();
}

void ClothLesson::check() const {
    const Index count = nodes * nodes;
    if (implicit() && !iterative() && count > most_direct_nodes)
        throw Refused(
            fmt::format("linear_solver = direct with nodes = {} is not accepted: {} nodes make a matrix that takes too long "
                        "to factorise in every step; give at most {} nodes along a side, or conjugate_gradients",
                        Index(nodes), count, Index(std::sqrt(Real(most_direct_nodes)))));
}

// ------------------------------------------------------------------------------------------------------ the start

std::vector<Index> ClothLesson::held_nodes() const {
    const Index n = nodes;
    std::vector<Index> held;
    for (Index k = 0; k < n * n; ++k) {
        const Index i = k % n, j = k / n;
        const bool at_edge = j == n - 1;
        const bool hold = setting == Setting::hanging_corners ? at_edge && (i == 0 || i == n - 1)
                          : setting == Setting::hanging_edge  ? at_edge
                          : setting == Setting::flag          ? i == 0
                          : setting == Setting::pedestal      ? sheet_->rest().col(k).norm() <= sphere_radius
                                                              : false;
        if (hold) held.push_back(k);
    }
    return held;
}

// A flag stands upright at a pole, with a small wave in it so that it can fall out of its plane; all other sheets start level,
// and those that hang swing down about the line that is held.
Points<3> ClothLesson::start_positions() const {
    Points<3> x = sheet_->rest();
    if (setting == Setting::flag) {
        for (Index n = 0; n < x.cols(); ++n)
            x(2, n) = start_wave * size * std::sin(2 * std::numbers::pi * (x(0, n) / size + 0.5));
        return x;
    }
    x.row(2) = -x.row(1);
    x.row(1).setZero();
    return x;
}

Sphere ClothLesson::sphere() const {
    return {.centre = {0, -sphere_radius - gap * size, 0}, .radius = sphere_radius, .friction = friction};
}

Vec<3> ClothLesson::wind_at(Real t) const {
    const Real across = wind * gust * std::sin(2 * std::numbers::pi * t);
    return setting == Setting::flag ? Vec<3>(wind, 0, across) : Vec<3>(across, 0, wind);
}

void ClothLesson::reset() {
    integrator_.reset();
    system_.reset();
    limiter_.reset();
    rates_key_.reset();
    sheet_ = std::make_unique<ClothSheet>(nodes, size);
    const Index count = sheet_->rest().cols();
    for (Points<3>* values : {&position_, &velocity_, &spring_force_}) values->setZero(3, count);
    follow_parameters();
    position_ = start_positions();
    for (Points<3>* force : {&damping_force_, &external_force_, &wind_force_}) force->setZero();
    contact_force_.setZero(setting == Setting::drape ? count : 0);
    strain_.setZero(sheet_->springs().size());
    for (VecX* values : {&stretch_, &bending_, &held_, &imbalance_}) values->setZero(count);
    std::ranges::fill(drag_numbers_, Real{0});
    gust_time_[0] = gust_at_ = pace_[0] = pace_[1] = 0;
    touches_.assign(static_cast<std::size_t>(count), {});
    touching_ = 0;
    stretch_before_limiting_ = limiter_excess_ = 0;
}

const Registration<ClothLesson> registration{{.id = "mesh/cloth",
                                              .title = "Cloth",
                                              .summary = "A sheet of masses and springs hangs, flies as a flag or drapes over a "
                                                         "sphere, at sixty steps a second.",
                                              .demo_steps = 240}};

}  // namespace pliant::cloth
