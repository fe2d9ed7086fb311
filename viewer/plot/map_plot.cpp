#include "plot/map_plot.h"

#include <pliant/study/stability_report.h>
#include <pliant/text/spoken.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plot/map_axes.h"
#include "plot/map_marks.h"

namespace pliant::viewer {
namespace {

constexpr float least_mark = 8;  // px at scale 1: smaller marks cannot be told apart

// Of a value in a list: "semi-implicit Euler", "0.01".
std::string name_of_value(const Parameter& p, Real value) {
    if (p.info.kind != Kind::choice) return p.text(value);
    const std::string_view label = p.info.options[static_cast<std::size_t>(value)].label;
    return std::string(label.substr(0, label.find(':')));
}

MapPicture::Axis axis_of(const Lesson& lesson, const Knob& knob) {
    const Parameter& p = lesson.parameter(knob.key);
    const std::string name = spoken(p.info.key);
    MapPicture::Axis axis{p.info.symbol.empty() ? name : fmt::format("{} {}", name, p.info.symbol), std::string(p.info.unit), {}};
    if (knob.spacing != Spacing::list) return axis;
    if (!p.info.unit.empty()) axis.label += fmt::format(" [{}]", p.info.unit);
    for (const Real v : knob.values) axis.names.push_back(name_of_value(p, v));
    return axis;
}

struct LegendRow {
    std::optional<Stability> kind;
    enum class Other { bound, wrong, present } other = Other::bound;
    std::string words;
};

class Drawer {
public:
    Drawer(Canvas& canvas, Box whole, const MapPicture& picture, const PlotStyle& style, bool beside)
        : canvas_(canvas),
          whole_(whole),
          p_(picture),
          map_(*picture.map),
          style_(style),
          beside_(beside),
          em_(canvas.line_height()) {}

    MapPlaces draw() {
        list_legend();
        lay_out();
        if (places_.area.width() < em_ || places_.area.height() < em_) return places_;
        draw_cells();
        draw_wrong();
        canvas_.push_clip(places_.area);
        for (const auto& [a, b] : p_.bound) {
            const std::array ends{places_.point(map_, a), places_.point(map_, b)};
            draw_bound_line(canvas_, ends, style_);
        }
        // Once more without its edges, which would cut the segments from one another.
        for (const auto& [a, b] : p_.bound) core_of_bound(places_.point(map_, a), places_.point(map_, b));
        canvas_.pop_clip();
        label_bound();
        if (p_.present) draw_present(canvas_, places_.point(map_, *p_.present), style_);
        outline(places_.area, style_.frame, style_.width(style_.frame_width));
        axes_.draw(places_, whole_);
        draw_legend();
        return places_;
    }

private:
    void list_legend() {
        for (int k = 0; k < stability_kinds; ++k)
            if (const Index n = map_.count(static_cast<Stability>(k)))
                rows_.push_back({static_cast<Stability>(k), {}, fmt::format("{}  {}", words_of(static_cast<Stability>(k)), n)});
        if (!p_.bound.empty()) rows_.push_back({{}, LegendRow::Other::bound, "limit of theory"});
        const auto wrong = std::ranges::count(p_.wrong, 1);
        if (wrong) rows_.push_back({{}, LegendRow::Other::wrong, fmt::format("against theory  {}", wrong)});
        if (p_.present) rows_.push_back({{}, LegendRow::Other::present, "present scene"});
        for (const LegendRow& r : rows_) legend_width_ = std::max(legend_width_, canvas_.text_size(r.words).x);
        legend_width_ += 2.6f * em_;
    }

    // Below the cells the legend stands in columns.
    int legend_columns() const { return std::max(1, static_cast<int>(whole_.width() / legend_width_)); }
    float legend_height() const {
        const int columns = legend_columns(), count = static_cast<int>(rows_.size());
        return static_cast<float>((count + columns - 1) / columns) * 1.35f * em_;
    }

