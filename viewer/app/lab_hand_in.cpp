// What the lab does with what is to be handed in: where it is kept between two starts, and the file that is handed in.
#include <pliant/study/claims.h>
#include <pliant/text/file.h>

#include "app/lab.h"

#include <filesystem>
#include <utility>

namespace pliant::viewer {

void Lab::keep_hand_in(const std::string& path) {
    hand_in_path_ = path;
    std::error_code ignored;
    if (path.empty() || !std::filesystem::exists(path, ignored)) return;
    try {
        state_.session.notebook.take(read_hand_in(read_file(path), path).hand_in);
    } catch (const Error& e) {
        const auto aside = set_aside(path, ".bad");
        state_.session.say(Session::Message::Kind::refused,
                           std::string(e.what()) + (aside.empty() ? "" : " It is kept as " + aside.string() + "."));
    }
}

// Claims that were predicted and measured belong to it as well.
void Lab::note_claims() {
    const ClaimBook& book = state_.claims.book;
    for (const Claim* c : book.listed(state_.session.entry().info.id)) {
        const auto answer = book.prediction(*c);
        const auto right = book.was_right(*c);
        if (!answer || !right || !book.result(*c)) continue;
        state_.session.notebook.note_claim(c->lesson, c->id, c->question, c->answers.at(static_cast<std::size_t>(*answer)),
                                           figure_text(*book.result(*c)), *right);
    }
}

void Lab::do_for_hand_in() {
    Session& s = state_.session;
    HandInPanelState& panel = state_.hand_in;
    note_claims();
    if (std::exchange(panel.wants_picture, false)) {
        s.dismiss();
        capture_ = Capture{.path = {}, .to_notebook = true};
    }
    if (std::exchange(panel.wants_save, false))
        state_.files.ask(FileChoice::Purpose::save, "Save what you hand in", ".handin.json", "work.handin.json",
                         [this](const std::string& path) {
                             write_file(path, hand_in_text(state_.session.notebook.hand_in()));
                             tell_written(path);
                         });
    if (hand_in_path_.empty() || std::exchange(hand_in_kept_, s.notebook.changes()) == s.notebook.changes()) return;
    try {
        std::error_code ignored;
        std::filesystem::create_directories(std::filesystem::path(hand_in_path_).parent_path(), ignored);
        write_file(hand_in_path_, hand_in_text(s.notebook.hand_in()));
    } catch (const Error&) {
        hand_in_path_.clear();  // a home that cannot be written to is no reason to disturb
    }
}

}  // namespace pliant::viewer
