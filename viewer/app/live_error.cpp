#include "app/live_error.h"

#include "app/companion.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

namespace pliant::viewer {
namespace {

constexpr Real none = std::numeric_limits<Real>::quiet_NaN();
constexpr Real same_time = 1e-9;

std::vector<Real> places_of(const Recorder& r, bool is_static) {
    return is_static ? std::vector<Real>(r.steps().begin(), r.steps().end()) : r.times();
}

// The errors of values against references, relative to the largest reference up to each.
std::vector<Real> relative_errors(const std::vector<Real>& values, const std::vector<Real>& references) {
    std::vector<Real> errors(values.size(), none);
    Real largest = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Real reference = i < references.size() ? references[i] : none;
        if (std::isfinite(reference)) largest = std::max(largest, std::abs(reference));
        if (largest > 0 && i > 0) errors[i] = std::abs(values[i] - reference) / largest;
    }
    return errors;
}

Real place_of(const Runner& r) { return r.is_static() ? static_cast<Real>(r.place().step) : r.time(); }

}  // namespace

std::optional<Real> ErrorSeries::latest() const {
    const auto found = std::find_if(error.rbegin(), error.rend(), [](Real e) { return std::isfinite(e); });
    return found == error.rend() ? std::nullopt : std::optional(*found);
}

ErrorSeries error_against_exact(const Recorder& recorder, std::size_t probe, bool is_static) {
    const pliant::Series& series = recorder.series(probe);
    return {places_of(recorder, is_static), relative_errors(series.value, series.exact)};
}

ErrorSeries error_against(const Recorder& recorder, std::size_t probe, bool is_static, const std::vector<Real>& times,
                          const std::vector<Real>& values) {
    ErrorSeries series{places_of(recorder, is_static), {}};
    std::vector<Real> references(series.at.size(), none);
    for (std::size_t i = 0; i < series.at.size(); ++i) {
        const Real within = same_time * series.at.back();
        const auto found = std::ranges::lower_bound(times, series.at[i] - within);
        if (found != times.end() && *found <= series.at[i] + within)
            references[i] = values[static_cast<std::size_t>(found - times.begin())];
    }
    series.error = relative_errors(recorder.series(probe).value, references);
    return series;
}

void LiveError::look_at(const LessonEntry& entry, const Runner& runner, int run) {
    const std::vector<Real> settings = settings_of(runner);
    if (std::exchange(entry_, &entry) != &entry) trail_.clear(), now_.reset(), run_ = -1;
    if (run_ != run || (settings_ != settings && runner.place() == Place{})) {
        keep_point();
        run_ = run, settings_ = settings;
        begin(runner);
    } else if (settings_ != settings) {
        keep_point();
        settings_ = settings, mixed_ = true;
    }
    mixed_ = mixed_ || runner.pulled();
    if (mixed_) drop_reference("A slider or the hand has acted on the way: Reset (R) measures this setting alone.");
}

void LiveError::begin(const Runner& runner) {
    mixed_ = false;
    is_static_ = runner.is_static();
    const auto& probes = runner.lesson().probes;
    const auto found = std::ranges::find(probes, runner.lesson().error_probe(), &Probe::name);
    probe_ = found == probes.end() ? nullptr : &*found;
    probe_number_ = static_cast<std::size_t>(found - probes.begin());
    exact_ = finer_ = {};
    now_.reset();
    drop_reference("");
}

void LiveError::drop_reference(std::string why) {
    reference_.reset();
    reference_text_.clear(), reference_times_.clear(), reference_values_.clear();
    no_reference_ = std::move(why);
}

void LiveError::make_reference(const Runner& runner) {
    const auto finer = runner.lesson().finer();
    if (finer.empty()) return drop_reference("This lesson names no finer run to measure errors against.");
    if (!runner.events().empty()) return drop_reference("A scene with recorded events has no finer run to measure against.");
    Runner::Assignments all;
    for (const Parameter* p : runner.lesson().parameters) all.emplace_back(std::string(p->info.key), p->text(runner.wanted(*p)));
    for (const auto& [key, text] : finer) {
        all.emplace_back(key, text);
        reference_text_ += fmt::format("{}{} = {}", reference_text_.empty() ? "" : ", ", key, text);
    }
    try {
        reference_ = std::make_unique<Runner>(*entry_, all, std::size_t{0});
    } catch (const Error& e) {
        drop_reference(fmt::format("The finer run is refused: {}", e.what()));
    }
}

void LiveError::measure(const Runner& runner, const Recorder& recorder, std::optional<Real> step_ms) {
    if (!probe_ || recorder.empty()) return;
    exact_ = error_against_exact(recorder, probe_number_, is_static_);
    finer_ = reference_times_.empty() ? ErrorSeries{}
                                      : error_against(recorder, probe_number_, is_static_, reference_times_, reference_values_);
    const auto error = exact_.latest() ? exact_.latest() : finer_.latest();
    if (runner.place().step == 0 || !error || !step_ms) return;
    now_ = Reached{settings_, is_static_ ? *step_ms : *step_ms / runner.time_step(), *error};
}

void LiveError::keep_point() {
    const auto point = std::exchange(now_, std::nullopt);
    if (!point || mixed_) return;
    std::erase_if(trail_, [&](const Reached& r) { return r.settings == point->settings; });
    trail_.push_back(*point);
    if (trail_.size() > longest_trail) trail_.erase(trail_.begin());
}

void LiveError::advance_reference(const Runner& runner, Real budget_ms) {
    if (!probe_ || !no_reference_.empty()) return;
    if (!reference_) make_reference(runner);
    if (!reference_) return;
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto spent_ms = [&] { return std::chrono::duration<Real, std::milli>(Clock::now() - start).count(); };
    const auto record = [&] {
        const auto value = reference_->value(reference_->lesson().probes[probe_number_]);
        reference_times_.push_back(place_of(*reference_));
        reference_values_.push_back(value.value_or(none));
    };
    try {
        if (reference_times_.empty()) record();
        while (place_of(*reference_) < place_of(runner) * (1 - same_time) && spent_ms() < budget_ms) {
            reference_->step();
            record();
        }
    } catch (const Error& e) {
        drop_reference(fmt::format("The finer run stopped: {}", e.what()));
    }
}

}  // namespace pliant::viewer
