#include <pliant/study/stability_verdict.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pliant {
namespace {

constexpr std::size_t part_count = 4;
constexpr Real least_rise = 1e-3;       // of the scale
constexpr Real rounding = 1e-8;         // of the scale, with the tolerance of a solver
constexpr Real least_of_swing = 0.5;    // of the swing within a part
constexpr Real doubtless_rise = 3;      // of the scale
constexpr Real noticeable_loss = 0.05;  // of the exact energy
constexpr Real least_exact = 0.01;      // of the scale: what is left when a damped motion has died out tells nothing
constexpr Real explosion = 1e12;

std::string percent(Real part) { return fmt::format("{:.3g} %", 100 * part); }

}  // namespace

std::string_view name_of(Stability kind) {
    constexpr std::array<std::string_view, stability_kinds> names{"stable", "dissipative", "diverged", "not_converged",
                                                                  "refused"};
    return names[static_cast<std::size_t>(kind)];
}

// Of each part the largest and smallest excess.
struct StabilityWatch::Parts {
    std::array<Real, part_count> high{}, low{};
    Real scale = 0, floor = 0;
    Real apart = 1;  // steps between the largest values of the first part and of the last

    Real rise() const { return high.back() - high.front(); }
    bool rises() const {
        return std::ranges::adjacent_find(high, std::greater_equal{}) == high.end() && rise() > rounding * scale;
    }
    bool beyond_its_swing() const {
        Real swing = std::numeric_limits<Real>::infinity();
        for (std::size_t k = 0; k < part_count; ++k) swing = std::min(swing, high[k] - low[k]);
        return rise() >= least_of_swing * swing;
    }
    std::optional<Real> growth() const {
        if (!(high.front() > floor)) return std::nullopt;
        return std::pow((high.back() - floor) / (high.front() - floor), 1 / (2 * apart));
    }
};

void StabilityWatch::clear() {
    excess_.clear();
    energy_.clear();
    exact_.clear();
}

void StabilityWatch::add(std::optional<Real> energy, std::optional<Real> exact) {
    if (!energy) return;
    if (excess_.empty() && exact) start_exact_ = *exact;
    if (exact && exact_.size() == excess_.size()) exact_.push_back(*exact);
    energy_.push_back(*energy);
    excess_.push_back(*energy - (exact ? std::max(Real{0}, *exact - start_exact_) : Real{0}));
}

bool StabilityWatch::exploded() const {
    return !excess_.empty() && excess_.back() - excess_.front() > explosion * std::abs(excess_.front()) && excess_.front() != 0;
}

StabilityWatch::Parts StabilityWatch::parts() const {
    Parts p;
    const std::size_t n = excess_.size();
    const auto largest = [](const std::vector<Real>& v, std::size_t a, std::size_t b) {
        return std::max_element(v.begin() + static_cast<Index>(a), v.begin() + static_cast<Index>(b));
    };
    std::array<Index, part_count> reached{};  // the step of the largest excess
    for (std::size_t k = 0; k < part_count; ++k) {
        const std::size_t a = n * k / part_count, b = n * (k + 1) / part_count;
        const auto high = largest(excess_, a, b);
        p.high[k] = *high, reached[k] = high - excess_.begin();
        p.low[k] = *std::min_element(excess_.begin() + static_cast<Index>(a), excess_.begin() + static_cast<Index>(b));
    }
    p.scale = std::max(std::abs(p.high[0]), std::abs(p.low[0]));
    p.floor = std::min(Real{0}, *std::ranges::min_element(excess_));
    p.apart = static_cast<Real>(reached.back() - reached.front());
    return p;
}

std::size_t StabilityWatch::live_samples(const Parts& p) const {
    if (exact_.size() != samples()) return samples();
    const auto dead = std::ranges::find_if(exact_, [&](Real x) { return x - p.floor <= least_exact * p.scale; });
    return static_cast<std::size_t>(dead - exact_.begin());
}

