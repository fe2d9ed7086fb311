#include "panels/plot_panel.h"

#include <pliant/text/format.h>

#include "panels/companion_panel.h"
#include "panels/field_plots.h"
#include "panels/methods_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pliant::viewer {
namespace {

constexpr std::string_view along = "along", heat_map = "map";
constexpr const char* hidden_hint = "predict first";

std::vector<std::string_view> plots_of_scene(const Lesson& lesson) {
    std::vector<std::string_view> names = lesson.first_plots();
    if (!names.empty()) return names;
    for (const Probe& probe : lesson.probes)
        if (names.size() < 2) names.push_back(probe.name);
    return names;
}

// Those that the slide names, else those of the scene.
std::vector<std::string> wanted_plots(const Session& s) {
    if (const auto of_slide = s.walkthrough ? s.walkthrough->slide().plots() : std::nullopt) return *of_slide;
    const auto of_scene = plots_of_scene(s.lesson());
    return {of_scene.begin(), of_scene.end()};
}

// The plots are those of the scene until a person chooses.
void choose_first(PanelContext& lab, PlotPanelState& panel) {
    const std::string_view lesson = lab.session.entry().info.id;
    if (panel.lesson != lesson) panel.lesson = lesson, panel.picked = false, panel.memory.clear();
    if (panel.picked) return;
    panel.chosen = wanted_plots(lab.session);
}

// Where the run stands, when that is not the end of what was recorded.
void mark_now(const PanelContext& lab, Plot& plot) {
    const Runner& runner = lab.session.runner();
    if (runner.place() == runner.reach()) return;
    plot.vertical_line("now", runner.is_static() ? static_cast<Real>(runner.place().step) : runner.time());
}

// A curve that belongs to the parameters of the run, such as what theory says: beside another run it says to which, unless it is
// the same for both.
std::string of_run(const Session& s, std::string_view curve, bool of_both) {
    return s.companion() && !of_both ? fmt::format("A: {}", curve) : std::string(curve);
}

// As far as both reach.
bool same_numbers(const std::vector<Real>& a, const std::vector<Real>& b) {
    const std::size_t count = std::min(a.size(), b.size());
    if (count == 0) return false;
    const auto same = [](Real x, Real y) {
        return std::abs(x - y) <= 1e-9 * std::max(std::abs(x), std::abs(y)) || (std::isnan(x) && std::isnan(y));
    };
    return std::equal(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(count), b.begin(), same);
}

bool same_curve(const Curve& a, const Curve& b) {
    return a.position.size() == b.position.size() && same_numbers(a.position, b.position) && same_numbers(a.value, b.value);
}

// A name that stands over a plot, along its axis, or in its legend; a slide may hide them until its answer.
std::string title_shown(const Session& s, std::string title) { return s.hides("titles") ? "?" : std::move(title); }

class Legend {
public:
    explicit Legend(const Session& s) : hidden_(s.hides("legends")) {}
    std::string name(std::string curve) { return ++count_, hidden_ ? fmt::format("curve {}", count_) : std::move(curve); }

private:
    bool hidden_;
    int count_ = 0;
};

void plot_probe(PanelContext& lab, Plot& plot, std::size_t i, Point size) {
    Session& s = lab.session;
    if (s.recorder().empty()) return;
    const Probe& probe = s.lesson().probes[i];
    const TimeSeries& series = s.recorder().series(i);
    const Axes axes{.x = s.runner().is_static() ? Axis{"step", ""} : Axis{"time t", "s"},
                    .y = {title_shown(s, name_with_symbol(probe.name, probe.symbol, " ")), std::string(probe.unit)},
                    .empty_hint = s.hides(probe.name) ? hidden_hint : Axes{}.empty_hint};
    if (!plot.begin(title_shown(s, words(probe.name)) + "##" + std::string(probe.name), size, axes)) return;
    if (s.hides(probe.name)) return plot.end();
    Legend legend(s);
    const auto line = [&](const std::string& name, const TimeSeries& of, Dash dash) {
        plot.line(legend.name(name), of.at(), of.values(), {.dash = dash});
    };
    line(s.companion() ? run_name(s, false, 1) : "measured", series, Dash::solid);
    if (const Companion* b = s.companion(); b && !b->recorder().empty())
        line(run_name(s, true, 1), b->recorder().series(i), Dash::dashed);
    if (s.pinned() && !s.pinned()->recorder.empty()) line("pinned", s.pinned()->recorder.series(i), Dash::dashed);
    if (!s.hides("theory") && std::ranges::any_of(series.exact(), [](Real x) { return std::isfinite(x); })) {
        const Companion* b = s.companion();
        const bool of_both = b && !b->recorder().empty() && same_numbers(series.exact(), b->recorder().series(i).exact());
        plot.reference(legend.name(of_run(s, "exact", of_both)), series.at(), series.exact());
    }
    mark_now(lab, plot);
    s.watch(i, zoomed_part(plot));
    plot.end();
}

// The same line in run B; null when there is none now.
const Line* line_of_b(const Session& s, const Line& line) {
    if (!s.companion()) return nullptr;
    const auto& lines = s.companion()->lesson().lines;
    const auto found = std::ranges::find(lines, line.name, &Line::name);
    return found != lines.end() && found->in_use() ? &*found : nullptr;
}

void plot_line(const Session& s, Plot& plot, const Line& line, Point size) {
    const Curve curve = curve_of(line.sample), reference = curve_of(line.reference);
    const AxisScale scale = line.log_log ? AxisScale::log : AxisScale::linear;
    const Axes axes{.x = {capitalised(std::string(line.position_name)), std::string(line.position_unit), scale},
                    .y = {title_shown(s, line.value_name.empty() ? words(line.name) : capitalised(std::string(line.value_name))),
                          std::string(line.unit), scale},
                    .empty_hint = s.hides(line.name) ? hidden_hint
                                  : line.log_log     ? "nothing above 0 to show"
                                                     : Axes{}.empty_hint};
    if (!plot.begin(title_shown(s, words(line.name)) + "##" + std::string(line.name), size, axes)) return;
    if (s.hides(line.name)) return plot.end();
    Legend legend(s);
    if (!curve.position.empty())
        plot.line(legend.name(s.companion() ? run_name(s, false, 1) : "now"), curve.position, curve.value);
    Curve of_b;
    const Line* b = line_of_b(s, line);
    if (b) {
        of_b = curve_of(b->sample);
        if (!of_b.position.empty())
            plot.line(legend.name(run_name(s, true, 1)), of_b.position, of_b.value, {.dash = Dash::dashed});
    }
    if (s.hides("theory")) return plot.end();
    const bool of_both = b && same_curve(reference, curve_of(b->reference));
    const std::string name = reference.position.empty() ? "" : legend.name(of_run(s, line.reference_name, of_both));
    if (!reference.position.empty())
        line.reference_points ? plot.points(name, reference.position, reference.value)
                              : plot.reference(name, reference.position, reference.value);
    std::vector<Curve> others(line.others.size()), others_of_b(others.size());  // stay in place until the plot is drawn
    for (std::size_t i = 0; i < others.size(); ++i) {
        const auto& [label, sample, points] = line.others[i];
        others[i] = curve_of(sample);
        if (others[i].position.empty()) continue;
        if (b && i < b->others.size()) others_of_b[i] = curve_of(b->others[i].sample);
        const bool shared = same_curve(others[i], others_of_b[i]);
        const std::string named = legend.name(of_run(s, label, shared));
        points ? plot.points(named, others[i].position, others[i].value) : plot.line(named, others[i].position, others[i].value);
        // A mark of where the run stands, such as its own point on a curve of theory, has a brother for B.
        if (points && !shared && !others_of_b[i].position.empty())
            plot.points(legend.name(fmt::format("B: {}", label)), others_of_b[i].position, others_of_b[i].value);
    }
    plot.end();
}

void plot_pin(PanelContext& lab, Plot& plot, Pin& pin, Point size) {
    const bool steps = lab.session.runner().is_static();
    const Field* field = lab.session.lesson().find_field(pin.field);
    const std::string name = field ? name_with_symbol(pin.field, field->symbol, " ") : words(pin.field);
    const bool hidden = lab.session.hides(pin.field);
    const Axes axes{.x = steps ? Axis{"step", ""} : Axis{"time t", "s"},
                    .y = {name, pin.unit},
                    .empty_hint = hidden ? hidden_hint : Axes{}.empty_hint};
    if (!plot.begin(fmt::format("{0}##followed {0}", pin.title), size, axes)) return;
    if (hidden) return plot.end();
    plot.line("pinned", pin.series.at(), pin.series.values());
    mark_now(lab, plot);
    pin.series.watch(zoomed_part(plot));
    plot.end();
}

void draw_named(PanelContext& lab, PlotPanelState& panel, Plot& plot, const std::string& name, Point size) {
    for (Pin& pin : lab.session.inspector.pins)
        if (pin.title == name) return plot_pin(lab, plot, pin, size);
    if (name == along) return plot_along(lab, panel, plot, size);
    if (name == heat_map) return plot_map(lab, plot, size);
    const Lesson& lesson = lab.session.lesson();
    for (std::size_t i = 0; i < lesson.probes.size(); ++i)
        if (lesson.probes[i].name == name) return plot_probe(lab, plot, i, size);
    for (const Line& line : lesson.lines)
        if (line.name == name && line.in_use()) return plot_line(lab.session, plot, line, size);
}

// With the entry of its menu that lets it fill the screen.
PlotHooks hooks_of(PanelContext& lab, const PlotPanelState& panel, const std::string& name) {
    PlotHooks hooks = panel.hooks;
    hooks.filled = static_cast<bool>(lab.fill);
    hooks.fill = [&lab, name] { lab.fill = lab.fill ? Fill{} : Fill{Filled::plot, name}; };
    return hooks;
}

void draw_one(PanelContext& lab, PlotPanelState& panel, const PlotStyle& style, const std::string& name, Point size) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = size.x > 0 ? size.x : ImGui::GetContentRegionAvail().x;
    Plot plot(panel.memory, style, hooks_of(lab, panel, name));
    draw_named(lab, panel, plot, name, size);
    lab.note_fillable({at.x, at.y, width, size.y}, {Filled::plot, name});
}

