// The picture: what moves, above it its path in the plane of x and v/ω; beside it where the step stands in the plane of λΔt.
#include "integration.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::integration {
namespace {

constexpr std::size_t longest_trail = 400, dotted = 60;  // steps

// The next of 1, 1.5, 2, 3, 5, 7, 10, …
Real rounded_up(Real x) {
    const Real decade = std::pow(10, std::floor(std::log10(x)));
    for (const Real step : {1., 1.5, 2., 3., 5., 7.})
        if (x <= step * decade * (1 + 1e-12)) return step * decade;
    return 10 * decade;
}

bool in_frame(const Position& p) { return std::abs(p[0]) <= 1 && std::abs(p[1]) <= 1; }

// Without the pieces that leave the portrait, or come back on the other side of a turn.
void keep_inside(LineMarks& path) {
    std::vector<Position> kept;
    for (std::size_t k = 0; k + 1 < path.ends.size(); k += 2) {
        const Position &a = path.ends[k], &b = path.ends[k + 1];
        if (in_frame(a) && in_frame(b) && std::abs(a[0] - b[0]) < 1) kept.insert(kept.end(), {a, b});
    }
    path.ends = std::move(kept);
}

// One period of the exact motion up to now, and what is still to come of the first one.
void draw_exact_path(const IntegrationLesson& l, Scene& scene) {
    constexpr int pieces = 180;
    if (!l.motion_->exact(l.watched(), 0)) return;
    const Real span = 2.2 * std::numbers::pi / l.rate(), from = std::max(Real{0}, l.time() - span);
    LineMarks path{.ends = {}, .ink = Ink::rest, .width = 2};
    for (int k = 0; k < pieces; ++k)
        for (const int end : {k, k + 1}) {
            if (k / 3 % 2 == 1) continue;  // dashes
            path.ends.push_back(l.in_portrait(*l.motion_->exact(l.watched(), from + span * end / pieces)));
        }
    keep_inside(path);
    scene.lines.push_back(std::move(path));
}

// Inside a step: where its pass has come to, the next force's place or Newton's iterate.
void draw_trial(const IntegrationLesson& l, Scene& scene) {
    if (!l.inside(l.predicted)) return;
    const Position from = l.in_portrait({l.x_[l.watched()], l.v_[l.watched()]}),
                   to = l.in_portrait({l.trial_x_[l.watched()], l.trial_v_[l.watched()]});
    if (!in_frame(to)) return;
    scene.line(from, to, Ink::text, 2);
    scene.points.push_back({.at = {to}, .ink = Ink::text, .radius = 5});
    LabelMark name{.at = to, .text = "X, V"};
    name.away_from = position(0, 0);
    scene.labels.push_back(std::move(name));
}

// Nothing any more in a run that is longer than paths are kept.
void draw_path(const IntegrationLesson& l, Scene& scene, Scheme one) {
    if (l.counts_[0] > static_cast<Real>(SchemePaths::longest)) return;
    const SchemePath& path = l.path_of(one);
    const std::size_t steps = std::min(path.motion.size(), static_cast<std::size_t>(l.counts_[0]) + 1);
    const auto [ink, dashed] = ink_of(one);
    const bool mine = one == l.scheme;
    LineMarks trail{.ends = {}, .ink = ink, .width = mine ? 3.0f : 1.5f};
    PointMarks dots{.at = {}, .ink = ink, .radius = mine ? 3.0f : 2.0f};

    const std::size_t first = steps > longest_trail ? steps - longest_trail : 0;
    for (std::size_t n = first; n < steps; ++n) {
        const Position here = l.in_portrait(path.motion[n]);
        if (!in_frame(here)) continue;
        if (steps - n <= dotted) dots.at.push_back(here);
        if (n + 1 >= steps || (dashed && n % 2 == 1)) continue;
        trail.ends.insert(trail.ends.end(), {here, l.in_portrait(path.motion[n + 1])});
    }
    keep_inside(trail);
    scene.lines.push_back(std::move(trail));
    scene.points.push_back(std::move(dots));
}

void draw_portrait(const IntegrationLesson& l, Scene& scene) {
    scene.box(position(-1, -1), position(1, 1), Ink::rest, 1);
    scene.line(position(-1, 0), position(1, 0), Ink::rest, 1);
    scene.line(position(0, -1), position(0, 1), Ink::rest, 1);
    const std::string reach = format_quantity(l.portrait_reach(), "m", 3);
    scene.label(position(1, 0), "x", Ink::text, 10, 0);
    scene.label(position(0, 1), "v/ω", Ink::text, 20, 10);
    scene.label(position(1, -1), reach, Ink::text, -4, 11);
    scene.label(position(-1, -1), "−" + reach, Ink::text, 4, 11);
    draw_exact_path(l, scene);
    for (const Scheme one : l.companions()) draw_path(l, scene, one);
    draw_path(l, scene, l.scheme);
    const Position now = l.in_portrait({l.x_[l.watched()], l.v_[l.watched()]});
    if (const auto exact = l.motion_->exact(l.watched(), l.time()))
        scene.points.push_back({.at = {l.in_portrait(*exact)}, .ink = Ink::rest, .radius = 5});
    scene.points.push_back({.at = {now}, .ink = Ink::accent, .radius = 6});
    draw_trial(l, scene);
    scene.points.push_back({.at = {l.in_portrait({l.x0, l.v0})},
                            .ink = Ink::text,
                            .radius = 4,
                            .pick = {.pickable = true, .on = On::handle, .first = start_handle}});
}

void draw_legend(const IntegrationLesson& l, Scene& scene) {
    std::vector<Scheme> shown{l.scheme};
    const std::vector<Scheme> beside = l.companions();
    shown.insert(shown.end(), beside.begin(), beside.end());
    std::ranges::sort(shown);
    const std::size_t per_column = shown.size() > 4 ? (shown.size() + 1) / 2 : shown.size();
    for (std::size_t k = 0; k < shown.size(); ++k) {
        const Real x = k < per_column ? -1 : region_x - 1, y = -1.35 - 0.18 * static_cast<Real>(k % per_column);
        const auto [ink, dashed] = ink_of(shown[k]);
        scene.line(position(x, y), position(x + 0.2, y), ink, shown[k] == l.scheme ? 4.0f : 2.0f, dashed);
        const Real growth = amplification(shown[k], l.motion_->fast_rate(), l.zeta, l.dt);
        LabelMark words{.at = position(x + 0.23, y),
                        .text = fmt::format("{}  ρ = {}", info_of(shown[k]).name, format_quantity(growth, "", 4)),
                        .ink = shown[k] == l.scheme ? Ink::accent : Ink::text};
        words.away_from = position(x, y);
        scene.labels.push_back(std::move(words));
    }
}

void write_notes(const IntegrationLesson& l, Scene& scene) {
    const Real w = l.motion_->fast_rate() * l.dt, limit = l.stable_time_step();
    const auto number = [](Real x, const char* unit = "") { return format_quantity(x, unit, 3); };
    const std::string bound = !std::isfinite(limit) ? "no limit"
                              : limit == 0          ? "stable at no Δt"
                              : l.dt <= limit       ? fmt::format("limit Δt = {}", number(limit, "s"))
                                                    : fmt::format("beyond the limit Δt = {}", number(limit, "s"));
    scene.notes.push_back(fmt::format("{}:  ωΔt = {},  {}", info_of(l.scheme).name, number(w), bound));
    const auto measured = l.measured_growth();
    const std::string found = measured ? format_quantity(*measured, "", 5) : "–";
    if (l.is(SwingingKind::stiff_pair))
        scene.notes.push_back(fmt::format("a step multiplies the stiff mode by ρ = {}, the soft one by {}",
                                          number(l.growth_per_step()),
                                          format_quantity(amplification(l.scheme, l.motion_->slow_rate(), l.zeta, l.dt), "", 5)));
    else
        scene.notes.push_back(fmt::format("a step multiplies by ρ = {} by theory{},  measured {}",
                                          format_quantity(l.growth_per_step(), "", 5),
                                          l.is(SwingingKind::pendulum) ? " of small swings" : "", found));
    if (const auto frequency = l.theoretical_frequency(); frequency && l.zeta < 1) {
        const Real exact = l.omega * std::sqrt((1 - l.zeta) * (1 + l.zeta));
        scene.notes.push_back(fmt::format("swings at ω′ = {}, the motion at {}:  {:+.2f} %", number(*frequency, "rad/s"),
                                          number(exact, "rad/s"), 100 * (*frequency / exact - 1)));
    }
}

}  // namespace

