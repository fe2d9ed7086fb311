#include "plot/plot.h"

#include <imgui_internal.h>
#include <pliant/math/error.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "plot/imgui_canvas.h"
#include "plot/interaction.h"

namespace pliant::viewer {
namespace {

constexpr float default_lines = 12;

Point or_default(Point size) {
    if (size.x <= 0) size.x = ImGui::GetContentRegionAvail().x;
    if (size.y <= 0) size.y = default_lines * ImGui::GetTextLineHeight();
    return {std::max(1.0f, std::floor(size.x)), std::max(1.0f, std::floor(size.y))};
}

// The three bars of the switch that opens the menu, and the focus of the keys.
void draw_switches(Canvas& canvas, const PlotLayout& layout, const PlotStyle& style, bool focused) {
    const Box menu = layout.menu;
    for (int bar = 0; bar < 3; ++bar) {
        const float y = std::round(menu.min.y + menu.height() * (0.3f + 0.22f * static_cast<float>(bar)));
        canvas.fill({{menu.min.x + 0.15f * menu.width(), y}, {menu.max.x - 0.1f * menu.width(), y + style.width(1.25f)}},
                    style.faint_text);
    }
    if (!focused) return;
    const Box w{{layout.whole.min.x + 1, layout.whole.min.y + 1}, {layout.whole.max.x - 1, layout.whole.max.y - 1}};
    const Point corners[] = {w.min, {w.max.x, w.min.y}, w.max, {w.min.x, w.max.y}, w.min};
    canvas.line(corners, palette_colour(style, 0), style.width(2));
}

PlotShot shot_of(const std::string& title, Box whole) {
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 origin = ImGui::GetMainViewport()->Pos, scale = io.DisplayFramebufferScale;
    const auto pixels = [](float length) { return static_cast<int>(std::lround(length)); };
    return {title, pixels((whole.min.x - origin.x) * scale.x), pixels((whole.min.y - origin.y) * scale.y),
            pixels(whole.width() * scale.x), pixels(whole.height() * scale.y)};
}

}  // namespace

namespace {
std::string name_in(const std::string& title) {
    const auto at = title.find("##");
    return at == title.npos ? title : title.substr(at + 2);
}

PlotSetting setting_of(const PlotMemory& m) { return {m.x.fixed, m.y.fixed, m.x.scale, m.y.scale, m.hidden}; }
}  // namespace

PlotRecord& PlotState::of(unsigned id, const std::string& title) {
    const auto [at, is_new] = records_.try_emplace(id);
    PlotRecord& record = at->second;
    if (!is_new) return record;
    record.name = name_in(title);
    if (const auto found = wanted_.find(record.name); found != wanted_.end()) {
        const PlotSetting& s = found->second;
        record.memory.x.fixed = s.x, record.memory.y.fixed = s.y;
        record.memory.x.scale = s.x_scale, record.memory.y.scale = s.y_scale;
        record.memory.hidden = s.hidden;
    }
    return record;
}

std::map<std::string, PlotSetting> PlotState::settings() const {
    std::map<std::string, PlotSetting> all = wanted_;
    for (const auto& [id, record] : records_)
        if (!record.name.empty()) all[record.name] = setting_of(record.memory);
    std::erase_if(all, [](const auto& named) { return named.second == PlotSetting{}; });
    return all;
}

void PlotState::begin_with(std::map<std::string, PlotSetting> settings) {
    records_.clear();
    wanted_ = std::move(settings);
}

void PlotState::refit() {
    for (auto& [id, record] : records_) {
        for (AxisMemory* axis : {&record.memory.x, &record.memory.y, &record.memory.colour}) axis->automatic.forget();
    }
}

bool Plot::begin(const std::string& title, Point size, const Axes& axes) {
    if (open_) throw std::logic_error("Plot::begin was called twice without end");
    size = or_default(size);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(title.c_str());
    id_ = state_.place ? ImHashStr(title.c_str(), 0, state_.place) : ImGui::GetID("##plot");
    const bool pressed =
        ImGui::InvisibleButton("##plot", {size.x, size.y}, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    const bool by_mouse = ImGui::IsMouseReleased(ImGuiMouseButton_Left) || ImGui::IsMouseReleased(ImGuiMouseButton_Right);
    pressed_by_key_ = pressed && !by_mouse;
    if (!ImGui::IsItemVisible()) {
        ImGui::PopID();
        return false;
    }
    whole_ = {{std::floor(at.x), std::floor(at.y)}, {std::floor(at.x) + size.x, std::floor(at.y) + size.y}};
    model_ = PlotModel{title.substr(0, title.find("##")), axes, {}, {}, {}};
    open_ = true;
    state_.of(id_, title);
    return true;
}

void Plot::add(SeriesKind kind, const std::string& name, Samples xs, Samples ys, const SeriesStyle& style) {
    if (xs.size() != ys.size())
        throw Refused("The curve '" + name + "' of the plot '" + model_.title + "' has " + std::to_string(xs.size()) + " x and " +
                      std::to_string(ys.size()) + " y values; there must be as many of both.");
    model_.series.push_back({name, kind, std::move(xs), std::move(ys), style});
}

void Plot::line(const std::string& name, Samples xs, Samples ys, const SeriesStyle& style) {
    add(SeriesKind::line, name, std::move(xs), std::move(ys), style);
}
void Plot::points(const std::string& name, Samples xs, Samples ys, const SeriesStyle& style) {
    add(SeriesKind::points, name, std::move(xs), std::move(ys), style);
}
void Plot::reference(const std::string& name, Samples xs, Samples ys, const SeriesStyle& style) {
    add(SeriesKind::reference, name, std::move(xs), std::move(ys), style);
}

void Plot::vertical_line(const std::string& label, Real x, Dash dash) { model_.guides.push_back({true, x, label, dash}); }

void Plot::heat_map(HeatMap heat) {
    if (heat.nx < 0 || heat.ny < 0 || static_cast<std::size_t>(heat.nx * heat.ny) != heat.values.size())
        throw Refused("The heat map '" + heat.name + "' has " + std::to_string(heat.values.size()) + " values for " +
                      std::to_string(heat.nx) + " x " + std::to_string(heat.ny) + " cells.");
    model_.heat = std::move(heat);
}

void Plot::end() {
    if (!open_) throw std::logic_error("Plot::end was called without begin");
    open_ = false;
    ImguiCanvas canvas(*ImGui::GetWindowDrawList(), style_.mathematics);
    PlotRecord& record = state_.of(id_);

    // What is to be seen, before and after the hand has moved it.
    PlotView view = current_view(model_, record.memory);
    PlotLayout layout = lay_out(whole_, model_, record.memory, view, canvas);
    const Hand hand{record, model_, view, layout, style_, hooks_};
    const ImGuiIO& io = ImGui::GetIO();
    const bool dragged = io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Right] > io.MouseDragThreshold * io.MouseDragThreshold;
    const bool right_click = record.drag != PlotDrag::none && ImGui::IsMouseReleased(ImGuiMouseButton_Right) && !dragged;
    const bool on_switch = record.drag == PlotDrag::click && ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
                           layout.menu.contains(record.pressed) && layout.menu.contains({io.MousePos.x, io.MousePos.y});
    if (follow_pointer(hand)) {
        view = current_view(model_, record.memory);
        layout = lay_out(whole_, model_, record.memory, view, canvas);
    }

    draw_plot({canvas, model_, record.memory, view, layout, style_, record.buffers, layout.x_map(view), layout.y_map(view)});
    const bool shooting = std::exchange(record.wants_png, false);
    if (shooting && hooks_.save_png) {
        hooks_.save_png(shot_of(model_.title, whole_));
    } else {
        draw_switches(canvas, layout, style_, ImGui::IsItemFocused() && io.NavVisible);
        if (ImGui::IsItemHovered() || ImGui::IsItemActive()) draw_pointer(hand, canvas);
    }
    if (state_.save_all_svg && hooks_.save_svg) hooks_.save_svg(model_.title, plot_svg(hand, canvas));
    plot_menu(hand, canvas, right_click || on_switch || pressed_by_key_);
    ImGui::PopID();
}

}  // namespace pliant::viewer
