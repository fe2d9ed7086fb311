// A picked thing with all its quantities, and how a number came about.
#include "panels/inspector_panel.h"

#include <pliant/run/awaited.h>
#include <pliant/text/file.h>
#include <pliant/text/format.h>

#include "panels/flowing_text.h"
#include "panels/typeset_text.h"
#include "panels/why_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace pliant::viewer {
namespace {

constexpr int digits = 5;

// Square brackets around a block that starts at `at`.
void brackets(PanelContext& lab, ImVec2 at, ImVec2 size) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const unsigned ink = ImGui::GetColorU32(ImGuiCol_Text);
    const float tick = lab.px(4), line = std::max(1.f, lab.px(1.5f));
    for (const auto& [x, inward] : {std::pair{at.x, tick}, {at.x + size.x, -tick}}) {
        draw->AddLine({x, at.y}, {x, at.y + size.y}, ink, line);
        draw->AddLine({x, at.y}, {x + inward, at.y}, ink, line);
        draw->AddLine({x, at.y + size.y}, {x + inward, at.y + size.y}, ink, line);
    }
}

// A number that answers when it is clicked.
void number(PanelContext& lab, const Field& f, Index index, int component, float width, std::string_view unit) {
    const Stage* const awaited = awaited_stage(lab.session.runner(), f);
    const bool hidden = lab.session.hides(f.name);
    const std::string text = awaited ? "—" : hidden ? "?" : format_quantity(row_value(f, index, component), unit, digits);
    const float room = std::max(width - ImGui::CalcTextSize(text.c_str()).x, 0.f);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
    ImGui::PushID(component);
    if (ImGui::Selectable(text.c_str(), false, 0, {ImGui::CalcTextSize(text.c_str()).x, 0}) && !awaited && !hidden)
        lab.session.ask({.field = std::string(f.name), .index = index, .component = component});
    const auto names = component_names(f);
    const std::string suffix = component >= 0 && f.rank != Rank::scalar ? "." + names[static_cast<std::size_t>(component)] : "";
    lab.note_control(fmt::format("why {}{}", f.name, suffix));
    tooltip(awaited  ? capitalised(not_yet(awaited))
            : hidden ? "Shown after Next: it would give the answer away"
                     : "Why this number? Click to see its formula and what went into it",
            lab.scale);
    ImGui::PopID();
}

void pin_button(PanelContext& lab, const Field& f, Index index) {
    Inspector& in = lab.session.inspector;
    const bool pinned = in.pinned(f.name, index, -1);
    const float width = ImGui::CalcTextSize("unpin").x + 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    if (ImGui::SmallButton(pinned ? "unpin" : "pin")) {
        if (pinned)
            std::erase_if(in.pins, [&](const Pin& p) { return p.field == f.name && p.index == index && p.component == -1; });
        else
            in.pin(lab.session.runner(), f, index, -1);
    }
    lab.note_control(fmt::format("pin {}", f.name));
    tooltip("Follow this quantity in a plot over time, from now on", lab.scale);
}

// A vector as a column, a tensor as a square of numbers in brackets; the unit once.
void block_of_numbers(PanelContext& lab, const Field& f, Index index) {
    const int columns = f.rank == Rank::vector ? 1 : (f.components == 4 ? 2 : 3), rows = f.components / columns;
    float widest = 0;
    for (int c = 0; c < f.components; ++c)
        widest = std::max(widest, ImGui::CalcTextSize(format_quantity(row_value(f, index, c), "", digits).c_str()).x);
    const float gap = lab.px(12), left = lab.px(18), line = ImGui::GetTextLineHeightWithSpacing();
    const ImVec2 start = ImGui::GetCursorScreenPos();
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            if (c) ImGui::SameLine();
            ImGui::SetCursorPosX(ImGui::GetStyle().WindowPadding.x + left + lab.px(6) + static_cast<float>(c) * (widest + gap));
            number(lab, f, index, r * columns + c, widest, "");
        }
    const float width = static_cast<float>(columns) * widest + static_cast<float>(columns - 1) * gap + lab.px(12);
    const float height = static_cast<float>(rows) * line - ImGui::GetStyle().ItemSpacing.y;
    brackets(lab, {start.x + left, start.y}, {width, height});
    if (f.unit.empty()) return;
    ImGui::GetWindowDrawList()->AddText(
        {start.x + left + width + lab.px(6), start.y + height / 2 - ImGui::GetTextLineHeight() / 2},
        ImGui::GetColorU32(ImGuiCol_TextDisabled), std::string(f.unit).c_str());
}

// The name and, on the same line where there is room, the number: of a vector its length.
void quantity(PanelContext& lab, const Field& f, Index index) {
    ImGui::PushID(f.name.data(), f.name.data() + f.name.size());
    const std::string symbol(f.symbol.empty() ? "" : f.symbol);
    const bool scalar = f.rank == Rank::scalar;
    const std::string name = scalar ? named_with_symbol(f.name, symbol) : words(f.name);
    const std::string equals = scalar ? "=" : as_formula(fmt::format("|{}| =", symbol));
    const std::string value = format_quantity(row_value(f, index, -1), f.unit, digits);
    draw_item(lab.fonts.mathematics, sentence_box(lab, name), ImGui::GetColorU32(ImGuiCol_Text));
    if (!f.help.empty()) sentence_tooltip(lab, f.help);
    const float pin_width = ImGui::CalcTextSize("unpin").x + lab.px(24);
    const float whole =
        sentence_width(lab, fmt::format("{}  {}  ", name, equals)) + ImGui::CalcTextSize(value.c_str()).x + pin_width;
    if (whole <= ImGui::GetContentRegionMax().x)
        ImGui::SameLine();
    else
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + lab.px(18));
    draw_item(lab.fonts.mathematics, sentence_box(lab, equals), ImGui::GetColorU32(ImGuiCol_TextDisabled));
    ImGui::SameLine();
    number(lab, f, index, -1, 0, f.unit);
    pin_button(lab, f, index);
    if (!scalar) block_of_numbers(lab, f, index);
    ImGui::PopID();
}

