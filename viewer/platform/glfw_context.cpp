#include <pliant/math/error.h>

#include "platform/backends.h"

#if PLIANT_HAVE_GLFW || defined(__EMSCRIPTEN__)
#ifndef GLFW_INCLUDE_NONE
#define GLFW_INCLUDE_NONE
#endif
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "platform/gl_loader.h"

namespace pliant::viewer {
namespace {

[[noreturn]] void window_lacks(const std::string& what) {
    const char* reason = nullptr;
#if !defined(__EMSCRIPTEN__)
    glfwGetError(&reason);
#endif
    throw MachineLacks(what + (reason ? std::string(" (") + reason + ")" : "") +
                       ". Use `pliant shot` for a picture or `pliant tour` for all of them; neither needs a display.");
}

class GlfwContext final : public Context {
public:
    GlfwContext(Size size, const std::string& title) {
        glfwSetErrorCallback(nullptr);
        if (open_windows() == 0 && !glfwInit()) window_lacks("No window can be opened here: there is no display");
        ++open_windows();
        try {
            open(size, title);
        } catch (...) {
            close();
            throw;
        }
    }
    ~GlfwContext() override { close(); }

    void make_current() override {
        glfwMakeContextCurrent(window_);
        load_gl(&gl_function);
    }
    Size framebuffer_size() const override {
        Size size;
        glfwGetFramebufferSize(window_, &size.width, &size.height);
        return size;
    }
    void resize(Size size) override {
        check_size(size);
        const Size pixels = framebuffer_size(), window = window_size();
        if (pixels.width > 0) size.width = size.width * window.width / pixels.width;
        if (pixels.height > 0) size.height = size.height * window.height / pixels.height;
        glfwSetWindowSize(window_, size.width, size.height);
    }
    void present() override { glfwSwapBuffers(window_); }
    std::string description() const override { return "GLFW " + std::string(glfwGetVersionString()) + ": " + describe_gl(); }

    // The part of the screen's scale that its window units do not already contain.
    float ui_scale() const override {
        float x = 1;
#if !defined(__EMSCRIPTEN__)
        glfwGetWindowContentScale(window_, &x, nullptr);
#endif
        const int pixels = framebuffer_size().width, width = window_size().width;
        const float inside_units = width > 0 && pixels > 0 ? static_cast<float>(pixels) / static_cast<float>(width) : 1;
        return std::max(1.0f, x / inside_units);
    }
    void poll_events(Real wait) override { wait > 0 ? glfwWaitEventsTimeout(wait) : glfwPollEvents(); }
    bool take_damage() override { return std::exchange(damaged_, false); }
    bool close_requested() const override { return glfwWindowShouldClose(window_) != 0; }
#if !defined(__EMSCRIPTEN__)
    bool full_screen() const override { return glfwGetWindowMonitor(window_) != nullptr; }
    void set_full_screen(bool on) override {
        if (on == full_screen()) return;
        if (on) {
            GLFWmonitor* const monitor = monitor_of(window_);
            const GLFWvidmode* const mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
            if (!mode) return;
            glfwGetWindowPos(window_, &windowed_x_, &windowed_y_);
            windowed_ = window_size();
            glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
        } else {
            glfwSetWindowMonitor(window_, nullptr, windowed_x_, windowed_y_, windowed_.width, windowed_.height, GLFW_DONT_CARE);
        }
        damaged_ = true;
    }
    void stand_beside(const Context& other) override {
        make_current();
        glfwSwapInterval(0);
        const auto* window = dynamic_cast<const GlfwContext*>(&other);
        GLFWmonitor* const taken = window ? monitor_of(window->window_) : nullptr;
        int count = 0;
        GLFWmonitor** const all = glfwGetMonitors(&count);
        for (int k = 0; k < count; ++k) {
            if (all[k] == taken) continue;
            const Place m = place_of(all[k]);
            const Size size = window_size();
            glfwSetWindowPos(window_, m.x + std::max(0, (m.width - size.width) / 2),
                             m.y + std::max(0, (m.height - size.height) / 2));
            return;
        }
    }
#endif
    void request_close() override { glfwSetWindowShouldClose(window_, GLFW_TRUE); }
    void cancel_close() override { glfwSetWindowShouldClose(window_, GLFW_FALSE); }
    std::vector<std::string> take_dropped_files() override { return std::exchange(dropped_, {}); }