Real StabilityWatch::average_kept(const Parts& p) const {
    Real energy = 0, expected = 0;
    for (std::size_t n = 0; n < live_samples(p); ++n) energy += energy_[n] - p.floor, expected += reference(n) - p.floor;
    return expected > 0 ? energy / expected : 1;
}

bool StabilityWatch::loses(const Parts& p) const {
    if (average_kept(p) >= 1 - noticeable_loss) return false;
    if (live_samples(p) < samples()) return true;
    for (std::size_t n = samples() - samples() / part_count; n < samples(); ++n)
        if (energy_[n] - p.floor >= (1 - noticeable_loss) * (reference(n) - p.floor)) return false;
    return true;
}

std::string StabilityWatch::kept(const Parts& p) const {
    return fmt::format("has on average {} of the energy {} in {} steps", percent(average_kept(p)),
                       exact_.size() == samples() ? "of the exact solution" : "of the start", live_samples(p) - 1);
}

StabilityVerdict StabilityWatch::verdict(bool came_round, bool last) const {
    if (exploded())
        return {.kind = Stability::diverged,
                .growth = overall_growth(),
                .reason = fmt::format("the energy grew by a factor of more than 10¹² in {} steps", samples() - 1)};
    if (samples() < part_count) return {.reason = "ran to its end; no energy to watch"};
    const Parts p = parts();
    StabilityVerdict v{.growth = p.growth()};
    const bool rises = p.rises(), enough = p.rise() > least_rise * p.scale && p.beyond_its_swing(),
               doubtless = p.rise() > doubtless_rise * p.scale;
    if (rises && enough && (came_round || doubtless || last)) {
        v.kind = Stability::diverged;
        v.reason = fmt::format("the energy grows from part to part of {} steps, by {:.3g} times what it had", samples() - 1,
                               p.rise() / p.scale);
        return v;
    }
    // Before it has come round, a motion may gain in one half of its turn more than it loses in the other.
    const bool gains = !came_round && p.rise() > least_rise * p.scale;
    v.settled = last || !(rises || gains);
    v.kind = loses(p) ? Stability::dissipative : Stability::stable;
    v.reason = v.kind == Stability::dissipative ? kept(p) : fmt::format("the energy stays bounded in {} steps", samples() - 1);
    return v;
}

std::optional<Real> StabilityWatch::overall_growth() const {
    if (excess_.size() < 2) return std::nullopt;
    const Real floor = std::min(Real{0}, *std::ranges::min_element(excess_)), from = excess_.front() - floor;
    if (!(from > 0)) return std::nullopt;
    return std::pow((excess_.back() - floor) / from, 1 / (2 * static_cast<Real>(excess_.size() - 1)));
}

void TurnMeter::clear(std::size_t arrays) {
    tracks_.resize(arrays);
    for (Track& t : tracks_) t.begun = false, t.turned = t.change_squared = 0;
}

void TurnMeter::add(std::size_t array, std::span<const Real> now) {
    Track& t = tracks_[array];
    if (!t.begun || t.last.size() != now.size()) {
        t.last.assign(now.begin(), now.end());
        t.change.assign(now.size(), 0);
        t.begun = true, t.change_squared = 0;
        return;
    }
    Real along = 0, squared = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
        const Real change = now[i] - t.last[i];
        along += change * t.change[i];
        squared += change * change;
        t.change[i] = change, t.last[i] = now[i];
    }
    const Real lengths = std::sqrt(squared * t.change_squared);
    if (lengths > 0 && std::isfinite(lengths)) t.turned += std::acos(std::clamp(along / lengths, Real{-1}, Real{1}));
    t.change_squared = squared;
}

Real TurnMeter::turned() const {
    Real most = 0;
    for (const Track& t : tracks_) most = std::max(most, t.turned);
    return most;
}

}  // namespace pliant
