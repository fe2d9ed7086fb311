#include "session/live_error.h"

#include <pliant/lesson/setting_words.h>

#include "session/companion.h"

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

// The error of a sample, relative to the largest reference up to it.
Real relative_error(Real value, Real reference, Real largest) {
    return largest > 0 ? std::abs(value - reference) / largest : none;
}

bool is_before(Real a, Real b, Real within) { return a < b - within; }

Real place_of(const Runner& r) { return r.is_static() ? static_cast<Real>(r.place().step) : r.time(); }

}  // namespace

std::optional<Real> ErrorSeries::latest() const {
    const auto found = std::find_if(error.rbegin(), error.rend(), [](Real e) { return std::isfinite(e); });
    return found == error.rend() ? std::nullopt : std::optional(*found);
}

ErrorSeries error_against_exact(const TimeSeries& run) {
    ErrorSeries e{run.at(), std::vector<Real>(run.size(), none)};
    for (std::size_t i = 1; i < run.exact().size(); ++i)
        e.error[i] = relative_error(run.values()[i], run.exact()[i], run.scale()[i]);
    return e;
}

ErrorSeries error_against(const TimeSeries& run, const References& references) {
    ErrorSeries e{run.at(), std::vector<Real>(run.size(), none)};
    const Real within = run.empty() ? 0 : same_time * run.at().back();
    Real largest = 0;
    auto r = references.begin();
    for (std::size_t i = 0; i < run.size(); ++i) {
        while (r != references.end() && is_before(r->at, run.at()[i], within)) ++r;
        if (r == references.end()) break;
        if (is_before(run.at()[i], r->at, within) || !std::isfinite(r->value)) continue;
        largest = std::max(largest, std::abs(r->value));
        if (i > 0) e.error[i] = relative_error(run.values()[i], r->value, largest);
    }
    return e;
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
    reference_text_.clear(), references_.clear();
    no_reference_ = std::move(why);
}

void LiveError::make_reference(const Runner& runner) {
    const auto finer = runner.lesson().finer();
    if (finer.empty()) return drop_reference("This lesson names no finer run to measure errors against.");
    if (!runner.events().empty()) return drop_reference("A scene with recorded events has no finer run to measure against.");
    Runner::Assignments all;
    for (const Parameter* p : runner.lesson().parameters) all.emplace_back(std::string(p->info.key), p->text(runner.wanted(*p)));
    all.insert(all.end(), finer.begin(), finer.end());
    try {
        reference_ = std::make_unique<Runner>(*entry_, all, std::size_t{0});
        reference_text_ = settings_words(runner.lesson(), finer);
    } catch (const Error& e) {
        drop_reference(fmt::format("The finer run is refused: {}", e.what()));
    }
}

void LiveError::measure(const Runner& runner, const Recorder& recorder, std::optional<Real> step_ms) {
    if (!probe_ || recorder.empty()) return;
    exact_ = error_against_exact(recorder.series(probe_number_));
    finer_ = references_.empty() ? ErrorSeries{} : error_against(recorder.series(probe_number_), references_);
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

// Only where the run has a sample, so that the references take no more memory than it does.
void LiveError::record_reference(const TimeSeries& run) {
    const Real at = place_of(*reference_), within = run.empty() ? 0 : same_time * run.at().back();
    const auto sample = std::ranges::lower_bound(run.at(), at - within);
    if (sample == run.at().end() || *sample > at + within) return;
    if (references_.size() == most_references) thin_references(run);
    references_.push_back({at, reference_->value(reference_->lesson().probes[probe_number_]).value_or(none)});
}

// Without those whose sample has been thinned out.
void LiveError::thin_references(const TimeSeries& run) {
    const Real within = run.empty() ? 0 : same_time * run.at().back();
    std::erase_if(references_, [&](const Reference& r) {
        const auto sample = std::ranges::lower_bound(run.at(), r.at - within);
        return sample == run.at().end() || *sample > r.at + within;
    });
}

bool LiveError::catching_up(const Runner& runner) const {
    if (!probe_ || !no_reference_.empty()) return false;
    return !reference_ || place_of(*reference_) < place_of(runner) * (1 - same_time);
}

void LiveError::advance_reference(const Runner& runner, const Recorder& recorder, Real budget_ms) {
    if (!probe_ || !no_reference_.empty() || recorder.empty()) return;
    if (!reference_) make_reference(runner);
    if (!reference_) return;
    const TimeSeries& run = recorder.series(probe_number_);
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto spent_ms = [&] { return std::chrono::duration<Real, std::milli>(Clock::now() - start).count(); };
    try {
        if (reference_->place() == Place{} && references_.empty()) record_reference(run);
        while (catching_up(runner) && spent_ms() < budget_ms) {
            reference_->step_pass();
            if (!reference_->inside_step()) record_reference(run);
        }
    } catch (const Error& e) {
        drop_reference(fmt::format("The finer run stopped: {}", e.what()));
    }
}

}  // namespace pliant::viewer
