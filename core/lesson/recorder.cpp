#include <pliant/lesson/format.h>
#include <pliant/lesson/recorder.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant {
namespace {

constexpr Real gap = std::numeric_limits<Real>::quiet_NaN();

std::string column(std::string_view name, std::string_view unit) {
    return unit.empty() ? std::string(name) : fmt::format("{} [{}]", name, unit);
}
std::string cell(Real value) { return std::isfinite(value) ? format_exact(value) : ""; }

}  // namespace

void Recorder::clear() {
    steps_.clear();
    times_.clear();
    series_.clear();
}

void Recorder::record(const Runner& runner) {
    const auto& probes = runner.lesson().probes;
    series_.resize(probes.size());
    // Forget what lies at or after this step.
    const std::size_t keep = static_cast<std::size_t>(std::ranges::lower_bound(steps_, runner.place().step) - steps_.begin());
    steps_.resize(keep);
    times_.resize(keep);
    for (Series& s : series_) s.value.resize(keep), s.exact.resize(std::min(keep, s.exact.size()));

    steps_.push_back(runner.place().step);
    times_.push_back(runner.time());
    for (std::size_t i = 0; i < probes.size(); ++i) {
        series_[i].value.push_back(runner.value(probes[i]).value_or(gap));
        if (probes[i].exact) series_[i].exact.push_back(runner.exact(probes[i]).value_or(gap));
    }
}

std::string Recorder::csv(const Lesson& lesson) const {
    std::string text = "step,time [s]";
    for (const Probe& p : lesson.probes) {
        text += "," + column(p.name, p.unit);
        if (p.exact) text += "," + column(fmt::format("{} exact", p.name), p.unit);
    }
    text += "\n";
    for (std::size_t row = 0; row < steps_.size(); ++row) {
        text += fmt::format("{},{}", steps_[row], format_exact(times_[row]));
        for (std::size_t i = 0; i < series_.size(); ++i) {
            text += "," + cell(series_[i].value[row]);
            if (lesson.probes[i].exact) text += "," + cell(series_[i].exact[row]);
        }
        text += "\n";
    }
    return text;
}

}  // namespace pliant
