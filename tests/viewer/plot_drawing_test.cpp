// Whole plots, drawn on a canvas that only takes notes.
#include "special_numbers.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include "plot/draw.h"
#include "plot/svg_canvas.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

namespace {

constexpr Rgba8 undrawn{};

class Notes final : public Canvas {
public:
    explicit Notes(float line_height = 18) : em_(line_height) {}

    struct Text {
        std::string words;
        Box box;
    };
    std::vector<Text> texts;
    std::vector<Point> points;   // of everything drawn
    std::vector<Rgba8> colours;  // of lines
    std::vector<float> widths;   // of lines
    std::size_t open_clips = 0;

    void fill(Box box, Rgba8) override { points.insert(points.end(), {box.min, box.max}); }
    void line(std::span<const Point> line, Rgba8 colour, float width) override {
        points.insert(points.end(), line.begin(), line.end());
        colours.push_back(colour);
        widths.push_back(width);
    }
    void polygon(std::span<const Point> corners, Rgba8) override { points.insert(points.end(), corners.begin(), corners.end()); }
    void text(Point at, Rgba8, std::string_view words) override {
        const Point size = text_size(words);
        if (!words.empty()) texts.push_back({std::string(words), {at, {at.x + size.x, at.y + size.y}}});
    }
    Point text_size(std::string_view words) const override {
        const auto letters = std::ranges::count_if(words, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
        return {0.55f * em_ * static_cast<float>(letters), em_};
    }
    void push_clip(Box) override { ++open_clips; }
    void pop_clip() override { --open_clips; }

private:
    float em_;
};

std::vector<Real> sampled(
    Real from, Real to, const std::function<Real(Real)>& f = [](Real x) { return x; }) {
    std::vector<Real> values;
    for (int i = 0; i <= 200; ++i) values.push_back(f(from + (to - from) * i / 200));
    return values;
}

Series series(std::string name, std::vector<Real> xs, std::vector<Real> ys, SeriesKind kind = SeriesKind::line) {
    return {std::move(name), kind, std::move(xs), std::move(ys), {}};
}

PlotModel plot_of(Axes axes, std::vector<Series> curves = {}) {
    PlotModel model;
    model.title = "Energy";
    model.axes = std::move(axes);
    model.series = std::move(curves);
    return model;
}

struct Drawn {
    PlotView view;
    PlotLayout layout;
    Notes notes;
};

Drawn draw(const PlotModel& model, PlotMemory& memory, Point size = {420, 260}, float line_height = 18) {
    Drawn drawn{{}, {}, Notes(line_height)};
    DrawBuffers buffers;
    const PlotStyle style = plot_style(PlotTheme::projector, line_height / 18);
    drawn.view = current_view(model, memory);
    drawn.layout = lay_out({{7, 9}, {7 + size.x, 9 + size.y}}, model, memory, drawn.view, drawn.notes);
    draw_plot({drawn.notes, model, memory, drawn.view, drawn.layout, style, buffers, drawn.layout.x_map(drawn.view),
               drawn.layout.y_map(drawn.view)});
    return drawn;
}

Drawn draw(const PlotModel& model) {
    PlotMemory memory;
    return draw(model, memory);
}

template <class... Curves>
std::vector<Series> list(Curves&&... curves) {
    std::vector<Series> result;
    (result.push_back(std::move(curves)), ...);
    return result;
}

// Plots with something awkward about each.
std::vector<PlotModel> awkward_plots() {
    const Real inf = std::numeric_limits<Real>::infinity();
    const Axes plain{{"time t", "s"}, {"energy E", "J"}},
        logs{{"Δt", "s", AxisScale::log}, {"error ‖u − u*‖₂", "m", AxisScale::log}};
    const auto t = sampled(0, 9.3);
    std::vector<PlotModel> plots;
    plots.push_back(plot_of(plain));
    plots.push_back(plot_of(plain, list(series("none", {}, {}))));
    plots.push_back(plot_of(plain, list(series("one", {0.3}, {2.5}))));
    plots.push_back(plot_of(plain, list(series("constant", t, sampled(0, 1, [](Real) { return -4.0; })))));
    plots.push_back(
        plot_of(plain, list(series("gaps", t, sampled(0, 9, [](Real x) { return std::fmod(x, 2) < 1 ? not_a_number : x; })))));
    plots.push_back(plot_of(plain, list(series("never finite", {1, 2, 3}, {not_a_number, inf, -inf}))));
    plots.push_back(plot_of(plain, list(series("huge", {0, 1, 2}, {-1e300, 1e300, 1e307}))));
    plots.push_back(plot_of(plain, list(series("tiny", {0, 1e-300, 2e-300}, {-1e-299, 1e-300, 0}))));
    plots.push_back(plot_of(plain, list(series("offset", t, sampled(0, 9, [](Real x) { return 1e6 + 0.002 * std::sin(x); })))));
    plots.push_back(plot_of(
        logs, list(series("fourth order", {1e-4, 1e-3, 1e-2}, {1e-12, 1e-8, 1e-4}), series("all negative", {1, 2}, {-1, -2}))));
    plots.push_back(plot_of(logs, list(series("all negative", {1, 2}, {-1, -2}))));
    PlotModel crowd = plot_of(plain);
    crowd.title = "A title that is far longer than any plot is wide, with σ = λ tr(ε) I + 2 μ ε in it";
    for (int i = 0; i < 9; ++i)
        crowd.series.push_back(series("a long name of a series, number " + std::to_string(i), sampled(0, 9.3), sampled(i, 9),
                                      i % 3 == 0   ? SeriesKind::points
                                      : i % 3 == 1 ? SeriesKind::line
                                                   : SeriesKind::reference));
    for (int i = 0; i < 5; ++i) {
        crowd.guides.push_back({true, 2.0 + 0.01 * i, "limit " + std::to_string(i), Dash::dashed});
        crowd.guides.push_back({false, 5.0 + 40 * i, "level " + std::to_string(i), Dash::dotted});
    }
    crowd.guides.push_back({true, not_a_number, "nowhere", Dash::solid});
    plots.push_back(std::move(crowd));
    PlotModel heat = plot_of({{"k", "N/m", AxisScale::log}, {"Δt", "s"}});
    std::vector<Real> cells(30 * 20, 3e5);
    cells[17] = not_a_number;
    cells[18] = -inf;
    cells[19] = -2e5;
    heat.heat = HeatMap{"pressure p", "Pa", std::move(cells), 30, 20, {1, 1e4}, {0, 0.1}, ColourMap::diverging};
    plots.push_back(std::move(heat));
    return plots;
}

bool overlap(Box a, Box b) {
    return a.min.x < b.max.x - 0.01f && b.min.x < a.max.x - 0.01f && a.min.y < b.max.y - 0.01f && b.min.y < a.max.y - 0.01f;
}

}  // namespace

TEST_CASE("Nothing that is not finite is drawn, at any size") {
    for (const PlotModel& model : awkward_plots()) {
        for (const Point size : {Point{1, 1}, {20, 300}, {300, 20}, {60, 60}, {200, 120}, {420, 260}, {1900, 1000}}) {
            PlotMemory memory;
            const Drawn drawn = draw(model, memory, size);
            CAPTURE(model.title, size.x, size.y);
            REQUIRE(drawn.notes.open_clips == 0);
            REQUIRE(
                std::ranges::all_of(drawn.notes.points, [](Point p) { return std::abs(p.x) < 5000 && std::abs(p.y) < 5000; }));
        }
    }
}

TEST_CASE("Words stay inside the plot and cover no other words") {
    for (const PlotModel& model : awkward_plots()) {
        for (const Point size : {Point{200, 120}, {260, 170}, {300, 240}, {420, 260}, {900, 600}}) {
            for (const float line_height : {18.0f, 27.0f}) {
                const float scale = line_height / 18;
                PlotMemory memory;
                const Drawn drawn = draw(model, memory, {size.x * scale, size.y * scale}, line_height);
                auto texts = drawn.notes.texts;
                // The title is written twice to be bold.
                if (texts.size() > 1 && texts[0].words == texts[1].words) texts.erase(texts.begin());
                const Box whole = drawn.layout.whole;
                for (std::size_t i = 0; i < texts.size(); ++i) {
                    CAPTURE(model.title, size.x, size.y, scale, texts[i].words);
                    CHECK(texts[i].box.min.x >= whole.min.x - 0.01f);
                    CHECK(texts[i].box.max.x <= whole.max.x + 0.01f);
                    CHECK(texts[i].box.min.y >= whole.min.y - 0.01f);
                    CHECK(texts[i].box.max.y <= whole.max.y + 0.01f);
                    for (std::size_t k = 0; k < i; ++k) {
                        CAPTURE(texts[k].words);
                        CHECK_FALSE(overlap(texts[i].box, texts[k].box));
                    }
                }
            }
        }
    }
}

TEST_CASE("No line of the projector theme is thinner than 2 px") {
    for (const PlotModel& model : awkward_plots()) {
        const Drawn drawn = draw(model);
        CHECK(std::ranges::all_of(drawn.notes.widths, [](float width) { return width >= 2; }));
    }
}

TEST_CASE("Units are always on the picture") {
    const Axes axes{{"time t", "s"}, {"energy E", "J"}};
    for (const Point size : {Point{200, 120}, {420, 260}}) {
        for (const bool filled : {false, true}) {
            PlotModel model = plot_of(axes);
            model.series.push_back(filled ? series("E", sampled(0, 9), sampled(0, 9)) : series("E", {}, {}));
            PlotMemory memory;
            const Drawn drawn = draw(model, memory, size);
            const auto holds = [&](const std::string& part) {
                return std::ranges::any_of(drawn.notes.texts,
                                           [&](const Notes::Text& text) { return text.words.find(part) != std::string::npos; });
            };
            CAPTURE(size.x, filled);
            CHECK(holds("[s]"));
            CHECK(holds("[J]"));
        }
    }
}

TEST_CASE("A label that begins with the title takes its place and leaves more room for the picture") {
    const auto layout = [](const std::string& label) {
        Axes axes{{"time t", "s"}, {label, "J"}};
        axes.y.range = Range{2e6, 2e6 + 20};
        PlotMemory memory;
        return draw(plot_of(axes, list(series("measured", sampled(0, 9), sampled(2e6, 2e6 + 20)), series("b", {}, {}))), memory,
                    {680, 170})
            .layout;
    };
    const PlotLayout same = layout("Energy E"), other = layout("kinetic E");
    CHECK(same.title.text == "Energy E = 2000000 J + … [J]");
    CHECK(same.y_label.text.empty());
    CHECK(other.title.text == "Energy");
    CHECK(other.y_label.text == "kinetic E = 2000000 J + … [J]");
    CHECK(same.area.height() > other.area.height());
}

TEST_CASE("An empty plot says what to do, and one whose curves cannot be seen says why") {
    const auto hint = [](PlotModel model, std::vector<std::string> hidden = {}) {
        PlotMemory memory;
        for (auto& name : hidden) memory.hidden.insert(name);
        return current_view(model, memory).hint;
    };
    const Axes plain{{"t", "s"}, {"E", "J"}}, log{{"t", "s"}, {"E", "J", AxisScale::log}};
    CHECK(hint(plot_of(plain)) == "no data yet: press Space");
    CHECK(hint(plot_of(log, list(series("E", {1, 2}, {-1, 0})))) == "no positive values for the log axis");
    CHECK(hint(plot_of(plain, list(series("E", {1}, {not_a_number})))) == "no finite values");
    CHECK(hint(plot_of(plain, list(series("E", {1}, {1}))), {"E"}) == "every curve is hidden");
    CHECK(hint(plot_of(plain, list(series("E", {1}, {1})))).empty());
}

TEST_CASE("A range that a person has fixed stays, and says so, until it is reset") {
    PlotMemory memory;
    const auto model_until = [](Real end) {
        return plot_of({{"time t", "s"}, {"E", "J"}}, list(series("E", sampled(0, end), sampled(0, end))));
    };
    draw(model_until(10), memory);
    memory.x.fixed = Range{2, 3};
    const Drawn fixed = draw(model_until(500), memory);
    CHECK(fixed.view.x == Range{2, 3});
    CHECK(fixed.layout.x_label.text == "time t [s] · fixed range");
    reset_axis(memory.x);
    const Drawn free = draw(model_until(500), memory);
    CHECK(free.view.x == Range{0, 500});
    CHECK(free.layout.x_label.text == "time t [s]");
}

TEST_CASE("The range given with an axis holds until the person zooms") {
    PlotMemory memory;
    Axes axes{{"x", "m"}, {"u", "m"}};
    axes.y.range = Range{-1, 1};
    const PlotModel model = plot_of(axes, list(series("u", {0, 1}, {0, 5})));
    CHECK(current_view(model, memory).y == Range{-1, 1});
    memory.y.fixed = Range{0, 6};
    CHECK(current_view(model, memory).y == Range{0, 6});
}

TEST_CASE("After a reset of the lesson the axes start over") {
    PlotMemory memory;
    const auto run = [](Real end, Real amplitude) {
        return plot_of(
            {{"t", "s"}, {"u", "m"}},
            list(series("u", sampled(0, end), sampled(0, end, [=](Real t) { return amplitude * std::sin(9 * t / end); }))));
    };
    CHECK(current_view(run(50, 100), memory).y.hi >= 100);
    const PlotView again = current_view(run(0.5, 1), memory);
    CHECK(again.x.hi < 1);
    CHECK(again.y.hi < 2);
}

TEST_CASE("A hidden curve is not drawn and does not widen the axes, but keeps its colour") {
    PlotModel model =
        plot_of({{"t", "s"}, {"u", "m"}}, list(series("large", {0, 1}, {0, 1000}), series("small", {0, 1}, {0, 1})));
    const PlotStyle style = plot_style(PlotTheme::projector, 1);
    const Rgba8 large = look_of(model, 0, style).colour, small = look_of(model, 1, style).colour;
    PlotMemory memory;
    memory.hidden.insert("large");
    const Drawn drawn = draw(model, memory);
    CHECK(drawn.view.y.hi < 2);
    CHECK(look_of(model, 1, style).colour == small);
    CHECK(std::ranges::count(drawn.notes.colours, large) == 0);
    CHECK(std::ranges::count(drawn.notes.colours, small) > 0);
    CHECK_FALSE(large == undrawn);
}

TEST_CASE("References are dashed, and curves of one plot differ without colour") {
    const PlotModel model =
        plot_of({}, list(series("a", {0}, {0}), series("exact", {0}, {0}, SeriesKind::reference), series("b", {0}, {0}),
                         series("published", {0}, {0}, SeriesKind::reference), series("p", {0}, {0}, SeriesKind::points)));
    const PlotStyle style = plot_style(PlotTheme::dark, 1);
    CHECK(look_of(model, 0, style).dash == Dash::solid);
    CHECK(look_of(model, 1, style).dash == Dash::dashed);
    CHECK(look_of(model, 3, style).dash == Dash::dotted);
    CHECK(look_of(model, 0, style).marker != look_of(model, 2, style).marker);
    CHECK(look_of(model, 2, style).marker != look_of(model, 4, style).marker);
    CHECK(look_of(plot_of({}, list(series("a", {0}, {0}))), 0, style).marker == Marker::none);
}

TEST_CASE("Colours of a diverging map lie about zero and do not change while the field stays within them") {
    PlotMemory memory;
    const auto field = [](Real size) {
        PlotModel model = plot_of({{"x", "m"}, {"y", "m"}});
        model.heat =
            HeatMap{"p", "Pa", std::vector<Real>{size, -0.1 * size, 0, not_a_number}, 2, 2, {0, 1}, {0, 1}, ColourMap::diverging};
        return model;
    };
    const Range full = current_view(field(7), memory).colour;
    CHECK(full.lo == -full.hi);
    CHECK(full.contains(Range{-7, 7}));
    CHECK(current_view(field(0.3), memory).colour == full);
    CHECK(current_view(field(-6), memory).colour == full);
    CHECK(current_view(field(70), memory).colour.hi >= 70);
}

TEST_CASE("Cells of a heat map are evenly wide on the scale that the axis was declared with") {
    CHECK(cell_edge({0, 3}, AxisScale::linear, 3, 1) == Catch::Approx(1));
    CHECK(cell_edge({1, 1000}, AxisScale::log, 3, 2) == Catch::Approx(100));
    CHECK(cell_edge({1, 1000}, AxisScale::log, 3, 3) == 1000);
}

TEST_CASE("The SVG of a plot is complete, and the same every time") {
    for (const PlotModel& model : awkward_plots()) {
        std::string documents[2];
        for (std::string& document : documents) {
            const Notes measure;
            SvgCanvas canvas({{0, 0}, {420, 260}}, measure);
            PlotMemory memory;
            DrawBuffers buffers;
            const PlotView view = current_view(model, memory);
            const PlotLayout layout = lay_out({{0, 0}, {420, 260}}, model, memory, view, canvas);
            draw_plot({canvas, model, memory, view, layout, plot_style(PlotTheme::light, 1), buffers, layout.x_map(view),
                       layout.y_map(view)});
            document = canvas.document();
        }
        CHECK(documents[0] == documents[1]);
        CHECK(documents[0].starts_with("<svg "));
        CHECK(documents[0].ends_with("</svg>\n"));
        const auto count = [&](const std::string& tag) {
            std::size_t found = 0;
            for (std::size_t at = documents[0].find(tag); at != std::string::npos; at = documents[0].find(tag, at + 1)) ++found;
            return found;
        };
        CHECK(count("<g ") == count("</g>"));
        CHECK(count("nan") == 0);
        CHECK(count("inf\"") == 0);
    }
}

TEST_CASE("The last number along an axis ends with the plot, and keeps clear of the one before it") {
    const Notes canvas(15);
    const float em = canvas.line_height(), length = 220;
    for (const Range range : {Range{0, 0.02}, Range{0, 0.2}, Range{0.3, 0.5}, Range{1, 1.006}, Range{-3e-3, 3e-3}}) {
        const Ticks ticks = ticks_that_fit(range, AxisScale::linear, "s", length, false, canvas);
        const AxisMap map(range, AxisScale::linear, 0, length);
        float end = -1000;
        for (const Tick& tick : ticks.ticks) {
            const float size = canvas.text_size(tick.text).x, middle = static_cast<float>(map.pixel(tick.value));
            const float start = std::min(middle - size / 2, length + beside_area * em - size);
            CAPTURE(range.lo, range.hi, tick.text);
            CHECK(start >= end + 0.15f * em - 0.01f);
            end = start + size;
        }
    }
}

TEST_CASE("a name that is cut keeps whole words or three letters of one, and a run its letter") {
    const Notes canvas(10);  // 5.5 px a letter
    CHECK(shortened(canvas, "implicit midpoint", 100) == "implicit midpoint");
    CHECK(shortened(canvas, "implicit midpoint", 75) == "implicit mid…");
    CHECK(shortened(canvas, "implicit midpoint", 69) == "implicit…");
    CHECK(shortened(canvas, "implicit midpoint", 15).empty());
    CHECK(shortened(canvas, "Φ of the cell", 40) == "Φ of…");
    CHECK(shortened_name(canvas, "A  implicit Euler", 15) == "A");
    CHECK(shortened_name(canvas, "A  implicit Euler", 45) == "A  impl…");
    CHECK(shortened_name(canvas, "implicit Euler", 15).empty());
}
