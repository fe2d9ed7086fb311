// A person at the lab: a screen of its own (Xvfb), the program in its window, a mouse and keys (xdotool), and what the lab tells
// of its state in the file that --state names.
#pragma once
#include "../process/process.h"
#include "close_request.h"

#include <poll.h>

#include <catch2/catch_test_macros.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

namespace pliant::test {

using Json = nlohmann::json;
using namespace std::chrono_literals;

// Frames that the lab needs to see one thing of the mouse or the keys. ImGui takes up one change of a button in a frame.
inline constexpr long frames_to_notice = 4;

inline bool on_path(const std::string& program) {
    std::istringstream folders(std::getenv("PATH") ? std::getenv("PATH") : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((folder + "/" + program).c_str(), X_OK) == 0) return true;
    return false;
}

inline void need_screen_and_mouse() {
    for (const char* program : {"Xvfb", "xdotool", "setxkbmap"})
        if (!on_path(program)) SKIP(program << " is not installed: apt-get install xvfb xdotool x11-xkb-utils");
}

// A display that no one else has; what is set on it stays when the last program leaves it.
class Screen {
public:
    explicit Screen(const Scratch& scratch, const std::string& size = "1280x800") {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
        server_ = std::make_unique<Child>(
            "Xvfb",
            Arguments{"-displayfd", std::to_string(ends[1]), "-screen", "0", size + "x24", "-nolisten", "tcp", "-noreset"},
            scratch.path("xvfb.out"), scratch.path("xvfb.err"), Environment{}, std::vector<int>{ends[1]});
        close(ends[1]);
        const std::string number = line_from(ends[0]);
        close(ends[0]);
        if (number.empty()) throw std::runtime_error("Xvfb does not start: " + contents_of(scratch.path("xvfb.err")));
        display_ = ":" + number;
    }
    ~Screen() { server_->end(SIGTERM); }
    const std::string& display() const { return display_; }

private:
    // The server writes the number of its display, and the end of the line after it, once it is ready.
    static std::string line_from(int descriptor) {
        std::string line;
        constexpr int patience_ms = std::chrono::milliseconds(patience).count();
        pollfd ready{descriptor, POLLIN, 0};
        for (char c = 0; poll(&ready, 1, patience_ms) > 0 && read(descriptor, &c, 1) == 1;) {
            if (c == '\n') return line;
            line += c;
        }
        return "";
    }
    std::unique_ptr<Child> server_;
    std::string display_;
};

struct Spot {
    int x = 0, y = 0;  // px, in the window
};

class Desk {
public:
    // More of the command line: a command, if any, comes first; --size, where the window is not to be as large as the screen.
    // config: where the lab keeps its settings; a folder of this desk's
    // own when not given. keyboard: its layout, "de" or "fr"; that of the US when not given. screen: its size in px.
    explicit Desk(const Arguments& more = {}, const std::string& config = "", const std::string& keyboard = "us",
                  const std::string& screen = "1280x800")
        : screen_(scratch_, screen) {
        REQUIRE(run_process("setxkbmap", {"-display", screen_.display(), keyboard}, {}).exit_code == 0);
        Arguments arguments = more;
        arguments.insert(arguments.end(), {"--state", state_path_});
        if (std::ranges::find(more, "--size") == more.end()) arguments.insert(arguments.end(), {"--size", "1280x800"});
        lab_ = std::make_unique<Child>(PLIANT_PROGRAM, arguments, scratch_.path("lab.out"), scratch_.path("lab.err"),
                                       Environment{{"DISPLAY", screen_.display()},
                                                   {"WAYLAND_DISPLAY", std::nullopt},
                                                   {"XDG_CONFIG_HOME", config.empty() ? scratch_.path("config") : config}},
                                       std::vector<int>{}, scratch_.folder());
        const auto deadline = std::chrono::steady_clock::now() + patience;
        while (!fs::exists(state_path_) && lab_->running() && std::chrono::steady_clock::now() < deadline)
            std::this_thread::sleep_for(20ms);
        INFO(contents_of(scratch_.path("lab.err")) << contents_of(scratch_.path("xvfb.err")));
        REQUIRE(fs::exists(state_path_));
        turn_to("Pliant");
    }
    // Keys and mouse go to the window of this title from now on.
    void turn_to(const std::string& title) {
        window_ = xdotool({"search", "--sync", "--onlyvisible", "--name", "^" + title + "$"});
        window_ = window_.substr(0, window_.find('\n'));
        REQUIRE_FALSE(window_.empty());
        xdotool({"windowfocus", "--sync", window_});
    }
    // Of the window, px.
    std::pair<int, int> window_size() const {
        std::istringstream told(xdotool({"getwindowgeometry", "--shell", window_}));
        std::pair<int, int> size;
        for (std::string line; std::getline(told, line);) {
            if (line.starts_with("WIDTH=")) size.first = std::stoi(line.substr(6));
            if (line.starts_with("HEIGHT=")) size.second = std::stoi(line.substr(7));
        }
        return size;
    }

