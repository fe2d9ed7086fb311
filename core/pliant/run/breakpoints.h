// Where a run is to stop by itself: before a stage, after each pass of its loop, when a probe crosses a limit, when an assumption
// or a conserved quantity fails.
#pragma once
#include <pliant/run/runner.h>

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

// "max_divergence > 1e-3"
struct Condition {
    std::string probe, comparison;  // <, <=, > or >=
    Real limit = 0;                 // in the unit of the probe
    bool holds(Real value) const;
    std::string text() const;
    bool operator==(const Condition&) const = default;
};
// Throws Refused, naming the nearest probe, for what is not PROBE COMPARISON NUMBER.
Condition parse_condition(std::string_view text, const Lesson& lesson);

class Breakpoints {
public:
    // --- what to stop at ---
    std::set<std::string, std::less<>> stages;  // before it runs
    std::set<std::string, std::less<>> passes;  // after each pass of its loop
    std::vector<Condition> conditions;          // when one begins to hold, at the end of a stage
    bool assumptions = false;                   // when one begins to fail, at the end of a step
    bool laws = false;                          // likewise, of the conserved quantities

    bool any() const { return !stages.empty() || !passes.empty() || !conditions.empty() || assumptions || laws; }
    void clear() { *this = {}; }

    // Looks at the run as it is now, so that what holds already does not stop it at once.
    void arm(const Runner& runner);
    // To be asked after every pass: why the run stops here, in words; empty when it does not.
    std::optional<std::string> stops(const Runner& runner);
    // Index in Lesson::assumptions of the one that made the run stop last; empty when something else did.
    const std::optional<std::size_t>& failed_assumption() const { return failed_assumption_; }

private:
    struct Watch {
        std::vector<char> conditions, assumptions, laws;  // does it hold (fail, fail) now?
    };
    Watch look(const Runner& runner, bool whole_step) const;
    std::string words_of(const Runner& runner, const Watch& now);

    Watch last_;
    std::optional<std::size_t> failed_assumption_;
};

}  // namespace pliant
