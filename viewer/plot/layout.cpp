#include "plot/layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pliant::viewer {
namespace {

// Lengths in heights of a line of type.
constexpr float small_height = 9, small_width = 15;                             // below: no labels
constexpr float legend_height = 11, least_legend_height = 6, legend_width = 8;  // of a plot so small: a row at most, or none
constexpr float least_area = 1.5f;                                              // of either side
constexpr float sample_length = 1.7f;                                           // of the line beside a name in the legend
constexpr float between_entries = 0.9f;
// Names are shortened as far as it takes for all curves to be named, but no further than to something that can be read.
constexpr std::array widest_names{16.f, 11.f, 8.f, 6.f, 4.5f, 3.f};

class Layouter {
public:
    Layouter(Box whole, const PlotModel& model, const PlotMemory& memory, const PlotView& view, const Canvas& canvas)
        : model_(model), memory_(memory), view_(view), canvas_(canvas), em_(canvas.line_height()) {
        out_.whole = whole;
        small_ = whole.height() < small_height * em_ || whole.width() < small_width * em_;
        inner_ = {{whole.min.x + 0.4f * em_, whole.min.y + 0.25f * em_},
                  {whole.max.x - beside_area * em_, whole.max.y - 0.25f * em_}};
    }

    PlotLayout run() {
        place_title();
        place_legend();
        if (!small_ && !label_is_title()) label_row_ = take_row();
        const float below = (small_ || !names_x() ? 1.4f : 2.45f) * em_;
        out_.area.min.y = inner_.min.y + 0.5f * em_;  // half a number above the top end
        out_.area.max.y = std::round(inner_.max.y - below);
        place_colour_bar();
        place_y_axis();
        place_x_axis();
        if (!small_) {
            place_colour_label();
            place_y_label();
            place_x_label();
        }
        out_.usable = out_.area.width() >= least_area * em_ && out_.area.height() >= least_area * em_;
        return std::move(out_);
    }

private:
    bool names_x() const { return !model_.axes.x.label.empty() || !model_.axes.x.unit.empty() || memory_.x.fixed; }
    float whole_height() const { return out_.whole.height() / em_; }
    float width(std::string_view words) const { return canvas_.text_size(words).x; }
    float take_row() {
        const float y = inner_.min.y;
        inner_.min.y += 1.15f * em_;
        return y;
    }
    std::string fit(const std::string& words, float room) const { return shortened(canvas_, words, std::max(room, 0.0f)); }

    // The label with its unit; says so when the person has fixed the range.
    static std::string axis_label(const Axis& axis, const Ticks& ticks, const AxisMemory& memory) {
        const std::string text = axis_text(axis.label, ticks);
        return memory.fixed ? text + (text.empty() ? "fixed range" : " · fixed range") : text;
    }

    // A label that begins with the title says it all: it takes its place.
    bool label_is_title() const { return !small_ && !model_.heat && model_.axes.y.label.starts_with(model_.title); }

    void place_title() {
        const float row = take_row();
        out_.menu = {{inner_.max.x - 1.1f * em_, row}, {inner_.max.x, row + em_}};
        const float room = out_.menu.min.x - inner_.min.x - 0.4f * em_;
        // The unit and the offset that the numbers of y will have, nearly.
        Ticks y{{}, model_.axes.y.unit, ""};
        if (view_.has_data && (small_ || label_is_title())) {
            const float height = std::max(4 * em_, out_.whole.height() - 5 * em_);
            y = ticks_that_fit(view_.y, view_.y_scale, model_.axes.y.unit, height, true, canvas_);
        }
        std::string title = label_is_title() ? axis_label(model_.axes.y, y, memory_.y) : model_.title;
        const std::string tail = axis_text("", {{}, y.unit, y.offset});
        if (small_ && !model_.heat && !tail.empty()) title = fit(title, room - width(tail) - width(" ")) + " " + tail;
        out_.title = {fit(title, room), {inner_.min.x, row}};
    }

