// GL/osmesa.h brings a GL header of its own, so this file includes no other.
#include <pliant/math/error.h>

#include "platform/backends.h"

#if PLIANT_HAVE_OSMESA
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <cstdint>

#include "platform/environment.h"
#include "platform/gl_loader.h"
#include "platform/headless_context.h"

namespace pliant::viewer {
namespace {

// The library is loaded when the first context is made: with all of LLVM behind it, that takes longer than many a command.
class OsmesaLibrary {
public:
    // Throws MachineLacks. Stays loaded until the program ends.
    static const OsmesaLibrary& get() {
        static const OsmesaLibrary library;
        return library;
    }

    decltype(&OSMesaCreateContextAttribs) create = nullptr;
    decltype(&OSMesaDestroyContext) destroy = nullptr;
    decltype(&OSMesaMakeCurrent) make_current = nullptr;
    decltype(&OSMesaGetCurrentContext) current = nullptr;
    decltype(&OSMesaGetProcAddress) proc_address = nullptr;

private:
    OsmesaLibrary() {
        void* library = nullptr;
        for (const char* name : {"libOSMesa.so.8", "libOSMesa.so"})
            if (!library) library = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (!library) throw MachineLacks("This machine has no OSMesa; install libosmesa6, or use a machine with EGL.");
        find(library, "OSMesaCreateContextAttribs", create);
        find(library, "OSMesaDestroyContext", destroy);
        find(library, "OSMesaMakeCurrent", make_current);
        find(library, "OSMesaGetCurrentContext", current);
        find(library, "OSMesaGetProcAddress", proc_address);
    }
    template <class Function>
    static void find(void* library, const char* name, Function& function) {
        function = reinterpret_cast<Function>(dlsym(library, name));
        if (!function) throw MachineLacks(std::string("OSMesa has no ") + name + "; install a newer libosmesa6.");
    }
};

class OsmesaContext final : public HeadlessContext {
public:
    explicit OsmesaContext(Size size) : HeadlessContext(size) {
        // The same software driver on every machine, so that pictures agree.
        const ScopedEnvironment driver("GALLIUM_DRIVER", "llvmpipe");
        // clang-format off
        const int wanted[] = {OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_STENCIL_BITS, 8,
                              OSMESA_PROFILE, OSMESA_CORE_PROFILE, OSMESA_CONTEXT_MAJOR_VERSION, 3,
                              OSMESA_CONTEXT_MINOR_VERSION, 3, 0};
        // clang-format on
        context_ = osmesa_.create(wanted, nullptr);
        if (!context_)
            throw MachineLacks("OSMesa makes no OpenGL 3.3 context with its driver llvmpipe; install a newer libosmesa6.");
        try {
            bind();
        } catch (...) {
            osmesa_.destroy(context_);
            throw;
        }
    }
    ~OsmesaContext() override {
        if (osmesa_.current() == context_) osmesa_.make_current(nullptr, nullptr, 0, 0, 0);
        osmesa_.destroy(context_);
    }

    void make_current() override { bind(); }
    void resize(Size size) override {
        check_size(size);
        size_ = size;
        bind();
    }
    void present() override { finish_gl(); }
    std::string description() const override { return "OSMesa: " + describe_gl(); }

private:
    // OSMesa draws into memory of the caller, row 0 at the bottom.
    void bind() {
        buffer_.resize(std::size_t{4} * static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height));
        if (!osmesa_.make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, size_.width, size_.height))
            throw MachineLacks("OSMesa cannot draw a picture of " + std::to_string(size_.width) + "x" +
                               std::to_string(size_.height) + " px.");
        load_gl([](const char* name) { return reinterpret_cast<GlFunction>(OsmesaLibrary::get().proc_address(name)); });
    }

    const OsmesaLibrary& osmesa_ = OsmesaLibrary::get();
    OSMesaContext context_ = nullptr;
    std::vector<std::uint8_t> buffer_;
};

}  // namespace

std::unique_ptr<Context> open_osmesa(Size size) { return std::make_unique<OsmesaContext>(size); }

}  // namespace pliant::viewer

#else

namespace pliant::viewer {
std::unique_ptr<Context> open_osmesa(Size) {
    throw MachineLacks("This build has no OSMesa; install libosmesa6-dev and build again, or use a machine with EGL.");
}
}  // namespace pliant::viewer

#endif
