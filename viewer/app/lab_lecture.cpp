// Lectures in the lab: opened, shown, and made of what is on the screen.
#include <pliant/lecture/lecture.h>
#include <pliant/text/file.h>

#include "app/lab.h"
#include "app/lecture_place.h"
#include "app/lecture_slide.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace pliant::viewer {
namespace fs = std::filesystem;
namespace {

using Told = Session::Message::Kind;

Knob knob_along(const Lesson& lesson, const std::string& key, Index cells) { return useful_knob(lesson.parameter(key), cells); }

}  // namespace

void Lab::open_lecture(Lecture lecture, std::size_t slide) {
    // What is added goes into its file; one that comes with Pliant has none.
    std::error_code error;
    if (fs::is_regular_file(lecture.path, error)) state_.lecture_file = lecture.path;
    state_.session.later([this, lecture, slide] {
        state_.session.open_lecture(lecture, slide);
        set_layout(Layout::deck);
    });
}

void Lab::follow_lecture() {
    const Session& s = state_.session;
    const std::pair here{s.lecture() ? s.open_count() : -1, s.slide_number()};
    if (std::exchange(lecture_slide_, here) != here) begin_lecture_slide(state_);
    keep_of_lecture_slide(state_);
}

bool Lab::perform_on_lecture(Action action) {
    switch (action) {
        case Action::open_lecture:
            return ask_for_lecture(), true;
        case Action::end_lecture:
            return state_.session.end_lecture(), true;
        case Action::add_scene:
        case Action::add_slide:
        case Action::add_claim:
        case Action::add_map:
            return add_to_lecture(slide_to_add(action)), true;
        default:
            return false;
    }
}

void Lab::ask_for_lecture() {
    state_.files.ask(FileChoice::Purpose::open, "Open a lecture, .md or .json", {".md", ".json"}, "",
                     [this](const std::string& path) { open_lecture_file(path); });
}

void Lab::open_lecture_file(const std::string& path) { open_lecture(read_lecture(with_whole_path(path))); }

LectureSlide Lab::slide_to_add(Action action) const {
    const Session& s = state_.session;
    LectureSlide slide;
    if (action == Action::add_claim) {
        slide.claim = state_.claims.book.unfolded(s.entry().info.id)->id;
        slide.slide.title = fmt::format("Claim {}", slide.claim);
        return slide;
    }
    if (action == Action::add_slide) {
        slide.slide.title = s.walkthrough->slide().title;
        slide.deck = DeckSlide{std::string(s.entry().info.id), s.slide_number()};
        return slide;
    }
    slide.slide.title = s.entry().info.title;
    slide.scene = scene_file();
    if (const std::string fill = text_of(state_.fill); !fill.empty())
        slide.fill = FilledPanel{fill.substr(0, fill.find(' ')), state_.fill.plot};
    if (action == Action::add_map) {
        const Atlas& atlas = state_.atlas.atlas;
        slide.slide.title += ": where it is stable";
        slide.atlas.emplace(knob_along(s.lesson(), atlas.across, atlas.cells), knob_along(s.lesson(), atlas.up, atlas.cells));
    }
    return slide;
}

// Into the file of the lecture; the first time it is asked for.
void Lab::add_to_lecture(const LectureSlide& slide) {
    const auto add = [this, slide](const std::string& path) {
        std::error_code error;
        const std::string before = fs::exists(path, error) ? read_file(path) : "";
        write_file(path, with_slide_added(before, path, slide));
        state_.lecture_file = with_whole_path(path);
        const Lecture now = read_lecture(path);
        state_.session.renew_lecture(now);
        state_.session.say(Told::info,
                           fmt::format("Added as slide {} of {}.", now.slides.size(), fs::path(path).filename().string()));
    };
    if (state_.lecture_file.empty())
        return state_.files.ask(FileChoice::Purpose::add, "Add to a lecture, new or old", {".md", ".json"}, "lecture.md", add);
    try {
        add(state_.lecture_file);
    } catch (const Error& e) {
        state_.session.say(Told::refused, e.what());
    }
}

}  // namespace pliant::viewer
