// What a scene holds of the panels: layout, plots and the knobs of the atlas.
#include "app/lab.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace pliant::viewer {
namespace {

constexpr std::string_view followed = "followed ", pin_prefix = "pin ";

// A number that is followed is known by its title in the lab, and by its place in the list in a scene.
std::string name_in_scene(const std::vector<Pin>& pins, const std::string& name) {
    const std::string title = name.starts_with(followed) ? name.substr(followed.size()) : name;
    const auto found = std::ranges::find(pins, title, &Pin::title);
    return found == pins.end() ? name : fmt::format("{}{}", pin_prefix, found - pins.begin() + 1);
}

std::string title_in_lab(const std::vector<Pin>& pins, const std::string& name) {
    if (!name.starts_with(pin_prefix)) return name;
    std::size_t number = 0;
    std::from_chars(name.data() + pin_prefix.size(), name.data() + name.size(), number);
    return number >= 1 && number <= pins.size() ? pins[number - 1].title : "";
}

bool is_plot(const Lesson& lesson, const std::string& name) {
    return name == "along" || name == "map" || name.starts_with(pin_prefix) ||
           std::ranges::find(lesson.probes, name, &Probe::name) != lesson.probes.end() ||
           std::ranges::find(lesson.lines, name, &Line::name) != lesson.lines.end();
}

std::optional<Interval> interval_of(const std::optional<Range>& range) {
    return range ? std::optional(Interval{range->lo, range->hi}) : std::nullopt;
}
std::optional<Range> range_of(const std::optional<Interval>& interval) {
    return interval ? std::optional(Range{interval->min, interval->max}) : std::nullopt;
}
std::optional<bool> is_log(const std::optional<AxisScale>& scale) {
    return scale ? std::optional(*scale == AxisScale::log) : std::nullopt;
}
std::optional<AxisScale> scale_with(const std::optional<bool>& log) {
    return log ? std::optional(*log ? AxisScale::log : AxisScale::linear) : std::nullopt;
}

template <class Enum>
Enum named(std::string_view name, std::initializer_list<Enum> all, Enum at_first) {
    const auto found = std::ranges::find(all, name, [](Enum e) { return name_of(e); });
    return found == all.end() ? at_first : *found;
}

SceneKnob scene_knob(const std::string& key, const std::optional<Atlas::Span>& span) {
    return {.key = key, .range = span ? std::optional(span->range) : std::nullopt, .log = span && span->log};
}
std::optional<Atlas::Span> span_of(const SceneKnob& knob) {
    return knob.range ? std::optional(Atlas::Span{*knob.range, knob.log}) : std::nullopt;
}

}  // namespace

// ---------------------------------------------------------------------------------------------------------- as a scene

SceneFile Lab::scene_file() const {
    SceneFile scene = state_.session.scene_file();
    // The page of the lecturer is no part of what others see.
    const Layout shown = state_.layout == Layout::presenter ? Layout::deck : state_.layout;
    SceneLayout layout{.layout = std::string(name_of(shown)), .tab = std::string(name_of(state_.side))};
    Fill fill = state_.fill;
    fill.plot = name_in_scene(state_.session.inspector.pins, fill.plot);
    layout.fill = text_of(fill);
    if (const Claim* claim = state_.claims.book.unfolded(scene.lesson); claim && state_.side == SideTab::claims)
        layout.claim = claim->id;
    if (layout != SceneLayout{}) scene.layout = std::move(layout);
    scene.plots = scene_plots();
    scene.atlas = scene_atlas();
    return scene;
}

ScenePlots Lab::scene_plots() const {
    const PlotPanelState& panel = state_.plots;
    const Session& s = state_.session;
    ScenePlots all{.cost = panel.cost_shown};
    // What belongs to another lesson is forgotten when it is drawn next.
    if (panel.lesson != s.entry().info.id) return all;
    const std::vector<Pin>& pins = s.inspector.pins;
    if (panel.picked) {
        all.shown.emplace();
        for (const std::string& name : panel.chosen) all.shown->push_back(name_in_scene(pins, name));
    }
    for (const auto& [name, set] : panel.memory.settings()) {
        const std::string in_scene = name_in_scene(pins, name);
        if (!is_plot(s.lesson(), in_scene)) continue;
        all.plots.push_back({.name = in_scene,
                             .x = interval_of(set.x),
                             .y = interval_of(set.y),
                             .x_log = is_log(set.x_scale),
                             .y_log = is_log(set.y_scale),
                             .hidden = {set.hidden.begin(), set.hidden.end()}});
    }
    all.axis = panel.axis, all.across = panel.across;
    return all;
}

