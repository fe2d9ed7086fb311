// What the lab does with what is to be handed in: where it is kept between two starts, and the file that is handed in.
#include <pliant/document/hand_in.h>
#include <pliant/study/claims.h>
#include <pliant/text/file.h>

#include "app/lab.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <utility>

namespace pliant::viewer {
namespace {

// Whose file it is; empty where there is none, or none that is a hand-in.
std::optional<std::string> owner_of(const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return std::nullopt;
    try {
        return read_hand_in(read_file(path), path).hand_in.name;
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace

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

// Where it was saved last, as long as that is this person's; else from the name and the lessons.
std::string Lab::name_to_hand_in() const {
    const HandIn& now = state_.session.notebook.hand_in();
    const std::string& last = state_.hand_in.file;
    if (!last.empty() && owner_of(last) == now.name) return last;
    return hand_in_file_name(now, state_.session.entry().info.id);
}

void Lab::save_hand_in(const std::string& path) {
    const HandIn& now = state_.session.notebook.hand_in();
    if (const auto owner = owner_of(path); owner && *owner != now.name)
        throw Refused(fmt::format("{} was handed in by {}: choose another name.", std::filesystem::path(path).filename().string(),
                                  owner->empty() ? "somebody without a name" : *owner));
    write_file(path, hand_in_text(now));
    std::error_code error;
    const auto whole = std::filesystem::absolute(path, error);
    state_.hand_in.file = error ? path : whole.lexically_normal().string();
    tell_written(path);
}

void Lab::do_for_hand_in() {
    Session& s = state_.session;
    HandInPanelState& panel = state_.hand_in;
    note_claims();
    if (std::exchange(panel.wants_picture, false)) {
        s.dismiss();
        panel.takes_picture = true;
        capture_ = Capture{.path = {}, .to_notebook = true};
    }
    if (std::exchange(panel.wants_save, false))
        state_.files.ask(FileChoice::Purpose::save, "Save what you hand in", {std::string(hand_in_ending)}, name_to_hand_in(),
                         [this](const std::string& path) { save_hand_in(path); });
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
