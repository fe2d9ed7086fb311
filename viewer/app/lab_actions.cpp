// What the keys and the menus do.
#include "app/lab.h"
#include "app/lecture_slide.h"
#include "app/summary.h"
#include "panels/focus.h"

#include <utility>

namespace pliant::viewer {

namespace {
bool asks_for_choice(const Session& s) {
    if (!s.walkthrough) return false;
    const auto& p = s.walkthrough->prediction();
    return p && p->kind == Prediction::Kind::choice && !s.walkthrough->revealed();
}
}  // namespace

// In a deck, for a show of hands, and beside the panel of a walkthrough the digits choose an answer.
bool Lab::digits_choose() const { return (in_deck() || state_.layout == Layout::lab) && asks_for_choice(state_.session); }

void Lab::take_show_of_hands() {
    Session& s = state_.session;
    const ImGuiIO& io = ImGui::GetIO();
    if (!digits_choose() || io.WantTextInput || io.KeyCtrl || io.KeyAlt || list_is_open() || state_.hand_in.has_keys) return;
    for (std::size_t k = 0; k < s.walkthrough->prediction()->options.size(); ++k)
        if (ImGui::IsKeyPressed(static_cast<ImGuiKey>(ImGuiKey_1 + static_cast<int>(k)), false)) s.predict({.option = k});
}

void Lab::perform(Action action) {
    if (digits_choose() && (action == Action::beside || action == Action::difference)) return;
    if (in_deck() && perform_on_deck(action)) return;
    if (!perform_on_run(action) && !perform_on_walkthrough(action) && !perform_on_lecture(action) && !perform_on_view(action))
        perform_on_files(action);
}

// True when the deck has done with it. What plays or turns it takes the keys back from any control.
bool Lab::perform_on_deck(Action action) {
    Session& s = state_.session;
    switch (action) {
        case Action::play:
        case Action::walkthrough_next:
        case Action::walkthrough_back:
        case Action::reset_slide:
        case Action::first_slide:
        case Action::last_slide:
            return deck_keys_.let_go(), false;
        case Action::leave_deck:
            return deck_keys_.let_go();
        case Action::previous_lesson:
        case Action::next_lesson:
            s.say(Session::Message::Kind::info,
                  "The deck stays with its lesson. Escape goes to the lab, where [ and ] open other lessons.");
            return true;
        default:
            return false;
    }
}

// True when the action was one of these.
bool Lab::perform_on_run(Action action) {
    Session& s = state_.session;
    switch (action) {
        case Action::play:
            return s.toggle_play(), true;
        case Action::step:
            return s.step(), true;
        case Action::step_back:
            return s.step_back(), true;
        case Action::stage:
            return s.step_stage(), true;
        case Action::stage_back:
            return s.stage_back(), true;
        case Action::pass:
            return s.step_pass(), true;
        case Action::pass_back:
            return s.pass_back(), true;
        case Action::why_back:
            if (s.inspector.asked.size() > 1) s.ask_back();
            return true;
        case Action::pin:
            return s.toggle_pin(), true;
        case Action::beside:
            return s.toggle_companion(), true;
        case Action::address_a:
        case Action::address_b:
            return s.address(action == Action::address_b), true;
        case Action::difference:
            return s.show_difference(!s.shows_difference()), true;
        case Action::reset:
            return s.reset(), true;
        case Action::previous_lesson:
            return s.open_next(-1), true;
        case Action::next_lesson:
            return s.open_next(1), true;
        case Action::undo:
            return s.undo(), true;
        case Action::defaults:
            return s.restore_defaults(), true;
        default:
            return false;
    }
}

bool Lab::perform_on_walkthrough(Action action) {
    Session& s = state_.session;
    switch (action) {
        case Action::black_out:
            return state_.black = true, true;
        case Action::presenter:
            state_.presenter.wanted = !state_.presenter.wanted;
            return true;
        case Action::walkthrough_next:
            if (show_more_of_slide(state_)) return true;
            // What fills the screen stays while the slide stays.
            if (!s.walkthrough || s.walkthrough->revealed()) state_.fill = {};
            return s.walkthrough ? s.walkthrough_next() : s.start_walkthrough(), true;
        case Action::walkthrough_back:
            if (s.walkthrough && !s.walkthrough->revealed()) state_.fill = {};
            return s.walkthrough_back(), true;
        case Action::deck:
            return in_deck() ? show_lab() : open_deck(), true;
        case Action::leave_deck:
            return show_lab(), true;
        case Action::reset_slide:
            return s.reset_slide(), true;
        case Action::first_slide:
            state_.fill = {};
            return s.go_to_slide(0), true;
        case Action::last_slide:
            state_.fill = {};
            return s.go_to_slide(s.slide_count() - 1), true;
        case Action::unlock:
            return s.toggle_lock(), true;
        case Action::notes:
            // Else they would come up before the audience when the window of the lecturer closes.
            if (!state_.presenter.wanted) state_.notes_shown = !state_.notes_shown;
            return true;
        default:
            return false;
    }
}

void Lab::show_lab() {
    state_.fill = {};
    set_layout(Layout::lab);
}

// One press: the table comes to the front and is being made.
void Lab::compare_all_methods() {
    MethodTable& table = state_.methods.table;
    table.follow(state_.session);
    if (!state_.methods_over.empty()) table.over = std::exchange(state_.methods_over, "");
    state_.side_wanted = SideTab::methods, state_.methods.focus = true;
    // What takes long is told first, and begun by its button, which has the keys.
    if (!table.over.empty() && !table.busy() && !table.work(state_.session).long_one()) table.start(state_.session, true);
}

bool Lab::perform_on_view(Action action) {
    Session& s = state_.session;
    switch (action) {
        case Action::fill:
            return state_.fill = state_.fill ? Fill{} : state_.pointed_at(), true;
        case Action::fill_back:
            return state_.fill = {}, true;
        case Action::full_screen:
            return context_.set_full_screen(!context_.full_screen()), true;
        case Action::quit:
            return context_.request_close(), true;
        case Action::lens:
            state_.lens_shown = !state_.lens_shown;
            return true;
        case Action::find:
            return show_lab(), state_.lesson_list.focus = true;
        case Action::hide_panels:
            state_.fill = {};
            return set_layout(state_.layout == Layout::lab ? Layout::slide : Layout::lab), true;
        case Action::menu:
            return show_lab(), state_.focus_menu = true;
        case Action::stops:
            return show_lab(), state_.timeline.open_breaks = true;
        case Action::compare:
            return s.compare(static_cast<Compare>((static_cast<int>(s.inspector.compare) + 1) % 5)), true;
        case Action::inspect:
            return show_lab(), state_.side_wanted = SideTab::inspect, state_.inspector.focus = true;
        case Action::claims:
            return show_lab(), state_.side_wanted = SideTab::claims, state_.claims.reveal = state_.claims.focus = true;
        case Action::atlas:
            return show_lab(), state_.side_wanted = SideTab::atlas, state_.atlas.focus = true;
        case Action::methods:
            return show_lab(), compare_all_methods(), true;
        case Action::help:
            state_.help_shown = !state_.help_shown;
            return true;
        case Action::extreme:
            s.extreme = !s.extreme;
            return true;
        case Action::arrows:
            s.show_arrows = !s.show_arrows;
            return true;
        case Action::theme:
            return set_theme(state_.theme == Theme::dark ? Theme::projector : Theme::dark), true;
        case Action::larger:
            return set_scale(state_.scale + 0.25f), true;
        case Action::smaller:
            return set_scale(state_.scale - 0.25f), true;
        case Action::cost:
            state_.plots.cost_shown = !state_.plots.cost_shown;
            return true;
        case Action::frame:
            return s.frame_afresh(), true;
        default:
            return perform_for_ear_and_hand(action);
    }
}

// What helps without a mouse, and without seeing the picture or its colours.
bool Lab::perform_for_ear_and_hand(Action action) {
    switch (action) {
        case Action::dismiss:
            if (state_.help_shown) return state_.help_shown = false, true;
            if (state_.hand_in.shown) return state_.hand_in.shown = false, true;
            state_.summary.text.empty() ? state_.session.dismiss() : state_.summary.text.clear();
            return true;
        case Action::hand_in:
            state_.hand_in.shown = !state_.hand_in.shown;
            return true;
        case Action::summary:
            state_.summary.text = state_.summary.text.empty() ? summary_of(state_) : "";
            if (!state_.summary.text.empty() && state_.speak) state_.speak(state_.summary.text);
            return true;
        case Action::patterns:
            state_.session.patterns = !state_.session.patterns;
            return true;
        case Action::next_panel:
        case Action::previous_panel:
            return focus_panel(action == Action::next_panel ? 1 : -1), true;
        default:
            return false;
    }
}

}  // namespace pliant::viewer