void toggle(PlotPanelState& panel, std::string_view name, const std::string& label) {
    auto& chosen = panel.chosen;
    const auto found = std::ranges::find(chosen, name);
    bool on = found != chosen.end();
    if (!ImGui::Checkbox((label + "##" + std::string(name)).c_str(), &on)) return;
    panel.picked = true;
    on ? chosen.push_back(std::string(name)) : void(chosen.erase(found));
}

void choice_menu(PanelContext& lab, PlotPanelState& panel) {
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##plots", panel.cost_shown ? "cost & error" : "plots …", ImGuiComboFlags_HeightLarge))
        return lab.note_control("plots");
    ImGui::Checkbox("cost & error  (C)", &panel.cost_shown);
    tooltip("In place of the plots: ms per stage, the error over time, and the error against the cost", lab.scale);
    ImGui::Separator();
    const Lesson& lesson = lab.session.lesson();
    for (const Probe& p : lesson.probes) toggle(panel, p.name, words(p.name));
    for (const Line& l : lesson.lines)
        if (l.in_use()) toggle(panel, l.name, words(l.name));
    toggle(panel, along, "the field along a line");
    if (lab.scene_has_grid) toggle(panel, heat_map, "the field as a heat map");
    ImGui::EndCombo();
}

bool shown_now(const PanelContext& lab, const std::string& name) {
    for (const Line& line : lab.session.lesson().lines)
        if (line.name == name) return line.in_use();
    return true;
}

