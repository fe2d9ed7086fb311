#include <pliant/math/error.h>

#include "platform/backends.h"

#if PLIANT_HAVE_EGL
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <utility>

#include "platform/environment.h"
#include "platform/gl_loader.h"
#include "platform/headless_context.h"

namespace pliant::viewer {
namespace {

[[noreturn]] void lacks(const std::string& what) {
    throw MachineLacks("EGL without a display: " + what + "; install Mesa's libegl1 and libgl1-mesa-dri.");
}

EGLDisplay start_display() {
    // The same software driver on every machine, so that pictures agree. Drivers read these variables when they start.
    const ScopedEnvironment software("LIBGL_ALWAYS_SOFTWARE", "true");
    const ScopedEnvironment driver("GALLIUM_DRIVER", "llvmpipe");
    const auto get = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (!get) lacks("the library has no eglGetPlatformDisplayEXT");
    const EGLDisplay display = get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY) lacks("no surfaceless platform");
    if (!eglInitialize(display, nullptr, nullptr)) lacks("it cannot be started");
    return display;
}

// EGL has one such display per process, which all contexts share: it stays until the end.
EGLDisplay surfaceless_display() {
    static const EGLDisplay display = start_display();
    return display;
}

EGLConfig choose_config(EGLDisplay display) {
    // clang-format off
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                             EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_ALPHA_SIZE, 8,
                             EGL_DEPTH_SIZE, 24, EGL_STENCIL_SIZE, 8, EGL_SAMPLES, 0, EGL_NONE};
    // clang-format on
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0)
        lacks("no configuration with 8 bits per colour and 24 of depth");
    return config;
}

class EglContext final : public HeadlessContext {
public:
    explicit EglContext(Size size) : HeadlessContext(size) {
        try {
            create_context();
            create_surface();
            bind();
        } catch (...) {
            release();
            throw;
        }
    }
    ~EglContext() override { release(); }

    void make_current() override { bind(); }
    void resize(Size size) override {
        check_size(size);
        size_ = size;
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroySurface(display_, std::exchange(surface_, EGL_NO_SURFACE));
        create_surface();
        bind();
    }
    void present() override { finish_gl(); }
    std::string description() const override { return "EGL: " + describe_gl(); }

private:
    void create_context() {
        if (!eglBindAPI(EGL_OPENGL_API)) lacks("no desktop OpenGL");
        config_ = choose_config(display_);
        // clang-format off
        const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
        // clang-format on
        context_ = eglCreateContext(display_, config_, EGL_NO_CONTEXT, wanted);
        if (context_ == EGL_NO_CONTEXT) lacks("no OpenGL 3.3 core context");
    }
    // A buffer surface gives the context a framebuffer 0, as a window has.
    void create_surface() {
        const EGLint wanted[] = {EGL_WIDTH, size_.width, EGL_HEIGHT, size_.height, EGL_NONE};
        surface_ = eglCreatePbufferSurface(display_, config_, wanted);
        if (surface_ == EGL_NO_SURFACE)
            lacks("no picture of " + std::to_string(size_.width) + "x" + std::to_string(size_.height) + " px");
    }
    void bind() {
        eglBindAPI(EGL_OPENGL_API);
        // Made current anew even if EGL believes it is: another library may have put its own context in place since.
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (!eglMakeCurrent(display_, surface_, surface_, context_)) lacks("the context cannot be made current");
        load_gl([](const char* name) { return reinterpret_cast<GlFunction>(eglGetProcAddress(name)); });
    }
    void release() {
        if (eglGetCurrentContext() == context_) eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
        if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    }

    EGLDisplay display_ = surfaceless_display();
    EGLConfig config_ = nullptr;
    EGLContext context_ = EGL_NO_CONTEXT;
    EGLSurface surface_ = EGL_NO_SURFACE;
};

}  // namespace

std::unique_ptr<Context> open_egl(Size size) { return std::make_unique<EglContext>(size); }

}  // namespace pliant::viewer

#else

namespace pliant::viewer {
std::unique_ptr<Context> open_egl(Size) { throw MachineLacks("This build has no EGL; install libegl-dev and build again."); }
}  // namespace pliant::viewer

#endif
