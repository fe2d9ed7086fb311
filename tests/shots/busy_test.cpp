// A lab whose work takes long: no frame waits for it, it is told how far it is, and it can be called off. Nothing here depends on
// how long anything takes: the work is a gate that the test opens.
#include "app/lab.h"
#include "app/state_report.h"

#include <pliant/math/watch.h>

#include <imgui.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <atomic>
#include <thread>

using namespace pliant;
using namespace pliant::viewer;
using Catch::Matchers::ContainsSubstring;

namespace {

// What the test lets through. Closed, the first that comes waits at it, and can be called off.
struct Gate {
    std::atomic<bool> open = true, holds = false;
    std::atomic<int> waiting = 0;
    void close() { holds = true, open = false; }
    void pass() {
        if (open || !holds.exchange(false)) return;
        ++waiting;
        while (!open) {
            try {
                cancel_point();
            } catch (const Cancelled&) {
                --waiting;
                throw;
            }
            std::this_thread::yield();
        }
        --waiting;
    }
};
Gate gate;

// A step of two stages; the second, and the reset to another size, stop at the gate.
class Gated final : public Lesson {
public:
    Whole size{*this, {.key = "size", .initial = 1, .useful = {1, 10}, .effect = Effect::rebuild}};

    Gated() {
        state = {state_array("x", "", x_)};
        fields = {{.name = "x", .view = view_of(x_)}};
        stages = {{.name = "prepare", .run = [this] { x_.array() += 1; }, .writes = {"x"}},
                  {.name = "solve",
                   .run =
                       [this] {
                           x_.array() += 10;
                           gate.pass();
                       },
                   .writes = {"x"}}};
        probes = {{.name = "x", .value = [this] { return x_[0]; }}};
    }
    int dimension() const override { return 2; }
    Real time_step() const override { return 0.01; }
    void reset() override {
        if (size != 1) gate.pass();
        x_ = VecX::Zero(size);
    }
    void draw(Scene& scene) const override { scene.points.push_back({.at = {position(x_[0], 0)}}); }

private:
    VecX x_;
};
const LessonEntry gated{{.id = "time/gated", .title = "Gated", .summary = ""}, [] { return std::unique_ptr<Lesson>(new Gated); }};

// A lab with a worker, at rest.
class SlowLab {
public:
    SlowLab() {
        gate.open = true;
        lab.frame(0);
        lab.session().open(gated);
        lab.work_beside({.budget = Budget::unlimited(), .patience_ms = 0, .card_after = 0});
        settle();
    }
    ~SlowLab() { gate.open = true; }
    Session& session() { return lab.session(); }

    // Frames until the worker has nothing to do.
    void settle() {
        do lab.frame(0.01);
        while (lab.busy() || lab.session().under_way());
        lab.frame(0.01), lab.call_off();
    }
    // What is asked for has come to the gate.
    void meet_gate() {
        while (gate.waiting == 0) lab.frame(0.01);
    }
    void press(ImGuiKey key) {
        ImGui::GetIO().AddKeyEvent(key, true);
        ImGui::GetIO().AddKeyEvent(key, false);
    }
    void click(const Rectangle& r) {
        ImGuiIO& io = ImGui::GetIO();
        io.AddMousePosEvent(r.x + r.width / 2, r.y + r.height / 2);
        io.AddMouseButtonEvent(0, true);
        io.AddMouseButtonEvent(0, false);
    }

    std::unique_ptr<Context> context = open_headless({800, 500});
    Lab lab{*context};
};

Real x_of(Session& s) { return *s.lesson().probe("x").value(); }

}  // namespace

TEST_CASE("no frame waits for a pass, and the run ends as it would have", "[busy]") {
    SlowLab b;
    gate.close();
    b.session().step();
    b.meet_gate();
    const long drawn = b.lab.busy_frames();
    for (int i = 0; i < 20; ++i) CHECK(b.lab.frame(0.01));
    CHECK(b.lab.busy());
    CHECK(b.lab.busy_frames() == drawn + 20);
    const BusyWords words = busy_words(b.lab.worker()->watch().progress(), 3);
    CHECK(words.title == "Solve");
    CHECK_THAT(words.line, ContainsSubstring("3.0 s so far"));
    gate.open = true;
    b.settle();
    CHECK(b.session().runner().place() == Place{1, 0});
    CHECK(x_of(b.session()) == 11);
    CHECK_FALSE(b.session().message());
}

