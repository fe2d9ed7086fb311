// All methods of a lesson in one scene: each option of a choice is run for the same simulated time, and says whether it lasts,
// how wrong it is, and what it costs.
#pragma once
#include <pliant/document/scene_file.h>
#include <pliant/run/runner.h>
#include <pliant/run/time_series.h>
#include <pliant/run/until.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

struct MethodRun {
    enum class Outcome {
        steady,    // runs to the end, its energy bounded
        loses,     // runs to the end, and loses energy that the exact motion keeps
        grows,     // runs to the end, its energy growing from part to part
        finished,  // runs to the end; the lesson has no energy to tell more
        stopped,   // broke down on the way
        refused    // the scene accepts no such method
    };
    std::string option, label;  // key of the option; its name for people
    Outcome outcome = Outcome::finished;
    std::string words{};          // in a sentence: what became of it
    Index steps = 0;              // that were run
    Real time = 0;                // s
    std::optional<Real> value{};  // of the probe at the end of the run
    std::optional<Real> error{};  // of it: |value − reference| / max|reference|
    Index passes = 0;             // of all stages, counted: the work
    Real ms = 0;                  // wall time, which no two machines share
    TimeSeries curve{};           // the probe over the time, or the steps of a static lesson
    bool ran() const { return outcome != Outcome::refused; }
};

struct MethodComparison {
    std::string lesson, parameter;  // key of the choice
    std::string probe, unit;        // whose error is taken
    std::string reference;          // what errors are measured against, in words; "" where there is nothing
    std::string no_error{};         // why no run has an error, in a sentence; "" where one has
    bool is_static = false;
    Index steps = 0;                                  // of each run, where it gets so far
    std::vector<MethodRun> runs;                      // in the order of the options
    std::vector<Real> reference_at, reference_value;  // the reference over the time; empty where there is none
};

// The choice whose options are the methods of the lesson, among those that the scene uses; null where it has none.
const Parameter* method_of(const Lesson& lesson);
// All choices that the scene uses and that can be compared, that of method_of() first.
std::vector<const Parameter*> comparable_choices(const Lesson& lesson);

// Each option from the start of the scene on, as far as `until` says for the method of the scene. key: the choice; method_of()
// when empty. after_run is given what there is behind each run: its rows so far. Tells its progress in thousandths of the whole,
// and throws Cancelled. Throws Refused when there is no such choice.
using AfterRun = std::function<void(const MethodComparison&)>;
MethodComparison compare_methods(const SceneFile& scene, std::string_view key, const Until& until,
                                 const AfterRun& after_run = {});
// How long that takes, s, from the first steps of each run, which are made for it; nothing for a static lesson, whose steps tell
// nothing of the later ones. Throws as compare_methods does.
std::optional<Real> seconds_to_compare(const SceneFile& scene, std::string_view key, const Until& until);

std::string_view name_of(MethodRun::Outcome outcome);
// A table for people, a row a method; and one object with lesson, parameter, probe, reference, steps and methods[].
std::string comparison_text(const MethodComparison& comparison);
std::string comparison_json(const MethodComparison& comparison);

}  // namespace pliant
