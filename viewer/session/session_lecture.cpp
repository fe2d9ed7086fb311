// The session under a lecture: its slides, each of which brings what it shows.
#include "session/claim_book.h"
#include "session/session.h"

#include <utility>

namespace pliant::viewer {
namespace {

// Words and formulas alone, with what is wrong in the place of what the slide would show.
Slide told(const LectureSlide& s) {
    Slide slide{s.slide.title, {}, s.slide.line};
    for (const Block& b : s.slide.blocks)
        if (b.kind == BlockKind::text || b.kind == BlockKind::formula || b.kind == BlockKind::notes) slide.blocks.push_back(b);
    slide.blocks.push_back({BlockKind::text, {"This slide cannot be shown. " + s.trouble}, s.line});
    return slide;
}

// The walkthrough up to the slide, with what the lecture adds to it.
Walkthrough up_to(const LectureSlide& s) {
    Walkthrough w = walkthrough_of(find_lesson(s.deck->lesson));
    w.slides.resize(s.deck->number + 1);
    w.slides.back() = s.slide;
    return w;
}

}  // namespace

void Session::open_lecture(Lecture lecture, std::size_t slide) {
    if (put_off([this, lecture, slide] { open_lecture(lecture, slide); })) return;
    lecture_.emplace(LectureShow{std::move(lecture), 0});
    show_lecture_slide(slide);
}

void Session::end_lecture() {
    if (put_off([this] { end_lecture(); })) return;
    lecture_.reset();
    end_walkthrough();
}

void Session::renew_lecture(const Lecture& lecture) {
    if (lecture_ && lecture_->lecture.path == lecture.path && lecture.slides.size() > lecture_->slide)
        lecture_->lecture = lecture;
}

std::optional<SceneSlide> Session::lecture_place() const {
    if (!lecture_ || !walkthrough) return std::nullopt;
    return SceneSlide{.number = lecture_->slide + 1,
                      .revealed = walkthrough->revealed(),
                      .unlocked = unlocked,
                      .lecture = lecture_->lecture.path,
                      .predicted = walkthrough->guess()};
}

const LectureSlide* Session::lecture_slide() const { return lecture_ ? &lecture_->lecture.slides[lecture_->slide] : nullptr; }

std::size_t Session::slide_number() const { return lecture_ ? lecture_->slide : walkthrough ? walkthrough->slide_number() : 0; }

std::size_t Session::slide_count() const {
    return lecture_ ? lecture_->lecture.slides.size() : walkthrough ? walkthrough->walkthrough().slides.size() : 0;
}

const Slide* Session::slide_after() const {
    const std::size_t next = slide_number() + 1;
    if (next >= slide_count()) return nullptr;
    return lecture_ ? &lecture_->lecture.slides[next].slide : &walkthrough->walkthrough().slides[next];
}

// Whatever opens a scene ends a lecture, so the lecture stands aside meanwhile.
void Session::show_lecture_slide(std::size_t n) {
    LectureShow show = *std::exchange(lecture_, std::nullopt);
    if (show.shown && walkthrough && walkthrough->prediction()) show.guesses[show.slide] = walkthrough->guess();
    show.slide = std::min(n, show.lecture.slides.size() - 1);
    const LectureSlide& slide = show.lecture.slides[show.slide];
    playing = false;
    dismiss();
    const auto of_slide = [&] {
        enter(show.lecture, slide);
        if (const auto said = show.guesses.find(show.slide); said != show.guesses.end() && walkthrough->prediction())
            walkthrough->restore(said->second);
        playing = false;
    };
    if (!guarded(of_slide)) present(walkthrough_of(show.lecture, slide));
    show.shown = true;
    lecture_ = std::move(show);
}

// Its first slide is set up.
void Session::present(Walkthrough words) {
    walkthrough.emplace(*runner_, std::move(words), [this] { record_of_walkthrough(); });
    show_field_of_slide();
    after_walkthrough();
}

void Session::enter(const Lecture& lecture, const LectureSlide& slide) {
    Walkthrough words = walkthrough_of(lecture, slide);
    // What a stage changed was looked at on another slide.
    inspector.stage.clear(), inspector.compare = Compare::now;
    if (!slide.trouble.empty()) {
        words.slides = {told(slide)};
    } else if (slide.deck) {
        open(find_lesson(slide.deck->lesson));
        present(up_to(slide));
        return move_walkthrough([&] { walkthrough->go_to_slide(slide.deck->number); });
    } else if (slide.scene) {
        open_scene(*slide.scene);
        if (slide.beside) open_companion(*slide.beside);
    } else if (!slide.claim.empty()) {
        open_as_scene(*this, find_claim(slide.claim));
    }
    present(std::move(words));
}

// The answer of the slide, or else the next one.
void Session::lecture_next() {
    bool moved = false;
    move_walkthrough([&] {
        moved = walkthrough->next();
        note_slide();
    });
    if (moved || message_) return;
    if (slide_number() + 1 == slide_count()) return say(Message::Kind::info, "This was the last slide.");
    show_lecture_slide(slide_number() + 1);
}

void Session::lecture_back() {
    const std::size_t n = slide_number();
    if (walkthrough->revealed()) return show_lecture_slide(n);
    if (n > 0) show_lecture_slide(n - 1);
}

}  // namespace pliant::viewer
