// The lab in a window.
#include <pliant/document/share.h>

#include "app/lab.h"
#include "app/lecture_place.h"
#include "app/presenter_window.h"
#include "app/redraw.h"
#include "app/settings.h"
#include "app/state_report.h"
#include "command_line/options.h"
#include "command_line/output_paths.h"
#include "command_line/terminal.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>

namespace pliant::viewer {
namespace {

// What the scene or the walkthrough to open sets without effect.
void check_first(const WindowOptions& o, const std::string& lesson) {
    if (!o.scene_path.empty()) tell_unused(unused_settings(open_scene_text(o.scene_path)), o.strict);
    const LessonEntry& entry = find_lesson(lesson);
    if (o.deck) tell_unused(unused_settings(entry, walkthrough_of(entry)), o.strict);
}

void open_lecture_of(Lab& lab, const WindowOptions& o, const LecturePlace& place) {
    Lecture lecture = read_lecture(with_whole_path(o.lecture));
    const auto count = static_cast<Index>(lecture.slides.size());
    if (o.slide && (*o.slide < 1 || *o.slide > count))
        throw Refused("--slide", static_cast<Real>(*o.slide), "", fmt::format("a number from 1 to {}", count));
    const auto left = o.slide ? std::nullopt : place.left(lecture);
    if (!left) return lab.open_lecture(std::move(lecture), static_cast<std::size_t>(o.slide.value_or(1) - 1));
    // Behind the first frame, so that a long way there shows how far it is.
    lab.state().wanted_scenes.push_back(*left);
}

void open_first(Lab& lab, const WindowOptions& o, const LecturePlace& place) {
    Session& s = lab.session();
    const bool is_string = is_share(o.scene_path);
    std::optional<SceneFile> scene;
    if (!o.scene_path.empty()) scene = open_scene_text(o.scene_path);
    if (scene) Session::check(*scene);
    // Where it stood is where it opens, behind the first frame, so that a long way there shows how far it is.
    const bool stands = scene && scene->version() > 1;
    if (stands)
        is_string ? lab.state().wanted_scenes.push_back(*scene) : lab.state().wanted_files.push_back(o.scene_path);
    else if (scene)
        is_string ? lab.open_scene(*scene) : lab.open_file(o.scene_path);
    s.playing = !o.deck && !stands && o.lecture.empty();
    if (!o.lecture.empty()) return open_lecture_of(lab, o, place);
    if (!o.deck) return;
    walkthrough_of(s.entry());  // refused, rather than a message, when there is none
    lab.open_deck();
}

// As the lab was last; a flag of the command line wins.
void restore(Lab& lab, const SettingsFile& file, const WindowOptions& o, float scale_of_screen) {
    const Settings& s = file.stored();
    lab.set_theme(o.theme.empty() ? s.theme.value_or(Theme::dark) : theme_from(o.theme));
    lab.set_scale(o.ui_scale != 0 ? o.ui_scale : s.scale.value_or(scale_of_screen));
    lab.session().speed = s.speed.value_or(lab.session().speed);
    lab.state().layout = s.layout.value_or(Layout::lab);
    lab.state().scene.hints_shown = s.hints_shown.value_or(true);
    lab.session().patterns = s.patterns.value_or(false);
    lab.state().sizes = s.panels;
    lab.state().recent = s.recent;
    lab.state().hand_in.file = s.hand_in_file;
}

// Writes the lecturer's notes to standard output, for a terminal on another screen, whenever the slide changes.
class NotesPrinter {
public:
    void look_at(const std::optional<WalkthroughPlayer>& player) {
        if (!player || shown_ == player->slide_number()) return;
        shown_ = player->slide_number();
        const std::string notes = player->slide().notes();
        print_now(fmt::format("{} / {}  {}\n{}\n\n", *shown_ + 1, player->walkthrough().slides.size(), player->slide().title,
                              notes.empty() ? "(no notes)" : notes));
    }

private:
    std::optional<std::size_t> shown_;
};

// To those who look at the lab from outside.
void tell(Lab& lab, StateReport& report, NotesPrinter& notes, const WindowOptions& o) {
    if (lab.busy()) {
        if (lab.card_shows())
            report.write_busy(busy_words(lab.worker()->watch().progress(), lab.worker()->seconds()), lab.cancel_button(),
                              lab.busy_frames());
        return;
    }
    lab.state().resting = false;
    if (o.notes) notes.look_at(lab.session().walkthrough);
    report.write(lab.state());
}

// The window of the lecturer, while the lab wants it.
class Lecturer {
public:
    Lecturer(Lab& lab, Context& audience) : lab_(lab), audience_(audience) {}

