// One control per parameter, made from its declaration alone.
#include "panels/parameter_panel.h"

#include <pliant/lesson/setting_words.h>
#include <pliant/text/format.h>
#include <pliant/text/quantity_text.h>
#include <pliant/text/spoken.h>
#include <pliant/text/stored_file.h>

#include "panels/companion_panel.h"
#include "panels/methods_panel.h"
#include "panels/typeset_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>

namespace pliant::viewer {
namespace {

std::string describe(const Parameter& p) {
    std::string text(p.info.help);
    if (p.info.is_number())
        text += "\nUsual " + range_words(p.info.useful, p.info.unit) + ", accepted " + range_words(p.accepted(), p.info.unit) +
                ", default " + format_quantity(p.info.initial, p.info.unit) +
                ".\nCtrl+click, or Enter, types a number: in the unit that is shown, unless another stands behind it; it may lie "
                "outside the usual range. ← and → go by a step, with Shift by a tenth; so does the wheel with Alt. Shift drags "
                "finely. A double click restores the default.";
    text += p.looks()                       ? "\nOnly chooses what is shown: the run stays as it is."
            : p.info.effect == Effect::live ? "\nTakes effect with the next step."
                                            : "\nRestarts the lesson (↻).";
    return text;
}

// As it is written for its name: with all digits, in the unit that is shown beside it.
std::string in_full(const Parameter& p, Real value) {
    if (p.info.kind != Kind::number) return p.text(value);
    return quantity_in(value, p.info.unit, unit_shown(value, p.info.unit, Session::value_digits));
}

// Space on a slider that the keys act on plays, as everywhere.
bool space_on(ImGuiID id) {
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    return g.NavActivateId == id && ImGui::IsKeyPressed(ImGuiKey_Space, false);
}

void slider_of(PanelContext& lab, ParameterPanelState& panel, const Parameter& p) {
    Session& session = lab.session;
    const Real value = session.addressed().wanted(p);
    std::optional<Real> set;
    // The value stands above the slider; while one is typed, it is shown in full, with its unit.
    const auto text = slider_or_text(lab.typed, "##value", in_full(p, value), [&] {
        set = number_slider("##value", p, session.extreme, value, panel.drag, lab.layout != Layout::deck);
    });
    if (text) return session.enter(p, *text);
    const bool typing = lab.typed.control == ImGui::GetItemID();
    if (!typing && space_on(ImGui::GetItemID())) lab.wanted.push_back(Action::play);
    if (!typing && ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        ImGui::ClearActiveID();  // else the button that is still down would set the value again
        return session.restore_default(p);
    }
    if (set) session.assign(p, *set, std::exchange(panel.drag.joins, true));
}

bool fits_with(const ImFont* font, const std::string& text, float room) {
    return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x <= room;
}

void choice_box(PanelContext& lab, const Parameter& p) {
    const auto current = static_cast<std::size_t>(lab.session.addressed().wanted(p));
    const std::string label(p.info.options[current].label);
    const float room = ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() - 2 * ImGui::GetStyle().FramePadding.x;
    ImFont* font = ImGui::GetFont();
    for (ImFont* smaller : {lab.fonts.medium, lab.fonts.normal, lab.fonts.small})
        if (smaller->FontSize < font->FontSize && !fits_with(font, label, room)) font = smaller;
    std::string shown = label;
    if (!fits_with(font, label, room)) {
        ImGui::PushFont(font);
        shown = with_ellipsis(label, room);
        ImGui::PopFont();
    }
    if (ImGui::BeginCombo("##value", "")) {
        for (std::size_t i = 0; i < p.info.options.size(); ++i)
            if (ImGui::Selectable(std::string(p.info.options[i].label).c_str(), i == current))
                lab.session.assign(p, static_cast<Real>(i));
        ImGui::EndCombo();
    }
    // Drawn into the box, whose list keeps the usual type: a font that is pushed belongs to the window of that moment.
    const ImVec2 at = ImGui::GetItemRectMin();
    const float down = (ImGui::GetItemRectSize().y - font->FontSize) / 2;
    ImGui::GetWindowDrawList()->AddText(font, font->FontSize, {at.x + ImGui::GetStyle().FramePadding.x, at.y + down},
                                        ImGui::GetColorU32(ImGuiCol_Text), shown.c_str());
}

// Told, where it is refused. By its key: the lesson may be another one by then.
void choose_file_later(Session& session, std::string_view key, const std::string& path) {
    session.later(
        [&session, key = std::string(key), path] { session.choose_file(session.addressed().lesson().parameter(key), path); });
}

void ask_for_file(PanelContext& lab, const Parameter& p) {
    const std::vector<std::string> endings(p.info.endings.begin(), p.info.endings.end());
    lab.files.ask(FileChoice::Purpose::open, fmt::format("Open a {}", spoken(p.info.key)), endings, "",
                  [&session = lab.session, key = std::string(p.info.key)](const std::string& path) {
                      session.choose_file(session.addressed().lesson().parameter(key), path);
                  });
}

// A file by its name, among the bodies that come with Pliant; and buttons for one of one's own.
void file_box(PanelContext& lab, const Parameter& p) {
    const Real current = lab.session.addressed().wanted(p);
    const std::string text = p.text(current);
    const std::vector<std::string> bodies = bundled_bodies(p.info.endings);
    if (ImGui::BeginCombo("##value", value_words(p, current).c_str())) {
        if (ImGui::Selectable("none", current == 0)) lab.session.assign(p, 0);
        for (const std::string& name : bodies) {
            if (ImGui::Selectable(name.c_str(), name == text)) choose_file_later(lab.session, p.info.key, name);
            lab.note_control(fmt::format("{} {}", p.info.key, name));
        }
        ImGui::EndCombo();
    }
    lab.note_control(std::string(p.info.key));
    ImGui::PushFont(lab.fonts.small);
    if (ImGui::Button("Open…")) ask_for_file(lab, p);
    lab.note_control(fmt::format("open {}", p.info.key));
    tooltip(fmt::format("A file of your own, which ends in {}; one that is dropped on the window is taken as well",
                        fmt::join(p.info.endings, ", ")),
            lab.scale);
    const bool is_own = current != 0 && std::ranges::find(bodies, text) == bodies.end();
    ImGui::SameLine();
    ImGui::BeginDisabled(!is_own);
    if (ImGui::Button("Read again")) choose_file_later(lab.session, p.info.key, text);
    ImGui::EndDisabled();
    lab.note_control(fmt::format("again {}", p.info.key));
    tooltip("The file has changed on the disk: read it again", lab.scale);
    ImGui::PopFont();
}

// The words belong to the box: a click on them turns it as well.
void switch_box(PanelContext& lab, const Parameter& p, const std::string& label) {
    bool on = lab.session.addressed().wanted(p) != 0;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x, blank = ImGui::CalcTextSize(" ").x;
    const float most = ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() - gap - blank;
    // Smaller, and cut at last, where the panel is narrow.
    ImFont* font = ImGui::GetFont();
    for (ImFont* smaller : {lab.fonts.medium, lab.fonts.normal, lab.fonts.small})
        if (smaller->FontSize < font->FontSize && lab.fonts.mathematics.sentence(label, font->FontSize).width > most)
            font = smaller;
    ImGui::PushFont(font);
    const MathBox words = sentence_box(lab, cut_sentence(lab, label, most));
    ImGui::PopFont();
    const std::string room(static_cast<std::size_t>(std::ceil(words.width / blank)), ' ');
    if (ImGui::Checkbox((room + "##value").c_str(), &on)) lab.session.assign(p, on ? 1 : 0);
    const ImVec2 at = ImGui::GetItemRectMin();
    lab.fonts.mathematics.draw(
        *ImGui::GetWindowDrawList(), words,
        {at.x + ImGui::GetFrameHeight() + gap, at.y + (ImGui::GetItemRectSize().y - words.height()) / 2 + words.above},
        ImGui::GetColorU32(ImGuiCol_Text));
}

void control_of(PanelContext& lab, ParameterPanelState& panel, const Parameter& p) {
    if (p.info.kind == Kind::choice) return choice_box(lab, p);
    p.info.kind == Kind::file ? file_box(lab, p) : slider_of(lab, panel, p);
}

// Where the two runs differ in it: the value in the one that the sliders do not set.
std::optional<Real> value_in_other_run(const Session& s, const Parameter& p) {
    if (!s.companion() || s.hides(p.info.key)) return std::nullopt;
    for (const Differing& d : differing(s.runner(), s.companion()->runner()))
        if (d.parameter->info.key == p.info.key) return s.addresses_b() ? d.a : d.b;
    return std::nullopt;
}

constexpr const char* covered_hint = "shown after Next";

// In the place of a control whose value would give the answer of the slide away.
void cover(PanelContext& lab) {
    ImGui::PushFont(lab.layout == Layout::deck ? lab.fonts.normal : lab.fonts.small);
    ImGui::Button(covered_hint, {-1, 0});
    ImGui::PopFont();
}

// A change that waits for the next step; "" where none does.
std::string waiting_words(const Session& s, const Parameter& p) {
    if (!s.addressed().waits(p)) return "";
    return fmt::format("Waits for the next step: {} until it begins, {} from there on.", value_words(p, p.value()),
                       value_words(p, s.addressed().wanted(p)));
}

std::string help_of(PanelContext& lab, ParameterPanelState& panel, const Parameter& p) {
    if (lab.session.hides(p.info.key)) return "Shown after Next: it would give the answer away.";
    if (lab.session.locked(p)) return "Locked on this slide; End the walkthrough or press L to unlock.";
    if (!p.used()) return fmt::format("{}\n{}", panel.usage.reason(lab.session.addressed(), p), describe(p));
    const auto other = value_in_other_run(lab.session, p);
    const std::string waiting = waiting_words(lab.session, p);
    return waiting + (waiting.empty() ? "" : "\n") + describe(p) +
           (other ? fmt::format("\nThe other run has {}.", setting_text(p, *other)) : "");
}

// What would be in the tooltip is looked for only where it is shown.
void parameter_tip(PanelContext& lab, ParameterPanelState& panel, const Parameter& p) {
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) sentence_tooltip(lab, help_of(lab, panel, p));
}

std::string label_of(const PanelContext& lab, const Parameter& p) {
    std::string label =
        fmt::format("{}{}", value_in_other_run(lab.session, p) ? "≠ " : "", named_with_symbol(p.info.key, p.info.symbol, "  "));
    if (p.info.effect == Effect::rebuild) label += "  ↻";
    if (!p.info.is_number() && !lab.session.hides(p.info.key) && lab.session.addressed().waits(p))
        label += fmt::format("  (still {})", value_words(p, p.value()));
    return label;
}

// Of a number, as it stands above its slider: "4 ms", or "4 ms → 8 ms" while the change waits for the next step.
std::string value_text(const PanelContext& lab, const Parameter& p) {
    if (lab.session.hides(p.info.key)) return "?";
    if (!p.info.is_number()) return "";
    const Runner& run = lab.session.addressed();
    const std::string wanted = format_quantity(run.wanted(p), p.info.unit, Session::value_digits);
    return run.waits(p) ? fmt::format("{} → {}", format_quantity(p.value(), p.info.unit, Session::value_digits), wanted) : wanted;
}

// The name and the value on one line, in the large type of a deck.
bool label_fits_large(const PanelContext& lab, const Parameter& p) {
    const std::string value = value_text(lab, p);
    const float room = ImGui::GetContentRegionAvail().x - lab.px(8);
    const ImFont* const font = lab.fonts.large;
    const float label = lab.fonts.mathematics.sentence(label_of(lab, p), lab.fonts.medium->FontSize).width;
    return label + font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, value.c_str()).x <= room;
}

