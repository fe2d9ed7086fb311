// How the lab stands, in plain sentences: for those who listen rather than look.
#pragma once
#include "app/lab_state.h"

#include <string>

namespace pliant::viewer {

// The summary of the run, and what the person looks at: the colours of the picture, the picked thing with its numbers, the
// claim, the slide and the last message.
std::string summary_of(const LabState& lab);

}  // namespace pliant::viewer
