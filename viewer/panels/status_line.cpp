#include <pliant/lesson/format.h>

#include "panels/lab_state.h"

#include <fmt/format.h>

namespace pliant::viewer {
namespace {

// A light that tells by its shape as well: a filled disc holds, a crossed square does not, a ring is not expected.
void light(LabState& lab, Holds holds, const std::string& name, const std::string& help) {
    const float r = lab.px(5), line = std::max(2.f, lab.px(1.5f));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 c{at.x + r, at.y + ImGui::GetTextLineHeight() / 2};
    ImDrawList* draw = ImGui::GetWindowDrawList();
    if (holds == Holds::yes) draw->AddCircleFilled(c, r, packed(good_colour));
    if (holds == Holds::not_expected) draw->AddCircle(c, r, packed(quiet_colour), 0, line);
    if (holds == Holds::no) {
        draw->AddRectFilled({c.x - r, c.y - r}, {c.x + r, c.y + r}, packed(bad_colour));
        draw->AddLine({c.x - r * 0.6f, c.y - r * 0.6f}, {c.x + r * 0.6f, c.y + r * 0.6f}, IM_COL32_WHITE, line);
        draw->AddLine({c.x - r * 0.6f, c.y + r * 0.6f}, {c.x + r * 0.6f, c.y - r * 0.6f}, IM_COL32_WHITE, line);
    }
    ImGui::Dummy({2 * r, ImGui::GetTextLineHeight()});
    ImGui::SameLine(0, lab.px(4));
    ImGui::TextUnformatted(name.c_str());
    tooltip(help, lab.scale);
    ImGui::SameLine(0, lab.px(14));
}

std::string_view law_text(Law law) {
    return law == Law::constant ? "stays constant" : law == Law::never_grows ? "never grows" : "is zero";
}

void conserved_lights(LabState& lab) {
    const Runner& runner = lab.session.runner();
    for (const std::size_t i : runner.shown_laws()) {
        const Conserved& c = runner.lesson().conserved[i];
        const std::string_view unit = runner.lesson().probe(c.probe).unit;
        const Holds holds = runner.holds(i);
        std::string help = fmt::format("{} {}", words(c.probe), law_text(c.law));
        if (holds == Holds::not_expected)
            help = fmt::format("{}: not expected to hold here", words(c.probe));
        else
            help += fmt::format(": off by {}, tolerance {}", format_quantity(runner.drift(i), unit),
                                format_quantity(c.tolerance(), unit));
        light(lab, holds, words(c.probe), help);
    }
}

// One light for all assumptions that hold, and one by name for each that does not.
void assumption_lights(LabState& lab) {
    std::string holding;
    std::vector<std::pair<std::string, std::string>> broken;
    for (const Assumption& a : lab.session.lesson().assumptions) {
        if (!a.in_use()) continue;
        const Real value = a.value(), limit = a.limit();
        const std::string text = fmt::format("{}: {}\n    {} against the limit {}\n", words(a.name), a.formula,
                                             format_quantity(value, a.unit), format_quantity(limit, a.unit));
        if (value <= limit)
            holding += text;
        else
            broken.emplace_back(words(a.name), fmt::format("Assumption {}Beyond it: {}", text, a.broken));
    }
    for (const auto& [name, text] : broken) light(lab, Holds::no, name, text);
    if (!holding.empty()) light(lab, Holds::yes, broken.empty() ? "assumptions" : "others", "Assumptions that hold:\n" + holding);
}

}  // namespace

void draw_status_line(LabState& lab) {
    const Session& s = lab.session;
    const Runner& r = s.runner();
    if (r.is_static()) {
        ImGui::Text("static   step %lld", static_cast<long long>(r.place().step));
    } else {
        ImGui::Text("t = %s   step %lld   Δt = %s", format_quantity(r.time(), "s").c_str(),
                    static_cast<long long>(r.place().step), format_quantity(r.time_step(), "s", 3).c_str());
        ImGui::SameLine(0, lab.px(14));
        if (s.playing)
            ImGui::Text("real time %.2f× of %.2g×", s.reached_speed(), s.speed);
        else
            ImGui::TextDisabled("paused");
        tooltip("Simulated seconds per second, reached and asked for. A slow machine falls behind; Δt never changes.", lab.scale);
    }
    ImGui::SameLine(0, lab.px(14));
    ImGui::Text("%.2f ms/step", r.step_ms());
    ImGui::SameLine(0, lab.px(18));
    conserved_lights(lab);
    assumption_lights(lab);
    const std::string past =
        fmt::format("past {} steps, {:.0f} of {:.0f} MB", r.history().size(), static_cast<double>(r.history().bytes()) / 1e6,
                    static_cast<double>(r.history().cap()) / 1e6);
    const float width = ImGui::CalcTextSize(past.c_str()).x;
    if (ImGui::GetContentRegionAvail().x > width) {
        ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
        ImGui::TextDisabled("%s", past.c_str());
        tooltip("States stored for stepping back", lab.scale);
    }
}

}  // namespace pliant::viewer
