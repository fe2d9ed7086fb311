// A context without a display whose frames nobody looks at: everything is laid out, and answers, as ever, but no pixel is drawn,
// which takes longest.
#pragma once
#include "platform/gl.h"
#include "platform/headless_context.h"

#include <memory>

namespace pliant::test {

inline std::unique_ptr<viewer::Context> open_unseen(viewer::Size size) {
    std::unique_ptr<viewer::Context> context = viewer::open_headless(size);
    glEnable(GL_RASTERIZER_DISCARD);
    return context;
}

}  // namespace pliant::test
