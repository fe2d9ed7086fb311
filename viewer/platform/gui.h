// ImGui on a context: the same calls for the window and for the headless picture.
#pragma once
#include "platform/context.h"

struct ImGuiContext;
struct ImDrawList;
struct ImDrawData;

namespace pliant::viewer {

class Gui {
public:
    // Makes ImGui's context, which stays current, and its OpenGL objects. `context` must outlive it and be current. ImGui stores
    // nothing on disk. Navigation by keys is on.
    explicit Gui(Context& context);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    // Starts a frame. dt in s, > 0: time since the last one, for a headless context; a window measures its own. Throws Refused.
    void begin_frame(Real dt);
    // Has a mouse or a key done something that no frame has seen?
    bool has_input() const;
    // s until the cursor in a text that is being typed shows or hides; infinity without one.
    Real next_blink() const;
    // Draws the frame over what framebuffer 0 holds.
    void end_frame();
    // The last frame once more, and this over it.
    void draw_again(ImDrawList& over);

private:
    void draw(ImDrawData& data);

    Context& context_;
    ImGuiContext* imgui_;
};

}  // namespace pliant::viewer
