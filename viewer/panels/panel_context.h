// What the panels of the lab share: the session, how the lab looks, and what they ask of it. What a panel alone remembers from
// frame to frame stands in its own header.
#pragma once
#include "panels/file_choice.h"
#include "panels/keys.h"
#include "panels/layout.h"
#include "panels/theme.h"
#include "panels/typed_number.h"
#include "session/live_error.h"
#include "session/session.h"

#include <imgui.h>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace pliant::viewer {

struct Rectangle {
    float x = 0, y = 0, width = 0, height = 0;  // px
};

// An animation that is asked for, or being made.
struct AnimationOrder {
    int seconds = 5, width = 640;    // of the file; px
    bool asking = false;             // its panel is open
    std::string path{};              // to be started
    std::optional<Real> progress{};  // 0 to 1, while it is made
    bool writing = false;            // all frames are recorded
};

// A law or an assumption: whether it holds, and what its tip says.
struct Light {
    Holds holds;
    std::string name, help;
};

struct KeyNumber {
    std::optional<Real> value, exact;
    std::string awaits{};  // the stage that has yet to compute it, in words
};

// Numbers of the run as it was when it moved last; of the last whole step while one that plays is cut by a frame, so that what is
// only of use inside a step does not flash up.
struct HeldNumbers {
    std::pair<int, long> of{-1, -1};  // which lesson that was opened, and the revision of its run
    std::vector<KeyNumber> key_numbers{};
    std::vector<Light> lights{};
};

// The words of a slide in the panel of the walkthrough: folded where what is asked and answered would not fit below them.
struct WalkthroughFold {
    std::pair<std::size_t, bool> of{static_cast<std::size_t>(-1), false};  // the slide, and whether its answer is shown
    bool closed = false, chosen = false;                                   // chosen: a person unfolded it
    int fresh = 0;                                                         // frames in which the panel finds its place
};

// The tabs at the right of the lab.
enum class SideTab { plots, inspect, claims, atlas, methods };
std::string_view name_of(SideTab tab);

struct PanelContext {
    Session session{};
    Theme theme = Theme::dark;
    float ui_scale = 1;  // of type and controls, 1 to 3, as it was chosen
    float scale = 1;     // as it is drawn: in a deck larger where the window is high
    Fonts fonts{};
    Layout layout = Layout::lab;
    Fill fill{};                                         // one panel in its place
    std::vector<std::pair<Rectangle, Fill>> fillable{};  // what could fill the screen, and where it is: of the last frame
    Real seconds = 0;                                    // of wall time since the frame before; with 0 nothing moves
    bool scene_has_grid = false;                         // of the last frame

    HeldNumbers held{};
    LiveError live_error{};
    TypedNumber typed{};
    WalkthroughFold fold{};
    std::optional<std::size_t> sketched{};  // the point of a sketch where the mouse was in the last frame

    std::string methods_over{};            // the choice whose options are to be compared; of the panel's own when empty
    SideTab side = SideTab::plots;         // that is in front
    std::optional<SideTab> side_wanted{};  // that comes to the front
    FileChoice files{};
    AnimationOrder animation{};
    std::vector<Action> wanted{};            // what the lab itself has to do, asked for by a panel: done at the end of the frame
    std::vector<SceneFile> wanted_scenes{};  // to be opened, likewise
    std::optional<Rectangle> focus{};        // the control that the keys act on, when it shows
    std::string focus_words{};               // what is said of it: in a deck, what its keys are

    // Where the controls are, by name, in px: for tests that move a real mouse, and for screen readers.
    std::map<std::string, Rectangle> controls{};
    // Those of the frame that their panel cuts off, and that cannot be scrolled to.
    std::set<std::string> cut{};
    // Remembers the last item under a name.
    void note_control(const std::string& name);

    // This part of the window that is drawn may fill the screen.
    void note_fillable(Rectangle place, const Fill& what);
    // What the mouse is over, else what has the keys, else the picture.
    Fill pointed_at() const;

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

// For people: "Plot: Energy".
std::string label_of(const Fill& fill);
// An entry of a menu: fills the screen, or goes back.
void fill_item(PanelContext& lab, const Fill& what);
// The menu of a right click on the last item; more: its other entries.
void fill_menu_of_last_item(PanelContext& lab, const Fill& what, const std::function<void()>& more = {});

// As much of the text as fits into a width in px, with an ellipsis behind it.
std::string with_ellipsis(std::string text, float width);
// Text cut with an ellipsis to a width in px; the whole text is its tooltip when it was cut.
void fitted_text(const std::string& text, float width);
// Words that stay readable over any picture, at this place of the window that is being drawn.
void haloed_text(PanelContext& lab, ImVec2 at, unsigned colour, const std::string& text);
// Before a tooltip of the last item: where the keys act on it, beside its panel, so that the next controls stay in sight.
void place_tip();
// The same for the mouse as well: a tooltip of this size, px, beside a panel at the side, or else above the item.
void place_tip_beside(const Rectangle& size);
// A tooltip for the last item, wrapped.
void tooltip(const std::string& text, float scale);
// A button on the line of the one before, or on the next where it does not fit.
bool flowing_button(PanelContext& lab, const std::string& label, const std::string& name, const std::string& help,
                    bool first = false);
// Without Markdown's marks of emphasis; the words stay.
std::string without_marks(const std::string& text);
// With a large first letter, unless the first word is a symbol of one letter.
std::string capitalised(std::string text);
// "youngs_modulus" as words.
std::string words(std::string_view key);
// "not computed yet: stage Projection does it"; "" for none.
std::string not_yet(const Stage* awaited);
// Do both have the same letters: det_F and det F?
bool says_the_same(std::string_view key, std::string_view symbol);
// The words with the symbol behind them; the symbol alone where it says the same: det F, P₁₁.
std::string name_with_symbol(std::string_view key, std::string_view symbol, std::string_view gap);

// The keys go to the item that was drawn last, and it shows.
void focus_last_item();

}  // namespace pliant::viewer
