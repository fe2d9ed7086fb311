// Numbers that no stage has computed yet: at the start of a run they stand at 0, which is no result.
#pragma once
#include <pliant/run/runner.h>

#include <string>
#include <vector>

namespace pliant {

// The stage that will compute the field in this run, the first one; null when one has, and for what the start has already: the
// state, and whatever is not 0 there.
const Stage* awaited_stage(const Runner& runner, const Field& field);
// The same of a probe: that it is measured by a stage, or follows from a field that waits.
const Stage* awaited_stage(const Runner& runner, const Probe& probe);

// The fields of the run that wait for a stage, by name.
std::vector<std::string> awaited_fields(const Runner& runner);

}  // namespace pliant
