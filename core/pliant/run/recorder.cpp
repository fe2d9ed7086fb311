#include <pliant/run/recorder.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

namespace pliant {
namespace {

std::string csv_reading(std::optional<Real> value) { return csv_cell(value.value_or(TimeSeries::undefined)); }

}  // namespace

void Recorder::clear() {
    series_.clear();
    last_.reset();
}

void Recorder::record(const Runner& runner) {
    const auto& probes = runner.lesson().probes;
    for (std::size_t i = series_.size(); i < probes.size(); ++i) series_.emplace_back(static_cast<bool>(probes[i].exact));
    is_static_ = runner.is_static();
    last_ = runner.place().step;
    const Real at = is_static_ ? static_cast<Real>(*last_) : runner.time();
    for (std::size_t i = 0; i < probes.size(); ++i)
        series_[i].add(*last_, at, runner.value(probes[i]).value_or(TimeSeries::undefined),
                       runner.exact(probes[i]).value_or(TimeSeries::undefined));
}

Recorder::Readings Recorder::readings(const Runner& runner) {
    Readings all;
    for (const Probe& p : runner.lesson().probes) all.push_back(runner.value(p)), all.push_back(runner.exact(p));
    return all;
}

void Recorder::look_again(const Runner& runner, const Readings& before) {
    const Readings now = readings(runner);
    for (std::size_t i = 0; i < series_.size(); ++i)
        if (now[2 * i] != before[2 * i] || now[2 * i + 1] != before[2 * i + 1]) series_[i].clear();
    if (last_ == runner.place().step && !runner.inside_step()) record(runner);
}

void Recorder::watch(std::size_t probe, const std::optional<Interval>& part) {
    if (probe < series_.size()) series_[probe].watch(part);
}

std::size_t Recorder::bytes() const {
    std::size_t sum = 0;
    for (const TimeSeries& s : series_) sum += s.bytes();
    return sum;
}

std::size_t Recorder::cap() const {
    std::size_t sum = 0;
    for (const TimeSeries& s : series_) sum += s.cap();
    return sum;
}

std::string csv_header(const Lesson& lesson) {
    std::string text = "step,time [s]";
    for (const Probe& p : lesson.probes) {
        text += "," + csv_column(p.name, p.unit);
        if (p.exact) text += "," + csv_column(fmt::format("{} exact", p.name), p.unit);
    }
    return text + "\n";
}

std::string csv_row(const Runner& runner) {
    std::string text = fmt::format("{},{}", runner.place().step, format_exact(runner.time()));
    for (const Probe& p : runner.lesson().probes) {
        text += "," + csv_reading(runner.value(p));
        if (p.exact) text += "," + csv_reading(runner.exact(p));
    }
    return text + "\n";
}

std::string Recorder::csv(const Lesson& lesson) const {
    std::vector<const TimeSeries*> all;
    for (const TimeSeries& s : series_) all.push_back(&s);
    return csv_header(lesson) + csv_rows(all, !is_static_);
}

}  // namespace pliant
