#include "session/notebook.h"

#include <pliant/document/share.h>
#include <pliant/document/walkthrough.h>
#include <pliant/text/sha256.h>

#include <algorithm>
#include <utility>

namespace pliant::viewer {
namespace {

using EntryKind = HandInEntry::Kind;

std::string question_of(const WalkthroughPlayer& player) {
    for (const Block& b : player.slide().blocks)
        if (b.kind == BlockKind::ask) return b.paragraph();
    return "";
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

void Notebook::add_prediction(HandInEntry entry) {
    std::erase_if(hand_in_.entries, [&](const HandInEntry& e) {
        return e.kind == EntryKind::prediction && e.lesson == entry.lesson && e.slide == entry.slide &&
               e.question == entry.question;
    });
    add(std::move(entry));
}

void Notebook::note_prediction(const Runner& runner, const WalkthroughPlayer& player) {
    if (!player.revealed() || !player.verdict() || !player.guess().given()) return;
    const PredictionVerdict& v = *player.verdict();
    HandInEntry e{.kind = EntryKind::prediction, .lesson = std::string(runner.info().id), .slide = player.slide().title};
    e.question = question_of(player);
    e.predicted = v.predicted, e.came = v.came, e.text = v.words, e.right = v.right;
    add_prediction(std::move(e));
}

void Notebook::note_claim(std::string_view lesson, std::string_view claim, std::string_view question, std::string_view predicted,
                          std::string_view came, bool right) {
    HandInEntry e{.kind = EntryKind::prediction, .lesson = std::string(lesson), .slide = "claim " + std::string(claim)};
    e.question = question, e.predicted = predicted, e.came = came, e.right = right;
    e.text = right ? "right" : "not this time";
    const auto same = std::ranges::find(hand_in_.entries, e);
    if (same == hand_in_.entries.end()) add_prediction(std::move(e));
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