InkOf ink_of(Scheme scheme) {
    switch (scheme) {
        case Scheme::explicit_euler:
            return {Ink::force, false};
        case Scheme::semi_implicit_euler:
            return {Ink::velocity, false};
        case Scheme::implicit_euler:
            return {Ink::fixed, false};
        case Scheme::velocity_verlet:
            return {Ink::body, false};
        case Scheme::runge_kutta_4:
            return {Ink::text, false};
        case Scheme::implicit_midpoint:
            return {Ink::velocity, true};
        case Scheme::newmark:
            return {Ink::body, true};
        default:
            return {Ink::fixed, true};
    }
}

void IntegrationLesson::draw(Scene& scene) const {
    draw_motion(scene);
    draw_portrait(*this, scene);
    draw_region(scene);
    draw_legend(*this, scene);
    write_notes(*this, scene);
    scene.frame(position(-1.3, companions().empty() ? -1.7 : -2.05), position(region_x + 1.15, turns() ? 2.5 : 2));
}

// So that the motion fills a good half of it, in round numbers; wider when a run grows. A pendulum that comes near the top, or
// goes over it, has the whole turn.
Real IntegrationLesson::portrait_reach() const {
    if (turns()) return 1.05 * std::numbers::pi * motion_->length();
    const Real size = std::max(std::abs(x_[watched()]), std::abs(v_[watched()]) / rate());
    const Real far = std::max(1.25 * motion_->scale(), 1.05 * size);
    return std::isfinite(far) ? rounded_up(far) : motion_->scale();
}

bool IntegrationLesson::turns() const {
    return is(SwingingKind::pendulum) && omega > 0 && motion_->scale() > 1.9 * motion_->length();
}

Position IntegrationLesson::in_portrait(const Motion& at) const {
    const Real reach = portrait_reach(), turn = 2 * std::numbers::pi * motion_->length();
    const Real x = turns() ? std::remainder(at.x, turn) : at.x;
    return position(x / reach, at.v / (rate() * reach));
}

// ----------------------------------------------------------------------------------------------------- the phase portrait

// ------------------------------------------------------------------------------------------------------------ the words

}  // namespace pliant::integration
