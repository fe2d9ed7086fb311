// A lesson told slide by slide: predict, run, check. The text lies beside the lesson as walkthrough.md and reads well as it is; a
// panel of the lab plays it, and `pliant walkthrough LESSON --check` plays it headless.
//
// The format is Markdown. `# Title` opens it, the words up to the first slide say why the lesson is there (they introduce its
// page, not the slides), and `## Title` begins a slide; fenced blocks have these meanings:
//   ```formula   shown as a formula
//   ```ask       the question to answer before going on
//   ```predict   what a person enters before going on: a choice, a number or a curve (prediction.h)
//   ```do        what happens, an action a line. set, reset, preset and show that stand before the first other action are the
//                set-up of the slide: they happen as soon as it is entered. So does a `solve` behind them, which ends the set-up:
//                a static lesson stands solved beside the question. The others wait for the next press of Next:
//                  set KEY=VALUE ...   reset   run N steps   run T s   run rest   run to STAGE   solve
//                  show FIELD          pull INDEX to X Y Z   release   preset NAME
//   ```expect    what must then hold, a line each:
//                  NAME <|<=|>|>=|= VALUE [within TOLERANCE [relative]]
//                where NAME is a probe, a parameter, `time` or `step`, and VALUE a number, `exact` (of that probe), `before` (its
//                value before the actions), another NAME, or a number times one of these ("0.5 before"); = needs a tolerance
//   ```answer    shown after the actions
//   ```hide      what would give the answer away, and does not show until then: names of probes, curves, fields and parameters
//                (their sliders are covered), and
//                  labels   the words in the picture
//                  titles   of the plots and their axes, and what sets two runs apart
//                  legends  the names of the curves
//                  theory   exact values, and the curves that stand beside a measured one
//                  matrices of the picture
//                  lights   of the assumptions and of what is conserved, and the notes above the picture
//                Probes that are expected, or predicted, are hidden without being named, and lights beside every question
//   ```plots     the probes and curves that are plotted beside the slide; without it those of the
//                scene, with `none` none
//   ```notes     for the lecturer alone: never shown with the slide itself
//   ```controls  the keys of the parameters that a person may change on this slide, one or more a line. All others are locked
//   while
//                the slide shows; `none`, or an empty block, locks all. A slide without this block leaves all free.
#pragma once
#include <pliant/document/prediction.h>
#include <pliant/document/scene_file.h>
#include <pliant/run/runner.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

// scene: of extensions alone (extensions.h). show: of lectures alone (lecture/lecture.h).
enum class BlockKind { text, formula, ask, predict, actions, expect, answer, hide, plots, notes, controls, scene, show };

struct Block {
    BlockKind kind;
    std::vector<std::string> lines;
    int first_line = 0;  // in the file, from 1
    // The lines as one paragraph.
    std::string paragraph() const;
};

struct Slide {
    std::string title;
    std::vector<Block> blocks;
    int line = 0;  // of its title in the file, from 1
    bool has(BlockKind kind) const;
    // What the lecturer should know; "" when nothing is noted.
    std::string notes() const;
    // May a person change the parameter of this key?
    bool allows(std::string_view key) const;
    // Is this probe, curve, field or parameter hidden until the answer is shown? Or one of "labels", "titles", "legends",
    // "theory", "matrices" and "lights".
    bool hides(std::string_view name) const;
    // The probes and curves that are plotted beside it; empty: it does not say.
    std::optional<std::vector<std::string>> plots() const;
    // Is there something to reveal?
    bool has_answer() const { return has(BlockKind::actions) || has(BlockKind::expect) || has(BlockKind::answer); }
};

struct Walkthrough {
    std::string path, title;
    std::vector<std::string> introduction;  // paragraphs
    std::vector<Slide> slides;
};

// Which further block the slides may have: a ```scene as extensions, or a ```show as lectures.
enum class ExtraBlock { none, scene, show };

// Throws Refused naming file and line.
Walkthrough parse_walkthrough(std::string_view text, std::string_view path, ExtraBlock extra = ExtraBlock::none);
// The walkthrough of a lesson; throws Refused when it has none.
Walkthrough walkthrough_of(const LessonEntry& entry);

