// Contexts without a display: what they draw, and that they agree.
#include <imgui.h>
#include <pliant/math/error.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "platform/context.h"
#include "platform/font.h"
#include "platform/gl.h"
#include "platform/gui.h"
#include "platform/image.h"
#include "plot/plot.h"

#include <array>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

using namespace pliant;
using namespace pliant::viewer;
using Catch::Matchers::ContainsSubstring;

namespace {

// The context, or a skipped test where this machine lacks its library.
std::unique_ptr<Context> open_or_skip(Backend backend, Size size) {
    try {
        return open_context(backend, size);
    } catch (const MachineLacks& lack) {
        SKIP(lack.what());
    }
    return nullptr;
}

void clear(float red, float green, float blue) {
    glClearColor(red, green, blue, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

// A page with type, curves and a heat map, after the frames that ImGui needs to settle.
Image page(Context& context) {
    Gui gui(context);
    add_fonts(std::array{15.f});
    std::vector<Real> xs, ys, cells;
    for (int i = 0; i < 300; ++i) {
        xs.push_back(0.01 * i);
        ys.push_back(0.5 * i * (300 - i));
        cells.push_back(i % 20);
    }
    PlotState plots;
    for (int frame = 0; frame < 3; ++frame) {
        clear(0.1f, 0.2f, 0.3f);
        gui.begin_frame(1.0 / 60);
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({640, 480});
        ImGui::Begin("page", nullptr, ImGuiWindowFlags_NoDecoration);
        Plot plot(plots, plot_style(PlotTheme::dark, 1));
        if (plot.begin("σ and ∇ψ", {600, 220}, {{"time t", "s"}, {"stress σ", "Pa"}})) {
            plot.line("σ₁₁", xs, ys);
            plot.reference("exact", xs, ys);
            plot.end();
        }
        if (plot.begin("field", {600, 220}, {{"x", "m"}, {"y", "m"}})) {
            plot.heat_map({.name = "p", .unit = "Pa", .values = cells, .nx = 20, .ny = 15, .x = {0, 1}, .y = {0, 1}});
            plot.end();
        }
        ImGui::End();
        gui.end_frame();
    }
    Image image = read_pixels(context);
    context.present();
    return image;
}

}  // namespace

TEST_CASE("A headless context clears to exactly the colour asked for, top row first") {
    for (const Backend backend : {Backend::osmesa, Backend::egl}) {
        const auto context = open_or_skip(backend, {64, 32});
        clear(0.5f, 0.25f, 1.0f);
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 24, 64, 8);  // counted from the bottom: the upper quarter
        clear(1, 0, 0);
        glDisable(GL_SCISSOR_TEST);
        const Image image = read_pixels(*context);
        REQUIRE((image.width == 64 && image.height == 32));
        const auto top = image.row(0), bottom = image.row(31);
        CHECK((top[0] == 255 && top[1] == 0 && top[2] == 0));
        // No sRGB conversion: half is half.
        CHECK((bottom[0] == 128 && bottom[1] == 64 && bottom[2] == 255));
        CHECK(image.row(7)[0] == 255);
        CHECK(image.row(8)[0] == 128);
    }
}

TEST_CASE("OSMesa and EGL draw the same pixels") {
    const Image by_osmesa = page(*open_or_skip(Backend::osmesa, {640, 480}));
    const Image by_egl = page(*open_or_skip(Backend::egl, {640, 480}));
    CHECK(compare(by_osmesa, by_egl).largest == 0);
}

TEST_CASE("The same page gives the same pixels again, in the context made for it and in one resized to it") {
    const Image first = page(*open_headless({640, 480}));
    CHECK(page(*open_headless({640, 480})) == first);
    for (const Backend backend : {Backend::osmesa, Backend::egl}) {
        const auto context = open_or_skip(backend, {100, 900});
        context->resize({640, 480});
        CHECK(context->framebuffer_size() == Size{640, 480});
        CHECK(page(*context) == first);
    }
}

TEST_CASE("Two contexts live side by side") {
    const auto a = open_or_skip(Backend::osmesa, {8, 8});
    const auto b = open_or_skip(Backend::egl, {8, 8});
    for (int round = 0; round < 3; ++round) {
        a->make_current();
        clear(1, 0, 0);
        b->make_current();
        clear(0, 1, 0);
        CHECK(read_pixels(*a).row(0)[0] == 255);
        CHECK(read_pixels(*b).row(0)[1] == 255);
    }
}

TEST_CASE("A context goes on drawing when another one of its kind is closed") {
    for (const Backend backend : {Backend::osmesa, Backend::egl}) {
        auto a = open_or_skip(backend, {8, 8}), b = open_or_skip(backend, {8, 8});
        b.reset();
        a->make_current();
        clear(1, 0, 0);
        CHECK(read_pixels(*a).row(0)[0] == 255);
    }
}

TEST_CASE("The driver's variables are as before once a context is open") {
    setenv("GALLIUM_DRIVER", "softpipe", 1);
    unsetenv("LIBGL_ALWAYS_SOFTWARE");
    for (const Backend backend : {Backend::osmesa, Backend::egl}) {
        const auto context = open_or_skip(backend, {16, 16});
        CHECK_THAT(context->description(), ContainsSubstring("llvmpipe"));
        CHECK(std::getenv("GALLIUM_DRIVER") == std::string("softpipe"));
        CHECK(std::getenv("LIBGL_ALWAYS_SOFTWARE") == nullptr);
    }
    unsetenv("GALLIUM_DRIVER");
}

TEST_CASE("A picture of no size, or too large a size, is refused with the range") {
    for (const Size size : {Size{0, 480}, {640, -1}, {largest_side + 1, 480}}) {
        CHECK_THROWS_AS(open_headless(size), Refused);
        CHECK_THROWS_WITH(open_headless(size), ContainsSubstring(std::to_string(largest_side)));
    }
    const auto context = open_headless({16, 16});
    CHECK_THROWS_AS(context->resize({0, 0}), Refused);
    CHECK(context->framebuffer_size() == Size{16, 16});
}

TEST_CASE("Without a display a window is lacking, and the message says what to use instead") {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    CHECK_THROWS_AS(open_context(Backend::window, {640, 480}), MachineLacks);
    CHECK_THROWS_WITH(open_context(Backend::window, {640, 480}), ContainsSubstring("pliant shot"));
}

TEST_CASE("The clock of a headless frame must move") {
    const auto context = open_headless({32, 32});
    Gui gui(*context);
    CHECK_THROWS_AS(gui.begin_frame(0), Refused);
}

TEST_CASE("A typeface that is not there is lacking by name") {
    setenv("PLIANT_FONT", "/nowhere/type.ttf", 1);
    CHECK_THROWS_WITH(find_font(), ContainsSubstring("/nowhere/type.ttf"));
    unsetenv("PLIANT_FONT");
}
