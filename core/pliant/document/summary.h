// How a run stands, in plain sentences: for those who listen rather than look, and for a terminal.
#pragma once
#include <pliant/run/runner.h>
#include <pliant/text/spoken.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

// One sentence a line: lesson, step and time, the stage that ran last and the next one, the key numbers with their units and
// exact values, which assumptions and laws hold or fail and by how much, and what ended the run. hidden: of the name of a probe,
// of "theory" or of "lights", which must not be told.
std::string summary_text(const Runner& runner, const std::function<bool(std::string_view)>& hidden = {});

// The numbers that matter: what the lesson names; else the probes with an exact value, or the first one.
std::vector<const Probe*> key_probes(const Lesson& lesson);

}  // namespace pliant
