// The functions of OpenGL 3.3 core; in a browser those of OpenGL ES 3.0, which the viewer's shaders and buffers keep to.
#pragma once
#if defined(__EMSCRIPTEN__)
#include <GLES3/gl3.h>
#else
#include <glad/gl.h>
#endif