// A field for the number, and a button down and up; with Ctrl they go by hundreds.
void choose_index(PanelContext& lab, InspectorPanelState& panel, Index& index, Index last) {
    const float button = ImGui::GetFrameHeight(), gap = lab.px(2);
    if (std::exchange(panel.focus, false)) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(lab.px(120) - 2 * (button + gap));
    const auto text = number_field(lab.typed, "##index", fmt::format("{}", index));
    if (text) lab.take_typed([&] { index = whole_typed("its number", *text, 0, last); });
    lab.note_control("thing index");
    tooltip(fmt::format("Its number, 0 to {}", last), lab.scale);
    ImGui::PushButtonRepeat(true);
    for (const Index direction : {Index{-1}, Index{1}}) {
        ImGui::SameLine(0, gap);
        if (ImGui::Button(direction < 0 ? "-##index" : "+##index", {button, button}))
            index = std::clamp<Index>(index + direction * (ImGui::GetIO().KeyCtrl ? 100 : 1), 0, last);
    }
    ImGui::PopButtonRepeat();
}

void choose_thing(PanelContext& lab, InspectorPanelState& panel) {
    Inspector& in = lab.session.inspector;
    std::set<On> kinds;
    Index count = 0;
    for (const Field& f : lab.session.lesson().fields)
        if (f.in_use() && f.size() > 0) kinds.insert(f.on);
    if (kinds.empty()) return;
    if (!in.thing || !kinds.contains(in.thing->on)) in.thing = Thing{*kinds.begin(), 0};
    for (const Field& f : lab.session.lesson().fields)
        if (f.in_use() && f.on == in.thing->on) count = std::max(count, f.size());
    ImGui::SetNextItemWidth(lab.px(92));
    if (ImGui::BeginCombo("##on", words(name_of(in.thing->on)).c_str())) {
        for (const On on : kinds)
            if (ImGui::Selectable(words(name_of(on)).c_str(), on == in.thing->on)) in.thing = Thing{on, 0};
        ImGui::EndCombo();
    }
    lab.note_control("thing kind");
    tooltip("What is looked at; a click in the picture chooses too", lab.scale);
    ImGui::SameLine();
    const Index last = std::max<Index>(count - 1, 0);
    in.thing->index = std::clamp<Index>(in.thing->index, 0, last);
    choose_index(lab, panel, in.thing->index, last);
}

void save(PanelContext& lab, const std::string& name, const std::string& text) {
    try {
        write_file(name, text);
        lab.session.say(Session::Message::Kind::info, "Saved as " + name + " in the folder where Pliant was started.");
    } catch (const Error& e) {
        lab.session.say(Session::Message::Kind::refused, e.what());
    }
}

void exports(PanelContext& lab) {
    const Inspector& in = lab.session.inspector;
    const std::string_view id = lab.session.entry().info.id;
    const std::string lesson(id.substr(id.find('/') + 1));
    if (ImGui::SmallButton("save these numbers"))
        save(lab, fmt::format("{}_{}_{}.csv", lesson, name_of(in.thing->on), in.thing->index),
             in.thing_csv(lab.session.lesson()));
    lab.note_control("save thing");
    tooltip("All quantities of this thing as a CSV file", lab.scale);
    if (in.pins.empty()) return;
    ImGui::SameLine();
    if (ImGui::SmallButton("save pinned plots"))
        save(lab, lesson + "_pinned.csv", in.pins_csv(!lab.session.runner().is_static()));
    lab.note_control("save pins");
    tooltip("Every pinned quantity over time as a CSV file", lab.scale);
}

}  // namespace

void draw_inspector(PanelContext& lab, InspectorPanelState& panel) {
    choose_thing(lab, panel);
    const Inspector& in = lab.session.inspector;
    if (!in.thing) return ImGui::TextDisabled("This lesson has no fields to look into.");
    exports(lab);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    ImGui::SetNextWindowSizeConstraints({room.x, lab.px(40)}, {room.x, room.y * 0.5f});
    ImGui::BeginChild("quantities", {room.x, 0}, ImGuiChildFlags_Border | ImGuiChildFlags_AutoResizeY,
                      ImGuiWindowFlags_NavFlattened);
    for (const Field& f : lab.session.lesson().fields)
        if (f.in_use() && f.on == in.thing->on && in.thing->index < f.size()) quantity(lab, f, in.thing->index);
    ImGui::EndChild();
    ImGui::BeginChild("why", {0, 0}, ImGuiChildFlags_Border, ImGuiWindowFlags_NavFlattened);
    draw_why(lab);
    ImGui::EndChild();
}

}  // namespace pliant::viewer