    void lay_out() {
        const float legend = beside_ ? legend_width_ + 1.2f * em_ : 0, below = beside_ ? 0 : legend_height() + 0.6f * em_;
        Box& area = places_.area;
        area = whole_;
        area.min.y += 1.6f * em_;
        area.max.y -= 2.9f * em_ + below;
        area.min.x += axes_.fit_up(area.height(), 0.35f * whole_.width()) + 0.5f * em_;
        area.max.x -= std::max(legend, em_);
        for (float* v : {&area.min.x, &area.min.y, &area.max.x, &area.max.y}) *v = std::round(*v);
        if (area.width() > em_) axes_.fit_across(area.width());
    }

    void draw_cells() {
        if (map_.cells.empty()) return;
        for (Index j = 0; j < map_.rows(); ++j)
            for (Index i = 0, end = 0; i < map_.columns(); i = end) {
                const Stability kind = map_.at(i, j).verdict.kind;
                for (end = i + 1; end < map_.columns() && map_.at(end, j).verdict.kind == kind;) ++end;
                const Box first = places_.box(map_, i, j), last = places_.box(map_, end - 1, j);
                canvas_.fill({first.min, last.max}, colour_of(kind));
            }
        const Box one = places_.box(map_, 0, 0);
        const auto every = [&](float length) {
            return std::max<Index>(1, static_cast<Index>(std::ceil(style_.px(least_mark) / std::max(length, 0.01f))));
        };
        const Index a = every(one.width()), b = every(one.height());
        const float size = std::min({static_cast<float>(a) * one.width(), static_cast<float>(b) * one.height(), style_.px(26)});
        for (Index j = b / 2; j < map_.rows(); j += b)
            for (Index i = a / 2; i < map_.columns(); i += a) {
                const Box box = places_.box(map_, i, j);
                draw_class_mark(canvas_, {(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2}, size,
                                map_.at(i, j).verdict.kind, style_);
            }
    }

    void outline(Box b, Rgba8 colour, float width) {
        const Point corners[] = {b.min, {b.max.x, b.min.y}, b.max, {b.min.x, b.max.y}, b.min};
        canvas_.line(corners, colour, width);
    }
    void draw_wrong() {
        for (Index j = 0; j < map_.rows(); ++j)
            for (Index i = 0; i < map_.columns(); ++i)
                if (p_.wrong[static_cast<std::size_t>(i + map_.columns() * j)])
                    outline(places_.box(map_, i, j), style_.text, style_.width(2));
    }

    void core_of_bound(Point a, Point b) {
        const bool dark = contrast(style_.background, {255, 255, 255}) > 5;
        canvas_.segment(a, b, dark ? Rgba8{255, 255, 255} : Rgba8{0, 0, 0}, style_.px(3.25f));
    }

    // Where the bound passes nearest to a place up and right of the middle.
    void label_bound() {
        if (p_.bound.empty()) return;
        const Box& area = places_.area;
        const Point wanted{area.min.x + 0.55f * area.width(), area.min.y + 0.35f * area.height()};
        Point best{};
        float nearest = -1;
        for (const auto& [a, b] : p_.bound) {
            const Point at = places_.point(map_, {(a.across + b.across) / 2, (a.up + b.up) / 2});
            const float d = std::hypot(at.x - wanted.x, at.y - wanted.y);
            if (nearest < 0 || d < nearest) nearest = d, best = at;
        }
        const Point size = canvas_.text_size("theory");
        if (size.x + em_ > area.width() || size.y + em_ > area.height()) return;
        const Point at{std::clamp(best.x + 0.8f * em_, area.min.x + 0.3f * em_, area.max.x - size.x - 0.3f * em_),
                       std::clamp(best.y - 0.5f * em_, area.min.y + 0.2f * em_, area.max.y - size.y - 0.2f * em_)};
        canvas_.fill({{at.x - 0.25f * em_, at.y}, {at.x + size.x + 0.25f * em_, at.y + size.y}}, style_.plate);
        canvas_.text(at, style_.text, "theory");
    }

    void draw_legend() {
        const int columns = beside_ ? 1 : legend_columns();
        const Point from = beside_ ? Point{places_.area.max.x + 1.2f * em_, places_.area.min.y}
                                   : Point{whole_.min.x, places_.area.max.y + 3.1f * em_};
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            const auto column = static_cast<int>(k) % columns, row = static_cast<int>(k) / columns;
            const Point at{from.x + static_cast<float>(column) * legend_width_, from.y + static_cast<float>(row) * 1.35f * em_};
            draw_entry(rows_[k], at);
        }
    }
    void draw_entry(const LegendRow& r, Point at) {
        const Box swatch{{at.x, at.y}, {at.x + 1.1f * em_, at.y + 1.1f * em_}};
        const Point middle{(swatch.min.x + swatch.max.x) / 2, (swatch.min.y + swatch.max.y) / 2};
        if (r.kind) {
            draw_class(canvas_, swatch, *r.kind, style_);
        } else if (r.other == LegendRow::Other::bound) {
            const std::array ends{Point{swatch.min.x, middle.y}, Point{swatch.max.x, middle.y}};
            draw_bound_line(canvas_, ends, style_);
        } else if (r.other == LegendRow::Other::wrong) {
            outline(swatch, style_.text, style_.width(2));
        } else {
            draw_present(canvas_, middle, style_);
        }
        canvas_.text({swatch.max.x + 0.5f * em_, at.y + 0.05f * em_}, style_.text, r.words);
    }