    const Scratch& scratch() const { return scratch_; }
    Json state() const { return Json::parse(contents_of(state_path_)); }
    double parameter(const std::string& key) const { return std::stod(state()["parameters"][key].get<std::string>()); }
    // Waits until the state is as wanted; false when the lab ends before, or hangs.
    bool becomes(const std::function<bool(const Json&)>& wanted, std::chrono::milliseconds at_most = patience) const {
        const auto deadline = std::chrono::steady_clock::now() + at_most;
        while (lab_->running() && std::chrono::steady_clock::now() < deadline) {
            if (wanted(state())) return true;
            std::this_thread::sleep_for(20ms);
        }
        return wanted(state());
    }
    bool becomes(const std::string& key, const Json& value) const {
        return becomes([&](const Json& s) { return s[key] == value; });
    }
    // The same, and stays so for some frames.
    bool stays(const std::string& key, const Json& value) const {
        if (!becomes(key, value)) return false;
        wait_frames(2 * frames_to_notice);
        return state()[key] == value;
    }
    // Until so many frames are drawn, or the lab rests: it then shows all that it was told.
    void wait_frames(long count) const { wait_frames_after(state()["frame"], count); }
    // Frames drawn so far.
    long frames() const { return state()["frame"]; }

    // Presses a key and lets it go; "ctrl+z" as a hand does it, with the first key held around the second.
    void key(const std::string& name) {
        const auto plus = name.find('+');
        if (plus == std::string::npos) return act({"key", name}, 2 * frames_to_notice);
        hold(name.substr(0, plus));
        key(name.substr(plus + 1));
        let_go(name.substr(0, plus));
    }
    void type(const std::string& text) {
        act({"type", "--delay", "20", text}, frames_to_notice * static_cast<long>(text.size()));
    }
    void move(Spot s) { act({"mousemove", "--window", window_, std::to_string(s.x), std::to_string(s.y)}); }
    void press() { act({"mousedown", "1"}); }
    void release() { act({"mouseup", "1"}); }
    void right_click(Spot s) { move(s), act({"click", "3"}); }
    // Turns the wheel where the mouse is, a notch at a time.
    void wheel(bool down) { act({"click", down ? "5" : "4"}); }
    void hold(const std::string& name) { act({"keydown", name}); }
    void let_go(const std::string& name) { act({"keyup", name}); }
    void click(Spot s) { move(s), press(), release(); }
    void click(const std::string& control) { click(on(control)); }
    void drag(Spot from, Spot to) { move(from), press(), move({(from.x + to.x) / 2, (from.y + to.y) / 2}), move(to), release(); }
    void click_right(Spot s) { move(s), act({"mousedown", "3"}), act({"mouseup", "3"}); }
    // As a hand does it: the second press is held for some frames.
    void double_click(Spot s) {
        move(s);
        act({"click", "1", "mousedown", "1"});
        release();
    }

    // The place at these fractions of a control's width and height, once it stays where it is: what is new in a panel may move
    // for some frames.
    Spot on(const std::string& control, double across = 0.5, double down = 0.5) const {
        INFO("control " << control);
        Json r;
        REQUIRE(becomes([&](const Json& s) {
            const Json now = s["controls"].contains(control) ? s["controls"][control] : Json();
            const bool stays = !now.is_null() && now == r;
            if (!stays && !now.is_null()) wait_frames_after(s["frame"], 2);
            r = now;
            return stays;
        }));
        return {static_cast<int>(r[0].get<double>() + across * r[2].get<double>()),
                static_cast<int>(r[1].get<double>() + down * r[3].get<double>())};
    }

    // Asks the window to close, as a window manager does.
    void ask_to_close() const { XConnection(screen_.display()).ask_to_close(static_cast<std::uint32_t>(std::stoul(window_))); }
    // The same, and gives the exit code; -1 when the program does not end.
    int close_window() {
        ask_to_close();
        return lab_->wait() ? lab_->exit_code() : -1;
    }
    // Presses a key that ends the program, and gives its exit code; -1 when it does not end.
    int end_by(const std::string& key) {
        xdotool({"key", key});
        return lab_->wait() ? lab_->exit_code() : -1;
    }
    std::string output() const { return contents_of(scratch_.path("lab.out")); }
    std::string complaints() const { return contents_of(scratch_.path("lab.err")); }

private:
    void act(const Arguments& arguments, long frames = frames_to_notice) const {
        const long before = state()["frame"];
        xdotool(arguments);
        // What changes nothing for the lab, such as a mouse that stays where it is, makes no frame.
        becomes([&](const Json& s) { return s["frame"].get<long>() > before; }, 500ms);
        wait_frames_after(before, frames);
    }
    void wait_frames_after(long first, long count) const {
        becomes([&](const Json& s) { return s["frame"].get<long>() >= first + count || s["resting"] == true; });
    }
    std::string xdotool(const Arguments& arguments) const {
        const Outcome outcome = run_process("xdotool", arguments, {{"DISPLAY", screen_.display()}});
        INFO("xdotool " << arguments[0] << ": " << outcome.err);
        REQUIRE(outcome.exit_code == 0);
        return outcome.out;
    }

    Scratch scratch_;
    Screen screen_;
    std::string state_path_ = scratch_.path("state.json"), window_;
    std::unique_ptr<Child> lab_;
};

// Takes hold of something that can be pulled, and gives the place.
inline Spot grip_of(Desk& desk) {
    for (const double down : {0.5, 0.4, 0.6, 0.7, 0.3})
        for (const double across : {0.5, 0.45, 0.55, 0.4, 0.6}) {
            const Spot spot = desk.on("scene", across, down);
            desk.move(spot);
            if (desk.state()["hovered"] < 0) continue;
            desk.press();
            if (desk.state()["pulling"] >= 0) return spot;
            desk.release();
        }
    FAIL("nothing that can be pulled lies under the pointer");
    return {};
}

inline void pause(Desk& desk) {
    desk.key("space");
    REQUIRE(desk.becomes("playing", false));
}

}  // namespace pliant::test
