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
        if (!glfwInit()) window_lacks("No window can be opened here: there is no display");
        try {
            open(size, title);
        } catch (...) {
            glfwTerminate();
            throw;
        }
    }
    ~GlfwContext() override {
        glfwDestroyWindow(window_);
        glfwTerminate();
    }

    void make_current() override {
        glfwMakeContextCurrent(window_);
        load_gl([](const char* name) { return reinterpret_cast<GlFunction>(glfwGetProcAddress(name)); });
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
    void cancel_close() override { glfwSetWindowShouldClose(window_, GLFW_FALSE); }
    std::vector<std::string> take_dropped_files() override { return std::exchange(dropped_, {}); }

    void gui_attach() override {
        ImGui_ImplGlfw_InitForOpenGL(window_, true);
        gui_key_ = glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int scancode, int action, int mods) {
            self(window).gui_key_(window, key, scancode, action, mods);
            note_sign(key, scancode, action);
        });
    }
    void gui_begin_frame(Real) override { ImGui_ImplGlfw_NewFrame(); }
    void gui_detach() override { ImGui_ImplGlfw_Shutdown(); }

private:
    static GlfwContext& self(GLFWwindow* window) { return *static_cast<GlfwContext*>(glfwGetWindowUserPointer(window)); }
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
    GLFWkeyfun gui_key_ = nullptr;
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
