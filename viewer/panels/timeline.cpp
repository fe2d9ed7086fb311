// The stored past with its scrubber, where the run is to stop, and what is shown of a stage.
#include "panels/timeline.h"

#include <imgui_internal.h>

#include <pliant/text/format.h>
#include <pliant/text/spoken.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pliant::viewer {
namespace {

constexpr const char* breaks_popup = "where the run stops";

Real megabytes(std::size_t bytes) { return static_cast<Real>(bytes) / 1e6; }

void stage_breaks(PanelContext& lab) {
    Session& s = lab.session;
    Breakpoints& breaks = s.inspector.breaks;
    ImGui::TextDisabled("Stop before a stage, or after each pass of its loop");
    if (!ImGui::BeginTable("stages", 3, ImGuiTableFlags_SizingFixedFit)) return;
    for (const Stage* stage : s.runner().stages()) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(words(stage->name).c_str());
        ImGui::TableNextColumn();
        bool before = breaks.stages.contains(stage->name);
        if (ImGui::Checkbox(fmt::format("before##{}", stage->name).c_str(), &before)) s.toggle_break(stage->name);
        lab.note_control(fmt::format("break {}", stage->name));
        ImGui::TableNextColumn();
        if (!stage->again || !stage->loop_from.empty()) continue;
        bool passes = breaks.passes.contains(stage->name);
        if (ImGui::Checkbox(fmt::format("each pass##{}", stage->name).c_str(), &passes))
            passes ? void(breaks.passes.emplace(stage->name)) : void(breaks.passes.erase(std::string(stage->name)));
        lab.note_control(fmt::format("break pass {}", stage->name));
    }
    ImGui::EndTable();
}

void add_condition(PanelContext& lab, TimelineState& panel) {
    try {
        lab.session.inspector.breaks.conditions.push_back(parse_condition(panel.condition, lab.session.lesson()));
        panel.condition.clear();
        panel.refused.clear();
    } catch (const Refused& e) {
        panel.refused = e.what();
    }
}

