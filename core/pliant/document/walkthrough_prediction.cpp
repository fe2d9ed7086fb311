// What is predicted on the slides of a walkthrough, and what the run gives.
#include <pliant/document/walkthrough.h>
#include <pliant/document/walkthrough_words.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace pliant {

namespace {

constexpr std::array<std::string_view, 6> parts_to_hide{"labels", "titles", "legends", "theory", "matrices", "lights"};

bool is_plotted(const Lesson& lesson, std::string_view name) {
    return std::ranges::find(lesson.probes, name, &Probe::name) != lesson.probes.end() ||
           std::ranges::find(lesson.lines, name, &Line::name) != lesson.lines.end();
}

bool can_be_hidden(const Lesson& lesson, std::string_view name) {
    return is_plotted(lesson, name) || std::ranges::find(parts_to_hide, name) != parts_to_hide.end() ||
           std::ranges::find(lesson.fields, name, &Field::name) != lesson.fields.end() ||
           std::ranges::any_of(lesson.parameters, [&](const Parameter* p) { return p->info.key == name; });
}

}  // namespace

// What is hidden or plotted is there.
void WalkthroughPlayer::check_names() const {
    const Lesson& lesson = runner_.lesson();
    for (const Slide& s : walkthrough_.slides)
        for (const Block& b : s.blocks) {
            if (b.kind != BlockKind::hide && b.kind != BlockKind::plots) continue;
            if (b.kind == BlockKind::plots && b.paragraph() == "none") continue;
            for (const std::string& name : words_of_line(b.paragraph())) {
                if (b.kind == BlockKind::plots && !is_plotted(lesson, name))
                    refuse(b.first_line, fmt::format("'{}' is neither a probe nor a curve of this lesson (in plots)", name));
                if (b.kind == BlockKind::hide && !can_be_hidden(lesson, name))
                    refuse(b.first_line, fmt::format("'{}' is no probe, curve, field or parameter of this lesson, nor one of {} "
                                                     "(in hide)",
                                                     name, fmt::join(parts_to_hide, ", ")));
            }
        }
}

void WalkthroughPlayer::read_predictions() {
    for (const Slide& s : walkthrough_.slides) {
        std::optional<Prediction>& prediction = predictions_.emplace_back();
        for (const Block& b : s.blocks) {
            if (b.kind != BlockKind::predict) continue;
            if (prediction) refuse(b.first_line, "a slide asks for one prediction");
            prediction = read_prediction(b, walkthrough_.path);
            try {
                check_prediction(*prediction, runner_.lesson());
            } catch (const Refused& e) {
                refuse(b.first_line, fmt::format("{} (in predict)", e.what()));
            }
        }
        if (!prediction && s.has(BlockKind::ask) && s.has_answer()) prediction = Prediction{.kind = Prediction::Kind::words};
    }
    guesses_.resize(walkthrough_.slides.size()), seen_.resize(walkthrough_.slides.size());
}

void WalkthroughPlayer::check_guess(const Guess& guess) const {
    const auto& p = prediction();
    if (!p) throw Refused("this slide asks for no prediction");
    if (guess.option && *guess.option >= p->options.size())
        throw Refused(fmt::format("answer {} is not there: there are {}", *guess.option + 1, p->options.size()));
    if (guess.words.size() > longest_answer)
        throw Refused(fmt::format("an answer has at most {} bytes, this one {}", longest_answer, guess.words.size()));
    const bool fits = (!guess.number || p->kind == Prediction::Kind::number) &&
                      (guess.sketch.empty() || p->kind == Prediction::Kind::sketch) &&
                      (guess.words.empty() || p->kind == Prediction::Kind::words);
    if (!fits) throw Refused("this slide asks for a prediction of another kind");
}

void WalkthroughPlayer::guess(const Guess& guess) {
    check_guess(guess);
    if (revealed_) throw Refused("the answer is shown already: Backspace goes back to the start of the slide");
    Guess said = guess, earlier = guesses_[slide_];
    said.was_right.reset(), earlier.was_right.reset();
    said.after_answer = earlier.after_answer;
    const bool repeats = said.given() && said == earlier;
    if (!repeats) said.after_answer = seen_[slide_];
    guesses_[slide_] = said;
}

void WalkthroughPlayer::say_right(bool right) {
    if (!revealed_ || guess().words.empty()) throw Refused("there is no answer in words beside the lesson's here");
    guesses_[slide_].was_right = right;
    judge();
}

void WalkthroughPlayer::restore(const Guess& guess) {
    check_guess(guess);
    guesses_[slide_] = guess;
    if (revealed_) return judge();
    guesses_[slide_].was_right.reset();
}

// From here on the probe of a sketch is measured step by step.
void WalkthroughPlayer::follow_sketch() {
    track_.clear();
    measured_curve_.clear();
    verdict_.reset();
    track_start_ = runner_.is_static() ? static_cast<Real>(runner_.place().step) : runner_.time();
    track_step();
}

void WalkthroughPlayer::track_step() {
    const auto& p = prediction();
    if (!p || p->kind != Prediction::Kind::sketch) return;
    const Real now = runner_.is_static() ? static_cast<Real>(runner_.place().step) : runner_.time();
    if (const auto value = runner_.value(runner_.lesson().probe(p->probe))) track_.emplace_back(now - track_start_, *value);
}

void WalkthroughPlayer::judge() {
    if (!prediction()) return;
    compare_guess();
    if (verdict_) note_after_answer(*verdict_, guess());
}

void WalkthroughPlayer::compare_guess() {
    const auto& p = prediction();
    if (p->kind == Prediction::Kind::words) {
        verdict_ = verdict_of_words(guess());
        return;
    }
    if (p->kind == Prediction::Kind::choice) {
        std::vector<bool> met;
        for (const Prediction::Option& o : p->options) met.push_back(check(o.condition, o.line).met);
        verdict_ = judge_choice(*p, guess(), met);
        return;
    }
    const std::string unit(runner_.lesson().probe(p->probe).unit);
    if (p->kind == Prediction::Kind::number) {
        verdict_ = judge_number(*p, guess(), runner_.value(p->probe), unit);
        return;
    }
    measured_curve_ = sampled(track_, p->span);
    verdict_ = judge_sketch(*p, guess(), measured_curve_, unit);
}

}  // namespace pliant
