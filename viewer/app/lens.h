// A large pointer for the back row: a ring, and in it what lies under the mouse, enlarged.
#pragma once
#include "panels/panel_context.h"
#include "platform/context.h"
#include "render/gl_objects.h"

struct ImDrawList;
struct ImDrawCmd;

namespace pliant::viewer {

class Lens {
public:
    static constexpr float enlargement = 2.5f;
    static constexpr float radius = 110;  // px at UI scale 1

    // Over all that the frame has drawn before; nothing where the mouse is outside. It reads framebuffer 0 while the frame is
    // drawn, and outlives that.
    void draw(const PanelContext& lab, Size framebuffer);

private:
    static void take(const ImDrawList* list, const ImDrawCmd* command);
    void make_texture_for(int side);

    GlTexture texture_;
    int side_ = 0;       // px of the framebuffer
    int x_ = 0, y_ = 0;  // its lower left corner there
};

}  // namespace pliant::viewer
