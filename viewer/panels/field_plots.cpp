#include "panels/field_plots.h"

#include <pliant/text/format.h>

#include "panels/field_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace pliant::viewer {
namespace {

std::string field_title(const PanelContext& lab, const Field& f) {
    const int c = lab.session.colours.component;
    return words(f.name) + (c >= 0 ? " " + component_names(f)[static_cast<std::size_t>(c)] : "");
}

// Where the line of a profile crosses an axis, as a part of the scene.
void across_slider(PanelContext& lab, const char* axis, Real& at) {
    const Real low = 0, high = 1;
    const std::string label = fmt::format("##across {}", axis), format = fmt::format("{} at %.2f", axis);
    const auto text = slider_or_text(lab.typed, label.c_str(), format_exact(at), [&] {
        ImGui::SliderScalar(label.c_str(), ImGuiDataType_Double, &at, &low, &high, format.c_str(),
                            ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
    });
    if (text) lab.take_typed([&] { at = number_typed(axis, *text, low, high); });
}

}  // namespace

void plot_along(PanelContext& lab, PlotPanelState& panel, Plot& plot, Point size) {
    Session& s = lab.session;
    PlotPanelState& state = panel;
    const Field* field = s.lesson().find_field(s.colours.field);
    if (!field || !field->in_use()) return ImGui::TextDisabled("Choose a field above the picture to see it along a line.");
    constexpr std::array<const char*, 3> axes{"x", "y", "z"};
    const int dim = s.lesson().dimension();
    state.axis = std::min(state.axis, dim - 1);
    ImGui::SetNextItemWidth(lab.px(60));
    ImGui::Combo("##axis", &state.axis, axes.data(), dim);
    std::size_t next = 0;
    for (int k = 0; k < dim; ++k) {
        if (k == state.axis) continue;
        ImGui::SameLine();
        ImGui::SetNextItemWidth((ImGui::GetContentRegionAvail().x - lab.px(4)) /
                                static_cast<float>(k == dim - 1 || (state.axis == dim - 1 && k == dim - 2) ? 1 : 2));
        across_slider(lab, axes[static_cast<std::size_t>(k)], state.across[next++]);
    }
    const Inspector& looked = s.inspector;
    const Scene& scene = s.scene();
    std::vector<Real> rows;
    row_values(*field, s.colours.component, rows);
    if (s.shows_change())
        if (const auto change = looked.change(s.runner(), *field, s.colours.component)) rows = *change;
    const auto along_line = [&](std::span<const Real> values) {
        return field_profile(s.lesson(), scene, field->on, values, state.axis, state.across);
    };
    const FieldProfile profile = along_line(rows);
    const bool awaited = scene.awaits(field->name) && !s.shows_change();
    const std::string axis = axes[static_cast<std::size_t>(state.axis)], title = field_title(lab, *field);
    size.y -= ImGui::GetFrameHeightWithSpacing();
    if (!plot.begin(fmt::format("{} along {}##along", title, axis), size,
                    {.x = {axis, "m"},
                     .y = {title, std::string(field->unit)},
                     .empty_hint = s.hides(field->name) ? "predict first"
                                   : awaited            ? "not computed yet"
                                                        : "this field has no places"}))
        return;
    if (s.hides(field->name) || awaited) return plot.end();
    plot.line(s.shows_change() ? "change" : "now", profile.position, profile.value);
    if (looked.compare != Compare::now && !s.shows_change()) {
        // What the stage found, beneath what it left.
        const auto found = looked.before(s.runner(), field->name);
        std::vector<Real> before;
        row_values(*field, found, s.colours.component, before);
        const FieldProfile old = along_line(before);
        plot.reference("before", old.position, old.value);
    }
    plot.end();
}

void plot_map(PanelContext& lab, Plot& plot, Point size) {
    Session& s = lab.session;
    const Field* field = s.lesson().find_field(s.colours.field);
    const Scene& scene = s.scene();
    if (!field || scene.grids.empty() || scene.grids[0].values.empty())
        return ImGui::TextDisabled("Choose a field of cells above the picture for a heat map.");
    if (s.hides(field->name)) return ImGui::TextDisabled("%s is shown after Next.", words(field->name).c_str());
    const GridMarks& g = scene.grids[0];
    const std::vector<Real> values(g.values.begin(), g.values.end());
    const ColourScale& scale = s.colour_scale();
    const bool awaited = scene.awaits(field->name) && !scene.override_values;
    if (!plot.begin(field_title(lab, *field) + "##map", size,
                    {.x = {"x", "m"}, .y = {"y", "m"}, .empty_hint = awaited ? "not computed yet" : Axes{}.empty_hint}))
        return;
    if (awaited) return plot.end();
    plot.heat_map({.name = field_title(lab, *field),
                   .unit = std::string(field->unit),
                   .values = values,
                   .nx = g.nx,
                   .ny = g.ny,
                   .x = {g.lower[0], g.upper[0]},
                   .y = {g.lower[1], g.upper[1]},
                   .map = scale.map,
                   .range = Range{scale.min, scale.max}});
    plot.end();
}

}  // namespace pliant::viewer
