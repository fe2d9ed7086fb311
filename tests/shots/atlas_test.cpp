// The atlas in the lab: knobs, a map that is made beside the run, and a click on a cell.
#include "parameters.h"

#include <pliant/math/error.h>

#include <pliant/study/stability_report.h>

#include "app/lab.h"
#include "app/map_picture.h"
#include "app/state_report.h"
#include "command_line/options.h"
#include "platform/png_file.h"
#include "session/atlas.h"
#include "waiting.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;
using Catch::Matchers::ContainsSubstring;

namespace {

const Runner::Assignments one_cell{{"cells_x", "1"}, {"cells_y", "1"}, {"cells_z", "1"}, {"scene", "spin"}};

Session lattice() {
    Session session;
    session.open(find_lesson("mass_spring"), one_cell);
    return session;
}

// Frames go by until the map is made.
bool wait_for(Atlas& atlas, const Session& session) {
    return comes_true([&] {
        atlas.follow(session);
        return !atlas.busy();
    });
}

void ask_for_little(Atlas& atlas) { atlas.cells = 8, atlas.steps = 50; }

}  // namespace

TEST_CASE("a map is made of the open lesson's parameters while the lab goes on", "[session][atlas]") {
    Session session = lattice();
    Atlas atlas;
    atlas.follow(session);
    CHECK(atlas.across == "time_step");
    CHECK(atlas.up == "k_structural");
    ask_for_little(atlas);
    CHECK_FALSE(atlas.map());
    atlas.start(session);
    CHECK(atlas.busy());
    CHECK(atlas.progress().total == 64);
    session.step();
    REQUIRE(wait_for(atlas, session));
    REQUIRE(atlas.map());
    CHECK(atlas.map()->columns() == 8);
    CHECK(atlas.map()->cells.size() == 64);
    CHECK(atlas.map()->order.settings.size() == 4);
    CHECK(atlas.present(session));
    CHECK_FALSE(atlas.outdated(session));
    session.assign(session.lesson().parameter("mass"), 3);
    CHECK(atlas.outdated(session));
    CHECK_FALSE(atlas.present(session));
    Atlas another;
    another.follow(session);
    ask_for_little(another);
    session.undo();
    another.make_now(session);
    CHECK(map_csv(*another.map()) == map_csv(*atlas.map()));
}

TEST_CASE("a cell opens as the scene of the lab, in one step of undo", "[session][atlas]") {
    Session session = lattice();
    Atlas atlas;
    atlas.follow(session);
    ask_for_little(atlas);
    atlas.make_now(session);
    const StabilityMap& map = *atlas.map();
    session.step();
    session.assign(session.lesson().parameter("mass"), 3);
    const Real dt = wanted(session, "time_step"), k = wanted(session, "k_structural");
    open_cell(session, map, 5, 2);
    CHECK(session.runner().place() == Place{});
    CHECK(wanted(session, "time_step") == map.order.across.values[5]);
    CHECK(wanted(session, "k_structural") == map.order.up.values[2]);
    CHECK(wanted(session, "mass") == 1);  // as it was when the map was made
    CHECK(wanted(session, "cells_x") == 1);
    REQUIRE(atlas.present(session));
    CHECK(std::abs(atlas.present(session)->across - 5) < 1e-9);
    session.undo();
    CHECK(wanted(session, "time_step") == dt);
    CHECK(wanted(session, "k_structural") == k);
    CHECK(wanted(session, "mass") == 3);
}

TEST_CASE("another lesson, a cancel and the end of the lab stop a map at once", "[session][atlas]") {
    // Each of these maps would take more than a day: that this case ends shows that none is made.
    Session session = lattice();
    Atlas atlas;
    atlas.follow(session);
    atlas.cells = 48, atlas.steps = 10'000'000;
    atlas.start(session);
    atlas.cancel();
    CHECK_FALSE(atlas.busy());
    atlas.start(session);
    session.open_next(1);
    atlas.follow(session);
    CHECK_FALSE(atlas.busy());
    CHECK_FALSE(atlas.map());
    CHECK(atlas.up != "k_structural");
    session.open(find_lesson("mass_spring"), one_cell);
    atlas.follow(session);
    atlas.start(session);
    CHECK(atlas.busy());
}

