// One control per parameter, made from its declaration alone.
#include <pliant/lesson/format.h>

#include "panels/lab_state.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

std::string describe(const Parameter& p) {
    std::string text(p.info.help);
    if (p.info.kind == Kind::number || p.info.kind == Kind::whole)
        text += "\nUsual " + p.info.useful.text() + ", accepted " + p.accepted().text() + (p.info.unit.empty() ? "" : " " + std::string(p.info.unit)) + ", default " +
                format_quantity(p.info.initial, p.info.unit) + ".\nCtrl+click types a number; a double click restores the default.";
    text += p.info.effect == Effect::live ? "\nTakes effect with the next step." : "\nRestarts the lesson (↻).";
    if (!p.used()) text += "\nNot used by the present scene.";
    return text;
}

// What the slider spans; open ends are left out by a hair, and a logarithmic one stays above zero.
Interval span_of(const Parameter& p, bool extreme) {
    Interval span = extreme ? p.accepted() : p.info.useful;
    if (p.info.scale == Scale::log && span.min <= 0) span.min = p.info.useful.min * 1e-6;
    const Real hair = 1e-6 * (span.max - span.min);
    if (span.open_min && p.info.scale == Scale::linear) span.min += hair;
    if (span.open_max) span.max -= hair;
    return span;
}

// ImGui takes the shown text as a format.
std::string as_format(std::string text) {
    for (std::size_t at = 0; (at = text.find('%', at)) != std::string::npos; at += 2) text.insert(at, "%");
    return text;
}

void number_slider(LabState& lab, const Parameter& p) {
    Session& session = lab.session;
    Real value = session.runner().wanted(p);
    Interval span = span_of(p, session.extreme);
    span.min = std::min(span.min, value), span.max = std::max(span.max, value);
    const std::string shown = as_format(format_quantity(value, p.info.unit, 5));
    const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat | (p.info.scale == Scale::log ? ImGuiSliderFlags_Logarithmic : 0);
    const bool was_active = ImGui::GetActiveID() == ImGui::GetID("##value");
    // When a number is typed, ImGui shows it by the format: a full one then.
    const char* format = ImGui::TempInputIsActive(ImGui::GetID("##value")) ? "%.10g" : shown.c_str();
    if (ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &span.min, &span.max, format, flags)) {
        if (p.info.kind == Kind::whole) value = std::round(value);
        session.assign(p, value, was_active);
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) session.restore_default(p);
}

void choice_box(LabState& lab, const Parameter& p) {
    const auto current = static_cast<std::size_t>(lab.session.runner().wanted(p));
    if (!ImGui::BeginCombo("##value", std::string(p.info.options[current].label).c_str())) return;
    for (std::size_t i = 0; i < p.info.options.size(); ++i)
        if (ImGui::Selectable(std::string(p.info.options[i].label).c_str(), i == current)) lab.session.assign(p, static_cast<Real>(i));
    ImGui::EndCombo();
}

void switch_box(LabState& lab, const Parameter& p, const std::string& label) {
    bool on = lab.session.runner().wanted(p) != 0;
    if (ImGui::Checkbox((label + "##value").c_str(), &on)) lab.session.assign(p, on ? 1 : 0);
}

void parameter_row(LabState& lab, const Parameter& p) {
    ImGui::PushID(&p);
    ImGui::BeginDisabled(!p.used());
    std::string label = words(p.info.key);
    if (!p.info.symbol.empty()) label += "  " + std::string(p.info.symbol);
    if (p.info.effect == Effect::rebuild) label += "  ↻";
    if (p.info.kind == Kind::toggle) {
        switch_box(lab, p, label);
    } else {
        ImGui::PushFont(lab.fonts.small);
        ImGui::TextUnformatted(label.c_str());
        ImGui::PopFont();
        tooltip(describe(p), lab.scale);
        ImGui::SetCursorPosY(ImGui::GetCursorPosY() - lab.px(4));
        ImGui::SetNextItemWidth(-1);
        p.info.kind == Kind::choice ? choice_box(lab, p) : number_slider(lab, p);
    }
    lab.note_control(std::string(p.info.key));
    tooltip(describe(p), lab.scale);
    ImGui::EndDisabled();
    ImGui::PopID();
}

void extreme_switch(LabState& lab) {
    const bool on = lab.session.extreme;
    if (on) ImGui::PushStyleColor(ImGuiCol_Text, packed(bad_colour));
    ImGui::Checkbox("extreme ranges", &lab.session.extreme);
    if (on) ImGui::PopStyleColor();
    lab.note_control("extreme");
    tooltip("Sliders span all that the solver accepts, far beyond where it works well.", lab.scale);
}

}  // namespace

void draw_parameters(LabState& lab) {
    ImGui::TextDisabled("Parameters");
    ImGui::SameLine();
    const float width = ImGui::CalcTextSize("extreme ranges").x + ImGui::GetFrameHeight() + lab.px(6);
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), ImGui::GetContentRegionMax().x - width));
    extreme_switch(lab);
    ImGui::BeginChild("parameters");
    for (const Parameter* p : lab.session.lesson().parameters) parameter_row(lab, *p);
    ImGui::EndChild();
}

}  // namespace pliant::viewer