    // Opens or closes it, and draws it where it has something new; its keys go to the lab. True when the lab has
    // to be drawn for it.
    bool go_on(Real now) {
        PresenterState& state = lab_.state().presenter;
        if (window_ && window_->close_requested()) state.wanted = false;
        if (state.wanted && !window_) open(now);
        if (!state.wanted) window_.reset();
        const bool is_open = window_ != nullptr, changed = is_open != state.open;
        state.open = is_open;
        drew_ = false;
        if (!window_) return changed;
        const std::string busy = busy_line();
        if (lab_.state().resting && !lab_.busy()) next_.follow(lab_.session());
        drew_ = window_->wait(now, state.view, busy, next_.preview()) <= 0;
        if (drew_) draw(now, busy);
        return hand_over(window_->take_actions()) || changed;
    }
    bool drew() const { return drew_; }
    // s until it has to be drawn again.
    Real wait(Real now) {
        return window_ ? window_->wait(now, lab_.state().presenter.view, busy_line(), next_.preview()) : Redraw::longest_wait;
    }

private:
    void open(Real now) {
        try {
            window_ = std::make_unique<PresenterWindow>(audience_, now);
        } catch (const MachineLacks& lack) {
            lab_.state().presenter.wanted = false;
            if (!lab_.busy()) lab_.session().say(Session::Message::Kind::refused, lack.what());
        }
    }
    std::string busy_line() const {
        if (!lab_.card_shows()) return "";
        const BusyWords text = busy_words(lab_.worker()->watch().progress(), lab_.worker()->seconds());
        return text.title + ": " + text.line;
    }
    void draw(Real now, const std::string& busy) {
        LabState& lab = lab_.state();
        window_->frame(now, lab.theme, lab.presenter.view, busy, next_.preview());
        lab.presenter.clock_paused = window_->clock_paused();
        lab.presenter.frames = window_->frames();
        lab.presenter.controls = window_->controls();
    }
    // A key lifts a black-out, and does nothing else.
    bool hand_over(const std::vector<Action>& actions) {
        if (actions.empty()) return false;
        LabState& lab = lab_.state();
        if (!std::exchange(lab.black, false)) lab.wanted.insert(lab.wanted.end(), actions.begin(), actions.end());
        return true;
    }

    Lab& lab_;
    Context& audience_;
    NextSlide next_;
    std::unique_ptr<PresenterWindow> window_;
    bool drew_ = false;
};

}  // namespace

int window(const WindowOptions& o) {
    const Size size = size_from(o.size);
    if (!o.theme.empty()) theme_from(o.theme);
    const std::string lesson = o.lesson.empty() ? "mesh/mass_spring" : std::string(find_lesson(o.lesson).info.id);
    if (o.ui_scale != 0) ui_scale_from(o.ui_scale);
    if (o.frames < 0) throw Refused("--frames", static_cast<Real>(o.frames), "", "a whole number from 0 on");
    if (!o.state_path.empty()) refuse_other_ending("--state", o.state_path, ".json", "the state is written as JSON");
    check_first(o, lesson);
    const auto context = open_context(Backend::window, size);
    Lab lab(*context, lesson);
    SettingsFile settings(o.no_settings ? std::filesystem::path() : settings_path());
    restore(lab, settings, o, context->ui_scale());
    settings.begin(lab.state());
    if (!o.no_settings && !settings_path().empty())
        lab.keep_hand_in((settings_path().parent_path() / "noted.handin.json").string());
    lab.state().speak = [](const std::string& text) { print_now(text + "\n"); };
    LecturePlace place(o.no_settings || settings_path().empty() ? std::filesystem::path()
                                                                : settings_path().parent_path() / "lecture.scene.json");
    open_first(lab, o, place);
    if (!settings.trouble().empty()) lab.session().say(Session::Message::Kind::refused, settings.trouble());
    StateReport report(o.state_path);
    NotesPrinter notes;
    Lecturer lecturer(lab, *context);
    lab.state().presenter.wanted = o.presenter;

    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto now = [&] { return std::chrono::duration<Real>(Clock::now() - start).count(); };
    lab.work_beside({});
    Redraw redraw;
    Real last = 0, kept = 0;
    for (long frame = 0; !context->close_requested() && (o.frames == 0 || frame < o.frames);) {
        context->poll_events(std::min(redraw.wait(now()), lecturer.wait(now())));
        if (lecturer.go_on(now())) redraw.input(now());
        if (lecturer.drew() && !lab.busy()) report.write(lab.state());
        const bool damaged = context->take_damage();
        if (damaged || lab.has_input()) redraw.input(now());
        if (!lab.busy()) settings.keep(lab.state(), now() - std::exchange(kept, now())), place.keep(lab);
        if (!redraw.due(now())) {
            if (redraw.resting(now()) && !lab.busy() && !std::exchange(lab.state().resting, true)) report.write(lab.state());
            continue;
        }
        const Real begun = now();
        if (lab.frame(begun - std::exchange(last, begun))) context->present(), ++frame;
        // A number of frames that was asked for is drawn without a rest.
        redraw.drawn(begun, o.frames == 0 ? lab.next_change() : 0);
        tell(lab, report, notes, o);
    }
    lab.call_off();
    settings.finish(lab.state());
    place.finish(lab);
    return 0;
}

}  // namespace pliant::viewer
