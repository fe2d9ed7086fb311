// What is said of a run that broke down, or of an assumption that failed: where, by how much, and what would mend it. It draws
// nothing.
#pragma once
#include <pliant/run/runner.h>

#include "session/inspector.h"

#include <optional>
#include <string>
#include <vector>

namespace pliant::viewer {

struct Autopsy {
    std::string headline;        // "Stopped in step 12: stage spring forces"
    std::string where;           // "strain of spring 413"; "" when it has no place
    std::string against;         // "11.6, at most 1 is accepted: 11.6 times the bound"; what went wrong, when there is no number
    std::string limit;           // in words: the limit that was exceeded, and what to do; "" when none is known
    std::string field{};         // whose element it is
    std::optional<Thing> thing;  // the element, when one can be picked
    std::optional<Fix> fix;
    std::vector<Fix> others{};  // that would mend it as well
    bool restarts = false;      // with a fix the run starts again; else it goes on from where it is
    const Fix& fix_at(std::size_t n) const { return n == 0 ? fix.value() : others.at(n - 1); }
    std::size_t fixes() const { return fix ? 1 + others.size() : 0; }
    // The words of the card, a line each.
    std::string text() const;
};

// Of a run whose last good state has been restored.
Autopsy autopsy_of(const Runner& runner, const Failure& failure);
// Of an assumption that fails now.
Autopsy autopsy_of(const Runner& runner, const Assumption& assumption);

// "11.6 times the bound"; by how much where a ratio says nothing: the bound is not above zero.
std::string excess(Real value, Real bound, std::string_view unit, std::string_view bound_name);

}  // namespace pliant::viewer