// The name on the left and, of a number, the value on the right.
void label_row(PanelContext& lab, ParameterPanelState& panel, const Parameter& p, ImFont* label_font) {
    const std::string value = value_text(lab, p);
    const bool waits = lab.session.addressed().waits(p) && !lab.session.hides(p.info.key);
    const float right = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(value.c_str()).x - lab.px(2);
    const float top = ImGui::GetCursorPosY(), drop = ImGui::GetTextLineHeight();
    ImGui::PushFont(label_font);
    ImGui::SetCursorPosY(top + drop - ImGui::GetTextLineHeight());
    fitted_sentence(lab, label_of(lab, p), right - ImGui::GetCursorPosX() - lab.px(4));
    ImGui::PopFont();
    parameter_tip(lab, panel, p);
    if (value.empty()) return;
    ImGui::SameLine();
    ImGui::SetCursorPosX(right);
    ImGui::SetCursorPosY(top);
    ImGui::PushStyleColor(ImGuiCol_Text, waits ? lab.ink(Ink::accent) : ImGui::GetColorU32(ImGuiCol_Text));
    ImGui::TextUnformatted(value.c_str());
    ImGui::PopStyleColor();
    if (waits) parameter_tip(lab, panel, p), lab.note_control("waiting " + std::string(p.info.key));
}

}  // namespace

