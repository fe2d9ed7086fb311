// A lesson for tests of the session.
#pragma once
#include "session/session.h"

#include <chrono>
#include <memory>
#include <thread>

namespace pliant::test {

// A point that moves at a constant speed, in steps that may take long, and blows up beyond a bound.
class Walker final : public Lesson {
public:
    Number speed{*this, {.key = "speed", .unit = "m/s", .initial = 1, .useful = {0, 10}, .accepted = Interval{-1e6, 1e6}}};
    Number start{*this, {.key = "start", .unit = "m", .initial = 0, .useful = {0, 1}, .effect = Effect::rebuild}};
    Number dt{*this, {.key = "time_step", .unit = "s", .initial = 0.001, .useful = {1e-4, 1}}};
    Number wait{*this, {.key = "wait", .unit = "s", .initial = 0, .useful = {0, 1}}};

    Walker() {
        state = {state_array("x", "m", x_)};
        fields = {{.name = "x", .unit = "m", .view = view_of(x_), .bound = [] { return 100.0; }}};
        stages = {{.name = "walk", .formula = "x ← x + Δt v", .run = [this] { walk(); }, .writes = {"x"}},
                  {.name = "look", .run = [] {}}};
        probes = {{.name = "x", .unit = "m", .value = [this] { return x_[0]; }}};
    }
    int dimension() const override { return 2; }
    Real time_step() const override { return dt; }
    void reset() override { x_ = VecX::Constant(1, start); }
    void check() const override {
        if (start + speed > 1e5) throw Refused("start and speed do not go together");
    }
    std::optional<On> can_pull() const override { return On::node; }
    void pull(const std::optional<Pull>& hand) override { hand_ = hand; }
    void draw(Scene& scene) const override { scene.points.push_back({.at = {position(x_[0], 0)}, .pick = {.pickable = true}}); }

private:
    void walk() {
        if (wait > 0) std::this_thread::sleep_for(std::chrono::duration<double>(wait));
        x_[0] += dt * speed + (hand_ ? 1 : 0);
    }
    VecX x_;
    std::optional<Pull> hand_;
};

inline const LessonEntry walker{{.id = "time/walker", .title = "Walker", .summary = ""},
                                [] { return std::unique_ptr<Lesson>(new Walker); }};

inline viewer::Session walking(const Runner::Assignments& assignments = {}) {
    viewer::Session session(lessons().front().info.id);
    session.open(walker, assignments);
    return session;
}

}  // namespace pliant::test