struct ExpectationResult {
    std::string text;  // the line
    bool met = false;
    std::string measured;  // "strain is 0.049, against 0.05"
    int line = 0;
    std::string sentence{};  // "the strain is 0.049, expected below 0.05", for people
};

// Plays a walkthrough on a runner. Each slide has a first half (text, formula, question) and, after the actions, a second half
// (answer and what was expected).
class WalkthroughPlayer {
public:
    // after_step, where given, is called behind each whole step that an action runs, and where an action starts the run
    // again. Throws Refused naming file and line when a
    // slide's controls name a parameter that the lesson lacks.
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
    // To the start of the slide before (or of this one, when it was revealed), as go_to_slide; false at the beginning.
    bool back();
    // To the start of slide n, counted from 0: everything up to there is played again from the initial parameters, so whatever a
    // person changed is gone. Throws as next, and Refused when there is no such slide.
    void go_to_slide(std::size_t n);
    // To the start of this slide, as it was before anything was changed on it.
    void reset_slide() { go_to_slide(slide_); }

    // --- the prediction of this slide ---
    const std::optional<Prediction>& prediction() const { return predictions_[slide_]; }
    const Guess& guess() const { return guesses_[slide_]; }
    // Before the answer is shown; marked where it had been shown earlier and what is said is new. Throws Refused for an answer
    // that there is none of.
    void guess(const Guess& guess);
    // The answer of this slide has been seen, in this walkthrough or in another.
    void note_seen() { seen_[slide_] = true; }
    // Of an answer in words, once the lesson's is shown. Throws Refused where none was given.
    void say_right(bool right);
    // What was said earlier, in a scene that is opened again; also behind the answer. Throws Refused as guess.
    void restore(const Guess& guess);
    // Once the answer is shown; also of a slide where nothing was predicted, and then it says what came.
    const std::optional<PredictionVerdict>& verdict() const { return verdict_; }
    // Of a sketch: what was measured, as that has it; empty before.
    const Sketch& measured_curve() const { return measured_curve_; }
    // Where the run stood before this slide was set up, and as a person left it before the answer was shown, where it had been
    // changed or moved since: what it takes to play the prediction again. Of slides that ask for one.
    const std::optional<SceneFile>& entered() const { return entered_; }
    const std::optional<SceneFile>& left() const { return left_; }
    // Does something show that the slide hides until its answer?
    bool hides(std::string_view name) const { return !revealed_ && slide().hides(name); }

    // May a person change the parameter of this key on this slide?
    bool allows(std::string_view key) const { return slide().allows(key); }

private:
    void check_controls() const;
    void check_names() const;
    void read_predictions();
    void check_guess(const Guess& guess) const;
    void enter();
    void play(bool set_up);
    void follow_sketch();
    void track_step();
    void judge();
    void compare_guess();
    void check_control(const std::string& key, int line) const;
    void reveal();
    void act(const std::string& line, int number);
    void perform(const std::vector<std::string>& words);
    ExpectationResult check(const std::string& line, int number) const;
    Real quantity(std::string_view name) const;
    std::optional<Real> before_of(std::string_view name) const;
    std::string unit_of(std::string_view name) const;
    [[noreturn]] void refuse(int line, const std::string& what) const;

    Runner& runner_;
    Walkthrough walkthrough_;
    std::function<void()> after_step_;
    std::size_t slide_ = 0;
    bool revealed_ = false;
    long entered_at_ = 0;                                 // revision of the run when the slide was set up
    std::vector<std::optional<Prediction>> predictions_;  // of each slide
    std::vector<Guess> guesses_;
    std::vector<bool> seen_;  // of each slide: has next() shown its answer?
    std::optional<PredictionVerdict> verdict_;
    std::optional<SceneFile> entered_, left_;
    Track track_;
    Real track_start_ = 0;
    Sketch measured_curve_;
    std::string shown_field_;
    std::map<std::string, Real, std::less<>> before_;
    std::vector<ExpectationResult> results_;
};

}  // namespace pliant
