#include "panels/run_plots.h"

#include <pliant/run/awaited.h>
#include <pliant/text/format.h>

#include "panels/companion_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

constexpr const char* hidden_hint = "predict first";

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

}  // namespace

void plot_probe(PanelContext& lab, Plot& plot, std::size_t i, Point size) {
    Session& s = lab.session;
    if (s.recorder().empty()) return;
    const Probe& probe = s.lesson().probes[i];
    const bool awaited = awaited_stage(s.runner(), probe) != nullptr;
    const TimeSeries& series = s.recorder().series(i);
    const Axes axes{.x = s.runner().is_static() ? Axis{"step", ""} : Axis{"time t", "s"},
                    .y = {title_shown(s, name_with_symbol(probe.name, probe.symbol, " ")), std::string(probe.unit)},
                    .empty_hint = s.hides(probe.name) ? hidden_hint
                                  : awaited           ? "not computed yet"
                                                      : Axes{}.empty_hint};
    if (!plot.begin(title_shown(s, words(probe.name)) + "##" + std::string(probe.name), size, axes)) return;
    if (s.hides(probe.name) || awaited) return plot.end();
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

namespace {

// The same line in run B; null when there is none now.
const Line* line_of_b(const Session& s, const Line& line) {
    if (!s.companion() || s.catching_up()) return nullptr;
    const auto& lines = s.companion()->lesson().lines;
    const auto found = std::ranges::find(lines, line.name, &Line::name);
    return found != lines.end() && found->in_use() ? &*found : nullptr;
}

}  // namespace

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

}  // namespace pliant::viewer
