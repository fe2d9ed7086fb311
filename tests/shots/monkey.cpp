#include "monkey.h"

#include "app/state_report.h"
#include "app/summary.h"
#include "platform/gl.h"
#include "platform/headless_context.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pliant::test {
namespace {

using namespace viewer;

// Of the run, that a frame may make: in a window so many milliseconds are the limit, which no test may depend on.
constexpr Index passes_of_a_frame = 20;

constexpr int width = 800, height = 560;

void send_key(ImGuiKey key, bool ctrl, bool shift) {
    ImGuiIO& io = ImGui::GetIO();
    if (ctrl) io.AddKeyEvent(ImGuiMod_Ctrl, true);
    if (shift) io.AddKeyEvent(ImGuiMod_Shift, true);
    io.AddKeyEvent(key, true);
    io.AddKeyEvent(key, false);
    if (shift) io.AddKeyEvent(ImGuiMod_Shift, false);
    if (ctrl) io.AddKeyEvent(ImGuiMod_Ctrl, false);
}

// A word of its own: "inf", not "infinite".
bool has_word(std::string_view text, std::string_view word) {
    const auto letter = [&](std::size_t i) { return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i])); };
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1))
        if (!(at > 0 && letter(at - 1)) && !letter(at + word.size())) return true;
    return false;
}

std::string not_a_number_in(const std::string& text, std::string_view where) {
    for (const std::string_view word : {"nan", "NaN", "inf"})
        if (has_word(text, word)) return fmt::format("'{}' in {}:\n{}", word, where, text);
    return "";
}

// A mesh or a grid beyond its useful size is slow by right; everything else goes to its extremes.
bool sizes_the_scene(const Parameter& p) {
    return p.info.effect == Effect::rebuild && (p.info.kind == Kind::whole || p.info.kind == Kind::number);
}

}  // namespace

Monkey::Monkey(std::string_view lesson, unsigned seed) : seed_(seed), random_(seed), context_(open_headless({width, height})) {
    fs::current_path(scratch_.folder());
    lab_ = std::make_unique<Lab>(*context_, lesson);
    lab_->keep_pace({.budget = Budget::of_passes(passes_of_a_frame)});
    frame();
}

Monkey::~Monkey() {
    fs::current_path(before_);
    lab_.reset();
}

void Monkey::note(std::string what) {
    inputs_.push_back(fmt::format("{}: {}", count_, std::move(what)));
    if (inputs_.size() > remembered) inputs_.pop_front();
}

std::string Monkey::report(const std::string& wrong) const {
    return fmt::format("{}\nseed {}, the latest inputs:\n  {}", wrong, seed_, fmt::join(inputs_, "\n  "));
}

std::string Monkey::play() {
    ++count_;
    try {
        act();
    } catch (const std::exception& e) {
        return fmt::format("it threw: {}", e.what());
    }
    if (std::string wrong = frame(); !wrong.empty()) return wrong;
    return look();
}

void Monkey::act() {
    if (lab_->state().files.asking() || lab_->state().animation.asking) return leave_dialogs();
    const int what = upto(100);
    if (what < 30) return press_key();
    if (what < 45) return move_mouse();
    if (what < 65) return press_mouse();
    if (what < 70) return turn_wheel();
    if (what < 75) return type_text();
    if (what < 82) return type_a_number();
    if (what < 88) return take_extreme();
    if (what < 92) return change_place();
    if (what < 96) return ask_why();
    if (what < 98) return set_stops();
    note("nothing");
}

void Monkey::leave_dialogs() {
    note("the dialog is left");
    lab_->state().files.cancel();
    lab_->state().animation.asking = false;
    send_key(ImGuiKey_Escape, false, false);
}

void Monkey::press_key() {
    constexpr std::array others{ImGuiKey_Tab,  ImGuiKey_Enter,      ImGuiKey_UpArrow, ImGuiKey_DownArrow, ImGuiKey_LeftArrow,
                                ImGuiKey_Home, ImGuiKey_RightArrow, ImGuiKey_Escape,  ImGuiKey_Space,     ImGuiKey_Delete};
    const auto& focus = lab_->state().focus;
    const bool held = focus && costly(focus->x + focus->width / 2, focus->y + focus->height / 2);
    if (!held && upto(3) == 0) {
        const ImGuiKey key = others[static_cast<std::size_t>(upto(others.size()))];
        const bool ctrl = upto(6) == 0;
        note(fmt::format("key {}{}", ctrl ? "Ctrl " : "", ImGui::GetKeyName(key)));
        return send_key(key, ctrl, false);
    }
    const auto table = key_bindings();
    const KeyBinding& b = table[static_cast<std::size_t>(upto(static_cast<int>(table.size())))];
    if ((b.key == ImGuiKey_None && !b.character) || (held && b.key == ImGuiKey_Space)) return note("no key");
    note(fmt::format("key {} ({})", b.keys, b.meaning));
    if (b.character) return ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(b.character));
    send_key(static_cast<ImGuiKey>(b.key), b.ctrl, b.shift);
}

