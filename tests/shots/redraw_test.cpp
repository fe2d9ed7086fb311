// When the window draws, told the time by the test.
#include "app/redraw.h"
#include "app/lab.h"

#include <imgui.h>

#include <catch2/catch_test_macros.hpp>

using namespace pliant;
using namespace pliant::viewer;

namespace {

// The frames of so many seconds, as the window draws them: it looks every millisecond.
int frames_drawn(Redraw& redraw, Real& now, Real seconds, Real change_in) {
    int drawn = 0;
    for (const Real end = now + seconds; now < end; now += 1e-3)
        if (redraw.due(now)) redraw.drawn(now, change_in), ++drawn;
    return drawn;
}

}  // namespace

TEST_CASE("what does not change is not drawn", "[redraw]") {
    Redraw redraw;
    Real now = 0;
    CHECK(frames_drawn(redraw, now, 2, Redraw::never) == Redraw::settle_frames);
    CHECK(redraw.resting(now));
    CHECK(redraw.wait(now) == Redraw::longest_wait);
    CHECK(frames_drawn(redraw, now, 3600, Redraw::never) == 0);

    // An input is drawn at once, and for as long as tips and popups take.
    redraw.input(now);
    CHECK(redraw.wait(now) == 0);
    CHECK_FALSE(redraw.resting(now));
    const int frames = frames_drawn(redraw, now, 5, Redraw::never);
    CHECK(frames >= Redraw::settle_frames);
    CHECK(frames <= 1 + Redraw::settle_seconds / Redraw::frame_seconds);
    CHECK(redraw.resting(now));
}

TEST_CASE("what moves is drawn sixty times a second, whatever the machine can", "[redraw]") {
    Redraw redraw;
    Real now = 0;
    const int frames = frames_drawn(redraw, now, 10, 0);
    CHECK(frames <= 600);
    CHECK(frames >= 580);  // each waits for the next millisecond
}

TEST_CASE("what changes now and then is drawn so often", "[redraw]") {
    Redraw redraw;
    Real now = 0;
    frames_drawn(redraw, now, 1, 0.1);
    CHECK(redraw.resting(now));
    const int frames = frames_drawn(redraw, now, 10, 0.1);
    CHECK(frames >= 98);
    CHECK(frames <= 101);
}

TEST_CASE("a lab that is left alone changes no more; one that plays does", "[redraw]") {
    const auto context = open_headless({640, 400});
    Lab lab(*context);
    for (const LessonEntry& entry : lessons()) {
        CAPTURE(entry.info.id);
        lab.session().open(entry);
        for (int i = 0; i < 3; ++i) lab.frame(0.02);
        CHECK(lab.next_change() == Redraw::never);
        CHECK_FALSE(lab.has_input());
        lab.session().playing = true;
        CHECK(lab.next_change() == 0);
        lab.session().playing = false;
    }
    ImGui::GetIO().AddMousePosEvent(100, 100);
    CHECK(lab.has_input());
    lab.frame(0.02);
    CHECK_FALSE(lab.has_input());
    lab.perform(Action::save_scene_picture);
    lab.state().files.cancel();
    CHECK(lab.next_change() == Redraw::never);
}

TEST_CASE("the cursor of a text that is typed blinks, and nothing else", "[redraw]") {
    const auto context = open_headless({640, 400});
    Lab lab(*context);
    lab.frame(0.02);
    lab.perform(Action::find);
    for (int i = 0; i < 60 && !ImGui::GetIO().WantTextInput; ++i) lab.frame(0.02);
    REQUIRE(ImGui::GetIO().WantTextInput);
    for (int i = 0; i < 100; ++i) {
        const Real wait = lab.next_change();
        REQUIRE(wait > 0);
        REQUIRE(wait <= 1.1);  // shown for 0.8 s of 1.2 s, and for 0.3 s more after a key
        lab.frame(0.03);
    }
}