    // The legend stands above the picture, so that it hides no data: at the end of the title's row if it fits, else in rows of
    // its own. In a small plot it has a row where there are curves to tell apart.
    void place_legend() {
        const std::size_t count = model_.series.size();
        const bool tells_nothing = count == 0 || (count == 1 && (model_.heat || model_.series[0].name == model_.title));
        if (tells_nothing) return;
        const float room = out_.menu.min.x - out_.title.at.x - width(out_.title.text) - 1.5f * em_;
        const int most_rows = rows_of_legend();
        for (const float widest : widest_names) {
            const auto wider = std::exchange(out_.legend, {});
            float total = 0;
            for (std::size_t i = 0; i < count; ++i) total += add_entry(i, widest) + between_entries * em_;
            const bool readable = std::ranges::none_of(out_.legend, [](const LegendEntry& e) { return e.name.text.empty(); });
            if (!readable && !wider.empty()) {
                out_.legend = wider;
                break;
            }
            if (total <= room) return move_legend(out_.menu.min.x - total, out_.title.at.y);
            if (rows_taken() <= most_rows) return wrap_legend(most_rows);
        }
        wrap_legend(most_rows);
    }
    int rows_of_legend() const {
        if (small_ && (whole_height() < least_legend_height || out_.whole.width() < legend_width * em_)) return 0;
        if (small_ && whole_height() < legend_height) return 1;
        // A narrow plot has no other words, and needs a row for each name.
        const float height_for_row = small_ ? 1.5f : 2.5f;
        return std::clamp(static_cast<int>((whole_height() - small_height) / height_for_row) + 1, 1, 4);
    }
    float add_entry(std::size_t series, float widest) {
        const float room = std::min(widest * em_, inner_.max.x - inner_.min.x - (sample_length + 1) * em_);
        const std::string name = shortened_name(canvas_, model_.series[series].name, std::max(room, 0.f));
        const float length = (sample_length + 0.4f) * em_ + width(name);
        out_.legend.push_back({series, {{0, 0}, {length, em_}}, {name, {(sample_length + 0.4f) * em_, 0}}});
        return length;
    }
    int rows_taken() const {
        float x = inner_.min.x;
        int rows = 1;
        for (const LegendEntry& entry : out_.legend) {
            if (x > inner_.min.x && x + entry.box.width() > inner_.max.x) ++rows, x = inner_.min.x;
            x += entry.box.width() + between_entries * em_;
        }
        return rows;
    }
    static void move_entry(LegendEntry& entry, float x, float y) {
        const float dx = x - entry.box.min.x, dy = y - entry.box.min.y;
        for (Point* point : {&entry.box.min, &entry.box.max, &entry.name.at}) *point = {point->x + dx, point->y + dy};
    }
    void move_legend(float x, float y) {
        for (LegendEntry& entry : out_.legend) {
            move_entry(entry, x, y);
            x = entry.box.max.x + between_entries * em_;
        }
    }
    void wrap_legend(int most_rows) {
        if (most_rows == 0) return out_.legend.clear();
        float x = inner_.min.x, y = take_row();
        int rows = 1;
        for (std::size_t i = 0; i < out_.legend.size(); ++i) {
            if (x > inner_.min.x && x + out_.legend[i].box.width() > inner_.max.x) {
                if (++rows > most_rows) return out_.legend.resize(i);
                x = inner_.min.x;
                y = take_row();
            }
            move_entry(out_.legend[i], x, y);
            x = out_.legend[i].box.max.x + between_entries * em_;
        }
    }

    void place_colour_bar() {
        out_.area.max.x = inner_.max.x;
        out_.colour_bar = {{inner_.max.x, out_.area.min.y}, {inner_.max.x, out_.area.max.y}};
        if (!model_.heat) return;
        out_.colour = ticks_that_fit(view_.colour, AxisScale::linear, model_.heat->unit, out_.area.height(), true, canvas_);
        const float numbers = widest(out_.colour), bar = (small_ ? 0.6f : 0.9f) * em_;
        out_.colour_bar.max.x = inner_.max.x - numbers - 0.35f * em_;
        out_.colour_bar.min.x = out_.colour_bar.max.x - bar;
        out_.area.max.x = out_.colour_bar.min.x - 0.7f * em_;
    }

    float widest(const Ticks& ticks) const {
        float widest = 0;
        for (const Tick& tick : ticks.ticks) widest = std::max(widest, width(tick.text));
        return widest;
    }

    void place_y_axis() {
        out_.y.unit = model_.axes.y.unit;
        if (view_.has_data)
            out_.y = ticks_that_fit(view_.y, view_.y_scale, model_.axes.y.unit, out_.area.height(), true, canvas_);
        // In steps of half a line, so that the picture does not shake while the numbers change.
        const float gutter = std::ceil((widest(out_.y) + 0.4f * em_) / (0.5f * em_)) * 0.5f * em_;
        out_.area.min.x = std::round(inner_.min.x + gutter);
        out_.area.max.x = std::round(out_.area.max.x);
        out_.area.min.y = std::round(out_.area.min.y);
        out_.y_strip = {{out_.whole.min.x, out_.area.min.y}, {out_.area.min.x, out_.area.max.y}};
    }

