// What a lecture tells of itself, and its slides played headless.
#include <pliant/lecture/lecture.h>
#include <pliant/study/claims_report.h>

#include <fmt/format.h>

#include <algorithm>

namespace pliant {

std::string LectureSlide::lesson() const {
    if (deck) return deck->lesson;
    if (scene) return scene->lesson;
    return claim.empty() ? "" : find_claim(claim).lesson;
}

Real Lecture::minutes() const {
    Real sum = 0;
    for (const LectureSlide& s : slides) sum += s.minutes;
    return sum;
}

Walkthrough walkthrough_of(const Lecture& lecture, const LectureSlide& slide) {
    return {.path = lecture.path, .title = lecture.title, .introduction = {}, .slides = {slide.slide}};
}

namespace {

std::vector<ExpectationResult> played_deck(const DeckSlide& deck) {
    const LessonEntry& entry = find_lesson(deck.lesson);
    Runner runner(entry);
    WalkthroughPlayer player(runner, walkthrough_of(entry));
    player.go_to_slide(deck.number);
    player.next();
    return player.results();
}

std::vector<ExpectationResult> played_scene(const Lecture& lecture, const LectureSlide& slide) {
    Runner runner(find_lesson(slide.scene->lesson), slide.scene->parameters);
    runner.set_events(slide.scene->events);
    WalkthroughPlayer player(runner, walkthrough_of(lecture, slide));
    player.next();
    return player.results();
}

std::vector<ExpectationResult> played_claim(const LectureSlide& slide) {
    const Claim& claim = find_claim(slide.claim);
    const ClaimResult r = measured(claim);
    return {{fmt::format("claim {} is {}", claim.id, name_of(claim.expected)), r.stands(),
             r.finding ? r.finding->text : r.failure, slide.line}};
}

}  // namespace

std::vector<ExpectationResult> played(const Lecture& lecture, std::size_t n) {
    const LectureSlide& slide = lecture.slides.at(n);
    if (!slide.trouble.empty()) throw Refused(slide.trouble);
    if (slide.deck) return played_deck(*slide.deck);
    if (slide.scene) return played_scene(lecture, slide);
    return slide.claim.empty() ? std::vector<ExpectationResult>() : played_claim(slide);
}

}  // namespace pliant
