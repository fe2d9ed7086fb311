// Loads the functions of OpenGL through the way that a context offers. Includes no GL header itself, so that a source which needs
// another library's own GL header can use it.
#pragma once
#include <string>

namespace pliant::viewer {

using GlFunction = void (*)();
using GlGetFunction = GlFunction (*)(const char* name);

// Loads all functions for the context that is current, unless they came from the same source last. Throws MachineLacks when it
// offers less than OpenGL 3.3.
void load_gl(GlGetFunction get);

// "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 3.3 (Core Profile) Mesa 22.3.6", of the context that is current.
std::string describe_gl();

// Waits until all that was asked for is drawn.
void finish_gl();

}  // namespace pliant::viewer
