// What the panels of the lab share from frame to frame.
#pragma once
#include "panels/file_choice.h"
#include "panels/keys.h"
#include "panels/layout.h"
#include "panels/plot_panel.h"
#include "panels/theme.h"
#include "panels/typed_number.h"
#include "render/picking.h"
#include "render/scene_renderer.h"
#include "session/atlas.h"
#include "session/claim_book.h"
#include "session/live_error.h"
#include "session/session.h"
#include "session/usage.h"

#include <imgui.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pliant::viewer {

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

// The type of the words in a picture.
struct LabelType {
    int run = -1;
    Layout layout = Layout::lab;
    float width = 0, height = 0, scale = 0;  // of the picture, px; of the lab
    std::size_t smaller = 0;                 // sizes below the largest
    bool same_picture(const LabelType& o) const {
        return run == o.run && layout == o.layout && width == o.width && height == o.height && scale == o.scale;
    }
};

// The strip above a picture that its notes stand in.
struct NotesStrip {
    int run = -1;
    Layout layout = Layout::lab;
    float width = 0, room = 0, scale = 0;  // of one picture and of the panel's height, px; of the lab
    bool small = false;                    // their type
    float height = 0;                      // the greatest that was asked for, px
    bool same_place(const NotesStrip& o) const {
        return run == o.run && layout == o.layout && width == o.width && room == o.room && scale == o.scale;
    }
};

// A law or an assumption: whether it holds, and what its tip says.
struct Light {
    Holds holds;
    std::string name, help;
};

// Numbers of the run as it was when it moved last; of the last whole step while one that plays is cut by a frame, so that what is
// only of use inside a step does not flash up.
struct HeldNumbers {
    std::pair<int, long> of{-1, -1};  // which lesson that was opened, and the revision of its run
    std::vector<std::pair<std::optional<Real>, std::optional<Real>>> key_numbers{};  // and their exact values
    std::vector<Light> lights{};
};

struct LabState {
    Session session;
    Theme theme = Theme::dark;
    float scale = 1;  // UI scale, 1 to 3
    Fonts fonts;
    Layout layout = Layout::lab;
    bool help_shown = false, hints_shown = true, notes_shown = false;

    std::string search;
    std::string listed{};  // the lesson that the list has scrolled to
    bool focus_search = false;
    PlotPanelState plots;
    bool cost_shown = false;  // cost and error in the place of the plots
    LiveError live_error{};

    HeldNumbers held{};
    UsageReasons usage{};
    bool value_changed = false;  // in the present drag of a slider: one step of undo
    TypedNumber typed{};

    // the scene panel
    std::optional<Picked> hovered;
    std::optional<Pull> pulling;
    Real seconds = 0;                            // of wall time since the frame before; with 0 nothing moves
    bool turning = false, clicked_only = false;  // has the pointer stayed where it was pressed?
    LabelType label_type{};
    NotesStrip notes_strip{};
    int transport_rows = 1;                            // of the last frame
    bool stages_scroll = false;                        // likewise
    std::optional<std::size_t> stage_in_sight{};       // to which the stages have scrolled
    bool scene_has_grid = false;                       // of the last frame
    std::unique_ptr<SceneRenderer> renderer_beside{};  // of run B, or of before

    // the inspector
    bool show_inspector = false, choose_inspector = false, focus_thing = false, open_breaks = false;
    std::string condition_text{};
    std::string condition_refused{};  // why the text above is none

    // the claims
    ClaimBook claims{};
    bool show_claims = false, choose_claims = false;
    bool reveal_claim = false, focus_claim = false;  // the unfolded card is scrolled to; the keys go to it

    // the atlas
    Atlas atlas{};
    bool show_atlas = false, choose_atlas = false, focus_atlas = false;
    std::optional<std::pair<Index, Index>> atlas_cell{};  // under the pointer

    // For those who do not see the picture: the summary, while it is shown, and who else takes it (standard output).
    std::string summary{};
    std::function<void(const std::string&)> speak{};
    std::optional<Rectangle> focus{};   // the control that the keys act on, when it shows
    std::optional<int> focused_card{};  // the run and step whose autopsy has had the focus

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

