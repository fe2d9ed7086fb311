// What the lab takes from files and the clipboard, and what it leaves there.
#include <pliant/document/share.h>
#include <pliant/text/file.h>
#include <pliant/text/spoken.h>
#include <pliant/text/stored_file.h>

#include "app/lab.h"
#include "platform/image.h"
#include "platform/png_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace pliant::viewer {
namespace fs = std::filesystem;
namespace {

using Told = Session::Message::Kind;
constexpr const char* scene_ending = ".json";
constexpr int frames_per_second = 20;

// "Kinetic energy" as the name of a file.
std::string file_name(std::string_view title, std::string_view ending) {
    std::string name;
    for (const char c : title) name += c == ' ' || c == '/' ? '_' : c;
    return name + std::string(ending);
}

std::string lesson_file(const Session& session, std::string_view ending) {
    const std::string_view id = session.entry().info.id;
    return file_name(id.substr(id.find('/') + 1), ending);
}

// A scene runs again to its place: how long that takes here, where it is worth a word.
std::string time_to_open(const Session& session) {
    constexpr Real soon = 5;  // s
    const Runner& run = session.runner();
    Real seconds = 0;
    for (const Stage& stage : run.lesson().stages) seconds += run.cost(stage).total_ms / 1000;
    if (seconds < soon) return "";
    return fmt::format(" It opens at step {}: to run there takes about {}.", step_number(run.place()), duration_words(seconds));
}

// A body is dropped where a lesson without bodies is open: the first lesson that takes it is named.
void refuse_file_of_another_lesson(const std::string& path) {
    for (const LessonEntry& entry : lessons()) {
        const auto lesson = entry.make();
        for (const Parameter* p : lesson->parameters)
            if (p->info.kind == Kind::file && takes_ending(path, p->info.endings))
                throw Refused(
                    fmt::format("{}: the lesson that is open reads no such file; {} does: open it, and drop the file again", path,
                                entry.info.title));
    }
}

}  // namespace

void Lab::perform_on_files(Action action) {
    switch (action) {
        case Action::open:
            return ask_to_open();
        case Action::save:
            return state_.file.empty() ? quick_save() : write_and_tell(state_.file, [&] { save_file(state_.file); });
        case Action::save_as:
            return ask_to_save();
        case Action::copy_share:
            return copy_share();
        case Action::paste_share:
            return paste_share();
        case Action::save_scene_picture:
        case Action::save_window_picture:
            return ask_for_picture(action == Action::save_window_picture);
        case Action::save_plots:
            state_.plots.memory.save_all_svg = true;
            return;
        case Action::save_probes:
            return ask_for_probes();
        case Action::save_animation:
            state_.animation.asking = !state_.animation.progress;
            return;
        default:
            return;
    }
}

// ------------------------------------------------------------------------------------------------------------- scenes

void Lab::open_file(const std::string& path) {
    const std::string text = read_file(path);
    if (looks_like_lecture(text)) return open_lecture_file(path);
    const SceneFile scene = parse_scene(text, path);
    Session::check(scene);
    state_.session.later([this, scene, path] {
        open_scene(scene);
        remember(path);
        tell_notes(scene);
    });
}

// A file that it names is another one now.
void Lab::tell_notes(const SceneFile& scene) {
    if (!scene.notes.empty()) state_.session.say(Told::info, fmt::format("{}", fmt::join(scene.notes, "\n")));
}

void Lab::save_file(const std::string& path) {
    write_file(path, scene_text_for(scene_file(), path));
    remember(path);
}

void Lab::remember(const std::string& path) {
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    state_.file = error ? path : absolute.lexically_normal().string();
    file_opening_ = state_.session.open_count();
    std::erase(state_.recent, state_.file);
    state_.recent.insert(state_.recent.begin(), state_.file);
    if (state_.recent.size() > most_recent) state_.recent.resize(most_recent);
}

void Lab::forget_file_of_another_scene() {
    if (file_opening_ != state_.session.open_count()) state_.file.clear();
}

void Lab::drop_file(const std::string& path) {
    try {
        if (const Parameter* const taker = state_.session.taker_of(path)) return state_.session.choose_file(*taker, path);
        refuse_file_of_another_lesson(path);
        open_file(path);
    } catch (const Error& e) {
        state_.session.say(Told::refused, e.what());
    }
}

void Lab::quick_save() {
    const std::string name = lesson_file(state_.session, ".scene.json");
    write_and_tell(name, [&] { write_file(name, scene_text_for(scene_file(), name)); });
}

void Lab::ask_to_open() {
    state_.files.ask(FileChoice::Purpose::open, "Open a scene file", {scene_ending}, "",
                     [this](const std::string& path) { open_file(path); });
}

void Lab::ask_to_save() {
    const std::string name = state_.file.empty() ? lesson_file(state_.session, ".scene.json") : state_.file;
    state_.files.ask(FileChoice::Purpose::save, "Save the scene", {scene_ending}, name, [this](const std::string& path) {
        save_file(path);
        tell_written(path);
    });
}

