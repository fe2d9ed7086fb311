// The page of the lecturer, beside the deck that the audience sees: notes, clock, what comes next and the numbers of the run. It
// is drawn from plain words, so that it needs neither the session nor the window of the lab.
#pragma once
#include "panels/panel_context.h"
#include "render/scene_renderer.h"
#include "session/next_slide.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pliant::viewer {

struct PresenterView {
    struct Reading {
        std::string name, number, exact;
        bool operator==(const Reading&) const = default;
    };
    std::string lesson;
    bool in_deck = false;
    std::size_t number = 0, count = 0;  // of the slide, from 1; 0 without a walkthrough
    std::string title, notes, question, answer, next_press, next_title, next_words;
    // Minutes that the notes plan: for this slide, up to its end, and for all.
    std::optional<Real> minutes, minutes_so_far, minutes_in_all;
    std::vector<Reading> readings;
    std::string now;      // "t = 0.2 s, plays"
    std::string message;  // that the audience sees
    bool black = false, filled = false;
    bool operator==(const PresenterView&) const = default;
};

struct PresenterClock {
    std::string time_of_day;  // "10:42"; "" when it is not to be told
    Real elapsed = 0;         // s
    bool paused = false;
};

// How the page is drawn.
struct PresenterPage {
    const Fonts& fonts;
    Theme theme;
    float scale;
    std::map<std::string, Rectangle>& controls;
    // The slide after this one, made by a renderer of the context that the page is drawn in; null where there is none.
    const SlidePreview* next = nullptr;
    SceneRenderer* renderer = nullptr;
    float px(float length) const { return length * scale; }
};

struct PresenterWishes {
    bool pause_clock = false, restart_clock = false;
    std::vector<Action> actions{};
};

// busy: what the run computes, while the numbers wait for it; else "".
PresenterWishes draw_presenter(const PresenterPage& page, const PresenterView& view, const PresenterClock& clock,
                               const std::string& busy);

// "0:07", "12:34", "1:02:03".
std::string elapsed_text(Real seconds);

}  // namespace pliant::viewer
