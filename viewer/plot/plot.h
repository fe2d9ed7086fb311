// Plots for ImGui windows: axes with units, linear and log scales, curves, points, references, limits and heat maps, with zoom,
// pan, read-out and export.
//
//     PlotState plots;                                      // kept from frame to frame
//     ...
//     Plot plot(plots, plot_style(PlotTheme::dark, 1));     // once per frame
//     if (plot.begin("Energy", {0, 240}, {{"time t", "s"}, {"energy E", "J"}})) {
//         plot.line("kinetic", times, kinetic);
//         plot.line("total", times, total);
//         plot.reference("exact", times, exact);
//         plot.end();
//     }
//
// By hand: the wheel zooms about the pointer, a drag pans, a right drag zooms to a box, a double click resets; each of them acts
// on one axis when done on its numbers. A click in the legend hides or shows a curve. A right click, the ≡ switch, or Enter when
// the plot has the focus of the keys, opens a menu that can do all of it too.
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "plot/draw.h"
#include "plot/model.h"
#include "plot/style.h"

namespace pliant::viewer {

// A plot in the framebuffer, in px from its top left corner, for saving as a picture.
struct PlotShot {
    std::string title;
    int left = 0, top = 0, width = 0, height = 0;
};

// What a plot asks of the application. Its menu offers only what is set.
struct PlotHooks {
    std::function<void(const PlotShot&)> save_png;  // called while a frame is built that shows the plot without menu or pointer
    std::function<void(const std::string& title, const std::string& svg)> save_svg;
    std::function<void()> fill;  // the screen by this plot, or back
    bool filled = false;         // it does
};

enum class PlotDrag { none, pan, pan_x, pan_y, box, click };

// What a person has set of a plot: the part that is shown, the scales, and the curves that are hidden.
struct PlotSetting {
    std::optional<Range> x{}, y{};
    std::optional<AxisScale> x_scale{}, y_scale{};
    std::set<std::string, std::less<>> hidden{};
    bool operator==(const PlotSetting&) const = default;
};

// What one plot remembers.
struct PlotRecord {
    std::string name{};  // what follows ## in its title, or the title
    PlotMemory memory;
    DrawBuffers buffers;
    PlotDrag drag = PlotDrag::none;
    Point pressed{};
    Range x_at_press, y_at_press;
    bool wants_png = false;
};

// The memory of all plots of a panel, by ImGui's ids: zoom, scales, hidden series. Keep one for as long as the panel lives.
class PlotState {
public:
    PlotRecord& of(unsigned id) { return records_[id]; }
    // The plot of this title; made where there is none, with what was set of its name.
    PlotRecord& of(unsigned id, const std::string& title);
    // By the names of plots: what is set of those that were drawn, and what is to be set of those that will be.
    std::map<std::string, PlotSetting> settings() const;
    void begin_with(std::map<std::string, PlotSetting> settings);
    // Plots of one title in one place are the same one, in whichever window they are drawn; 0: those of one id of ImGui are.
    unsigned place = 0;
    // Automatic ranges are made anew from the data to come: call when a lesson is reset. What the person has set stays.
    void refit();
    // Each plot in sight in this frame is given to PlotHooks::save_svg.
    bool save_all_svg = false;
    // Forgets everything.
    void clear() { records_.clear(), wanted_.clear(); }

private:
    std::map<unsigned, PlotRecord> records_;
    std::map<std::string, PlotSetting> wanted_;  // of plots that are not drawn yet
};

class Plot {
public:
    Plot(PlotState& state, const PlotStyle& style, const PlotHooks& hooks = {}) : state_(state), style_(style), hooks_(hooks) {}

    // A plot `size` px wide and high at ImGui's cursor; 0 takes the width that is left, or a height of twelve lines. What follows
    // ## in the title tells plots of one title apart and is not shown. False when the plot is out of sight: add nothing then, and
    // do not call end.
    bool begin(const std::string& title, Point size, const Axes& axes);

    // Samples are vectors or spans that stay in place until end, or temporaries. Those with a number that is not finite, or not
    // positive on a log axis, leave a gap. Throws Refused when xs and ys differ in size.
    void line(const std::string& name, Samples xs, Samples ys, const SeriesStyle& style = {});
    void points(const std::string& name, Samples xs, Samples ys, const SeriesStyle& style = {});
    // An exact or published curve: dashed, over the measured ones.
    void reference(const std::string& name, Samples xs, Samples ys, const SeriesStyle& style = {});
    // A limit or an event. Where it lies outside the picture an arrow points to it.
    void vertical_line(const std::string& label, Real x, Dash dash = Dash::dashed);
    // At most one per plot. Throws Refused when there are not nx * ny values.
    void heat_map(HeatMap heat);

    // The part of the x axis that the person has zoomed to; ask between begin and end.
    std::optional<Range> zoomed_x() const { return state_.of(id_).memory.x.fixed; }

    void end();

private:
    void add(SeriesKind kind, const std::string& name, Samples xs, Samples ys, const SeriesStyle& style);

    PlotState& state_;
    const PlotStyle style_;
    const PlotHooks hooks_;
    PlotModel model_;
    Box whole_{};
    unsigned id_ = 0;
    bool pressed_by_key_ = false, open_ = false;
};

}  // namespace pliant::viewer