// What was chosen; in the deck the first two that suit its scene.
std::vector<std::string> shown_plots(const PanelContext& lab, const PlotPanelState& panel) {
    const bool deck = lab.layout == Layout::deck;
    const std::vector<std::string> wanted = deck ? wanted_plots(lab.session) : panel.chosen;
    std::vector<std::string> shown;
    std::ranges::copy_if(wanted, std::back_inserter(shown), [&](const std::string& n) { return shown_now(lab, n); });
    if (lab.layout == Layout::lab)
        for (const Pin& pin : lab.session.inspector.pins) shown.push_back(pin.title);
    if (deck && shown.size() > 2) shown.resize(2);
    return shown;
}

void begin_plots(PanelContext& lab, PlotPanelState& panel) {
    choose_first(lab, panel);
    if (std::exchange(panel.run, lab.session.run_count()) != lab.session.run_count()) panel.memory.refit();
    follow_live_error(lab);
    // A plot that fills the screen is that of its layout, with its zoom.
    if (!lab.fill || panel.memory.place == 0) panel.memory.place = 1 + static_cast<unsigned>(lab.layout);
}

// How many plots are seen at once; on a slide, where nobody scrolls, none is cut, and one that has no room for its axes is left
// out.
std::size_t rows_of_plots(const PanelContext& lab, std::size_t count, float least) {
    if (lab.layout == Layout::lab) return std::min<std::size_t>(count, 3);
    const float spacing = ImGui::GetStyle().ItemSpacing.y, room = ImGui::GetContentRegionAvail().y;
    if (room < lab.px(80)) return 0;
    return std::clamp<std::size_t>(static_cast<std::size_t>(std::max(room + spacing, 0.f) / (least + spacing)), 1, count);
}

void say_empty(const PlotPanelState& panel) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", panel.chosen.empty() ? "No plot is chosen."
                                                   : "None of the chosen plots belongs to this scene: choose others above.");
    ImGui::PopTextWrapPos();
}

constexpr std::string_view cost = "cost";  // and error, as a name among plots

void cost_and_error(PanelContext& lab, PlotPanelState& panel, const PlotStyle& style) {
    const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
    const std::string name(cost);
    Plot plot(panel.memory, style, hooks_of(lab, panel, name));
    draw_cost_and_error(lab, plot);
    lab.note_fillable({at.x, at.y, room.x, room.y}, {Filled::plot, name});
}

