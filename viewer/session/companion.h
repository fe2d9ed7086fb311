// A second run, B, beside the present one, A: the same lesson with parameters of its own, its clock tied to that of A. It draws
// nothing.
#pragma once
#include <pliant/document/scene_parts.h>
#include <pliant/run/recorder.h>
#include <pliant/run/runner.h>

#include "session/cost_history.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace pliant::viewer {

class Companion {
public:
    // At the start, with the parameters and events that A has, and these changes. Throws Refused.
    explicit Companion(const LessonEntry& entry, const Runner& a, const Runner::Assignments& changes = {});

    const Runner& runner() const { return runner_; }
    const Lesson& lesson() const { return runner_.lesson(); }
    const Recorder& recorder() const { return recorder_; }
    void watch(std::size_t probe, const std::optional<Interval>& part) { recorder_.watch(probe, part); }
    const CostHistory& costs() const { return costs_; }
    bool owns(const Parameter& parameter) const;

    // Throws Refused, and then nothing has changed.
    void assign(const Parameter& parameter, Real value);
    // At another thing, by the keys of parameters that only look.
    void look(const std::vector<std::pair<std::string, Real>>& values);
    // A script of its own in place of that of A; from the start on.
    void follow_script(std::vector<Event> events);
    // Throws Refused.
    void apply(const SceneChanges& changes);
    // The same hand as in A; ignored where the two runs have other things to pull.
    void pull(const std::optional<Pull>& pull, const Lesson& of_a);
    void restart();

    // Goes on or back in whole steps of its own until A is less than one of them ahead. A static lesson follows by the count of
    // steps. What goes wrong stops B alone.
    void follow(const Runner& a);
    // The same, one pass at a time: to be asked again until B has caught up, or it fails and gives false.
    bool follow_a_pass(const Runner& a);
    bool caught_up(const Runner& a) const;
    // By more than two runs that go side by side ever are: its numbers are those of an earlier time than A's.
    bool far_behind(const Runner& a) const;
    // Why B does not go on, in words; empty while it does.
    const std::string& stopped() const { return stopped_; }

private:
    bool ahead(const Runner& a) const;
    bool behind(const Runner& a) const;
    void go_back(const Runner& a);
    void moved();
    bool tried(const std::function<void()>& action);

    Runner runner_;
    Recorder recorder_;
    CostHistory costs_;
    std::string stopped_;
};

// Sets parameters that only look, by key: the run stays where it is, and numbers that read otherwise now are recorded anew.
void look_at(Runner& runner, Recorder& recorder, const std::vector<std::pair<std::string, Real>>& values);

// A parameter in which two runs of one lesson differ, with the values that they have or will have from the next step on.
struct Differing {
    const Parameter* parameter;
    Real a, b;
};
std::vector<Differing> differing(const Runner& a, const Runner& b);
// The values of all parameters, in their order.
std::vector<Real> settings_of(const Runner& runner);

}  // namespace pliant::viewer
