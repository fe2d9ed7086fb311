// Plays a walkthrough: its actions, and what it expects.
#include <pliant/document/scene_file.h>
#include <pliant/document/summary.h>
#include <pliant/document/walkthrough.h>
#include <pliant/document/walkthrough_sentences.h>
#include <pliant/document/walkthrough_words.h>
#include <pliant/run/until.h>
#include <pliant/text/format.h>
#include <pliant/text/number_text.h>
#include <pliant/text/spoken.h>

#include <fmt/format.h>

#include <cmath>

namespace pliant {
WalkthroughPlayer::WalkthroughPlayer(Runner& runner, Walkthrough walkthrough, std::function<void()> after_step)
    : runner_(runner), walkthrough_(std::move(walkthrough)), after_step_(std::move(after_step)) {
    check_controls();
    check_names();
    read_predictions();
    enter();
}

void WalkthroughPlayer::check_controls() const {
    for (const Slide& s : walkthrough_.slides)
        for (const Block& b : s.blocks) {
            if (b.kind != BlockKind::controls || b.paragraph() == "none") continue;
            int number = b.first_line;
            for (const std::string& line : b.lines) {
                for (const std::string& key : words_of_line(line)) check_control(key, number);
                ++number;
            }
        }
}

void WalkthroughPlayer::check_control(const std::string& key, int line) const {
    if (key == "none") refuse(line, "'none' stands alone: it locks all parameters");
    try {
        runner_.lesson().parameter(key);
    } catch (const Refused& e) {
        refuse(line, fmt::format("{} (in controls)", e.what()));
    }
}

void WalkthroughPlayer::refuse(int line, const std::string& what) const {
    throw Refused(fmt::format("{}:{}: {}", walkthrough_.path, line, what));
}

bool WalkthroughPlayer::next() {
    if (!revealed_ && slide().has_answer()) return reveal(), note_seen(), true;
    if (slide_ + 1 == walkthrough_.slides.size()) return false;
    ++slide_;
    enter();
    return true;
}

bool WalkthroughPlayer::back() {
    if (slide_ == 0 && !revealed_) return false;
    go_to_slide(revealed_ ? slide_ : slide_ - 1);
    return true;
}

void WalkthroughPlayer::go_to_slide(std::size_t n) {
    const std::size_t count = walkthrough_.slides.size();
    if (n >= count) throw Refused(fmt::format("slide {} is not there: {} has slides 1 to {}", n + 1, walkthrough_.path, count));
    runner_.load({});
    shown_field_.clear();
    for (slide_ = 0; slide_ < n; ++slide_) enter(), reveal();
    enter();
}

// The set-up of the slide. What was measured before it is what `before` means.
void WalkthroughPlayer::enter() {
    revealed_ = false;
    results_.clear();
    verdict_.reset();
    measured_curve_.clear();
    before_.clear();
    entered_.reset(), left_.reset();
    if (prediction()) entered_ = placed_scene_of(runner_);
    for (const Probe& p : runner_.lesson().probes)
        if (const auto value = runner_.value(p)) before_[std::string(p.name)] = *value;
    play(true);
    entered_at_ = runner_.revision();
}

// The set-up: the actions before the first that runs, or that is expected to have done something. Or else what comes behind it,
// block by block.
void WalkthroughPlayer::play(bool set_up) {
    SetUp leading;
    for (const Block& b : slide().blocks) {
        const bool expects = b.kind == BlockKind::expect;
        if (b.kind != BlockKind::actions && !expects) continue;
        int number = b.first_line;
        for (const std::string& raw : b.lines) {
            if (const std::string line = trimmed(raw); !line.empty()) {
                if (expects) leading.end();
                if (leading.takes(line) == set_up) expects ? results_.push_back(check(line, number)) : act(line, number);
            }
            ++number;
        }
    }
}

// Where a person has changed or moved something since the slide was entered, its scene is set up again.
void WalkthroughPlayer::reveal() {
    if (runner_.revision() != entered_at_) {
        if (prediction()) left_ = placed_scene_of(runner_);
        play(true);
    }
    results_.clear();
    follow_sketch();
    play(false);
    revealed_ = true;
    judge();
}

namespace {

// "run 20 steps", "run 0.5 s", "run rest", "run to advection".
void run_for(Runner& runner, const std::vector<std::string>& words, const std::function<void()>& after_step) {
    if (words.size() == 2 && words[1] == "rest") return advance(runner, Until::at_rest(), after_step);
    if (words.size() == 3 && words[2] == "s")
        if (const auto seconds = finite_number(words[1])) return advance(runner, Until::after_time(*seconds), after_step);
    if (words.size() == 3 && (words[2] == "steps" || words[2] == "step"))
        if (const auto steps = whole_number(words[1])) return advance(runner, Until::after_steps(*steps), after_step);
    if (words.size() == 3 && words[1] == "to") return runner.run_to_stage(words[2]);
    throw Refused("run needs one of: N steps, T s, rest, to STAGE");
}

Pull pull_of(const std::vector<std::string>& words) {
    const auto index = words.size() == 6 && words[2] == "to" ? whole_number(words[1]) : std::nullopt;
    Vec<3> to;
    bool complete = index.has_value();
    for (std::size_t i = 0; complete && i < 3; ++i) {
        const auto value = finite_number(words[3 + i]);
        complete = value.has_value();
        to[static_cast<Index>(i)] = value.value_or(0);
    }
    if (!complete) throw Refused("pull needs: INDEX to X Y Z");
    return {*index, to, to};
}

}  // namespace

void WalkthroughPlayer::act(const std::string& line, int number) {
    const auto words = words_of_line(line);
    const bool was_at_start = runner_.place() == Place{};
    try {
        perform(words);
    } catch (const Refused& e) {
        refuse(number, fmt::format("{} (in '{}')", e.what(), line));
    }
    if (after_step_ && !was_at_start && runner_.place() == Place{}) after_step_();
}

void WalkthroughPlayer::perform(const std::vector<std::string>& words) {
    if (words[0] == "set" && words.size() > 1) return runner_.assign(assignments_of(words));
    if (words[0] == "reset" && words.size() == 1) return runner_.reset();
    const auto each_step = [this] {
        track_step();
        if (after_step_) after_step_();
    };
    if (words[0] == "run") return run_for(runner_, words, each_step);
    if (words[0] == "solve" && words.size() == 1) {
        if (!runner_.is_static()) throw Refused("solve is for static lessons; this one runs: run N steps, T s or rest");
        return advance(runner_, Until::at_rest(), each_step);
    }
    if (words[0] == "release" && words.size() == 1) return runner_.pull(std::nullopt);
    if (words[0] == "pull") return runner_.pull(pull_of(words));
    if (words[0] == "preset" && words.size() == 2)
        return runner_.load(preset(find_lesson(runner_.info().id), words[1]).parameters);
    if (words[0] == "show" && words.size() == 2) return void(shown_field_ = runner_.lesson().field(words[1]).name);
    throw Refused(
        "no such action; there are: set KEY=VALUE ..., reset, run, solve, show FIELD, pull INDEX to X Y Z, release, preset NAME");
}

Real WalkthroughPlayer::quantity(std::string_view name) const {
    if (name == "time") return runner_.time();
    if (name == "step") return static_cast<Real>(runner_.place().step);
    for (const Parameter* p : runner_.lesson().parameters)
        if (p->info.is_called(name)) return p->value();
    const auto value = runner_.value(runner_.lesson().probe(name));
    if (!value) throw Refused(fmt::format("the probe '{}' is not defined here", name));
    return *value;
}

// A probe that is called by an older name has been measured by the one of today.
std::optional<Real> WalkthroughPlayer::before_of(std::string_view name) const {
    auto found = before_.find(name);
    for (const Probe& p : runner_.lesson().probes)
        if (found == before_.end() && !name.empty() && p.formerly == name) found = before_.find(p.name);
    return found == before_.end() ? std::nullopt : std::optional(found->second);
}

std::string WalkthroughPlayer::unit_of(std::string_view name) const {
    if (name == "time") return "s";
    if (name == "step") return "";
    for (const Parameter* p : runner_.lesson().parameters)
        if (p->info.key == name) return std::string(p->info.unit);
    return std::string(runner_.lesson().probe(name).unit);
}

// NAME OP [FACTOR] VALUE [within TOLERANCE [relative]]
ExpectationResult WalkthroughPlayer::check(const std::string& line, int number) const try {
    const auto words = words_of_line(line);
    if (words.size() < 3) throw Refused("an expectation reads: NAME < VALUE, or NAME = VALUE within TOLERANCE [relative]");
    const Real left = quantity(words[0]);

    // The right side, with its optional factor.
    std::size_t at = 2;
    Real factor = 1;
    if (const auto number_first = finite_number(words[at]); number_first && at + 1 < words.size() && words[at + 1] != "within")
        factor = *number_first, ++at;
    const std::string& term = words[at++];
    Real right = 0;
    ExpectedNumber expected{.name = words[0], .comparison = words[1], .left = left};
    if (const auto constant = finite_number(term))
        right = *constant;
    else if (term == "exact")
        right = runner_.exact(runner_.lesson().probe(words[0])).value(), expected.what = "the exact value";
    else if (term == "before" && before_of(words[0]))
        right = *before_of(words[0]), expected.what = "what it was before";
    else
        right = quantity(term), expected.what = fmt::format("the {}", spoken(term));
    right *= factor;
    if (factor != 1 && !expected.what.empty())
        expected.what = fmt::format("{} times {}", format_quantity(factor, "", 3), expected.what);
    expected.right = right;

    const std::string& op = words[1];
    bool met = false;
    if (op == "=") {
        const auto tolerance = at + 1 < words.size() && words[at] == "within" ? finite_number(words[at + 1]) : std::nullopt;
        if (!tolerance) throw Refused("= needs a tolerance: within 1e-6, or within 1e-6 relative");
        at += 2;
        const bool relative = at < words.size() && words[at] == "relative";
        if (relative) ++at;
        expected.tolerance = *tolerance, expected.relative = relative;
        met = std::abs(left - right) <= *tolerance * (relative ? std::abs(right) : 1);
    } else if (op == "<" || op == "<=" || op == ">" || op == ">=") {
        met = op == "<" ? left < right : op == "<=" ? left <= right : op == ">" ? left > right : left >= right;
    } else {
        throw Refused(fmt::format("unknown comparison '{}'; known: < <= > >= =", op));
    }
    if (at < words.size()) throw Refused(fmt::format("'{}' is more than an expectation says: leave it out", words[at]));
    const std::string unit = unit_of(words[0]);
    return {line, met,
            fmt::format("{} {} {}, against {}", spoken(words[0]), is_or_are(spoken(words[0])), format_quantity(left, unit, 4),
                        format_quantity(right, unit, 4)),
            number, expectation_sentence(runner_.lesson(), expected)};
} catch (const Refused& e) {
    refuse(number, fmt::format("{} (in '{}')", e.what(), line));
} catch (const std::bad_optional_access&) {
    refuse(number, fmt::format("this probe has no exact value here (in '{}')", line));
}

}  // namespace pliant