    void gui_attach() override {
        gui_ = ImGui::GetCurrentContext();
        ImGui_ImplGlfw_InitForOpenGL(window_, false);
        install_gui_callbacks();
    }
    void gui_begin_frame(Real) override { ImGui_ImplGlfw_NewFrame(); }
    void gui_detach() override {
        gui_ = nullptr;
        ImGui_ImplGlfw_Shutdown();
    }

private:
    static GlfwContext& self(GLFWwindow* window) { return *static_cast<GlfwContext*>(glfwGetWindowUserPointer(window)); }
    static int& open_windows() {
        static int count = 0;
        return count;
    }
    static GlFunction gl_function(const char* name) { return reinterpret_cast<GlFunction>(glfwGetProcAddress(name)); }
    void close() {
        if (window_) glfwDestroyWindow(window_);
        if (--open_windows() == 0) glfwTerminate();
    }
    // With two windows, what one of them takes goes to its own GUI, whichever is current.
    template <class Act>
    static void in_gui_of(GLFWwindow* window, const Act& act) {
        ImGuiContext* const gui = self(window).gui_;
        if (!gui) return;
        ImGuiContext* const now = ImGui::GetCurrentContext();
        ImGui::SetCurrentContext(gui);
        act();
        ImGui::SetCurrentContext(now);
    }
    void install_gui_callbacks() {
        glfwSetWindowFocusCallback(
            window_, [](GLFWwindow* w, int focused) { in_gui_of(w, [&] { ImGui_ImplGlfw_WindowFocusCallback(w, focused); }); });
        glfwSetCursorEnterCallback(
            window_, [](GLFWwindow* w, int entered) { in_gui_of(w, [&] { ImGui_ImplGlfw_CursorEnterCallback(w, entered); }); });
        glfwSetCursorPosCallback(
            window_, [](GLFWwindow* w, double x, double y) { in_gui_of(w, [&] { ImGui_ImplGlfw_CursorPosCallback(w, x, y); }); });
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int mods) {
            in_gui_of(w, [&] { ImGui_ImplGlfw_MouseButtonCallback(w, button, action, mods); });
        });
        glfwSetScrollCallback(
            window_, [](GLFWwindow* w, double x, double y) { in_gui_of(w, [&] { ImGui_ImplGlfw_ScrollCallback(w, x, y); }); });
        glfwSetCharCallback(
            window_, [](GLFWwindow* w, unsigned character) { in_gui_of(w, [&] { ImGui_ImplGlfw_CharCallback(w, character); }); });
        glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
            in_gui_of(w, [&] {
                ImGui_ImplGlfw_KeyCallback(w, key, scancode, action, mods);
                note_sign(key, scancode, action);
            });
        });
    }
    void open(Size size, const std::string& title) {
        set_hints();
        window_ = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
        if (!window_) window_lacks("No window with OpenGL 3.3 can be opened");
        glfwSetWindowUserPointer(window_, this);
        glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
            auto& files = self(window).dropped_;
            files.insert(files.end(), paths, paths + count);
            self(window).damaged_ = true;
        });
        glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { self(window).damaged_ = true; });
        glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* window, int, int) { self(window).damaged_ = true; });
        make_current();
        glfwSwapInterval(1);
    }
    // The backend of the GUI knows the + of a US keyboard alone; with Ctrl it types no character either.
    static void note_sign(int key, int scancode, int action) {
        const char* name = glfwGetKeyName(key, scancode);
        if (!name || action == GLFW_REPEAT) return;
        const std::string_view typed(name);
        if (typed == "+") ImGui::GetIO().AddKeyEvent(ImGuiKey_Equal, action == GLFW_PRESS);
        if (typed == "-") ImGui::GetIO().AddKeyEvent(ImGuiKey_Minus, action == GLFW_PRESS);
    }
#if !defined(__EMSCRIPTEN__)
    struct Place {
        int x = 0, y = 0, width = 0, height = 0;
    };
    static Place place_of(GLFWmonitor* monitor) {
        Place p;
        glfwGetMonitorPos(monitor, &p.x, &p.y);
        if (const GLFWvidmode* mode = glfwGetVideoMode(monitor)) p.width = mode->width, p.height = mode->height;
        return p;
    }
    // The one that shows most of the window; null without any.
    static GLFWmonitor* monitor_of(GLFWwindow* window) {
        Place w;
        glfwGetWindowPos(window, &w.x, &w.y);
        glfwGetWindowSize(window, &w.width, &w.height);
        int count = 0;
        GLFWmonitor** const all = glfwGetMonitors(&count);
        GLFWmonitor* best = count > 0 ? all[0] : nullptr;
        long most = 0;
        for (int k = 0; k < count; ++k) {
            const Place m = place_of(all[k]);
            const long across = std::min(w.x + w.width, m.x + m.width) - std::max(w.x, m.x),
                       down = std::min(w.y + w.height, m.y + m.height) - std::max(w.y, m.y);
            if (across > 0 && down > 0 && across * down > most) most = across * down, best = all[k];
        }
        return best;
    }
#endif
    static void set_hints() {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
#if defined(__EMSCRIPTEN__)
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
        glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
#else
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
        // A full screen stays when the window of the lecturer gets the keys.
        glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
#endif
        // As in the headless contexts: no multisampling and no colour conversion of framebuffer 0.
        glfwWindowHint(GLFW_SAMPLES, 0);
        glfwWindowHint(GLFW_SRGB_CAPABLE, GLFW_FALSE);
        glfwWindowHint(GLFW_DEPTH_BITS, 24);
        glfwWindowHint(GLFW_STENCIL_BITS, 8);
    }
    Size window_size() const {
        Size size;
        glfwGetWindowSize(window_, &size.width, &size.height);
        return size;
    }

    GLFWwindow* window_ = nullptr;
    ImGuiContext* gui_ = nullptr;  // that takes what the window gets
#if !defined(__EMSCRIPTEN__)
    Size windowed_;  // before the full screen
    int windowed_x_ = 0, windowed_y_ = 0;
#endif
    std::vector<std::string> dropped_;
    bool damaged_ = true;
};

}  // namespace

std::unique_ptr<Context> open_window(Size size, const std::string& title) { return std::make_unique<GlfwContext>(size, title); }

}  // namespace pliant::viewer

#else

namespace pliant::viewer {
std::unique_ptr<Context> open_window(Size, const std::string&) {
    throw MachineLacks(
        "This build has no window: GLFW was not there. Install libglfw3-dev and build again, or use `pliant shot` for a "
        "picture.");
}
}  // namespace pliant::viewer

#endif
