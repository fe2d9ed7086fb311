// Numbers that no stage has computed yet: at the start of a run they stand at 0, which is no result.
#pragma once
#include <pliant/run/runner.h>

namespace pliant {

// The stage that will compute the field in this run, the first one; null when one has, and for what the start has already: the
// state, and whatever is not 0 there.
const Stage* awaited_stage(const Runner& runner, const Field& field);
// The same of a probe: that it is measured by a stage, or follows from a field that waits.
const Stage* awaited_stage(const Runner& runner, const Probe& probe);

}  // namespace pliant
