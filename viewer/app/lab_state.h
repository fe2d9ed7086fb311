// All that the lab remembers from frame to frame: what its panels share, and what each of them keeps.
#pragma once
#include "app/panel_borders.h"
#include "panels/atlas_panel.h"
#include "panels/claims_panel.h"
#include "panels/file_dialog.h"
#include "panels/hand_in_panel.h"
#include "panels/help_panel.h"
#include "panels/inspector_panel.h"
#include "panels/lesson_list.h"
#include "panels/methods_panel.h"
#include "panels/panel_context.h"
#include "panels/parameter_panel.h"
#include "panels/plot_panel.h"
#include "panels/presenter_panel.h"
#include "panels/scene_panel.h"
#include "panels/slide_picture.h"
#include "panels/stage_bar.h"
#include "panels/summary_panel.h"
#include "panels/timeline.h"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace pliant::viewer {

inline constexpr std::size_t most_recent = 8;

// The window of the lecturer.
struct PresenterState {
    bool wanted = false, open = false;
    PresenterView view{};  // of the last frame while it is wanted
    bool clock_paused = false;
    long frames = 0;
    std::map<std::string, Rectangle> controls{};  // px of its window
};

struct LabState : PanelContext {
    LessonListState lesson_list{};
    ParameterPanelState parameters{};
    StageBarState stages{};
    TimelineState timeline{};
    ScenePanelState scene{};
    PlotPanelState plots{};
    InspectorPanelState inspector{};
    ClaimsPanelState claims{};
    AtlasPanelState atlas{};
    MethodsPanelState methods{};
    SummaryPanelState summary{};
    HandInPanelState hand_in{};
    FileDialogState file_dialog{};
    SlidePictureState slide_pictures{};

    PanelSizes sizes{};
    float border_grip = 0;  // where the border that is dragged was taken, px from its middle
    bool help_shown = false, notes_shown = false;
    HelpPanelState help{};
    PresenterState presenter{};
    bool black = false;                               // the screen, until a key or a button is pressed
    bool lens_shown = false;                          // around the pointer
    bool full_screen = false;                         // the window
    bool focus_menu = false;                          // the menus get the keys
    std::vector<std::string> wanted_files{};          // scene files to open, asked for in a menu
    std::string wanted_lecture{};                     // to open, asked for in a menu; "" for none
    std::vector<std::string> recent{};                // scene files, the latest first
    std::string file{};                               // that the scene came from or was saved in
    std::string lecture_file{};                       // that slides are added to; "" until it is chosen
    std::function<void(const std::string&)> speak{};  // who else takes the summary (standard output)
    bool resting = false;                             // nothing is drawn until something changes
};

void draw_menu_bar(LabState& lab);
// Plots, inspector, claims and atlas, one behind the other.
void draw_side(LabState& lab);

}  // namespace pliant::viewer
