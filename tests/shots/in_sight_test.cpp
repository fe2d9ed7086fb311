// What moves stays in the picture, from the first moment on and for as long as one looks.
#include "../every_lesson.h"
#include "app/deck_layout.h"
#include "app/lab.h"
#include "panels/colour_bar.h"
#include "render/moving_parts.h"
#include "unseen.h"

#include <pliant/text/texts.h>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

namespace {

// A window in which a scene is looked at.
class Onlooker {
public:
    explicit Onlooker(Size size = {480, 270}, Layout layout = Layout::slide) : context_(open_unseen(size)), lab(*context_) {
        lab.state().layout = layout;
        lab.state().scene.hints_shown = false;
    }
    void draw(Real seconds = 0) { lab.frame(seconds), context_->present(); }

    // The part of the picture's half width or height that lies between its middle and the outermost place that moves: up to 1 all
    // is in sight.
    float outermost() {
        Session& s = lab.session();
        const Rectangle place = lab.state().controls.at("scene");
        const float right = colour_bar_place(lab.state(), place.width).right, free = place.width - right;
        const Projection projection(s.seen_by(), s.lesson().dimension(), place.width, place.height, right);
        float most = 0;
        for (const Position& p : moving_parts(s.scene())) {
            const Eigen::Vector3f at = projection.pixel(p);
            if (at.z() >= 1) return 9;
            most = std::max({most, std::abs(2 * at.x() / free - 1), std::abs(2 * at.y() / place.height - 1)});
        }
        return most;
    }

private:
    std::unique_ptr<Context> context_;

public:
    Lab lab;
};

constexpr Real watched = 30;  // simulated seconds
constexpr int moments = 12;

// Steps that make up 30 s, but no more than 600 long ones, and of a scene with a large state no more than its size affords.
Index steps_to_watch(const Runner& r, const Lesson& lesson) {
    Index numbers = 1;
    for (const StateArray& array : lesson.state) numbers += static_cast<Index>(array.view().size());
    const Real dt = r.time_step(), affordable = std::max(150.0, 4e6 / static_cast<Real>(numbers));
    return static_cast<Index>(std::min({std::ceil(watched / dt), dt >= 0.005 ? 600.0 : 30000.0, affordable}));
}

void check_in_sight(Onlooker& watch) { CHECK(watch.outermost() <= 1.001f); }

// Plays a scene and looks at it now and then, more often at first. What moves in the picture is found by its ink; a scene whose
// marks never move is left after the first moments.
void watch_scene(Onlooker& watch, const SceneFile& scene) {
    Session& s = watch.lab.session();
    s.open_scene(scene);
    watch.draw();
    if (!scene.camera) check_in_sight(watch);
    if (s.runner().is_static()) {
        s.run(Until::at_rest());
        watch.draw();
        return check_in_sight(watch);
    }
    const Index steps = moving_parts(s.scene()).empty() ? 20 : steps_to_watch(s.runner(), s.lesson());
    for (int moment = 1; moment <= moments; ++moment) {
        const Real part = static_cast<Real>(moment) / moments;
        const auto until = static_cast<Index>(std::ceil(static_cast<Real>(steps) * part * part));
        try {
            s.run(Until::after_steps(until - s.runner().place().step));
        } catch (const Diverged&) {
            return;  // a torn body is nowhere
        }
        watch.draw();
        CAPTURE(scene.lesson, s.runner().place().step, s.runner().time());
        check_in_sight(watch);
        if (s.lesson().at_rest()) return;
    }
}

}  // namespace

TEST_CASE("the scene that the lab opens with stays in the picture", "[shots][sight]") {
    Onlooker watch({1440, 810}, Layout::lab);
    watch_scene(watch, {.lesson = "mesh/mass_spring", .parameters = {}});
}

TEST_CASE("every lesson: the first 30 s of it and of its presets stay in the picture", "[shots][sight][slow][every_lesson]") {
    Onlooker watch;
    for (const LessonEntry& entry : every_lesson()) {
        watch_scene(watch, {.lesson = std::string(entry.info.id), .parameters = {}});
        for (const std::string& name : preset_names(entry.info.id)) {
            CAPTURE(name);
            watch_scene(watch, preset(entry, name));
        }
    }
}

TEST_CASE("a scene that is drawn fills its room, in every layout", "[shots][sight]") {
    for (const Layout layout : {Layout::lab, Layout::slide})
        for (const LessonEntry& entry : lessons()) {
            Onlooker watch({1280, 720}, layout);
            Session& s = watch.lab.session();
            s.open(entry);
            watch.draw();
            watch.draw();
            CAPTURE(entry.info.id, name_of(layout));
            const Rectangle place = watch.lab.state().controls.at("scene");
            const float right = colour_bar_place(watch.lab.state(), place.width).right;
            const Frame frame = frame_of(s.scene(), s.lesson().dimension());
            // No nearer camera shows the whole frame, and what moves needs no farther one.
            CHECK(s.seen_by().distance <= 1.02 * framing(frame, (place.width - right) / place.height).distance);
        }
}