    Canvas& canvas_;
    const Box whole_;
    const MapPicture& p_;
    const StabilityMap& map_;
    const PlotStyle& style_;
    const bool beside_;
    const float em_;
    MapPlaces places_;
    MapAxes axes_{canvas_, p_, style_};
    std::vector<LegendRow> rows_;
    float legend_width_ = 0;
};

}  // namespace

MapPicture::MapPicture(const StabilityMap& shown) : map(&shown) {
    // Between coarse cells the limit would be a staircase.
    if (shown.complete) bound = theory_bound(shown);
    const auto lesson = shown.order.lesson->make();
    across = axis_of(*lesson, shown.order.across), up = axis_of(*lesson, shown.order.up);
    for (Index j = 0; j < shown.rows(); ++j)
        for (Index i = 0; i < shown.columns(); ++i) wrong.push_back(shown.complete && contradicts_theory(shown, i, j));
}

std::optional<std::pair<Index, Index>> MapPlaces::cell(const StabilityMap& map, Point at) const {
    if (!area.contains(at)) return std::nullopt;
    const auto i = static_cast<Index>((at.x - area.min.x) / area.width() * static_cast<float>(map.columns())),
               j = static_cast<Index>((area.max.y - at.y) / area.height() * static_cast<float>(map.rows()));
    return std::pair{std::clamp<Index>(i, 0, map.columns() - 1), std::clamp<Index>(j, 0, map.rows() - 1)};
}

Point MapPlaces::point(const StabilityMap& map, MapPlace place) const {
    const Real x = (place.across + 0.5) / static_cast<Real>(map.columns()), y = (place.up + 0.5) / static_cast<Real>(map.rows());
    return {area.min.x + static_cast<float>(x) * area.width(), area.max.y - static_cast<float>(y) * area.height()};
}

Box MapPlaces::box(const StabilityMap& map, Index i, Index j) const {
    const Point low = point(map, {static_cast<Real>(i) - 0.5, static_cast<Real>(j) - 0.5}),
                high = point(map, {static_cast<Real>(i) + 0.5, static_cast<Real>(j) + 0.5});
    return {{std::round(low.x), std::round(high.y)}, {std::round(high.x), std::round(low.y)}};
}

MapPlaces draw_map(Canvas& canvas, Box whole, const MapPicture& picture, const PlotStyle& style, bool legend_beside) {
    return Drawer(canvas, whole, picture, style, legend_beside).draw();
}

}  // namespace pliant::viewer
