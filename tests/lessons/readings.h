// What the tests of lessons read off a run, by name.
#pragma once
#include <pliant/run/runner.h>

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pliant::test {

// Of a probe; throws where it is not defined.
inline Real value(const Runner& runner, std::string_view probe) { return runner.value(runner.lesson().probe(probe)).value(); }
inline Real exact(const Runner& runner, std::string_view probe) { return runner.exact(runner.lesson().probe(probe)).value(); }

inline std::span<const Real> field(const Runner& runner, std::string_view name) { return runner.lesson().field(name).view(); }

// Every conserved quantity is, within its tolerance.
inline void check_laws(const Runner& runner) {
    for (std::size_t i = 0; i < runner.lesson().conserved.size(); ++i) {
        INFO(runner.lesson().conserved[i].probe << " is off by " << runner.drift(i));
        CHECK(runner.holds(i) != Holds::no);
    }
}

inline const Assumption& assumption(const Runner& runner, std::string_view name) {
    return *std::ranges::find(runner.lesson().assumptions, name, &Assumption::name);
}
// One that is not in use holds.
inline bool holds(const Assumption& a) { return !a.in_use() || a.value() <= a.limit(); }
inline bool holds(const Runner& runner, std::string_view name) { return holds(assumption(runner, name)); }

// Of the stages in use, in their order.
using Names = std::vector<std::string>;
inline Names stage_names(const Runner& runner) {
    Names names;
    for (const Stage* stage : runner.stages()) names.emplace_back(stage->name);
    return names;
}

}  // namespace pliant::test
