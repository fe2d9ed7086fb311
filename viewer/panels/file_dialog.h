// The dialog in which a file is chosen: a list of a folder, a name to type, and all of it by keys too: arrows choose, Enter
// takes, Escape leaves.
#pragma once
#include "panels/file_choice.h"

namespace pliant::viewer {

struct LabState;

// Shown while lab.files is asking.
void draw_file_dialog(LabState& lab);

}  // namespace pliant::viewer