void condition_breaks(PanelContext& lab, TimelineState& panel) {
    auto& conditions = lab.session.inspector.breaks.conditions;
    ImGui::TextDisabled("Stop when a probe crosses a limit");
    for (std::size_t k = 0; k < conditions.size(); ++k) {
        ImGui::PushID(static_cast<int>(k));
        const bool gone = ImGui::Button("×");
        tooltip("Take this condition away", lab.scale);
        ImGui::SameLine();
        ImGui::TextUnformatted(conditions[k].text().c_str());
        ImGui::PopID();
        if (gone) conditions.erase(conditions.begin() + static_cast<std::ptrdiff_t>(k--));
    }
    ImGui::SetNextItemWidth(lab.px(230));
    const std::string example = fmt::format("{} > 1e-3", lab.session.lesson().probes.front().name);
    std::array<char, 200> text{};
    panel.condition.copy(text.data(), text.size() - 1);
    const bool entered =
        ImGui::InputTextWithHint("##condition", example.c_str(), text.data(), text.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    panel.condition = text.data();
    lab.note_control("condition");
    tooltip("A probe, <, <=, > or >=, and a number in the probe's unit", lab.scale);
    ImGui::SameLine();
    if (ImGui::Button("Add") || entered) add_condition(lab, panel);
    lab.note_control("add condition");
    if (panel.refused.empty()) return;
    ImGui::PushTextWrapPos(lab.px(320));
    ImGui::TextUnformatted(panel.refused.c_str());
    ImGui::PopTextWrapPos();
}

// Below it, as far as there is room, wherever the mouse is.
void open_at_last_item(const char* popup) {
    ImGui::OpenPopup(popup);
    ImGui::GetCurrentContext()->OpenPopupStack.back().OpenPopupPos = {ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y};
}

void breaks_menu(PanelContext& lab, TimelineState& panel) {
    Breakpoints& breaks = lab.session.inspector.breaks;
    const std::size_t count = breaks.stages.size() + breaks.passes.size() + breaks.conditions.size() +
                              static_cast<std::size_t>(breaks.assumptions) + static_cast<std::size_t>(breaks.laws);
    if (ImGui::Button(count ? fmt::format("Stops: {}###breaks", count).c_str() : "Stops###breaks") || panel.open_breaks)
        open_at_last_item(breaks_popup);
    panel.open_breaks = false;
    lab.note_control("breaks");
    tooltip("Where the run is to stop by itself (F9)", lab.scale);
    if (!ImGui::BeginPopup(breaks_popup)) return;
    stage_breaks(lab);
    ImGui::Separator();
    condition_breaks(lab, panel);
    ImGui::Separator();
    ImGui::Checkbox("when an assumption fails", &breaks.assumptions);
    lab.note_control("break assumptions");
    ImGui::Checkbox("when a conserved quantity is lost", &breaks.laws);
    lab.note_control("break laws");
    if (ImGui::Button("Clear all")) breaks.clear(), lab.session.inspector.stopped.clear();
    lab.note_control("clear breaks");
    ImGui::EndPopup();
}

void compare_menu(PanelContext& lab) {
    Session& s = lab.session;
    Inspector& in = s.inspector;
    const Stage* shown = in.shown_stage(s.runner());
    ImGui::SetNextItemWidth(lab.px(112));
    if (ImGui::BeginCombo("##compare", std::string(name_of(in.compare)).c_str())) {
        for (const Compare c : {Compare::now, Compare::before, Compare::difference, Compare::side_by_side, Compare::swipe})
            if (ImGui::Selectable(std::string(name_of(c)).c_str(), in.compare == c)) s.compare(c);
        ImGui::EndCombo();
    }
    lab.note_control("compare");
    tooltip("What the picture and the profile show of a stage: what it left, what it found, or what it changed (V)", lab.scale);
    if (in.compare == Compare::now) return;
    ImGui::SameLine(0, lab.px(4));
    ImGui::SetNextItemWidth(lab.px(128));
    if (ImGui::BeginCombo("##of stage", shown ? words(shown->name).c_str() : "no stage yet")) {
        if (ImGui::Selectable("the latest", in.stage.empty())) in.stage.clear(), s.compare(in.compare);
        for (const Stage* stage : s.runner().stages())
            if (ImGui::Selectable(words(stage->name).c_str(), in.stage == stage->name))
                in.stage = stage->name, s.compare(in.compare);
        ImGui::EndCombo();
    }
    lab.note_control("compared stage");
    tooltip("The stage whose before and after are compared", lab.scale);
}

void scrubber(PanelContext& lab, float width) {
    Session& s = lab.session;
    const Runner& runner = s.runner();
    const Index first = runner.history().first_step() == 0 ? 0 : runner.history().first_step() + 1;
    const Index last = std::max(runner.reach().step, first);
    Index step = std::clamp(runner.place().step, first, last);
    ImGui::SetNextItemWidth(width);
    ImGui::BeginDisabled(first == last);
    const bool inside = runner.inside_step() && !s.shows_last_step();
    const std::string format = inside ? place_words(runner.place()) : "step %lld";
    bool moved = false;
    // The number stands over the grab, which is wide where few steps are stored.
    ImGui::PushStyleColor(ImGuiCol_SliderGrab, ImGui::GetColorU32(ImGuiCol_SliderGrab, 0.4f));
    const auto text = slider_or_text(lab.typed, "##past", fmt::format("{}", step), [&] {
        moved = ImGui::SliderScalar("##past", ImGuiDataType_S64, &step, &first, &last, format.c_str(),
                                    ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
    });
    ImGui::PopStyleColor();
    if (text) lab.take_typed([&] { step = whole_typed("step", *text, first, last), moved = true; });
    if (moved && step != runner.place().step) s.go_to({step, 0});
    ImGui::EndDisabled();
    lab.note_control("past");
    const History& h = runner.history();
    tooltip(fmt::format("The stored past: steps {} to {}. {} states take {:.1f} MB of the {:.0f} MB that they may", first, last,
                        h.size(), megabytes(h.bytes()), megabytes(h.cap())),
            lab.scale);
}

}  // namespace

void draw_timeline(PanelContext& lab, TimelineState& panel) {
    const Session& s = lab.session;
    const History& history = s.runner().history();
    const std::size_t recorded = s.recorded_bytes() + lab.live_error.bytes(), most = s.recorded_cap() + lab.live_error.cap();
    std::string memory = fmt::format("past {:.0f}/{:.0f}, plots {:.0f}/{:.0f} MB", megabytes(history.bytes()),
                                     megabytes(history.cap()), megabytes(recorded), megabytes(most));
    breaks_menu(lab, panel);
    ImGui::SameLine();
    compare_menu(lab);
    ImGui::SameLine();
    const std::string stopped = s.inspector.stopped.empty() ? "" : "stopped: " + s.inspector.stopped;
    ImGui::PushFont(lab.fonts.small);
    // Where the slider would have no room, it goes before the memory, which its tooltip has too.
    float memory_width = ImGui::CalcTextSize(memory.c_str()).x + ImGui::GetStyle().ItemSpacing.x;
    if (ImGui::GetContentRegionAvail().x - memory_width < lab.px(120)) memory.clear(), memory_width = 0;
    const float room = ImGui::GetContentRegionAvail().x - memory_width,
                wanted = stopped.empty() ? 0 : std::min(ImGui::CalcTextSize(stopped.c_str()).x + lab.px(10), room * 0.6f);
    ImGui::PopFont();
    scrubber(lab, room - wanted);
    ImGui::PushFont(lab.fonts.small);
    if (!memory.empty()) {
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s", memory.c_str());
        tooltip(fmt::format(
                    "Memory, and what it may take: of the stored past {:.1f} of {:.0f} MB; of what is recorded for plots and "
                    "errors {:.1f} of {:.1f} MB. As a run goes on its older steps are thinned out, both ends and all extremes "
                    "stay; pliant run --csv writes every step",
                    megabytes(history.bytes()), megabytes(history.cap()), megabytes(recorded), megabytes(most)),
                lab.scale);
    }
    if (!stopped.empty()) {
        ImGui::SameLine();
        ImGui::PushStyleColor(ImGuiCol_Text, lab.ink(Ink::accent));
        fitted_text(stopped, wanted - lab.px(8));
        ImGui::PopStyleColor();
    }
    ImGui::PopFont();
}

}  // namespace pliant::viewer
