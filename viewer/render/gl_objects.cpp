#include "render/gl_objects.h"

#include <pliant/math/error.h>

#include <string>

namespace pliant::viewer {
namespace {

#if defined(__EMSCRIPTEN__)
constexpr const char* header = "#version 300 es\nprecision highp float;\nprecision highp int;\n";
#else
constexpr const char* header = "#version 330 core\n";
#endif

GLuint compile(GLenum kind, const char* source) {
    const GLuint shader = glCreateShader(kind);
    const char* texts[] = {header, source};
    glShaderSource(shader, 2, texts, nullptr);
    glCompileShader(shader);
    GLint done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done) return shader;
    std::string log(2048, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    throw MachineLacks("The graphics driver refuses a shader of the lab; update it, or use `pliant shot`. It says: " + log);
}

}  // namespace

GlProgram make_program(const char* vertex, const char* fragment) {
    GlProgram program(glCreateProgram());
    const GLuint v = compile(GL_VERTEX_SHADER, vertex), f = compile(GL_FRAGMENT_SHADER, fragment);
    glAttachShader(program, v);
    glAttachShader(program, f);
    glLinkProgram(program);
    glDeleteShader(v);
    glDeleteShader(f);
    GLint done = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &done);
    if (!done)
        throw MachineLacks("The graphics driver cannot link a shader program of the lab; update it, or use `pliant shot`.");
    return program;
}

GlBuffer make_buffer() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return GlBuffer(name);
}

GlVertexArray make_vertex_array() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return GlVertexArray(name);
}

GlTexture make_texture() {
    GLuint name = 0;
    glGenTextures(1, &name);
    return GlTexture(name);
}

}  // namespace pliant::viewer
