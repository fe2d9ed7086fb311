// The keys as a table for people: by what they are for.
#include "panels/keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace pliant::viewer {

std::string_view heading_of(KeyGroup group) {
    switch (group) {
        case KeyGroup::time:
            return "Time";
        case KeyGroup::inside:
            return "Inside a step";
        case KeyGroup::two_runs:
            return "Two runs";
        case KeyGroup::lessons:
            return "Lessons, claims and maps";
        case KeyGroup::lecture:
            return "Walkthrough, deck and lecture";
        case KeyGroup::screen:
            return "What is seen";
        case KeyGroup::parameters:
            return "Parameters";
        case KeyGroup::files:
            return "Scenes and files";
        case KeyGroup::keyboard:
            return "Without a mouse, and help";
        case KeyGroup::mouse:
            return "Mouse";
    }
    return "";
}

KeyGroup group_of(Action action) {
    switch (action) {
        case Action::play:
        case Action::step:
        case Action::step_back:
        case Action::stage:
        case Action::stage_back:
        case Action::pass:
        case Action::pass_back:
        case Action::stops:
        case Action::reset:
            return KeyGroup::time;
        case Action::compare:
        case Action::inspect:
        case Action::why_back:
            return KeyGroup::inside;
        case Action::pin:
        case Action::beside:
        case Action::address_a:
        case Action::address_b:
        case Action::difference:
            return KeyGroup::two_runs;
        case Action::previous_lesson:
        case Action::next_lesson:
        case Action::find:
        case Action::claims:
        case Action::atlas:
        case Action::methods:
            return KeyGroup::lessons;
        case Action::walkthrough_next:
        case Action::walkthrough_back:
        case Action::deck:
        case Action::leave_deck:
        case Action::reset_slide:
        case Action::first_slide:
        case Action::last_slide:
        case Action::unlock:
        case Action::notes:
        case Action::black_out:
        case Action::presenter:
        case Action::open_lecture:
        case Action::end_lecture:
        case Action::add_scene:
        case Action::add_slide:
        case Action::add_claim:
        case Action::add_map:
            return KeyGroup::lecture;
        case Action::hide_panels:
        case Action::fill:
        case Action::fill_back:
        case Action::full_screen:
        case Action::lens:
        case Action::arrows:
        case Action::patterns:
        case Action::theme:
        case Action::larger:
        case Action::smaller:
        case Action::frame:
        case Action::cost:
            return KeyGroup::screen;
        case Action::undo:
        case Action::extreme:
        case Action::defaults:
            return KeyGroup::parameters;
        case Action::hand_in:
        case Action::open:
        case Action::save:
        case Action::save_as:
        case Action::copy_share:
        case Action::paste_share:
        case Action::save_scene_picture:
        case Action::save_window_picture:
        case Action::save_plots:
        case Action::save_probes:
        case Action::save_animation:
        case Action::quit:
            return KeyGroup::files;
        case Action::help:
        case Action::menu:
        case Action::dismiss:
        case Action::summary:
        case Action::next_panel:
        case Action::previous_panel:
            return KeyGroup::keyboard;
    }
    return KeyGroup::keyboard;
}

std::vector<KeyRow> key_rows() {
    std::vector<KeyRow> rows;
    for (const KeyBinding& b : key_bindings()) {
        if (b.keys.empty()) continue;
        const auto same = std::ranges::find(rows, b.meaning, &KeyRow::meaning);
        if (same == rows.end())
            rows.push_back({{b.keys}, b.meaning, group_of(b.action)});
        else
            same->keys.push_back(b.keys);
    }
    rows.push_back({{"1 … 9"}, "choose an answer, while a prediction waits for one", KeyGroup::lecture});
    std::ranges::stable_sort(rows, {}, &KeyRow::group);
    constexpr KeyGroup mouse = KeyGroup::mouse;
    rows.push_back({{"left drag"}, "pull the body; beside it, turn or move the picture", mouse});
    rows.push_back({{"right drag"}, "move the picture", mouse});
    rows.push_back({{"right click"}, "on a picture or a plot: its menu; on a parameter: what if", mouse});
    rows.push_back({{"wheel"}, "zoom", mouse});
    rows.push_back({{"← and →"}, "on a slider: a step less or more; with Shift a tenth of it", mouse});
    rows.push_back({{"Alt+wheel"}, "over a slider: a step less or more; with Shift a tenth of it", mouse});
    rows.push_back({{"Shift+drag"}, "a slider, ten times as finely", mouse});
    rows.push_back({{"Ctrl+click"},
                    "type a slider's number, in the unit that is shown or with one of its own; with keys, Enter on it",
                    mouse});
    rows.push_back({{"double click"}, "a slider's default", mouse});
    return rows;
}

std::vector<KeyRow> key_rows(std::string_view search) {
    const auto lowered = [](std::string text) {
        for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        return text;
    };
    std::istringstream typed(lowered(std::string(search)));
    std::vector<std::string> wanted;
    for (std::string word; typed >> word;) wanted.push_back(word);
    std::vector<KeyRow> rows = key_rows();
    std::erase_if(rows, [&](const KeyRow& row) {
        const std::string all = lowered(fmt::format("{} {} {}", row.text(), row.meaning, heading_of(row.group)));
        return !std::ranges::all_of(wanted, [&](const std::string& w) { return all.find(w) != std::string::npos; });
    });
    return rows;
}

std::string KeyRow::text() const { return fmt::format("{}", fmt::join(keys, " or ")); }

namespace {
// Calls heading and row, in the order of the table.
void go_through_table(const auto& heading, const auto& row_of_group) {
    std::string_view last;
    for (const KeyRow& row : key_rows()) {
        if (heading_of(row.group) != last) heading(last = heading_of(row.group));
        row_of_group(row);
    }
}
}  // namespace

std::string keys_text() {
    std::string text;
    go_through_table([&](std::string_view heading) { text += fmt::format("{}{}\n", text.empty() ? "" : "\n", heading); },
                     [&](const KeyRow& row) { text += fmt::format("  {:<24}{}\n", row.text(), row.meaning); });
    return text;
}

std::string keys_markdown() {
    std::string text = R"(# Keys and mouse

A sign, such as `/` or `]`, is what a key types, with Shift or AltGr as a keyboard needs; letters are those of its language.
Where a sign is hard to reach, a function key does the same. `scripts/docs` makes this page from the table that the lab obeys
and F1 shows.

<!-- Made by `pliant keys --markdown`. -->
)";
    go_through_table([&](std::string_view heading) { text += fmt::format("\n## {}\n\n| keys | |\n|---|---|\n", heading); },
                     [&](const KeyRow& row) {
                         std::vector<std::string> keys;
                         for (const std::string_view key : row.keys) keys.push_back(fmt::format("`{}`", key));
                         text += fmt::format("| {} | {} |\n", fmt::join(keys, " or "), row.meaning);
                     });
    return text;
}

}  // namespace pliant::viewer
