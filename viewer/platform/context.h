// A place to draw with OpenGL: a window, or memory when there is no display. The window and the headless picture differ in
// nothing else, so all code above this folder is the same for both.
#pragma once
#include <pliant/math/types.h>

#include <memory>
#include <string>
#include <vector>

namespace pliant::viewer {

struct Size {
    int width = 0, height = 0;
    bool operator==(const Size&) const = default;
};

enum class Backend {
    window,  // GLFW, on a display
    osmesa,  // Mesa's off-screen library, drawing on the CPU
    egl,     // Mesa's EGL without a surface of any display, drawing on the CPU
};

class Context {
public:
    Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    virtual ~Context() = default;

    // Framebuffer 0 and the loaded GL functions are those of this context from now on.
    virtual void make_current() = 0;
    virtual Size framebuffer_size() const = 0;  // px
    // Asks for another framebuffer size in px; a window may not obey. Throws Refused outside 1 to largest_side.
    virtual void resize(Size size) = 0;
    // Shows the frame; a headless context waits until it is drawn. Read pixels before this call.
    virtual void present() = 0;
    // Who draws: "OSMesa: llvmpipe (...), OpenGL 3.3 ...". Holds version numbers: keep it out of golden pictures.
    virtual std::string description() const = 0;

    // What type and line widths must be multiplied with on this screen.
    virtual float ui_scale() const { return 1; }
    // Takes what has happened; with `wait`, in s, sleeps so long at most until something does.
    virtual void poll_events(Real wait = 0) { (void)wait; }
    // Has the window another size, was it uncovered, or were files dropped on it, since the last call?
    virtual bool take_damage() { return false; }
    // A window may fill the screen that it is on, and have its old size and place again.
    virtual bool full_screen() const { return false; }
    virtual void set_full_screen(bool on) { (void)on; }
    // A second window: it goes to a screen where the other one is not, where there is one, and its frames do not wait for the
    // screen.
    virtual void stand_beside(const Context& other) { (void)other; }
    virtual bool close_requested() const { return false; }
    virtual void request_close() {}  // as if a person had closed the window
    virtual void cancel_close() {}
    // Paths of the files dropped on the window since the last call.
    virtual std::vector<std::string> take_dropped_files() { return {}; }

    // The platform half of ImGui, called by Gui. `dt` in s: time since the last frame, which a window measures itself.
    virtual void gui_attach() = 0;
    virtual void gui_begin_frame(Real dt) = 0;
    virtual void gui_detach() = 0;
};

inline constexpr int largest_side = 8192;  // px, what llvmpipe draws at most

// Opens a context, makes it current and loads the GL functions. One context is current at a time; several windows may be open.
// Throws MachineLacks, which says what is missing and what to do instead; throws Refused for a size outside 1 to largest_side.
std::unique_ptr<Context> open_context(Backend backend, Size size, const std::string& title = "Pliant");

// OSMesa or, where that is missing or fails, EGL.
std::unique_ptr<Context> open_headless(Size size);

}  // namespace pliant::viewer