void draw_parameter(PanelContext& lab, ParameterPanelState& panel, const Parameter& p, bool large) {
    ImGui::PushID(&p);
    ImFont* const label_font = !large ? lab.fonts.small : label_fits_large(lab, p) ? lab.fonts.medium : lab.fonts.normal;
    ImGui::PushFont(!large ? lab.fonts.normal : label_font == lab.fonts.medium ? lab.fonts.large : lab.fonts.medium);
    // A file that is chosen sets what uses it.
    ImGui::BeginDisabled((!p.used() && p.info.companions.empty()) || lab.session.locked(p));
    const bool covered = lab.session.hides(p.info.key);
    if (p.info.kind == Kind::toggle && !covered) {
        switch_box(lab, p, label_of(lab, p));
    } else {
        label_row(lab, panel, p, label_font);
        ImGui::SetCursorPosY(ImGui::GetCursorPosY() - lab.px(4));
        ImGui::SetNextItemWidth(-1);
        if (p.info.is_number()) ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {lab.px(4), lab.px(0.5f)});
        covered ? cover(lab) : control_of(lab, panel, p);
        if (p.info.is_number()) ImGui::PopStyleVar();
    }
    if (p.info.kind != Kind::file || covered) lab.note_control(std::string(p.info.key));
    if (!large && p.info.kind != Kind::file) what_if_menu(lab, p);
    ImGui::EndDisabled();
    ImGui::PopFont();
    parameter_tip(lab, panel, p);
    ImGui::PopID();
}

}  // namespace pliant::viewer
