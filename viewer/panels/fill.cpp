// What fills the screen: its name, and what could.
#include <pliant/math/error.h>

#include "panels/panel_context.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>

namespace pliant::viewer {
namespace {

constexpr std::array<std::pair<std::string_view, Filled>, 3> fills_by_name{
    {{"picture", Filled::picture}, {"matrix", Filled::matrix}, {"atlas", Filled::atlas}}};
constexpr std::string_view before_plot = "plot ";

bool covers(const Rectangle& r, ImVec2 p) { return p.x >= r.x && p.x < r.x + r.width && p.y >= r.y && p.y < r.y + r.height; }

}  // namespace

std::string text_of(const Fill& fill) {
    if (fill.what == Filled::plot) return fmt::format("{}{}", before_plot, fill.plot);
    const auto named = std::ranges::find(fills_by_name, fill.what, &std::pair<std::string_view, Filled>::second);
    return named == fills_by_name.end() ? "" : std::string(named->first);
}

Fill fill_from(std::string_view text) {
    if (text.empty()) return {};
    if (text.starts_with(before_plot) && text.size() > before_plot.size())
        return {Filled::plot, std::string(text.substr(before_plot.size()))};
    const auto named = std::ranges::find(fills_by_name, text, &std::pair<std::string_view, Filled>::first);
    if (named == fills_by_name.end())
        throw Refused(fmt::format(
            "'{}' cannot fill the screen: give picture, matrix, atlas, or plot and its name, as in 'plot energy'", text));
    return {named->second, ""};
}

std::string label_of(const Fill& fill) {
    switch (fill.what) {
        case Filled::picture:
            return "The picture";
        case Filled::matrix:
            return "The matrices";
        case Filled::atlas:
            return "The stability atlas";
        case Filled::plot:
            return fill.plot == "cost" ? "Cost and error" : fmt::format("Plot: {}", words(fill.plot));
        case Filled::none:
            break;
    }
    return "";
}

void PanelContext::note_fillable(Rectangle place, const Fill& what) {
    const ImRect clip = ImGui::GetCurrentWindow()->ClipRect;
    const float right = std::min(place.x + place.width, clip.Max.x), bottom = std::min(place.y + place.height, clip.Max.y);
    place.x = std::max(place.x, clip.Min.x), place.y = std::max(place.y, clip.Min.y);
    place.width = right - place.x, place.height = bottom - place.y;
    if (place.width > 0 && place.height > 0) fillable.push_back({place, what});
}

Fill PanelContext::pointed_at() const {
    const auto at = [&](ImVec2 p) -> const std::pair<Rectangle, Fill>* {
        const auto found = std::find_if(fillable.rbegin(), fillable.rend(), [&](const auto& f) { return covers(f.first, p); });
        return found == fillable.rend() ? nullptr : &*found;
    };
    if (const auto* under_mouse = at(ImGui::GetIO().MousePos)) return under_mouse->second;
    if (focus)
        if (const auto* focused = at({focus->x + focus->width / 2, focus->y + focus->height / 2})) return focused->second;
    return {Filled::picture, ""};
}

void fill_item(PanelContext& lab, const Fill& what) {
    const bool back = lab.fill.what != Filled::none;
    if (ImGui::MenuItem(back ? "Back" : "Fill the screen", "X")) lab.fill = back ? Fill{} : what;
    lab.note_control("menu fill");
}

void fill_menu_of_last_item(PanelContext& lab, const Fill& what, const std::function<void()>& more) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool dragged = io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Right] > io.MouseDragThreshold * io.MouseDragThreshold;
    const std::string name = fmt::format("fill menu {}", text_of(what));
    if (ImGui::IsItemHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Right) && !dragged) ImGui::OpenPopup(name.c_str());
    if (!ImGui::BeginPopup(name.c_str())) return;
    fill_item(lab, what);
    if (more) more();
    ImGui::EndPopup();
}

}  // namespace pliant::viewer
