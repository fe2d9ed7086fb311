// What the panels of the lab share from frame to frame.
#pragma once
#include "app/keys.h"
#include "app/session.h"
#include "app/theme.h"
#include "panels/file_choice.h"
#include "panels/plot_panel.h"
#include "render/picking.h"
#include "render/scene_renderer.h"

#include <imgui.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pliant::viewer {

// lab: all panels. slide: the picture, its plots and the numbers that matter, large.
enum class Layout { lab, slide };

struct Rectangle {
    float x = 0, y = 0, width = 0, height = 0;  // px
};

inline constexpr std::size_t most_recent = 8;

// An animation that is asked for, or being made.
struct AnimationOrder {
    int seconds = 5, width = 640;    // of the file; px
    bool asking = false;             // its panel is open
    std::string path{};              // to be started
    std::optional<Real> progress{};  // 0 to 1, while it is made
    bool writing = false;            // all frames are recorded
};

struct LabState {
    Session session;
    Theme theme = Theme::dark;
    float scale = 1;  // UI scale, 1 to 3
    Fonts fonts;
    Layout layout = Layout::lab;
    bool help_shown = false, hints_shown = true;

    std::string search;
    bool focus_search = false;
    PlotPanelState plots;

    bool value_changed = false;  // in the present drag of a slider, or while a number is typed: one step of undo

    // the scene panel
    std::optional<Picked> hovered;
    std::optional<Pull> pulling;
    bool turning = false;

    // What the lab itself has to do, asked for by a panel: done at the end of the frame.
    std::vector<Action> wanted{};
    std::vector<std::string> wanted_files{};  // scene files to open

    FileChoice files{};
    int file_question = 0;              // that the dialog shows
    bool file_scroll = false;           // the list shows the name
    bool file_focus = false;            // the name gets the keys
    std::vector<std::string> recent{};  // scene files, the latest first
    std::string file{};                 // that the scene came from or was saved in
    bool focus_menu = false;            // the menus get the keys
    AnimationOrder animation{};

    // Where the controls are, by name, in px: for tests that move a real mouse, and for screen readers.
    std::map<std::string, Rectangle> controls;
    // Remembers the last item under a name.
    void note_control(const std::string& name);

    float px(float length) const { return length * scale; }
    unsigned ink(Ink role, float opacity = 1) const { return viewer::ink(theme, role, opacity); }
};

// A window without a frame of its own at a fixed place.
class FixedPanel {
public:
    FixedPanel(const char* name, const Rectangle& place, int extra_flags = 0);
    ~FixedPanel();
    FixedPanel(const FixedPanel&) = delete;
    FixedPanel& operator=(const FixedPanel&) = delete;
};

// Text cut with an ellipsis to a width in px; the whole text is its tooltip when it was cut.
void fitted_text(const std::string& text, float width);
// A tooltip for the last item, wrapped.
void tooltip(const std::string& text, float scale);
// "youngs_modulus" as words.
std::string words(std::string_view key);

inline constexpr float stage_height = 60;  // px at scale 1

void draw_menu_bar(LabState& lab);
void draw_animation_panel(LabState& lab);
void draw_lesson_list(LabState& lab);
void draw_parameters(LabState& lab);
void draw_transport(LabState& lab);
void draw_stage_bar(LabState& lab);
void draw_scene(LabState& lab, SceneRenderer& renderer);
void draw_plots(LabState& lab);
void draw_status_line(LabState& lab);
void draw_walkthrough(LabState& lab);
void draw_help(LabState& lab);
void draw_headline(LabState& lab);
void draw_key_numbers(LabState& lab);

}  // namespace pliant::viewer
