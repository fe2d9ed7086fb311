// The dialog for files.
#pragma once
#include "panels/panel_context.h"

namespace pliant::viewer {

struct FileDialogState {
    int question = 0;     // that it shows
    bool scroll = false;  // the list shows the name
    bool focus = false;   // the name gets the keys
};

// Shown while lab.files is asking.
void draw_file_dialog(PanelContext& lab, FileDialogState& panel);

}  // namespace pliant::viewer
