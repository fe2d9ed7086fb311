// A hand on a plot: events go into ImGui, which needs no screen for this.
#include <imgui.h>
#include <pliant/math/error.h>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "plot/plot.h"

#include <string>
#include <vector>

using namespace pliant;
using namespace pliant::viewer;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;

namespace {

// One plot of 400 x 300 px in the corner of a window.
class Hand {
public:
    std::vector<Real> xs, rising, falling;
    PlotState plots;
    std::string svg;
    std::vector<PlotShot> shots;

    Hand() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
        io.DisplaySize = {800, 600};
        io.DeltaTime = 1.0f / 60;
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
        io.SetClipboardTextFn = [](void* user, const char* text) { *static_cast<std::string*>(user) = text; };
        io.ClipboardUserData = &clipboard_;
        for (int i = 0; i <= 100; ++i) {
            xs.push_back(0.1 * i);
            rising.push_back(i);
            falling.push_back(100 - i);
        }
        for (int i = 0; i < 3; ++i) frame();
    }
    ~Hand() { ImGui::DestroyContext(); }
    Hand(const Hand&) = delete;
    Hand& operator=(const Hand&) = delete;

    void frame() {
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({800, 600});
        ImGui::Begin("window", nullptr, ImGuiWindowFlags_NoDecoration);
        PlotHooks hooks;
        hooks.save_png = [this](const PlotShot& shot) { shots.push_back(shot); };
        hooks.save_svg = [this](const std::string&, const std::string& text) { svg = text; };
        Plot plot(plots, plot_style(PlotTheme::dark, 1), hooks);
        REQUIRE(plot.begin("Plot", {400, 300}, {{"time t", "s"}, {"force f", "N"}}));
        id_ = ImGui::GetID("##plot");
        plot.line("rising", xs, rising);
        plot.line("falling", xs, falling);
        plot.end();
        ImGui::End();
        ImGui::EndFrame();
    }

    void move(Point at) {
        ImGui::GetIO().AddMousePosEvent(at.x, at.y);
        frame();
    }
    void button(int which, bool down) {
        ImGui::GetIO().AddMouseButtonEvent(which, down);
        frame();
    }
    void click(Point at, int which = 0) {
        move(at);
        button(which, true);
        button(which, false);
        frame();
    }
    void drag(Point from, Point to, int which) {
        move(from);
        button(which, true);
        move({(from.x + to.x) / 2, (from.y + to.y) / 2});
        move(to);
        button(which, false);
    }
    void wheel(Point at, float notches) {
        move(at);
        ImGui::GetIO().AddMouseWheelEvent(0, notches);
        frame();
    }
    void key(ImGuiKey which) {
        ImGui::GetIO().AddKeyEvent(which, true);
        frame();
        ImGui::GetIO().AddKeyEvent(which, false);
        frame();
    }
    void wait() {
        for (int i = 0; i < 60; ++i) frame();
    }

    PlotMemory& memory() { return plots.of(id_).memory; }
    const std::string& clipboard() const { return clipboard_; }

    // Where the parts of the plot lie: the same layout as its own.
    PlotLayout layout() {
        const PlotModel model = this->model();
        const Measure measure;
        const PlotView view = current_view(model, memory());
        return lay_out({{8, 8}, {408, 308}}, model, memory(), view, measure);
    }
    PlotView view() { return current_view(model(), memory()); }
    Point middle() {
        const Box area = layout().area;
        return {(area.min.x + area.max.x) / 2, (area.min.y + area.max.y) / 2};
    }

private:
    struct Measure final : Canvas {
        void fill(Box, Rgba8) override {}
        void line(std::span<const Point>, Rgba8, float) override {}
        void polygon(std::span<const Point>, Rgba8) override {}
        void text(Point, Rgba8, std::string_view) override {}
        Point text_size(std::string_view words) const override {
            const ImVec2 size = ImGui::CalcTextSize(words.data(), words.data() + words.size());
            return {size.x, size.y};
        }
        void push_clip(Box) override {}
        void pop_clip() override {}
    };
    PlotModel model() {
        PlotModel model;
        model.title = "Plot";
        model.axes = {{"time t", "s"}, {"force f", "N"}};
        model.series.push_back({"rising", SeriesKind::line, xs, rising});
        model.series.push_back({"falling", SeriesKind::line, xs, falling});
        return model;
    }

    unsigned id_ = 0;
    std::string clipboard_;
};

}  // namespace

TEST_CASE("The wheel zooms about the pointer and a double click goes back") {
    Hand hand;
    const Range all_x = hand.view().x, all_y = hand.view().y;
    const PlotLayout before = hand.layout();
    const Point at{before.area.min.x + 100, before.area.min.y + 50};
    const Real x = before.x_map(hand.view()).value(at.x), y = before.y_map(hand.view()).value(at.y);
    hand.wheel(at, 2);
    CHECK(hand.view().x.span() < 0.8 * all_x.span());
    const PlotLayout after = hand.layout();
    // The numbers of y may have become wider, so the place counts in parts of the picture.
    const Real part = (at.x - before.area.min.x) / before.area.width();
    CHECK(value_at(hand.view().x, AxisScale::linear, part) == Catch::Approx(x));
    CHECK(after.y_map(hand.view()).value(at.y) == Catch::Approx(y));

    hand.wait();
    hand.click(at);
    hand.click(at);
    CHECK(hand.view().x == all_x);
    CHECK(hand.view().y == all_y);
}

