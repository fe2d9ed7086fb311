// The keys of the lab, in one table that feeds both the handler and the help.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pliant::viewer {

enum class Action {
    play,
    step,
    step_back,
    stage,
    stage_back,
    pass,
    pass_back,
    stops,
    compare,
    inspect,
    claims,
    atlas,
    methods,
    why_back,
    reset,
    previous_lesson,
    next_lesson,
    find,
    hide_panels,
    help,
    undo,
    extreme,
    arrows,
    theme,
    larger,
    smaller,
    walkthrough_next,
    walkthrough_back,
    deck,
    leave_deck,
    reset_slide,
    first_slide,
    last_slide,
    unlock,
    notes,
    save,
    frame,
    open,
    save_as,
    copy_share,
    paste_share,
    save_scene_picture,
    save_window_picture,
    save_plots,
    save_probes,
    save_animation,
    defaults,
    menu,
    pin,
    beside,
    address_a,
    address_b,
    difference,
    cost,
    dismiss,
    hand_in,
    summary,
    patterns,
    next_panel,
    previous_panel,
    open_lecture,
    end_lecture,
    add_scene,
    add_slide,
    add_claim,
    add_map,
    fill,
    fill_back,
    full_screen,
    black_out,
    lens,
    presenter,
    quit
};

// What a key is for: the headings of the help.
enum class KeyGroup { time, inside, two_runs, lessons, lecture, screen, parameters, files, keyboard, mouse };
std::string_view heading_of(KeyGroup group);
KeyGroup group_of(Action action);

// Where a key has its meaning; over a message, a summary or the help, and where a panel fills the screen, it has that one alone.
// The deck is the layout for a lecture, while a walkthrough plays in it.
enum class Where { everywhere, outside_deck, in_deck, on_slide, in_walkthrough, over_a_message, filled };
inline bool is_alone(Where where) { return where == Where::over_a_message || where == Where::filled; }

struct KeyBinding {
    Action action;
    int key;  // ImGuiKey; none where a character counts
    bool ctrl;
    bool repeats;                    // while the key is held
    std::string_view keys, meaning;  // no keys: in the menus only
    Where where = Where::everywhere;
    bool shift = false;
    char character = 0;  // what is typed, on whatever key of a keyboard, with Shift or AltGr as it needs
};

// What the person is in, for the keys that depend on it.
struct KeyContext {
    bool walkthrough = false, deck = false, slide = false, message = false, filled = false;
    bool ring_has_space = false;  // keys went to a control, which Space acts on
    bool window_over = false;     // a window over the lab is worked in: what is typed is not for the lab
    bool suits(Where where) const;
};

std::span<const KeyBinding> key_bindings();
const KeyBinding& binding(Action action);

// How often the key was pressed in this frame; never while a text is being typed.
int presses(const KeyBinding& binding, const KeyContext& context = {});
// A list, a menu or another popup is open: letters, digits and Space are for it, or for nothing.
bool list_is_open();

// All keys and what the mouse does, for the help and the documentation: keys with one meaning stand together, ". or F2".
struct KeyRow {
    std::vector<std::string_view> keys;
    std::string_view meaning;
    KeyGroup group;
    std::string text() const;  // of the keys
};
std::vector<KeyRow> key_rows();  // group by group
// Those in which each word of the search stands, in keys, meaning or heading; all for an empty one.
std::vector<KeyRow> key_rows(std::string_view search);
std::string keys_text();
std::string keys_markdown();  // docs/keys.md

// Calls `perform` for each press of an action's key in this frame.
void handle_keys(const KeyContext& context, const auto& perform) {
    int taken = 0;
    for (const KeyBinding& b : key_bindings()) {
        if (!context.suits(b.where) || (taken != 0 && b.key == taken)) continue;
        const int times = presses(b, context);
        if (times > 0 && is_alone(b.where)) taken = b.key;
        for (int i = 0; i < times; ++i) perform(b.action);
    }
}

}  // namespace pliant::viewer
