// What a lecture tells of itself, and its slides played headless.
#include <pliant/document/walkthrough_words.h>
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

namespace {

constexpr std::string_view of_second_run = "B ";

// The expectations of one of the two runs. A line of the other is left blank, so that places stay what they are.
Slide slide_of_run(Slide slide, bool second) {
    for (Block& b : slide.blocks) {
        if (b.kind != BlockKind::expect) continue;
        for (std::string& line : b.lines) {
            line = trimmed(line);
            const bool of_second = line.starts_with(of_second_run);
            line = of_second != second ? "" : of_second ? line.substr(of_second_run.size()) : line;
        }
    }
    return slide;
}

}  // namespace

Walkthrough walkthrough_of(const Lecture& lecture, const LectureSlide& slide, bool second_run) {
    return {.path = lecture.path, .title = lecture.title, .introduction = {}, .slides = {slide_of_run(slide.slide, second_run)}};
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

std::vector<ExpectationResult> played_run(const Lecture& lecture, const LectureSlide& slide, bool second) {
    Runner::Assignments parameters = slide.scene->parameters;
    if (second) parameters.insert(parameters.end(), slide.beside->begin(), slide.beside->end());
    Runner runner(find_lesson(slide.scene->lesson), parameters);
    runner.set_events(slide.scene->events);
    WalkthroughPlayer player(runner, walkthrough_of(lecture, slide, second));
    player.next();
    return player.results();
}

std::vector<ExpectationResult> played_scene(const Lecture& lecture, const LectureSlide& slide) {
    auto results = played_run(lecture, slide, false);
    if (!slide.beside) return results;
    for (ExpectationResult& r : played_run(lecture, slide, true)) {
        r.text = std::string(of_second_run) + r.text;
        r.sentence = "in B " + r.sentence;
        results.push_back(std::move(r));
    }
    return results;
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
