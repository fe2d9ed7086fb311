// What the source file of each backend offers. Where its library is absent from the build, each throws MachineLacks.
#pragma once
#include <memory>
#include <string>

#include "platform/context.h"

namespace pliant::viewer {

std::unique_ptr<Context> open_window(Size size, const std::string& title);
std::unique_ptr<Context> open_osmesa(Size size);
std::unique_ptr<Context> open_egl(Size size);

// Throws Refused when a side lies outside 1 to largest_side.
void check_size(Size size);

}  // namespace pliant::viewer