// Empty where the knobs are those that the lesson begins with.
std::optional<SceneAtlas> Lab::scene_atlas() const {
    const Atlas& atlas = state_.atlas.atlas;
    Atlas at_first;
    at_first.follow(state_.session);
    if (!atlas.follows(state_.session) || atlas.across.empty() || atlas.up.empty()) return std::nullopt;
    SceneAtlas scene{.across = scene_knob(atlas.across, atlas.across_span), .up = scene_knob(atlas.up, atlas.up_span)};
    if (atlas.cells != Atlas::first_cells) scene.cells = atlas.cells;
    if (atlas.steps != Atlas::first_steps) scene.steps = atlas.steps;
    const bool same = scene == SceneAtlas{.across = {.key = at_first.across}, .up = {.key = at_first.up}};
    return same ? std::nullopt : std::optional(std::move(scene));
}

// --------------------------------------------------------------------------------------------------- from a scene

void Lab::open_scene(const SceneFile& scene) {
    const auto open = [this, scene] {
        state_.session.open_scene(scene);
        follow_lecture();
        show_scene(scene);
    };
    state_.session.holding() ? state_.session.later(open) : open();
}

void Lab::show_scene(const SceneFile& scene) {
    if (scene.version() < 2) return;
    const SceneLayout layout = scene.layout.value_or(SceneLayout{});
    state_.layout = named(layout.layout, {Layout::lab, Layout::slide, Layout::deck}, Layout::lab);
    state_.side_wanted =
        named(layout.tab, {SideTab::plots, SideTab::inspect, SideTab::claims, SideTab::atlas, SideTab::methods}, SideTab::plots);
    const auto claim = std::ranges::find(claims(), layout.claim, &Claim::id);
    if (claim != claims().end()) state_.claims.book.unfold(*claim);
    state_.fill = fill_from(layout.fill);
    state_.fill.plot = title_in_lab(state_.session.inspector.pins, state_.fill.plot);
    show_plots(scene);
    Atlas& atlas = state_.atlas.atlas;
    atlas.follow(state_.session);
    if (scene.atlas) show_atlas_of(*scene.atlas);
}

void Lab::show_plots(const SceneFile& scene) {
    PlotPanelState& panel = state_.plots;
    const std::vector<Pin>& pins = state_.session.inspector.pins;
    panel.lesson = scene.lesson;
    panel.picked = scene.plots.shown.has_value();
    panel.chosen.clear();
    for (const std::string& name : scene.plots.shown.value_or(std::vector<std::string>{}))
        panel.chosen.push_back(title_in_lab(pins, name));
    std::map<std::string, PlotSetting> settings;
    for (const ScenePlot& p : scene.plots.plots) {
        const std::string title = title_in_lab(pins, p.name);
        settings[title == p.name ? title : std::string(followed) + title] = {
            range_of(p.x), range_of(p.y), scale_with(p.x_log), scale_with(p.y_log), {p.hidden.begin(), p.hidden.end()}};
    }
    panel.memory.begin_with(std::move(settings));
    panel.cost_shown = scene.plots.cost;
    panel.axis = scene.plots.axis, panel.across = scene.plots.across;
}

void Lab::show_atlas_of(const SceneAtlas& scene) {
    Atlas& atlas = state_.atlas.atlas;
    atlas.across = scene.across.key, atlas.up = scene.up.key;
    atlas.across_span = span_of(scene.across), atlas.up_span = span_of(scene.up);
    atlas.cells = scene.cells.value_or(Atlas::first_cells), atlas.steps = scene.steps.value_or(Atlas::first_steps);
}

}  // namespace pliant::viewer
