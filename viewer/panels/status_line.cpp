#include "panels/status_line.h"

#include <pliant/text/format.h>
#include <pliant/text/spoken.h>

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace pliant::viewer {
namespace {

float light_width(const PanelContext& lab) { return lab.px(10); }
float gap_before_name(const PanelContext& lab) { return lab.px(4); }
float gap_of_lights(const PanelContext& lab) { return lab.px(14); }

float named_width(const PanelContext& lab, const Light& light) {
    return light_width(lab) + gap_before_name(lab) + ImGui::CalcTextSize(light.name.c_str()).x;
}

// Is there room for the names of the lights?
bool names_fit(const PanelContext& lab) {
    float width = 0;
    for (const Light& l : lab.held.lights) width += named_width(lab, l) + gap_of_lights(lab);
    return width <= ImGui::GetContentRegionAvail().x + gap_of_lights(lab);
}

// A light that tells by its shape as well: a filled disc holds, a warning triangle does not, a ring is not expected. With its
// name it is one item.
void draw_light(PanelContext& lab, const Light& light, bool named) {
    const Holds holds = light.holds;
    const float r = light_width(lab) / 2, line = std::max(2.f, lab.px(1.5f));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 c{at.x + r, at.y + ImGui::GetTextLineHeight() / 2};
    ImDrawList* draw = ImGui::GetWindowDrawList();
    if (holds == Holds::yes) draw->AddCircleFilled(c, r, packed(good_colour));
    if (holds == Holds::not_expected) draw->AddCircle(c, r, packed(quiet_colour), 0, line);
    if (holds == Holds::no) {
        const float wide = 1.3f * r, base = c.y + 1.05f * r;
        draw->AddTriangleFilled({c.x, c.y - 1.2f * r}, {c.x + wide, base}, {c.x - wide, base}, packed(bad_colour));
        draw->AddLine({c.x, c.y - 0.45f * r}, {c.x, c.y + 0.35f * r}, IM_COL32_WHITE, line);
        draw->AddLine({c.x, c.y + 0.6f * r}, {c.x, c.y + 0.85f * r}, IM_COL32_WHITE, line);
    }
    if (named) draw->AddText({at.x + 2 * r + gap_before_name(lab), at.y}, ImGui::GetColorU32(ImGuiCol_Text), light.name.c_str());
    ImGui::Dummy({named ? named_width(lab, light) : 2 * r, ImGui::GetTextLineHeight()});
    tooltip(named ? light.help : fmt::format("{}: {}", light.name, light.help), lab.scale);
}

// Where the run stands inside a step; "" between two.
std::string inside_text(const Session& s) {
    const Runner& r = s.runner();
    if (!r.inside_step() || s.shows_last_step()) return "";
    const std::string stage = words(r.stages()[r.next_stage()]->name);
    const std::string pass = r.passes_in_stage() > 0 ? fmt::format(", pass {} done", r.passes_in_stage()) : "";
    return fmt::format("{}: {}{}", s.moving() || s.playing ? "computing" : "inside a step", stage, pass);
}

}  // namespace

float draw_lights_at(PanelContext& lab, const Rectangle& room) {
    if (lab.held.lights.empty() || lab.session.hides("lights")) return 0;
    const float pad = lab.px(6), line = ImGui::GetTextLineHeight(), left = room.x + lab.px(10), right = room.x + room.width;
    // In as many rows as they need, the last at the lower end.
    std::vector<ImVec2> places;
    ImVec2 at{left, 0};
    float widest = left;
    for (const Light& l : lab.held.lights) {
        const float width = named_width(lab, l);
        if (at.x > left && at.x + width > right - pad) at = {left, at.y + line + pad};
        places.push_back(at);
        widest = std::max(widest, at.x + width);
        at.x += width + gap_of_lights(lab);
    }
    const float height = at.y + line + pad, top = room.y + room.height - height;
    ImGui::GetWindowDrawList()->AddRectFilled({left - pad, top - pad / 2}, {widest + pad, top + height - pad / 2},
                                              packed(palette(lab.theme).background, 0.8f), pad);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const Light& light = lab.held.lights[k];
        ImGui::SetCursorScreenPos({places[k].x, top + places[k].y});
        draw_light(lab, light, true);
        lab.note_control("light " + light.name);
    }
    return height;
}

void draw_status_line(PanelContext& lab) {
    const Session& s = lab.session;
    const Runner& r = s.runner();
    const bool under_way = r.inside_step() && !s.shows_last_step();
    std::string place = fmt::format("step {}", under_way ? step_number(r.place()) : r.place().step);
    // What is shown is the last good state.
    if (r.failure() && r.failure()->step > r.place().step) place += fmt::format(" ({} broke down)", r.failure()->step);
    if (r.is_static()) {
        ImGui::Text("static   %s", place.c_str());
    } else {
        ImGui::Text("t = %s   %s   Δt = %s", format_quantity(r.time(), "s").c_str(), place.c_str(),
                    format_quantity(r.time_step(), "s", 3).c_str());
        ImGui::SameLine(0, lab.px(14));
        const std::string inside = inside_text(s);
        if (!inside.empty())
            ImGui::TextUnformatted(inside.c_str());
        else if (s.playing)
            ImGui::Text("real time %.2f× of %.2g×", s.reached_speed(), s.speed);
        else
            ImGui::TextDisabled("paused");
        tooltip(inside.empty()
                    ? "Simulated seconds per second, reached and asked for. A slow machine falls behind; Δt never changes."
                    : "A step that takes longer than a frame is run pass by pass; the lab stays at hand meanwhile. Space stops "
                      "it here.",
                lab.scale);
    }
    ImGui::SameLine(0, lab.px(14));
    ImGui::Text("%.2f ms/step", r.step_ms());
    ImGui::SameLine(0, lab.px(18));
    const bool room = names_fit(lab);
    if (!s.hides("lights"))
        for (const Light& l : lab.held.lights) {
            draw_light(lab, l, room || l.holds == Holds::no);
            ImGui::SameLine(0, gap_of_lights(lab));
        }
    const std::string past =
        fmt::format("past {}, {:.0f} of {:.0f} MB", counted(static_cast<long long>(r.history().size()), "step"),
                    static_cast<double>(r.history().bytes()) / 1e6, static_cast<double>(r.history().cap()) / 1e6);
    const float width = ImGui::CalcTextSize(past.c_str()).x;
    if (ImGui::GetContentRegionAvail().x > width) {
        ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
        ImGui::TextDisabled("%s", past.c_str());
        tooltip("States stored for stepping back", lab.scale);
    }
}

}  // namespace pliant::viewer