    void place_x_axis() {
        out_.x_strip = {{out_.area.min.x, out_.area.max.y}, {out_.area.max.x, out_.whole.max.y}};
        out_.x.unit = model_.axes.x.unit;
        if (out_.area.width() < em_) return;
        if (view_.has_data)
            out_.x = ticks_that_fit(view_.x, view_.x_scale, model_.axes.x.unit, out_.area.width(), false, canvas_);
        if (!small_ || out_.x.unit.empty()) return;
        // The unit stands at the end of the numbers, those that it would cover go.
        const std::string text = "[" + out_.x.unit + "]";
        const float left = out_.whole.max.x - width(text) - 0.15f * em_;
        const AxisMap map = out_.x_map(view_);
        for (Tick& tick : out_.x.ticks) {
            if (map.pixel(tick.value) + width(tick.text) / 2 + 0.3f * em_ > left) tick.text.clear();
        }
        out_.x_label = {text, {left, out_.area.max.y + below_area * em_}};
    }

    void place_colour_label() {
        if (!model_.heat) return;
        const std::string text = axis_text(model_.heat->name, out_.colour) + (memory_.colour.fixed ? " · fixed" : "");
        out_.colour_label.text = fit(text, 0.55f * (inner_.max.x - inner_.min.x));
        out_.colour_label.at = {inner_.max.x - width(out_.colour_label.text), label_row_};
    }

    void place_y_label() {
        const std::string text = axis_label(model_.axes.y, out_.y, memory_.y);
        if (label_is_title()) {
            const bool legend_beside = !out_.legend.empty() && out_.legend[0].box.min.y == out_.title.at.y;
            const float end = legend_beside ? out_.legend[0].box.min.x : out_.menu.min.x;
            out_.title.text = fit(text, end - inner_.min.x - 0.4f * em_);
        } else {
            const float end = model_.heat ? out_.colour_label.at.x - em_ : inner_.max.x;
            out_.y_label = {fit(text, end - inner_.min.x), {inner_.min.x, label_row_}};
        }
    }

    void place_x_label() {
        const std::string text = fit(axis_label(model_.axes.x, out_.x, memory_.x), inner_.max.x - inner_.min.x);
        const float middle = (out_.area.min.x + out_.area.max.x - width(text)) / 2;
        const float left = std::clamp(middle, inner_.min.x, std::max(inner_.min.x, inner_.max.x - width(text)));
        out_.x_label = {text, {left, out_.area.max.y + (below_area + 1) * em_}};
    }

    const PlotModel& model_;
    const PlotMemory& memory_;
    const PlotView& view_;
    const Canvas& canvas_;
    float em_;
    bool small_ = false;
    Box inner_;
    float label_row_ = 0;
    PlotLayout out_;
};

}  // namespace

Ticks ticks_that_fit(Range range, AxisScale scale, std::string_view unit, float length, bool vertical, const Canvas& canvas) {
    const float em = canvas.line_height();
    const AxisMap map(range, scale, 0, length);
    const auto numbers_of = [](const Ticks& ticks) {
        return std::count_if(ticks.ticks.begin(), ticks.ticks.end(), [](const Tick& tick) { return !tick.text.empty(); });
    };
    const auto fits = [&](const Ticks& ticks, float gap) {
        Real end = -1e9;  // of the last number
        for (const Tick& tick : ticks.ticks) {
            if (tick.text.empty()) continue;
            const Real size = vertical ? em : canvas.text_size(tick.text).x, middle = map.pixel(tick.value);
            // The last number along x ends with the plot.
            const Real start = vertical ? middle - size / 2 : std::min(middle - size / 2, length + beside_area * em - size);
            if (start - gap / 2 < end) return false;
            end = start + size + gap / 2;
        }
        return true;
    };
    // Comfortably spaced or, where that leaves but one number, as close as can be read.
    for (const float gap : {0.8f * em, 0.15f * em}) {
        for (int most = std::clamp(static_cast<int>(length / em), 2, 12); most > 1; --most) {
            Ticks ticks = make_ticks(range, scale, most, unit);
            if (numbers_of(ticks) > 1 && fits(ticks, gap)) return ticks;
        }
    }
    return make_ticks(range, scale, 1, unit);
}

PlotLayout lay_out(Box whole, const PlotModel& model, const PlotMemory& memory, const PlotView& view, const Canvas& canvas) {
    return Layouter(whole, model, memory, view, canvas).run();
}

}  // namespace pliant::viewer
