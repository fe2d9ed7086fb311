// A hand on the lab, through ImGui's own queue of events.
#pragma once
#include "app/lab.h"
#include "unseen.h"

#include <imgui.h>
#include <catch2/catch_test_macros.hpp>

#include <memory>
#include <string>

namespace pliant::test {

class LabHand {
public:
    explicit LabHand(std::string_view lesson, viewer::Size size = {1280, 900})
        : context_(open_unseen(size)), lab_(*context_, lesson) {
        frames(3);
    }
    viewer::Lab& lab() { return lab_; }
    viewer::Session& session() { return lab_.session(); }
    viewer::LabState& state() { return lab_.state(); }
    Real value(std::string_view key) { return session().runner().wanted(session().lesson().parameter(key)); }
    std::string told() { return session().message() ? session().message()->text : ""; }

    void frames(int count) {
        for (int i = 0; i < count; ++i) lab_.frame(0), context_->present();
    }
    viewer::Rectangle place(const std::string& control) {
        REQUIRE(state().controls.contains(control));
        return state().controls.at(control);
    }
    void move(float x, float y) { io().AddMousePosEvent(x, y), frames(1); }
    // So far along a control, and px further.
    void move_onto(const std::string& control, float along = 0.5f, float further = 0) {
        const viewer::Rectangle r = place(control);
        move(r.x + along * r.width + further, r.y + 0.5f * r.height);
    }
    void button(bool down) { io().AddMouseButtonEvent(0, down), frames(2); }
    void click(const std::string& control, float along = 0.5f) { move_onto(control, along), button(true), button(false); }
    void wheel(float notches) { io().AddMouseWheelEvent(0, notches), frames(2); }
    void hold(ImGuiKey modifier, bool down) { io().AddKeyEvent(modifier, down), frames(1); }
    void press(ImGuiKey key) {
        io().AddKeyEvent(key, true), frames(1);
        io().AddKeyEvent(key, false), frames(2);
    }

private:
    static ImGuiIO& io() { return ImGui::GetIO(); }
    std::unique_ptr<viewer::Context> context_;
    viewer::Lab lab_;
};

}  // namespace pliant::test
