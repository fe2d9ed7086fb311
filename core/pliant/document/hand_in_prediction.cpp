// What was predicted on a slide, kept so that it can be played again.
#include <pliant/document/hand_in.h>
#include <pliant/document/share.h>
#include <pliant/document/walkthrough.h>
#include <pliant/document/walkthrough_words.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pliant {
namespace {

bool plays_or_judges(BlockKind kind) {
    return kind == BlockKind::actions || kind == BlockKind::expect || kind == BlockKind::predict;
}

std::string text_that_plays(const Slide& slide) {
    std::string text;
    for (const Block& b : slide.blocks)
        if (plays_or_judges(b.kind)) text += fmt::format("```{}\n{}\n```\n", name_of(b.kind), fmt::join(b.lines, "\n"));
    return text;
}

std::string question_on(const Slide& slide) {
    for (const Block& b : slide.blocks)
        if (b.kind == BlockKind::ask) return b.paragraph();
    return "";
}

// Is the slide that of the lesson, as this version of Pliant has it? True for slides of other files.
bool is_known(const HandInEntry& e) {
    try {
        for (const Slide& slide : walkthrough_of(find_lesson(e.lesson)).slides)
            if (slide.title == e.slide) return text_that_plays(slide) == e.slide_text;
    } catch (const Refused&) {  // it has none
    }
    return true;
}

std::string_view verdict_words(bool right) { return right ? "right" : "not right"; }

}  // namespace

HandInEntry prediction_of(const Runner& runner, const WalkthroughPlayer& player) {
    const PredictionVerdict& v = player.verdict().value();
    HandInEntry e{.kind = HandInEntry::Kind::prediction, .lesson = std::string(runner.info().id), .slide = player.slide().title};
    e.question = question_on(player.slide());
    e.predicted = v.predicted, e.came = v.came, e.text = v.words, e.right = v.right;
    e.after_answer = player.guess().after_answer;
    if (!player.entered()) return e;
    const SceneFile& entered = *player.entered();
    try {
        e.scene = share_text(entered);
        if (!runner.events().empty())
            e.script = share_text({.lesson = entered.lesson, .parameters = {}, .events = runner.events()});
        if (player.left()) e.left = share_text(*player.left());
    } catch (const Refused&) {  // more than a share string holds: it is told, and cannot be played again
        e.scene.clear(), e.script.clear(), e.left.clear();
        return e;
    }
    e.slide_text = text_that_plays(player.slide());
    e.guess = player.guess(), e.guess.after_answer = false;  // the entry says it
    return e;
}

HandInFinding repeated_prediction(const HandInEntry& e) {
    const SceneFile scene = read_share(e.scene);
    Runner runner(find_lesson(scene.lesson), scene.parameters, 0);
    const auto script = e.script.empty() ? std::vector<Event>{} : read_share(e.script).events;
    // What was done by hand has happened on the way; what starts anew begins without it.
    const auto play = [&](const SceneFile& to) { play_to_place(runner, to), runner.set_events(script); };
    play(scene);
    WalkthroughPlayer player(runner, parse_walkthrough(fmt::format("# {0}\n\n## {0}\n\n{1}", e.slide, e.slide_text), e.slide));
    player.guess(e.guess);
    if (!e.left.empty()) play(read_share(e.left));
    player.next();
    const PredictionVerdict v = player.verdict().value_or(PredictionVerdict{});
    const std::string where = fmt::format("prediction, {}, {}", e.lesson, e.slide);
    if (v.right != e.right || v.came != e.came)
        return {true, false,
                fmt::format("{}: handed in as {}, with “{}” from the run; played again, the run gives “{}” and it is {}", where,
                            verdict_words(e.right), e.came, v.came, verdict_words(v.right))};
    return {true, true,
            fmt::format("{}: {} Played again: the same.{}", where, e.text,
                        is_known(e) ? "" : " (The slide asks something else in this version of Pliant.)")};
}

}  // namespace pliant
