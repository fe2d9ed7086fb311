// Runs within a budget: cut after any pass, they end in the same bits as in whole steps.
#include "session/session.h"
#include "walker.h"

#include <catch2/catch_test_macros.hpp>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

namespace {

// A lesson whose step needs many passes, each of which counts.
class Sweeping final : public Lesson {
public:
    Whole sweeps{*this, {.key = "sweeps", .initial = 100, .useful = {1, 1000}}};
    Number rate{*this, {.key = "rate", .initial = 0.5, .useful = {0, 1}}};

    Sweeping() {
        state = {state_array("x", "", x_)};
        fields = {{.name = "x", .view = view_of(x_)}};
        stages = {{.name = "begin", .run = [this] { done_ = 0; }},
                  {.name = "sweep",
                   .run = [this] { ++done_, x_[0] += rate / static_cast<Real>(done_ + 1); },
                   .writes = {"x"},
                   .again = [this] { return done_ < sweeps; }}};
        probes = {{.name = "x", .value = [this] { return x_[0]; }}};
    }
    int dimension() const override { return 2; }
    Real time_step() const override { return 0.01; }
    void reset() override { x_ = VecX::Zero(1), done_ = 0; }
    void draw(Scene& scene) const override { scene.points.push_back({.at = {position(x_[0], 0)}}); }

private:
    VecX x_;
    Index done_ = 0;
};
const LessonEntry sweeping{{.id = "time/sweeping", .title = "Sweeping", .summary = ""},
                           [] { return std::unique_ptr<Lesson>(new Sweeping); }};

Session opened(const LessonEntry& entry, const Runner::Assignments& assignments = {}) {
    Session session(lessons().front().info.id);
    session.open(entry, assignments);
    session.sliced = true;
    return session;
}

}  // namespace

TEST_CASE("no frame runs more passes than its budget, and the run ends in the same bits", "[session][budget]") {
    for (const Index budget : {1, 3, 7, 100, 1000}) {
        CAPTURE(budget);
        Session s = opened(sweeping);
        s.playing = true;
        while (s.runner().place().step < 5) {
            const long before = s.passes_run();
            s.update(0.01, Budget::of_passes(budget));
            REQUIRE(s.passes_run() - before <= budget);
        }
        s.toggle_play();
        while (s.under_way()) s.update(0.01, Budget::of_passes(budget));
        CHECK_FALSE(s.runner().inside_step());
        Runner whole(sweeping);
        for (Index k = 0; k < s.runner().place().step; ++k) whole.step();
        CHECK(state_hash(s.lesson()) == state_hash(whole.lesson()));
        CHECK(s.recorder().csv(s.lesson()).find("\n" + std::to_string(s.runner().place().step) + ",") != std::string::npos);
    }
}

TEST_CASE("every lesson ends in the same bits whether its steps are cut or whole", "[session][budget]") {
    for (const LessonEntry& entry : lessons()) {
        CAPTURE(entry.info.id);
        Session s = opened(entry);
        Runner whole(entry);
        for (int k = 0; k < 3; ++k) {
            s.step();
            while (s.moving()) s.update(0, Budget::of_passes(1));
            whole.step();
        }
        CHECK(s.runner().place() == whole.place());
        CHECK(state_hash(s.lesson()) == state_hash(whole.lesson()));
    }
}

TEST_CASE("a move forward goes on from update to update, and tells that it is under way", "[session][budget]") {
    Session s = opened(sweeping);
    s.step();
    CHECK(s.moving());
    CHECK(s.runner().place() == Place{});
    s.update(0, Budget::of_passes(10));
    CHECK(s.runner().place() == Place{0, 10});
    CHECK(s.under_way());
    for (int k = 0; k < 9; ++k) s.update(0, Budget::of_passes(10));
    CHECK(s.under_way());
    s.update(0, Budget::of_passes(10));
    CHECK_FALSE(s.under_way());
    CHECK(s.runner().place() == Place{1, 0});

    s.step_stage();
    s.update(0, Budget::of_passes(10));
    CHECK(s.runner().place() == Place{1, 1});
    s.run_to_stage("sweep");
    s.update(0, Budget::of_passes(50));
    CHECK(s.runner().place() == Place{1, 51});
    s.step_pass();
    s.update(0, Budget::of_passes(50));
    CHECK(s.runner().place() == Place{1, 52});
    CHECK_FALSE(s.under_way());
    s.run_to_stage("no such stage");
    REQUIRE(s.message());
    CHECK_FALSE(s.under_way());
}

