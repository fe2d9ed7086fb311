// What a person does to a run, as events: played again from the same start they give the same bits.
#pragma once
#include <pliant/lesson/lesson.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pliant {

// Something that happens at the start of a given step: recorded, it makes a played run repeatable.
struct Event {
    Index step = 0;
    std::vector<std::pair<std::string, std::string>> assign{};  // parameter key, value as text
    std::optional<Pull> pull{};
    bool release = false;
    bool operator==(const Event&) const = default;
};

// The parameters that a run began with, and the live changes and pulls since, at most one event a step.
class Recording {
public:
    // A run begins from the parameters as they are; what was recorded belongs to another run.
    void begin(const Lesson& lesson);
    // A live parameter has this value from the start of `step` on. Before anything has run it belongs to the start.
    void assign(const Parameter& parameter, Real value, Index step, bool before_start);
    // What is looked at is no part of the run: whoever opens it begins with the latest.
    void look_at(const Parameter& parameter, Real value);
    // The hand, or its release, from the start of `step` on.
    void pull(const std::optional<Pull>& pull, Index step);
    // The run has gone back to the start of this step or into it: what was done later has not happened.
    void back_to(Index step);

    // The value that the parameter had when the run began.
    Real start(const Parameter& parameter) const;
    // In the order of their steps.
    const std::vector<Event>& events() const { return events_; }

private:
    Event& event(Index step);

    std::vector<std::pair<const Parameter*, Real>> start_;
    std::vector<Event> events_;
};

}  // namespace pliant
