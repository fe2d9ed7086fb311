#include <pliant/run/recording.h>

#include <algorithm>

namespace pliant {

void Recording::begin(const Lesson& lesson) {
    events_.clear();
    start_.clear();
    for (const Parameter* p : lesson.parameters) start_.emplace_back(p, p->value());
}

// The event of this step, made when there is none. Nothing is recorded for a step before the latest one: back_to has come first.
Event& Recording::event(Index step) {
    const auto at = std::ranges::lower_bound(events_, step, {}, &Event::step);
    if (at != events_.end() && at->step == step) return *at;
    return *events_.insert(at, Event{.step = step});
}

void Recording::look_at(const Parameter& parameter, Real value) {
    for (auto& [known, start] : start_)
        if (known == &parameter) start = value;
}

void Recording::assign(const Parameter& parameter, Real value, Index step, bool before_start) {
    if (before_start) return look_at(parameter, value);
    auto& assigned = event(step).assign;
    const auto same = std::ranges::find(assigned, parameter.info.key, [](const auto& a) { return a.first; });
    if (same != assigned.end())
        same->second = parameter.text(value);
    else
        assigned.emplace_back(parameter.info.key, parameter.text(value));
}

void Recording::pull(const std::optional<Pull>& pull, Index step) {
    Event& e = event(step);
    e.pull = pull;
    e.release = !pull;
}

void Recording::back_to(Index step) {
    std::erase_if(events_, [&](const Event& e) { return e.step > step; });
}

Real Recording::start(const Parameter& parameter) const {
    const auto found = std::ranges::find(start_, &parameter, [](const auto& s) { return s.first; });
    return found == start_.end() ? parameter.value() : found->second;
}

}  // namespace pliant
