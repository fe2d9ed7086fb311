// A hand at a lab without a window: mouse and keys go into ImGui, as the window's library gives them. Its pixels are drawn only
// for those who look at them.
#pragma once
#include "app/lab.h"
#include "platform/image.h"
#include "unseen.h"

#include <imgui.h>

#include <memory>
#include <string>

namespace pliant::test {

enum class Pixels { unseen, seen };

struct Hand {
    std::unique_ptr<viewer::Context> context;
    viewer::Lab lab;

    explicit Hand(std::string_view lesson, viewer::Size size = {1280, 720}, Pixels shown = Pixels::unseen)
        : context(shown == Pixels::seen ? viewer::open_headless(size) : open_unseen(size)), lab(*context, lesson) {
        frames(3);
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) lab.frame(0), context->present();
    }
    // Presses a key and lets it go.
    void key(ImGuiKey key) {
        ImGui::GetIO().AddKeyEvent(key, true);
        frames(2);
        ImGui::GetIO().AddKeyEvent(key, false);
        frames(3);
    }
    void type(char character) {
        ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(character));
        frames(3);
    }
    void move(float x, float y) {
        ImGui::GetIO().AddMousePosEvent(x, y);
        frames(2);
    }
    void button(int which, bool down) {
        ImGui::GetIO().AddMouseButtonEvent(which, down);
        frames(2);
    }
    void click(float x, float y, int which = 0) { move(x, y), button(which, true), button(which, false), frames(2); }
    void wheel(float notches) {
        ImGui::GetIO().AddMouseWheelEvent(0, notches);
        frames(3);
    }
    viewer::Rectangle place(const std::string& control) { return lab.state().controls.at(control); }
    void click(const std::string& control) {
        const viewer::Rectangle r = place(control);
        click(r.x + r.width / 2, r.y + r.height / 2);
    }
    // Of a hand whose pixels are seen.
    viewer::Image pixels() {
        lab.frame(0);
        viewer::Image image = viewer::read_pixels(*context);
        context->present();
        return image;
    }
};

}  // namespace pliant::test
