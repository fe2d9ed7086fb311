#include "session/notebook.h"

#include <pliant/document/share.h>
#include <pliant/document/walkthrough.h>
#include <pliant/text/sha256.h>

#include <algorithm>
#include <utility>

namespace pliant::viewer {
namespace {

using EntryKind = HandInEntry::Kind;

std::string first_of(const WalkthroughPlayer& player, BlockKind kind) {
    const auto& blocks = player.slide().blocks;
    const auto found = std::ranges::find(blocks, kind, &Block::kind);
    return found == blocks.end() ? "" : found->paragraph();
}

std::string question_of(const WalkthroughPlayer& player) { return first_of(player, BlockKind::ask); }

// A slide without words of its own says by what it expects.
std::string answer_of(const WalkthroughPlayer& player) {
    std::string answer = first_of(player, BlockKind::answer);
    for (const ExpectationResult& r : player.results())
        if (player.slide().has(BlockKind::answer))
            break;
        else
            answer += (answer.empty() ? "" : "; ") + r.sentence;
    return answer.empty() ? "the run" : answer;
}

}  // namespace

void Notebook::set_name(std::string name) {
    if (hand_in_.name == name) return;
    hand_in_.name = std::move(name);
    ++changes_;
}

void Notebook::add(HandInEntry entry) {
    hand_in_.entries.push_back(std::move(entry));
    ++changes_;
}

// An answer that was noted by hand has nothing that came, and stays.
void Notebook::add_anew(HandInEntry entry) {
    std::erase_if(hand_in_.entries, [&](const HandInEntry& e) {
        return e.kind == entry.kind && (e.kind == EntryKind::prediction || !e.came.empty()) && e.lesson == entry.lesson &&
               e.slide == entry.slide && e.question == entry.question;
    });
    add(std::move(entry));
}

void Notebook::note_slide(const Runner& runner, const WalkthroughPlayer& player) {
    if (!player.revealed() || !player.verdict() || !player.guess().given()) return;
    if (player.guess().words.empty()) return add_anew(prediction_of(runner, player));
    HandInEntry e{.kind = EntryKind::answer, .lesson = std::string(runner.info().id), .slide = player.slide().title};
    e.question = question_of(player);
    e.text = player.verdict()->predicted, e.came = answer_of(player), e.own_verdict = player.guess().was_right;
    e.after_answer = player.guess().after_answer;
    add_anew(std::move(e));
}

void Notebook::note_claim(std::string_view lesson, std::string_view claim, std::string_view question, std::string_view predicted,
                          std::string_view came, bool right) {
    HandInEntry e{.kind = EntryKind::prediction, .lesson = std::string(lesson), .slide = "claim " + std::string(claim)};
    e.question = question, e.predicted = predicted, e.came = came, e.right = right;
    e.text = right ? "right" : "not this time";
    const auto same = std::ranges::find(hand_in_.entries, e);
    if (same == hand_in_.entries.end()) add_anew(std::move(e));
}

void Notebook::note_number(const Runner& runner, std::string_view probe) { add(measurement_of(runner, probe)); }

void Notebook::note_answer(const Runner& runner, const WalkthroughPlayer* player, std::string text) {
    HandInEntry e{.kind = EntryKind::answer, .lesson = std::string(runner.info().id)};
    if (player) e.slide = player->slide().title, e.question = question_of(*player);
    e.text = std::move(text);
    add(std::move(e));
}

void Notebook::note_picture(const Runner& runner, std::string_view png) {
    HandInEntry e{.kind = EntryKind::picture, .lesson = std::string(runner.info().id)};
    e.scene = share_text(scene_of(runner));
    e.step = runner.place().step, e.passes = runner.place().passes, e.time = runner.time();
    e.png = base64(png);
    add(std::move(e));
}

void Notebook::erase(std::size_t n) {
    if (n >= hand_in_.entries.size()) return;
    hand_in_.entries.erase(hand_in_.entries.begin() + static_cast<std::ptrdiff_t>(n));
    ++changes_;
}

void Notebook::clear() {
    hand_in_.entries.clear();
    ++changes_;
}

void Notebook::take(HandIn hand_in) { hand_in_ = std::move(hand_in); }

}  // namespace pliant::viewer
