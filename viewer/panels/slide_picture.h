// A picture of a lecture, from its file.
#pragma once
#include "panels/panel_context.h"
#include "render/gl_objects.h"

#include <map>
#include <string>

namespace pliant::viewer {

// The pictures that were drawn, by their paths. They belong to the context in which they were.
struct SlidePictureState {
    struct Kept {
        GlTexture texture{};
        int width = 0, height = 0;  // px
        std::string trouble{};      // why there is none
    };
    std::map<std::string, Kept> kept{};
};

// As large as the place takes it, in its middle; a file that cannot be read is told there.
void draw_slide_picture(PanelContext& lab, SlidePictureState& panel, const std::string& path);

}  // namespace pliant::viewer
