// What the slide layout shows besides picture and plots: the title, and the numbers that matter in large type.
#include "panels/headline.h"

#include <pliant/document/summary.h>
#include <pliant/text/format.h>

#include "panels/companion_panel.h"
#include "panels/typeset_text.h"

#include <fmt/format.h>

namespace pliant::viewer {
namespace {

std::string now_text(const Runner& r) {
    if (r.is_static()) return "static";
    return fmt::format("t = {}, Δt = {}", format_quantity(r.time(), "s", 3), format_quantity(r.time_step(), "s", 3));
}

// The name of a number and, where the number leaves it no room beside it, its exact value. Tells whether that is still to come.
bool draw_label(PanelContext& lab, const Probe& probe, const std::string& number, const std::string& exact) {
    ImGui::PushFont(lab.fonts.large);
    const float number_width = ImGui::CalcTextSize(number.c_str()).x;
    ImGui::PopFont();
    const float room = ImGui::GetContentRegionAvail().x, gap = lab.px(12);
    const bool beside = number_width + gap + ImGui::CalcTextSize(exact.c_str()).x <= room;
    ImGui::PushFont(lab.layout == Layout::deck ? lab.fonts.normal : lab.fonts.small);
    const MathBox& name = sentence_box(lab, named_with_symbol(probe.name, probe.symbol, "  "));
    draw_item(lab.fonts.mathematics, name, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    ImGui::PopFont();
    const float label_width = ImGui::GetItemRectSize().x;
    ImGui::PushFont(lab.fonts.small);
    const float width = ImGui::CalcTextSize(exact.c_str()).x;
    // Without room on either line the plot alone tells it.
    if (!beside && label_width + gap + width <= room) {
        ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
        ImGui::TextDisabled("%s", exact.c_str());
    }
    ImGui::PopFont();
    return beside;
}

}  // namespace

void draw_headline(PanelContext& lab) {
    const LessonInfo& info = lab.session.entry().info;
    ImGui::PushFont(lab.fonts.huge);
    ImGui::TextUnformatted(info.title.data(), info.title.data() + info.title.size());
    ImGui::PopFont();
    const std::string now = now_text(lab.session.runner());
    const float room = ImGui::GetContentRegionMax().x - ImGui::GetItemRectSize().x - lab.px(30);
    ImGui::PushFont(lab.fonts.large);
    const bool fits = ImGui::CalcTextSize(now.c_str()).x <= room;
    ImGui::PopFont();
    ImGui::PushFont(fits ? lab.fonts.large : lab.fonts.normal);
    const float width = ImGui::CalcTextSize(now.c_str()).x;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    ImGui::TextDisabled("%s", now.c_str());
    ImGui::PopFont();
    fitted_sentence(lab, std::string(info.summary), ImGui::GetContentRegionAvail().x);
}

void draw_key_numbers(PanelContext& lab) {
    if (lab.session.companion()) return draw_companion_table(lab);
    const Runner& r = lab.session.runner();
    const auto probes = key_probes(r.lesson());
    const auto& held = lab.held.key_numbers;
    for (std::size_t k = 0; k < probes.size() && k < held.size(); ++k) {
        const Probe* p = probes[k];
        const auto& [value, exact, awaits] = held[k];
        const bool hidden = lab.session.hides(p->name);  // until it is predicted
        const std::string number = hidden ? "?" : !awaits.empty() ? "—" : value ? format_quantity(*value, p->unit) : "undefined";
        const std::string exact_text =
            exact && !hidden && !lab.session.hides("theory") ? fmt::format("exact {}", format_quantity(*exact, p->unit)) : "";
        const bool beside = draw_label(lab, *p, number, exact_text);
        ImGui::PushFont(lab.fonts.large);
        ImGui::TextUnformatted(number.c_str());
        ImGui::PopFont();
        tooltip(awaits, lab.scale);
        if (exact_text.empty() || !beside) continue;
        ImGui::SameLine(0, lab.px(12));
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s", exact_text.c_str());
    }
}

}  // namespace pliant::viewer