TEST_CASE("between a change of the lesson and its next frame a map shows no present scene", "[session][atlas]") {
    Session session = lattice();
    Atlas atlas;
    atlas.follow(session);
    ask_for_little(atlas);
    atlas.make_now(session);
    REQUIRE(atlas.present(session));
    session.open(find_lesson("elasticity/moduli"));
    CHECK(atlas.outdated(session));
    CHECK_FALSE(atlas.present(session));
}

TEST_CASE("a lesson that is solved at once has no map, and the panel says so", "[session][atlas]") {
    const auto context = open_headless({1280, 720});
    Lab lab(*context, "elasticity/moduli");
    lab.perform(Action::atlas);
    const auto state_after = [&](int frames) {
        for (int i = 0; i < frames; ++i) lab.frame(1.0 / 60);
        return nlohmann::json::parse(state_json(lab.state()));
    };
    const auto state = state_after(4);
    CHECK(state["atlas"]["shown"] == true);
    for (const char* control : {"tab atlas", "atlas across", "atlas up", "atlas cells", "atlas steps", "atlas make"})
        CHECK(state["controls"].contains(control));
    CHECK(state["focus"]["control"] == "atlas across");
    start_atlas(lab.state(), lab.state().atlas);
    CHECK_THAT(state_after(1)["message"].get<std::string>(), ContainsSubstring("solved at once"));
    CHECK(state_after(1)["atlas"]["busy"] == false);
}

// Somebody has looked at the picture. To renew it after a change that is meant to be seen, run this with PLIANT_UPDATE_GOLDEN=1
// and look again.
TEST_CASE("the picture of a known map is as it was", "[shots][atlas]") {
    const auto map_of = [](const char* scheme) {
        const LessonEntry& entry = find_lesson("time/integration");
        const auto lesson = entry.make();
        return make_stability_map({.lesson = &entry,
                                   .settings = {{"scheme", scheme}, {"omega", "10"}},
                                   .across = parse_knob(*lesson, "time_step=1e-2:1:20:log"),
                                   .up = parse_knob(*lesson, "damping_ratio=0:1.5:16")},
                                  1);
    };
    const auto picture_of = [&](const char* scheme) { return map_image(map_of(scheme), {720, 405}, Theme::projector, 1); };
    const std::string path = PLIANT_SOURCE_DIR "/tests/shots/golden_atlas/map.png";
    const Image image = picture_of("semi_implicit_euler");
    if (const char* wish = std::getenv("PLIANT_UPDATE_GOLDEN"); wish && std::string(wish) == "1") write_png(image, path);
    const Image expected = read_png(path);
    CHECK(compare(image, expected, 24).fraction_over <= 0.002);
    CHECK(compare(picture_of("implicit_euler"), expected, 24).fraction_over >= 0.05);
    CHECK(compare(map_image(map_of("semi_implicit_euler"), {720, 405}, Theme::projector, 1), image).largest == 0);
}

TEST_CASE("the lab shows the map of the first knobs in a picture made without a window", "[shots][atlas]") {
    const auto file = std::filesystem::temp_directory_path() / ("pliant_atlas_" + std::to_string(getpid()) + ".png");
    RunOptions run;
    run.lesson = "time/integration", run.steps = 0;
    PictureOptions picture;
    picture.layout = "lab", picture.size = "960x540", picture.out = file.string();
    shot(run, picture);
    const Image without = read_png(file.string());
    picture.atlas = true;
    shot(run, picture);
    const Image with = read_png(file.string());
    std::filesystem::remove(file);
    const auto orange = [](const Image& image) {
        const Rgba8 c = colour_of(Stability::diverged);
        std::size_t count = 0;
        for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3)
            count += image.rgb[i] == c.r && image.rgb[i + 1] == c.g && image.rgb[i + 2] == c.b;
        return count;
    };
    CHECK(orange(with) > orange(without) + 5000);
    picture.layout = "slide";
    CHECK_THROWS_AS(shot(run, picture), Refused);
}