std::optional<Rectangle> Monkey::some_control() {
    const auto& controls = lab_->state().controls;
    if (controls.empty()) return std::nullopt;
    return std::next(controls.begin(), upto(static_cast<int>(controls.size())))->second;
}

// Is a slider here that would make the scene slow?
bool Monkey::costly(float x, float y) {
    const LabState& s = lab_->state();
    if (!s.session.extreme) return false;
    return std::ranges::any_of(s.session.lesson().parameters, [&](const Parameter* p) {
        const auto at = s.controls.find(std::string(p->info.key));
        if (!sizes_the_scene(*p) || at == s.controls.end()) return false;
        const Rectangle& r = at->second;
        return x >= r.x - 4 && x <= r.x + r.width + 4 && y >= r.y - 30 && y <= r.y + r.height + 30;
    });
}

void Monkey::move_mouse() {
    x_ = part() * width, y_ = part() * height;
    if (const auto control = some_control(); control && upto(2))
        x_ = control->x + part() * control->width, y_ = control->y + part() * control->height;
    note(fmt::format("mouse to {:.0f}, {:.0f}", x_, y_));
    ImGui::GetIO().AddMousePosEvent(x_, y_);
}

void Monkey::press_mouse() {
    if (!down_ && costly(x_, y_)) return note("no press");
    const int button = upto(8) == 0 ? 1 : 0;
    ImGuiIO& io = ImGui::GetIO();
    if (down_ || upto(3)) {
        note(fmt::format("mouse {} at {:.0f}, {:.0f}", down_ ? "up" : "click", x_, y_));
        if (!down_) io.AddMouseButtonEvent(button, true);
        for (int b = 0; b < 2; ++b) io.AddMouseButtonEvent(b, false);
        down_ = false;
        return;
    }
    note(fmt::format("mouse down at {:.0f}, {:.0f}", x_, y_));
    io.AddMouseButtonEvent(button, true);
    down_ = true;
}

void Monkey::turn_wheel() {
    const float turns = static_cast<float>(upto(21) - 10);
    note(fmt::format("wheel {}", turns));
    ImGui::GetIO().AddMouseWheelEvent(0, turns);
}

void Monkey::type_text() {
    constexpr std::array texts{"-1", "1e308", "nan", "inf", "0", "1e-300", "energy > 1", "×α∇", "stress", "9999999999999999999"};
    const std::string text = texts[static_cast<std::size_t>(upto(texts.size()))];
    note(fmt::format("types {}", text));
    if (!ImGui::GetIO().WantTextInput) return;  // else each letter would be a key of its own
    ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
}

// As Ctrl and a click on a slider, a number and Enter.
void Monkey::type_a_number() {
    const auto& all = lab_->session().lesson().parameters;
    const Parameter& p = *all[static_cast<std::size_t>(upto(static_cast<int>(all.size())))];
    const auto at = lab_->state().controls.find(std::string(p.info.key));
    if (at == lab_->state().controls.end() || sizes_the_scene(p)) return note("types no number");
    constexpr std::array numbers{"0", "-1", "1", "1e9", "-1e9", "1e-9", "0.5", "1e300", "1e-300", "nan"};
    const std::string number = numbers[static_cast<std::size_t>(upto(numbers.size()))];
    note(fmt::format("types {} = {}", p.info.key, number));
    const Rectangle r = at->second;
    ImGuiIO& io = ImGui::GetIO();
    io.AddMousePosEvent(r.x + r.width / 2, r.y + r.height / 2);
    lab_->frame(0.01);
    io.AddKeyEvent(ImGuiMod_Ctrl, true);
    io.AddMouseButtonEvent(0, true);
    lab_->frame(0.01);
    io.AddMouseButtonEvent(0, false);
    io.AddKeyEvent(ImGuiMod_Ctrl, false);
    lab_->frame(0.01);
    if (!io.WantTextInput) return;
    io.AddInputCharactersUTF8(number.c_str());
    lab_->frame(0.01);
    send_key(ImGuiKey_Enter, false, false);
}