TEST_CASE("a pass is called off by Escape and by the button, and the run stands at the start of its step", "[busy]") {
    SlowLab b;
    b.session().step();
    b.settle();
    for (const bool by_key : {true, false}) {
        CAPTURE(by_key);
        gate.close();
        b.session().step();
        b.meet_gate();
        b.lab.frame(0.01);
        REQUIRE(b.lab.cancel_button());
        by_key ? b.press(ImGuiKey_Escape) : b.click(*b.lab.cancel_button());
        while (b.lab.busy()) b.lab.frame(0.01);
        gate.open = true;
        b.settle();
        CHECK(b.session().runner().place() == Place{1, 0});
        CHECK(x_of(b.session()) == 11);
        REQUIRE(b.session().message());
        CHECK(b.session().message()->text == "Called off.");
        CHECK_FALSE(b.session().playing);
    }
    b.session().step();
    b.settle();
    CHECK(x_of(b.session()) == 22);
}

TEST_CASE("a reset that takes long is called off, and the parameters are as before", "[busy]") {
    SlowLab b;
    gate.close();
    {
        const Session::Held drawing(b.session());
        b.session().assign(b.session().lesson().parameter("size"), 5);
    }
    CHECK(b.session().anything_waits());
    b.meet_gate();
    b.lab.frame(0.01);
    REQUIRE(b.lab.cancel_button());
    b.press(ImGuiKey_Escape);
    while (b.lab.busy()) b.lab.frame(0.01);
    gate.open = true;
    b.settle();
    CHECK(b.session().lesson().parameter("size").value() == 1);
    CHECK(b.session().runner().place() == Place{});
    REQUIRE(b.session().message());
    CHECK_FALSE(b.session().can_undo());

    b.session().assign(b.session().lesson().parameter("size"), 5);
    b.settle();
    CHECK(b.session().lesson().field("x").size() == 5);
}

TEST_CASE("what is pressed while the card covers the lab does nothing afterwards", "[busy]") {
    SlowLab b;
    gate.close();
    b.session().step();
    b.meet_gate();
    b.lab.frame(0.01);
    b.press(ImGuiKey_Space);
    b.press(ImGuiKey_R);
    b.click({10, 10, 100, 100});
    b.lab.frame(0.01);
    gate.open = true;
    b.settle();
    CHECK(b.session().runner().place() == Place{1, 0});
    CHECK_FALSE(b.session().playing);
}

TEST_CASE("a lab that is closed while it computes ends its work", "[busy]") {
    {
        SlowLab b;
        gate.close();
        b.session().playing = true;
        b.meet_gate();
    }
    CHECK(gate.waiting == 0);
}

TEST_CASE("a worker tells what its work threw, and does the next", "[busy]") {
    Worker worker;
    worker.begin([] { throw Refused("no"); });
    CHECK_THROWS_AS(
        [&] {
            while (!worker.finished(1000)) continue;
        }(),
        Refused);
    CHECK_FALSE(worker.busy());
    int done = 0;
    for (int i = 0; i < 100; ++i) {
        worker.begin([&] { ++done; });
        while (!worker.finished(1000)) continue;
    }
    CHECK(done == 100);
}

TEST_CASE("a lab with a worker does what one without does", "[busy]") {
    const auto context = open_headless({800, 500});
    for (const LessonEntry& entry : lessons()) {
        CAPTURE(entry.info.id);
        Lab lab(*context);
        lab.session().open(entry);
        lab.work_beside({.budget = Budget::of_passes(5), .patience_ms = 1, .card_after = 1e9});
        lab.session().playing = true;
        for (int i = 0; i < 20; ++i) lab.frame(0.02);
        while (lab.busy()) lab.frame(0.02);
        lab.session().playing = false;
        lab.session().step();
        while (lab.busy() || lab.session().under_way()) lab.frame(0.02);
        lab.call_off();
        Runner alone(entry);
        while (alone.place() < lab.session().runner().place()) alone.step_pass();
        CHECK(alone.place() == lab.session().runner().place());
        CHECK(state_hash(alone.lesson()) == state_hash(lab.session().lesson()));
    }
}
