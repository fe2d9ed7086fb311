// Cost and error of the present run: ms per stage over time, the error over time, and the one against the other.
#include <pliant/text/format.h>

#include "panels/companion_panel.h"
#include "panels/plot_panel.h"

#include <fmt/format.h>

#include <algorithm>

namespace pliant::viewer {
namespace {

constexpr Real reference_budget_ms = 4;  // per frame, for the finer run

Axis place_axis(const Session& s) { return s.runner().is_static() ? Axis{"step", ""} : Axis{"time t", "s"}; }

void plot_stages(PanelContext& lab, Plot& plot, Point size) {
    const Session& s = lab.session;
    const auto& stages = s.lesson().stages;
    if (!plot.begin("Cost per stage##cost", size, {.x = place_axis(s), .y = {"time per step", "ms"}})) return;
    constexpr std::array dashes{Dash::solid, Dash::dashed, Dash::dotted};
    std::size_t shown = 0;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        if (!stages[i].in_use()) continue;
        plot.line(words(stages[i].name), s.costs().places(), s.costs().stage_ms(i), {.dash = dashes[shown++ % dashes.size()]});
    }
    plot.end();
}

void plot_error(PanelContext& lab, Plot& plot, Point size) {
    Session& s = lab.session;
    const LiveError& e = lab.live_error;
    const std::string title = fmt::format("Error of {}##error", e.probe() ? words(e.probe()->name) : "");
    const bool any = e.exact().latest() || e.finer().latest();
    const std::string hint = any ? "" : e.no_reference().empty() ? "press Space" : "no error to show";
    if (!plot.begin(title, size,
                    {.x = place_axis(s), .y = {.label = "relative error", .scale = AxisScale::log}, .empty_hint = hint}))
        return;
    if (e.exact().latest()) plot.line("from exact", e.exact().at, e.exact().error);
    if (e.finer().latest()) plot.line("from a finer run", e.finer().at, e.finer().error, {.dash = Dash::dashed});
    if (e.probe()) s.watch(e.probe_number(), zoomed_part(plot));
    plot.end();
}

// The settings of a point in which the points of the plot differ.
std::string point_name(const Lesson& lesson, const LiveError& e, const LiveError::Reached& point) {
    std::string name;
    for (std::size_t i = 0; i < point.settings.size(); ++i) {
        const auto differs = [&](const LiveError::Reached& other) { return other.settings[i] != point.settings[i]; };
        if (!std::ranges::any_of(e.trail(), differs) && !(e.now() && differs(*e.now()))) continue;
        name += fmt::format("{}{}", name.empty() ? "" : ", ", setting_text(*lesson.parameters[i], point.settings[i]));
    }
    return name;
}

void plot_error_against_cost(PanelContext& lab, Plot& plot, Point size) {
    const Session& s = lab.session;
    const LiveError& e = lab.live_error;
    const Axis cost = s.runner().is_static() ? Axis{.label = "cost per step", .unit = "ms", .scale = AxisScale::log}
                                             : Axis{.label = "cost per simulated second", .unit = "ms", .scale = AxisScale::log};
    if (!plot.begin("Error against cost##error cost", size,
                    {.x = cost, .y = {.label = "relative error", .scale = AxisScale::log}}))
        return;
    std::vector<Real> costs, errors;
    for (const LiveError::Reached& point : e.trail()) costs.push_back(point.cost), errors.push_back(point.error);
    if (e.now()) costs.push_back(e.now()->cost), errors.push_back(e.now()->error);
    // The settings of now may be in the trail too.
    for (std::size_t i = 0; i < e.trail().size(); ++i) {
        const LiveError::Reached& point = e.trail()[i];
        if (!e.now() || e.now()->settings != point.settings)
            plot.points(point_name(s.lesson(), e, point), std::vector{point.cost}, std::vector{point.error},
                        {.colour = i + 1, .marker = marker_by_place(i + 1)});
    }
    if (e.now()) {
        const std::string name = point_name(s.lesson(), e, *e.now());
        plot.points(fmt::format("now{}{}{}", name.empty() ? "" : ": ", name, e.mixed() ? " (mixed)" : ""),
                    std::vector{e.now()->cost}, std::vector{e.now()->error},
                    {.colour = std::size_t{0}, .marker = Marker::circle});
    }
    if (costs.size() > 1) plot.line("in turn", costs, errors, {.dash = Dash::dotted, .marker = Marker::none, .width = 1.f});
    plot.end();
}

// What the error is measured against, where that is not plain.
std::string remark(const PanelContext& lab) {
    const LiveError& e = lab.live_error;
    if (!e.probe()) return "This lesson names no number to measure errors of.";
    if (e.mixed()) return e.no_reference();
    if (!e.no_reference().empty() && !e.exact().latest()) return e.no_reference();
    return e.reference().empty() ? "" : fmt::format("Finer run: {}", e.reference());
}

}  // namespace

void follow_live_error(PanelContext& lab) {
    lab.live_error.look_at(lab.session.entry(), lab.session.runner(), lab.session.run_count());
}

void draw_cost_and_error(PanelContext& lab, Plot& plot) {
    const Session& s = lab.session;
    LiveError& e = lab.live_error;
    if (e.catching_up(s.runner()))
        lab.session.later([&e, &s] { e.advance_reference(s.runner(), s.recorder(), reference_budget_ms); });
    e.measure(s.runner(), s.recorder(), s.costs().step_ms());
    ImGui::BeginChild("cost and error", {0, -companion_table_height(lab)});
    const std::string words_below = remark(lab);
    const float room = ImGui::GetContentRegionAvail().y, gap = ImGui::GetStyle().ItemSpacing.y,
                below = words_below.empty()
                            ? 0
                            : gap + ImGui::CalcTextSize(words_below.c_str(), nullptr, false, ImGui::GetContentRegionAvail().x).y;
    // The first and the last have long legends.
    const float all = std::max(lab.px(380), room - below - 2 * gap);
    plot_stages(lab, plot, {0, 0.37f * all});
    plot_error(lab, plot, {0, 0.26f * all});
    plot_error_against_cost(lab, plot, {0, 0.37f * all});
    if (!words_below.empty()) ImGui::TextWrapped("%s", words_below.c_str());
    ImGui::EndChild();
    lab.note_control("cost and error");
}

}  // namespace pliant::viewer
