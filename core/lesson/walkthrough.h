// A lesson told slide by slide: predict, run, check. The text lies beside the lesson as walkthrough.md and reads well as it is; a
// panel of the lab plays it, and `pliant walkthrough LESSON --check` plays it headless.
//
// The format is Markdown. `# Title` opens it and `## Title` begins a slide; fenced blocks have these meanings:
//   ```formula   shown as a formula
//   ```ask       the question to answer before going on
//   ```do        what happens on the next press of Next, an action a line:
//                  set KEY=VALUE ...   reset   run N steps   run T s   run rest   run to STAGE
//                  show FIELD          pull INDEX to X Y Z   release   preset NAME
//   ```expect    what must then hold, a line each:
//                  NAME <|<=|>|>=|= VALUE [within TOLERANCE [relative]]
//                where NAME is a probe, a parameter, `time` or `step`, and VALUE a number, `exact` (of that probe), `before` (its
//                value before the actions), another NAME, or a number times one of these ("0.5 before"); = needs a tolerance
//   ```answer    shown after the actions
#pragma once
#include <pliant/lesson/runner.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

enum class BlockKind { text, formula, ask, actions, expect, answer };

struct Block {
    BlockKind kind;
    std::vector<std::string> lines;
    int first_line = 0;  // in the file, from 1
};

struct Slide {
    std::string title;
    std::vector<Block> blocks;
    bool has(BlockKind kind) const;
};

struct Walkthrough {
    std::string path, title;
    std::vector<Slide> slides;
};

// Throws Refused naming file and line.
Walkthrough parse_walkthrough(std::string_view text, std::string_view path);
// The walkthrough of a lesson; throws Refused when it has none.
Walkthrough walkthrough_of(const LessonEntry& entry);

struct ExpectationResult {
    std::string text;  // the line
    bool met = false;
    std::string measured;  // "strain = 0.049, limit 0.05"
    int line = 0;
};

// Plays a walkthrough on a runner. Each slide has a first half (text, formula, question) and, after the actions, a second half
// (answer and what was expected).
class WalkthroughPlayer {
public:
    // after_step, where given, is called behind each whole step that an action runs.
    WalkthroughPlayer(Runner& runner, Walkthrough walkthrough, std::function<void()> after_step = {});

    const Walkthrough& walkthrough() const { return walkthrough_; }
    std::size_t slide_number() const { return slide_; }
    const Slide& slide() const { return walkthrough_.slides[slide_]; }
    bool revealed() const { return revealed_; }
    const std::vector<ExpectationResult>& results() const { return results_; }
    // The field that the slides so far asked to show; "" when none did.
    const std::string& shown_field() const { return shown_field_; }

    // Performs the actions of the slide, if they have not been, else goes to the next slide. False at the end. Throws Refused
    // naming file and line for an action that the lesson refuses, and Diverged when the run does.
    bool next();
    // To the start of the slide before (or of this one, when it was revealed): everything up to there is played again.
    bool back();

private:
    void reveal();
    void act(const std::string& line, int number);
    ExpectationResult check(const std::string& line, int number) const;
    Real quantity(std::string_view name) const;
    [[noreturn]] void refuse(int line, const std::string& what) const;

    Runner& runner_;
    Walkthrough walkthrough_;
    std::function<void()> after_step_;
    std::size_t slide_ = 0;
    bool revealed_ = false;
    std::string shown_field_;
    std::map<std::string, Real, std::less<>> before_;
    std::vector<ExpectationResult> results_;
};

}  // namespace pliant