TEST_CASE("a camera that the person has moved stays where it is; Home gives it back", "[shots][sight]") {
    Onlooker watch({1440, 810}, Layout::lab);
    Session& s = watch.lab.session();
    watch.draw();
    Camera own = s.seen_by();
    own.target += Vec<3>(5, 0, 0), own.distance *= 2;
    s.camera = own;
    s.run(Until::after_steps(2000));
    watch.draw(0.02);
    CHECK(s.seen_by() == own);
    CHECK(s.scene_file().camera == own);
    watch.lab.perform(Action::frame);
    watch.draw();
    check_in_sight(watch);
    // Nobody chose this camera: a scene that is saved does not hold on to it.
    CHECK_FALSE(s.scene_file().camera);
    // A view that was only turned is saved as it is seen.
    s.viewpoint.turn(80, 10);
    watch.draw();
    CHECK(s.scene_file().camera == s.seen_by());
}

TEST_CASE("two runs beside each other are both in sight", "[shots][sight]") {
    Onlooker watch({1440, 810}, Layout::lab);
    Session& s = watch.lab.session();
    s.open_companion({{"drop_height", "1.5"}});
    s.run(Until::after_steps(3000));
    watch.draw();
    const Rectangle place = watch.lab.state().controls.at("scene B");
    const Projection projection(s.seen_by(), 3, place.width, place.height);
    for (const Scene& scene : {s.scene(), s.picture_beside()->scene})
        for (const Position& p : moving_parts(scene)) {
            const Eigen::Vector3f at = projection.pixel(p);
            REQUIRE(at.x() >= 0);
            REQUIRE(at.x() <= place.width);
            REQUIRE(at.y() >= 0);
            REQUIRE(at.y() <= place.height);
        }
}

namespace {
// All that moves in a picture lies in its place on the screen.
void check_part(Onlooker& watch, const Scene& scene, const char* control) {
    Session& s = watch.lab.session();
    const Rectangle place = watch.lab.state().controls.at(control);
    const Projection projection(s.seen_by(), s.lesson().dimension(), place.width, place.height);
    INFO(control);
    float most = 0;
    for (const Position& p : moving_parts(scene)) {
        const Eigen::Vector3f at = projection.pixel(p);
        most = std::max({most, std::abs(2 * at.x() / place.width - 1), std::abs(2 * at.y() / place.height - 1)});
    }
    CHECK(most <= 1.001f);
}

// A person's camera from which all is seen, turned where the lesson has three dimensions.
void choose_camera(Session& s) {
    Camera& own = s.own_camera();
    own.distance *= 1.25;
    if (s.lesson().dimension() == 3) own.yaw += 0.35;
}
}  // namespace

TEST_CASE("every lesson: the body is in sight at first, at Home, in both halves, and before and after a stage",
          "[shots][sight][every_lesson]") {
    for (const LessonEntry& entry : every_lesson())
        for (const Size size : {Size{1280, 720}, Size{1920, 1080}}) {
            CAPTURE(entry.info.id, size.width);
            Onlooker watch(size, Layout::lab);
            watch.lab.set_scale(1.5f);
            Session& s = watch.lab.session();
            s.open(entry);
            for (int i = 0; i < 3; ++i) watch.draw();
            check_in_sight(watch);
            for (int i = 0; i < 5; ++i) s.step();
            watch.draw();
            check_in_sight(watch);
            for (const bool chosen : {false, true}) {
                if (chosen) choose_camera(s);
                const Camera whole = s.seen_by();
                s.compare(Compare::side_by_side);
                for (int i = 0; i < 3; ++i) watch.draw();
                if (const KeptPicture before = s.other_picture()) {
                    check_part(watch, s.scene(), "scene");
                    check_part(watch, before->scene, "scene B");
                }
                CHECK(s.seen_by().yaw == whole.yaw);
                s.compare(Compare::now);
                watch.draw();
                if (chosen) CHECK(s.seen_by() == whole);
                s.toggle_companion();
                for (int i = 0; i < 5; ++i) s.step();
                for (int i = 0; i < 3; ++i) watch.draw();
                check_part(watch, s.scene(), "scene");
                check_part(watch, s.picture_beside()->scene, "scene B");
                CHECK(s.seen_by().yaw == whole.yaw);
                s.close_companion();
                watch.draw();
            }
            Camera& away = s.own_camera();
            away.target += Vec<3>(100, 0, 0);
            watch.lab.perform(Action::frame);
            watch.draw();
            check_in_sight(watch);
        }
}

TEST_CASE("every lesson: on each slide of its deck the picture has its room, and what moves is in it",
          "[shots][sight][every_lesson]") {
    Onlooker watch({1280, 720}, Layout::deck);
    Session& s = watch.lab.session();
    for (const LessonEntry& entry : every_lesson()) {
        s.open(entry);
        s.start_walkthrough();
        const std::size_t count = s.walkthrough->walkthrough().slides.size();
        for (std::size_t n = 0; n < count; ++n) {
            s.go_to_slide(n);
            s.walkthrough_next();
            watch.draw();
            watch.draw();
            CAPTURE(entry.info.id, n + 1);
            const DeckPlaces p = deck_places(watch.lab.state(), 1280, 720);
            CHECK(p.picture.width * p.picture.height >= 0.26f * 1280 * 720);
            // The panels lie side by side in the window.
            const std::array all{p.title, p.words, p.parameters, p.picture, p.plots, p.numbers};
            float area = 0;
            for (const Rectangle& r : all) {
                area += r.width * r.height;
                CHECK(r.x >= 0);
                CHECK(r.x + r.width <= 1280.5f);
                CHECK(r.y + r.height <= 720.5f);
            }
            CHECK(area <= 1280 * 720 * 1.001f);
            if (!s.autopsy()) check_in_sight(watch);
        }
    }
}