    bool resting = false;  // nothing is drawn until something changes

    // Where the controls are, by name, in px: for tests that move a real mouse, and for screen readers.
    std::map<std::string, Rectangle> controls;
    // Remembers the last item under a name.
    void note_control(const std::string& name);

    // Does what a text that was typed asks for; a refusal becomes a message.
    void take_typed(const std::function<void()>& action);

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

// As much of the text as fits into a width in px, with an ellipsis behind it.
std::string with_ellipsis(std::string text, float width);
// Text cut with an ellipsis to a width in px; the whole text is its tooltip when it was cut.
void fitted_text(const std::string& text, float width);
// Words that stay readable over any picture, at this place of the window that is being drawn.
void haloed_text(LabState& lab, ImVec2 at, unsigned colour, const std::string& text);
// A tooltip for the last item, wrapped.
void tooltip(const std::string& text, float scale);
// A button on the line of the one before, or on the next where it does not fit.
bool flowing_button(LabState& lab, const std::string& label, const std::string& name, const std::string& help,
                    bool first = false);
// Without Markdown's marks of emphasis; the words stay.
std::string without_marks(const std::string& text);
// With a large first letter, unless the first word is a symbol of one letter.
std::string capitalised(std::string text);
// "youngs_modulus" as words.
std::string words(std::string_view key);
// The words with the symbol behind them; the symbol alone where it says the same: det F, P₁₁.
std::string name_with_symbol(std::string_view key, std::string_view symbol, std::string_view gap);

inline constexpr float stage_height = 74, least_stage_width = 104, most_stage_width = 320, stage_scrollbar = 9;  // px at scale 1

// Measures key numbers and lights anew, if the run has moved.
void measure_held_numbers(LabState& lab);
void draw_menu_bar(LabState& lab);
void draw_animation_panel(LabState& lab);
void draw_lesson_list(LabState& lab);
void draw_parameters(LabState& lab);
// One control. Large ones are for the deck.
void draw_parameter(LabState& lab, const Parameter& parameter, bool large = false);
void draw_transport(LabState& lab);
void draw_stage_bar(LabState& lab);
void draw_scene(LabState& lab, SceneRenderer& renderer);
void draw_timeline(LabState& lab);
// Plots, inspector, claims and atlas, one behind the other.
void draw_side(LabState& lab);
void draw_inspector(LabState& lab);
void draw_claims(LabState& lab);
void draw_atlas(LabState& lab);
// Begins a map of the chosen knobs; a refusal becomes a message.
void start_atlas(LabState& lab);
void draw_plots(LabState& lab);  // below each other
void draw_plots_in_row(LabState& lab);
void draw_status_line(LabState& lab);
void draw_walkthrough(LabState& lab);
// The deck: the title with the number of the slide; its words; the parameters that it allows; the lecturer's notes. The heights
// are those that suit, px; the parameters have none when the slide allows none.
void draw_slide_title(LabState& lab);
void draw_slide_words(LabState& lab);
void draw_slide_parameters(LabState& lab);
void draw_slide_notes(LabState& lab);
float slide_parameters_height(const LabState& lab);
// In which size of type the words fit into a room, 0 for the largest.
std::size_t slide_words_type(const LabState& lab, ImVec2 room);
float slide_notes_height(const LabState& lab, float width);
void draw_help(LabState& lab);
// Over the picture, at most a third of it: why the run stopped, and what to do.
void draw_autopsy(LabState& lab, const Rectangle& picture);
// How things stand, in sentences.
void draw_summary(LabState& lab);
// A thick ring around the control that the keys act on.
void draw_focus(LabState& lab);
// The keys go to the item that was drawn last, and it shows.
void focus_last_item();
// The keys go to the next panel, or the one before.
void focus_panel(int direction);
void draw_headline(LabState& lab);
void draw_key_numbers(LabState& lab);

}  // namespace pliant::viewer