void Lab::copy_share() {
    Session& s = state_.session;
    try {
        const std::string text = share_text(scene_file());
        ImGui::SetClipboardText(text.c_str());
        s.say(Told::info,
              fmt::format("Copied: {} letters that hold this scene{}. Whoever pastes them into Pliant (Ctrl Shift V) opens it.{}",
                          text.size(), s.companion() ? " with its second run, B" : "", time_to_open(s)));
    } catch (const Error& e) {
        s.say(Told::refused, e.what());
    }
}

void Lab::paste_share() {
    Session& s = state_.session;
    try {
        const char* text = ImGui::GetClipboardText();
        if (!text || !*text) throw Refused("the clipboard holds no text: copy a share string first");
        const SceneFile scene = read_share(text);
        open_scene(scene);
        tell_notes(scene);
    } catch (const Error& e) {
        s.say(Told::refused, e.what());
    }
}

// ------------------------------------------------------------------------------------------------- pictures and numbers

void Lab::tell_written(const std::string& file) {
    const bool here = fs::path(file).parent_path().empty();
    state_.session.say(Told::info, "Saved as " + file + (here ? " in the folder where Pliant was started." : "."));
}

void Lab::write_and_tell(const std::string& file, const std::function<void()>& write) {
    try {
        write();
        tell_written(file);
    } catch (const Error& e) {
        state_.session.say(Told::refused, e.what());
    }
}

void Lab::save_plot(const PlotShot& shot) {
    const std::string name = file_name(shot.title, ".png");
    write_and_tell(name, [&] { write_png(crop(read_pixels(context_), shot.left, shot.top, shot.width, shot.height), name); });
}

void Lab::save_svg(const std::string& title, const std::string& svg) {
    const std::string name = file_name(title, ".svg");
    const auto before = state_.session.message();
    write_and_tell(name, [&] { write_file(name, svg); });
    // Several in one frame are told together.
    if (state_.plots.memory.save_all_svg && before && before->kind == Told::info && before->text.starts_with("Saved as "))
        state_.session.say(Told::info, fmt::format("Saved as {}, {}", name, before->text.substr(9)));
}

void Lab::ask_for_probes() {
    state_.files.ask(FileChoice::Purpose::save, "Save the probes as CSV", {".csv"}, lesson_file(state_.session, ".csv"),
                     [this](const std::string& path) {
                         write_file(path, state_.session.recorder().csv(state_.session.lesson()));
                         tell_written(path);
                     });
}

void Lab::ask_for_picture(bool whole) {
    state_.files.ask(FileChoice::Purpose::save, whole ? "Save the window as PNG" : "Save the picture as PNG", {".png"},
                     lesson_file(state_.session, ".png"), [this, whole](const std::string& path) {
                         check_writable(path);
                         state_.session.dismiss();
                         capture_ = Capture{whole, path};
                     });
}

void Lab::capture() {
    const Capture c = *std::exchange(capture_, std::nullopt);
    if (c.to_notebook) {
        state_.hand_in.takes_picture = false;
        state_.session.notebook.note_picture(state_.session.runner(), png_bytes(scene_pixels()));
        return state_.session.say(Told::info, "Noted: the picture of the scene.");
    }
    write_and_tell(c.path, [&] { write_png(c.whole ? read_pixels(context_) : scene_pixels(), c.path); });
}

// The scene panel as it was drawn.
Image Lab::scene_pixels() {
    const Rectangle r = state_.controls["scene"];
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    const auto px = [](float length) { return static_cast<int>(std::lround(length)); };
    return crop(read_pixels(context_), px(r.x * scale.x), px(r.y * scale.y), px(r.width * scale.x), px(r.height * scale.y));
}

// ----------------------------------------------------------------------------------------------------------- animation

void Lab::start_animation() {
    animation_path_ = std::exchange(state_.animation.path, {});
    write_and_tell(animation_path_, [&] { check_writable(animation_path_); });
    if (state_.session.message()->kind == Told::refused) return;
    state_.session.dismiss();
    animation_.emplace(state_.animation.seconds, frames_per_second, state_.animation.width);
    state_.animation.progress = 0;
    state_.session.playing = true;
}

void Lab::record_animation() {
    const auto stop = [&] {
        animation_.reset();
        state_.animation.progress.reset();
        state_.animation.writing = false;
        state_.session.playing = false;
    };
    if (ImGui::IsKeyPressed(ImGuiKey_Escape, false)) {
        stop();
        return state_.session.say(Told::info, "The animation was given up, nothing was written.");
    }
    // The dialog that asked for it is still in the first frame.
    if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) return;
    try {
        if (!animation_->complete()) {
            animation_->add(scene_pixels());
            state_.animation.progress = animation_->progress();
            return;
        }
        state_.session.playing = false;
        state_.animation.writing = true;
        const bool more = animation_->encode_some();
        state_.animation.progress = animation_->encoded_share();
        if (more) return;
        write_file(animation_path_, animation_->take_encoded());
        tell_written(animation_path_);
    } catch (const Error& e) {
        state_.session.say(Told::refused, e.what());
    }
    stop();
}

}  // namespace pliant::viewer
