#include "platform/gl_loader.h"

#include <pliant/math/error.h>

#include "platform/gl.h"

namespace pliant::viewer {

#if defined(__EMSCRIPTEN__)
// A browser links its functions by name.
void load_gl(GlGetFunction) {}
#else
void load_gl(GlGetFunction get) {
    static GlGetFunction loaded = nullptr;
    if (get == loaded) return;
    const int version = gladLoadGL(reinterpret_cast<GLADloadfunc>(get));
    if (version < GLAD_MAKE_VERSION(3, 3))
        throw MachineLacks("The GL driver offers less than OpenGL 3.3, which Pliant draws with. Install a newer Mesa or driver.");
    loaded = get;
}
#endif

std::string describe_gl() {
    const auto text = [](GLenum name) {
        const GLubyte* value = glGetString(name);
        return std::string(value ? reinterpret_cast<const char*>(value) : "unknown");
    };
    return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

void finish_gl() { glFinish(); }

}  // namespace pliant::viewer