TEST_CASE("On the numbers of an axis the wheel and a drag act on that axis alone") {
    Hand hand;
    const Range all_x = hand.view().x, all_y = hand.view().y;
    const PlotLayout layout = hand.layout();
    const Point below{hand.middle().x, layout.area.max.y + 10}, beside{layout.area.min.x - 8, hand.middle().y};
    hand.wheel(below, 3);
    CHECK(hand.view().x.span() < 0.8 * all_x.span());
    CHECK(hand.view().y == all_y);
    const Range zoomed_x = hand.view().x;
    hand.drag(beside, {beside.x, beside.y + 40}, 0);
    CHECK(hand.view().x == zoomed_x);
    // Pulled down: higher values come into sight.
    CHECK(hand.view().y.lo > all_y.lo);
}

TEST_CASE("A drag carries the picture along") {
    Hand hand;
    const PlotLayout layout = hand.layout();
    const Real x = layout.x_map(hand.view()).value(hand.middle().x);
    const Point from = hand.middle(), to{from.x - 60, from.y + 30};
    hand.drag(from, to, 0);
    CHECK(hand.layout().x_map(hand.view()).value(to.x) == Catch::Approx(x).epsilon(1e-3));
    CHECK(hand.memory().x.fixed);
}

TEST_CASE("A drag with the right button zooms to its box and opens no menu") {
    Hand hand;
    const PlotLayout layout = hand.layout();
    const Point a{layout.area.min.x + 50, layout.area.min.y + 40}, b{a.x + 120, a.y + 60};
    const AxisMap x = layout.x_map(hand.view()), y = layout.y_map(hand.view());
    hand.drag(b, a, 1);
    CHECK(hand.view().x.lo == Catch::Approx(x.value(a.x)));
    CHECK(hand.view().x.hi == Catch::Approx(x.value(b.x)));
    CHECK(hand.view().y.lo == Catch::Approx(y.value(b.y)));
    CHECK(hand.view().y.hi == Catch::Approx(y.value(a.y)));
    CHECK_FALSE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
}

TEST_CASE("A click in the legend hides a curve and another one shows it again") {
    Hand hand;
    const Box entry = hand.layout().legend.at(1).box;
    const Point at{(entry.min.x + entry.max.x) / 2, (entry.min.y + entry.max.y) / 2};
    hand.click(at);
    CHECK(hand.memory().hidden.contains("falling"));
    hand.wait();
    hand.click(at);
    CHECK(hand.memory().hidden.empty());
}

TEST_CASE("A click that does not drag changes nothing") {
    Hand hand;
    hand.click(hand.middle());
    CHECK_FALSE(hand.memory().x.fixed);
    CHECK_FALSE(hand.memory().y.fixed);
}

TEST_CASE("The menu opens by a right click, by its switch and by the keys, and copies the samples with their units") {
    Hand hand;
    SECTION("right click") { hand.click(hand.middle(), 1); }
    SECTION("switch") {
        const Box menu = hand.layout().menu;
        hand.click({(menu.min.x + menu.max.x) / 2, (menu.min.y + menu.max.y) / 2});
    }
    SECTION("keys") {
        hand.key(ImGuiKey_DownArrow);
        hand.key(ImGuiKey_Enter);
    }
    hand.frame();
    REQUIRE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
    // The entries of the menu loop: the one above the first is the last, SVG, and CSV stands two above that.
    hand.key(ImGuiKey_Home);
    for (int i = 0; i < 3; ++i) hand.key(ImGuiKey_UpArrow);
    hand.key(ImGuiKey_Enter);
    CHECK_THAT(hand.clipboard(), StartsWith("time t [s],rising [N],falling [N]\r\n0,0,100\r\n0.1,1,99\r\n"));
}

TEST_CASE("The menu hands out the plot as SVG, and where it stands for a picture without menu and pointer") {
    Hand hand;
    hand.click(hand.middle(), 1);
    hand.key(ImGuiKey_Home);
    hand.key(ImGuiKey_UpArrow);
    hand.key(ImGuiKey_Enter);
    CHECK_THAT(hand.svg, StartsWith("<svg "));
    CHECK_THAT(hand.svg, ContainsSubstring("force <tspan font-style=\"italic\">f</tspan> [N]"));

    hand.click(hand.middle(), 1);
    hand.key(ImGuiKey_Home);
    hand.key(ImGuiKey_UpArrow);
    hand.key(ImGuiKey_UpArrow);
    hand.key(ImGuiKey_Enter);
    REQUIRE(hand.shots.size() == 1);
    CHECK(hand.shots[0].title == "Plot");
    CHECK((hand.shots[0].left == 8 && hand.shots[0].top == 8 && hand.shots[0].width == 400 && hand.shots[0].height == 300));
    CHECK_FALSE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
}

TEST_CASE("Curves whose numbers do not pair, and grids that do not fill, are refused by name") {
    Hand hand;
    ImGui::NewFrame();
    ImGui::Begin("window");
    Plot plot(hand.plots, plot_style(PlotTheme::dark, 1));
    REQUIRE(plot.begin("Plot", {400, 300}, {}));
    CHECK_THROWS_AS(plot.line("odd", std::vector<Real>{1, 2}, std::vector<Real>{1}), Refused);
    CHECK_THROWS_AS(
        plot.heat_map(
            {.name = "p", .unit = "", .values = std::vector<Real>{1, 2, 3}, .nx = 2, .ny = 2, .x = {0, 1}, .y = {0, 1}}),
        Refused);
    plot.end();
    ImGui::End();
    ImGui::EndFrame();
}
