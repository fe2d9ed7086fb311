#include "platform/context.h"

#include <pliant/math/error.h>

#include "platform/backends.h"

namespace pliant::viewer {

void check_size(Size size) {
    const auto fits = [](int side) { return side >= 1 && side <= largest_side; };
    if (fits(size.width) && fits(size.height)) return;
    throw Refused("size = " + std::to_string(size.width) + "x" + std::to_string(size.height) +
                  " px is refused: each side must be 1 to " + std::to_string(largest_side) + " px.");
}

std::unique_ptr<Context> open_context(Backend backend, Size size, const std::string& title) {
    check_size(size);
    switch (backend) {
        case Backend::window:
            return open_window(size, title);
        case Backend::osmesa:
            return open_osmesa(size);
        case Backend::egl:
            return open_egl(size);
    }
    throw std::logic_error("unknown backend");
}

std::unique_ptr<Context> open_headless(Size size) {
    check_size(size);
    std::string reasons;
    for (const Backend backend : {Backend::osmesa, Backend::egl}) {
        try {
            return open_context(backend, size);
        } catch (const MachineLacks& lack) {
            reasons += std::string("\n  ") + lack.what();
        }
    }
    throw MachineLacks("No picture can be drawn without a display on this machine:" + reasons);
}

}  // namespace pliant::viewer
