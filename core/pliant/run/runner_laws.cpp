// What a run measures, and whether its conserved quantities hold.
#include <pliant/run/runner.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant {

namespace {
// Of the terms of a sum, after many steps with a rounding in each.
constexpr Real rounding_of_sums = 1e-11;
}  // namespace

Real Runner::time() const { return base_time_ + static_cast<Real>(step_ - base_step_) * base_dt_; }

namespace {
std::optional<Real> finite(std::optional<Real> value, const Probe& probe, Index step, Real time) {
    if (value && !std::isfinite(*value))
        throw Diverged({.stage = {},
                        .field = std::string(probe.name),
                        .index = -1,
                        .step = step,
                        .time = time,
                        .what = "the probe is not finite",
                        .limit = {}});
    return value;
}
}  // namespace

std::optional<Real> Runner::value(const Probe& probe) const { return finite(probe.value(), probe, step_, time()); }

Real Runner::value(std::string_view name) const {
    if (const auto now = value(lesson_->probe(name))) return *now;
    throw Refused(fmt::format("the probe '{}' has no value now", name));
}

std::optional<Real> Runner::exact(const Probe& probe) const {
    return probe.exact ? finite(probe.exact(time()), probe, step_, time()) : std::nullopt;
}

void Runner::check_probes() const {
    for (const Probe& probe : lesson_->probes) value(probe), exact(probe);
}

std::optional<LawStart> Runner::start_of(const Conserved& c) const {
    const std::optional<Real> value = lesson_->probe(c.probe).value();
    return value ? std::optional(LawStart{*value, c.tolerance()}) : std::nullopt;
}

void Runner::renew_laws() {
    law_starts_.assign(lesson_->conserved.size(), std::nullopt);
    update_laws();
}

void Runner::update_laws() {
    for (std::size_t i = 0; i < law_starts_.size(); ++i) {
        const Conserved& c = lesson_->conserved[i];
        if (c.expected && !c.expected())
            law_starts_[i].reset();
        else if (!law_starts_[i])
            law_starts_[i] = start_of(c);
    }
}

Real Runner::drift(std::size_t i) const {
    const Conserved& c = lesson_->conserved[i];
    const std::optional<Real> now = lesson_->probe(c.probe).value();
    if (!now || !law_starts_[i]) return 0;
    if (!std::isfinite(*now)) return std::numeric_limits<Real>::infinity();
    const Real start = law_starts_[i]->value;
    switch (c.law) {
        case Law::constant:
            return std::abs(*now - start);
        case Law::never_grows:
            return std::max(Real{0}, *now - start);
        case Law::zero:
            return std::abs(*now);
    }
    return 0;
}

Real Runner::tolerance(std::size_t i) const {
    const Conserved& c = lesson_->conserved[i];
    const bool since_the_start = c.law != Law::zero && law_starts_[i];
    return (since_the_start ? law_starts_[i]->tolerance : c.tolerance()) + (c.cancels ? rounding_of_sums * c.cancels() : 0);
}

std::vector<std::size_t> Runner::shown_laws() const {
    const auto& laws = lesson_->conserved;
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < laws.size(); ++i) {
        const auto of_same_probe = [&](std::size_t j) { return laws[j].probe == laws[i].probe; };
        const auto rival = std::ranges::find_if(shown, of_same_probe);
        if (rival == shown.end())
            shown.push_back(i);
        else if (holds(*rival) == Holds::not_expected && holds(i) != Holds::not_expected)
            *rival = i;
    }
    return shown;
}

Holds Runner::holds(std::size_t i) const {
    const Conserved& c = lesson_->conserved[i];
    if (!law_starts_[i] || (c.expected && !c.expected())) return Holds::not_expected;
    return drift(i) <= tolerance(i) ? Holds::yes : Holds::no;
}

}  // namespace pliant
