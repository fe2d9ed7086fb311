// What is predicted on the slides of a walkthrough, and what the run gives.
#include <pliant/document/walkthrough.h>
#include <pliant/document/walkthrough_words.h>

#include <fmt/format.h>

#include <algorithm>

namespace pliant {

namespace {

// The first name that a ```hide block has and the lesson has not; "" when all are there.
std::string unknown_in(const Block& hidden, const Lesson& lesson) {
    for (const std::string& name : words_of_line(hidden.paragraph())) {
        const bool known = name == "labels" || std::ranges::find(lesson.probes, name, &Probe::name) != lesson.probes.end() ||
                           std::ranges::find(lesson.lines, name, &Line::name) != lesson.lines.end();
        if (!known) return name;
    }
    return "";
}

}  // namespace

void WalkthroughPlayer::read_predictions() {
    for (const Slide& s : walkthrough_.slides) {
        for (const Block& b : s.blocks)
            if (const std::string name = b.kind == BlockKind::hide ? unknown_in(b, runner_.lesson()) : ""; !name.empty())
                refuse(b.first_line,
                       fmt::format("'{}' is neither a probe nor a curve of this lesson, nor labels (in hide)", name));
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
    }
    guesses_.resize(walkthrough_.slides.size());
}

void WalkthroughPlayer::guess(const Guess& guess) {
    const auto& p = prediction();
    if (!p) throw Refused("this slide asks for no prediction");
    if (revealed_) throw Refused("the answer is shown already: Backspace goes back to the start of the slide");
    if (guess.option && *guess.option >= p->options.size())
        throw Refused(fmt::format("answer {} is not there: there are {}", *guess.option + 1, p->options.size()));
    guesses_[slide_] = guess;
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
    const auto& p = prediction();
    if (!p) return;
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
