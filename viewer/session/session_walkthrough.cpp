// The session under a walkthrough: slides, their locks, and what is recorded of their runs.
#include "session/session.h"

#include <pliant/document/share.h>
#include <pliant/document/summary.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <utility>

namespace pliant::viewer {
namespace {

// By file and title, so that a slide is the same in a lecture and in the walkthrough of its lesson.
std::pair<std::string, std::string> slide_key(const WalkthroughPlayer& player) {
    return {player.walkthrough().path, player.slide().title};
}

}  // namespace

bool Session::locked(const Parameter& parameter) const {
    return hides(parameter.info.key) || (walkthrough && !unlocked && !walkthrough->allows(parameter.info.key));
}

void Session::toggle_lock() {
    if (walkthrough) unlocked = !unlocked;
}

void Session::start_walkthrough() {
    if (put_off([this] { start_walkthrough(); })) return;
    guarded([&] {
        Walkthrough text = walkthrough_of(*entry_);
        open(*entry_);
        extension_.reset();
        present(std::move(text));
    });
}

void Session::predict(const Guess& guess) {
    if (!walkthrough) return;
    if (answers_seen_.contains(slide_key(*walkthrough))) walkthrough->note_seen();
    guarded([&] { walkthrough->guess(guess); });
}

void Session::say_right(bool right) {
    if (!walkthrough) return;
    guarded([&] {
        walkthrough->say_right(right);
        note_slide();
    });
}

// What was said on the slide whose answer shows.
void Session::note_slide() {
    if (!walkthrough->revealed()) return;
    answers_seen_.insert(slide_key(*walkthrough));
    notebook.note_slide(*runner_, *walkthrough);
}

void Session::note_number(std::string_view probe) {
    guarded([&] {
        notebook.note_number(*runner_, probe);
        const HandInEntry& e = notebook.hand_in().entries.back();
        say(Message::Kind::info, fmt::format("Noted: {} = {}.", spoken(e.probe), format_quantity(e.value, e.unit)));
    });
}

void Session::note_answer(std::string text) {
    notebook.note_answer(*runner_, walkthrough ? &*walkthrough : nullptr, std::move(text));
}

void Session::end_walkthrough() {
    if (put_off([this] { end_walkthrough(); })) return;
    walkthrough.reset();
    lecture_.reset();
    unlocked = false;
}

const std::vector<Extension>& Session::extensions() const {
    if (std::exchange(extensions_of_, entry_->info.id) != entry_->info.id) {
        extensions_.clear();
        extensions_ = pliant::extensions_of(*entry_);
    }
    return extensions_;
}

void Session::open_extension(std::size_t n) {
    if (put_off([this, n] { open_extension(n); })) return;
    guarded([&] {
        const Extension extension = extensions().at(n);
        open_scene(read_share(share_text(extension.scene)));
        present(extension.walkthrough);
        extension_ = n;
        playing = false;
    });
}

// A slide may start the lesson again, so a step that was recorded before begins another run.
void Session::record_of_walkthrough() {
    if (!recorder_.empty() && runner_->place().step <= recorder_.last_step())
        begin_run();
    else
        moved();
}

// Without a run in the slide, a reset shows by the step alone.
void Session::after_walkthrough() {
    const bool restarted = !recorder_.empty() && runner_->place().step < recorder_.last_step();
    restarted ? begin_run() : moved();
}

void Session::show_field_of_slide() {
    const std::string& shown = walkthrough->shown_field();
    if (shown.empty() || shown == colours.field) return;
    colours = {shown, -1};
    range.forget();
}

// Changes of parameters on the slide before cannot be undone on this one, and a scene of another size is framed afresh.
void Session::move_walkthrough(const std::function<void()>& move) {
    if (!walkthrough) return;
    playing = false;
    dismiss();
    const KeptPicture before = picture();
    const std::size_t slide = walkthrough->slide_number();
    guarded(move);
    undo_.clear();
    // Each slide begins with the whole picture, as it is now.
    if (walkthrough->slide_number() != slide) inspector.stage.clear(), compare(Compare::now);
    show_field_of_slide();
    after_walkthrough();
    const Scene& now = scene();
    if (now.lower != before->scene.lower || now.upper != before->scene.upper) camera.reset();
}

void Session::walkthrough_next() {
    if (put_off([this] { walkthrough_next(); })) return;
    if (lecture_) return lecture_next();
    move_walkthrough([this] {
        if (!walkthrough->next())
            say(Message::Kind::info,
                extension_ ? "This was its answer."
                           : "This was the last slide. Below it in the lab is what to try next; H hands in what you "
                             "predicted and noted.");
        note_slide();
    });
}

void Session::walkthrough_back() {
    if (put_off([this] { walkthrough_back(); })) return;
    if (lecture_) return lecture_back();
    if (walkthrough && walkthrough->slide_number() == 0 && !walkthrough->revealed()) return;
    go_to_slide(walkthrough->revealed() ? walkthrough->slide_number() : walkthrough->slide_number() - 1);
}

void Session::go_to_slide(std::size_t n) {
    if (put_off([this, n] { go_to_slide(n); })) return;
    if (lecture_) return show_lecture_slide(n);
    if (const auto opened = extension()) return open_extension(*opened);
    move_walkthrough([this, n] {
        colours = lesson().first_colours();
        runner_->load({});
        begin_run();
        walkthrough->go_to_slide(n);
    });
}

void Session::reset_slide() {
    if (put_off([this] { reset_slide(); })) return;
    if (walkthrough) go_to_slide(slide_number());
}

}  // namespace pliant::viewer