void table_below(PanelContext& lab) {
    if (companion_table_height(lab) > 0) draw_companion_table(lab);
}

}  // namespace

std::optional<Interval> zoomed_part(const Plot& plot) {
    const auto x = plot.zoomed_x();
    return x ? std::optional(Interval{x->lo, x->hi}) : std::nullopt;
}

PlotTheme plot_theme(Theme theme) { return theme == Theme::dark ? PlotTheme::dark : PlotTheme::projector; }

void draw_plots(PanelContext& lab, PlotPanelState& panel) {
    begin_plots(lab, panel);
    if (lab.layout == Layout::lab) choice_menu(lab, panel), draw_what_if_words(lab);
    if (panel.cost_shown && lab.layout != Layout::deck) return cost_and_error(lab, panel, style_of_plots(lab)), table_below(lab);
    std::vector<std::string> shown = shown_plots(lab, panel);
    if (shown.empty()) return say_empty(panel), table_below(lab);
    ImGui::BeginChild("plots", {0, -companion_table_height(lab)}, ImGuiChildFlags_None,
                      ImGuiWindowFlags_NavFlattened | ImGuiWindowFlags_NoBackground);
    const float spacing = ImGui::GetStyle().ItemSpacing.y,
                least = lab.layout == Layout::lab ? lab.px(130) : std::min(lab.px(130), ImGui::GetContentRegionAvail().y);
    const std::size_t rows = rows_of_plots(lab, shown.size(), least);
    if (lab.layout != Layout::lab) shown.resize(rows);
    if (shown.empty()) return ImGui::EndChild(), table_below(lab);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const auto count = static_cast<float>(rows);
    // They fill the room, but are hardly higher than wide; in a deck, where the legend has rows of its own, a little more.
    const float highest = (lab.layout == Layout::deck ? 1.35f : 1.1f) * room.x;
    const float height = std::clamp((room.y - spacing * (count - 1)) / count, least, std::max(least, highest));
    for (const std::string& name : shown) draw_one(lab, panel, style_of_plots(lab), name, {0, height});
    ImGui::EndChild();
    table_below(lab);
}

PlotStyle style_of_plots(const PanelContext& lab) {
    PlotStyle style = plot_style(plot_theme(lab.theme), lab.scale);
    style.mathematics = &lab.fonts.mathematics;
    return style;
}

void draw_plots_in_row(PanelContext& lab, PlotPanelState& panel) {
    begin_plots(lab, panel);
    const std::vector<std::string> shown = shown_plots(lab, panel);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float gap = ImGui::GetStyle().ItemSpacing.x, count = static_cast<float>(std::max<std::size_t>(shown.size(), 1));
    const float width = std::min((room.x - gap * (count - 1)) / count, 2.6f * room.y);
    for (const std::string& name : shown) {
        if (name != shown.front()) ImGui::SameLine(0, gap);
        draw_one(lab, panel, style_of_plots(lab), name, {width, room.y});
    }
}

bool slide_has_plots(const PanelContext& lab) { return !wanted_plots(lab.session).empty(); }

std::string first_plot_of_scene(const Lesson& lesson) {
    const auto names = plots_of_scene(lesson);
    return names.empty() ? "" : std::string(names.front());
}

bool has_plot(const PanelContext& lab, std::string_view name) {
    const Session& s = lab.session;
    if (name == along || name == cost) return true;
    if (name == heat_map) return lab.scene_has_grid;
    if (std::ranges::any_of(s.inspector.pins, [&](const Pin& pin) { return pin.title == name; })) return true;
    return std::ranges::any_of(s.lesson().probes, [&](const Probe& p) { return p.name == name; }) ||
           std::ranges::any_of(s.lesson().lines, [&](const Line& l) { return l.name == name && l.in_use(); });
}

void draw_filled_plot(PanelContext& lab, PlotPanelState& panel) {
    begin_plots(lab, panel);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    constexpr float least_lines = 24;  // in the height of the screen
    ImFont* font = lab.fonts.normal;
    for (ImFont* larger : {lab.fonts.medium, lab.fonts.large, lab.fonts.larger})
        if (least_lines * larger->FontSize <= room.y) font = larger;
    PlotStyle style = plot_style(plot_theme(lab.theme), lab.scale * font->FontSize / lab.fonts.normal->FontSize);
    style.mathematics = &lab.fonts.mathematics;
    ImGui::PushFont(font);
    if (lab.fill.plot == cost)
        cost_and_error(lab, panel, style);
    else
        draw_one(lab, panel, style, lab.fill.plot, {room.x, room.y});
    ImGui::PopFont();
}

}  // namespace pliant::viewer