// The ends of what is accepted, of one parameter.
void Monkey::take_extreme() {
    const auto& all = lab_->session().lesson().parameters;
    const Parameter& p = *all[static_cast<std::size_t>(upto(static_cast<int>(all.size())))];
    const Interval span = sizes_the_scene(p) ? p.info.useful : p.info.kind == Kind::choice ? p.info.useful : p.accepted();
    Real value = upto(2) ? span.min : span.max;
    if (upto(3) == 0) value = span.min + static_cast<Real>(part()) * (span.max - span.min);
    if (!std::isfinite(value)) value = std::copysign(1e300, value);
    if (p.info.kind != Kind::number) value = std::round(value);
    note(fmt::format("{} = {}", p.info.key, value));
    lab_->session().assign(p, value);
}

void Monkey::change_place() {
    const auto layout = static_cast<Layout>(upto(3));
    switch (upto(4)) {
        case 0:
            note("layout");
            return layout == Layout::deck ? lab_->open_deck() : lab_->set_layout(layout);
        case 1:
            note("theme");
            return lab_->set_theme(upto(2) ? Theme::dark : Theme::projector);
        case 2:
            note("scale");
            return lab_->set_scale(1 + 2 * part());
        default:
            note("before and after");
            return lab_->session().compare(static_cast<Compare>(upto(5)));
    }
}

void Monkey::ask_why() {
    Session& s = lab_->session();
    std::vector<const Field*> fields;
    for (const Field& f : s.lesson().fields)
        if (f.in_use() && f.size() > 0) fields.push_back(&f);
    if (fields.empty()) return note("no fields");
    const Field& f = *fields[static_cast<std::size_t>(upto(static_cast<int>(fields.size())))];
    const Index index = upto(static_cast<int>(f.size()));
    note(fmt::format("why {} {}", f.name, index));
    s.inspector.thing = Thing{f.on, index};
    s.ask({.field = std::string(f.name), .index = index, .component = upto(f.components + 1) - 1});
    lab_->state().side_wanted = SideTab::inspect;
}

void Monkey::set_stops() {
    Session& s = lab_->session();
    const auto& stages = s.runner().stages();
    note("stops");
    if (!stages.empty() && upto(2)) s.toggle_break(stages[static_cast<std::size_t>(upto(static_cast<int>(stages.size())))]->name);
    s.inspector.breaks.assumptions = upto(2);
    s.inspector.breaks.laws = upto(4) == 0;
    if (upto(4) == 0) s.inspector.breaks.clear();
}

// All of a frame but its pixels, which take longest and which nobody looks at; those of every tenth are drawn too.
std::string Monkey::frame() {
    (count_ % 10 == 0 ? glDisable : glEnable)(GL_RASTERIZER_DISCARD);
    const long before = lab_->session().passes_run();
    try {
        lab_->frame(0.016);
        context_->present();
    } catch (const std::exception& e) {
        return fmt::format("a frame threw: {}", e.what());
    }
    const long passes = lab_->session().passes_run() - before;
    return passes > passes_of_a_frame ? fmt::format("a frame ran {} passes", passes) : "";
}

std::string Monkey::look() {
    const Session& s = lab_->session();
    for (const Probe& p : s.lesson().probes)
        if (const auto value = p.value(); value && !std::isfinite(*value))
            return fmt::format("the probe {} is not finite", p.name);
    // A refusal may quote a number that was typed.
    const auto& message = lab_->session().message();
    if (message && message->kind == Session::Message::Kind::refused) lab_->session().dismiss();
    if (std::string wrong = not_a_number_in(state_json(lab_->state()), "the state"); !wrong.empty()) return wrong;
    return not_a_number_in(summary_of(lab_->state()), "the summary");
}

std::string Monkey::reset() {
    Session& s = lab_->session();
    ++count_;
    note("reset");
    s.end_walkthrough();
    s.restore_defaults();
    s.reset();
    if (s.message()) return fmt::format("the lab cannot be reset: {}", s.message()->text);
    if (s.runner().place() != Place{}) return "the reset lab is not at its start";
    if (std::string wrong = frame(); !wrong.empty()) return wrong;
    return look();
}

}  // namespace pliant::test