TEST_CASE("a pause ends the step that is under way; another one stops at once", "[session][budget]") {
    Session s = opened(sweeping);
    s.toggle_play();
    s.update(0.01, Budget::of_passes(10));
    REQUIRE(s.runner().place() == Place{0, 10});
    CHECK(s.shows_last_step());
    s.toggle_play();
    CHECK_FALSE(s.playing);
    CHECK(s.moving());
    s.update(0.01, Budget::of_passes(10));
    s.toggle_play();
    CHECK_FALSE(s.under_way());
    CHECK(s.runner().place() == Place{0, 20});
    s.update(0.01, Budget::of_passes(10));
    CHECK(s.runner().place() == Place{0, 20});
    s.reset();
    s.step();
    s.reset();
    CHECK_FALSE(s.moving());
    CHECK(s.runner().place() == Place{});
}

TEST_CASE("a slider that is moved while a step is cut acts from the next step on, and the run can be played again",
          "[session][budget]") {
    Session s = opened(sweeping);
    s.playing = true;
    s.update(0.01, Budget::of_passes(30));
    s.assign(s.lesson().parameter("rate"), 0.25);
    while (s.runner().place().step < 3) s.update(0.01, Budget::of_passes(30));
    s.toggle_play();
    while (s.under_way()) s.update(0.01, Budget::of_passes(30));

    Runner again(sweeping);
    again.load(s.scene_file().parameters);
    again.set_events(s.scene_file().events);
    while (again.place().step < s.runner().place().step) again.step();
    CHECK(state_hash(again.lesson()) == state_hash(s.lesson()));
    Runner other(sweeping);
    while (other.place().step < s.runner().place().step) other.step();
    CHECK(state_hash(other.lesson()) != state_hash(s.lesson()));
}

TEST_CASE("a picture of a run that plays is that of a whole step, until a step takes long", "[session][budget]") {
    Session s = opened(sweeping);
    const auto shown = [&] { return s.scene().points.at(0).at.at(0)[0]; };
    const float start = shown();
    s.playing = true;
    for (int k = 0; k < 5; ++k) {
        s.update(0.01, Budget::of_passes(10));
        CHECK(shown() == start);
    }
    while (s.runner().place().step == 0) s.update(0.01, Budget::of_passes(10));
    CHECK_FALSE(s.runner().inside_step());
    CHECK(shown() == static_cast<float>(*s.lesson().probe("x").value()));
    // One that takes dozens of frames is watched from within.
    s.assign(s.lesson().parameter("sweeps"), 1000);
    for (int k = 0; k < 40; ++k) s.update(0.01, Budget::of_passes(10));
    CHECK(s.runner().place().passes > 300);
    CHECK(shown() == static_cast<float>(*s.lesson().probe("x").value()));
}

TEST_CASE("two runs keep to one clock under a budget", "[session][budget]") {
    Session s = opened(sweeping);
    s.open_companion({{"sweeps", "7"}});
    s.playing = true;
    for (int k = 0; k < 200; ++k) {
        const long a = s.runner().place().step;
        const long b = s.companion()->runner().place().step;
        REQUIRE((b == a || b == a - 1));
        s.update(0.01, Budget::of_passes(9));
    }
    s.toggle_play();
    while (s.under_way()) s.update(0.01, Budget::of_passes(9));
    CHECK(s.companion()->runner().place() == s.runner().place());
    Runner alone(sweeping, {{"sweeps", "7"}});
    while (alone.place().step < s.runner().place().step) alone.step();
    CHECK(state_hash(alone.lesson()) == state_hash(s.companion()->lesson()));
}
