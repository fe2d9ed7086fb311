// GL objects that delete themselves. They belong to the context that was current when they were made.
#pragma once
#include "platform/gl.h"

#include <utility>

namespace pliant::viewer {

template <void (*Delete)(GLuint)>
class GlObject {
public:
    GlObject() = default;
    explicit GlObject(GLuint name) : name_(name) {}
    GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlObject() {
        if (name_) Delete(name_);
    }
    operator GLuint() const { return name_; }

private:
    GLuint name_ = 0;
};

namespace gl_delete {
inline void program(GLuint n) { glDeleteProgram(n); }
inline void buffer(GLuint n) { glDeleteBuffers(1, &n); }
inline void vertex_array(GLuint n) { glDeleteVertexArrays(1, &n); }
inline void texture(GLuint n) { glDeleteTextures(1, &n); }
inline void framebuffer(GLuint n) { glDeleteFramebuffers(1, &n); }
inline void renderbuffer(GLuint n) { glDeleteRenderbuffers(1, &n); }
}  // namespace gl_delete

using GlProgram = GlObject<gl_delete::program>;
using GlBuffer = GlObject<gl_delete::buffer>;
using GlVertexArray = GlObject<gl_delete::vertex_array>;
using GlTexture = GlObject<gl_delete::texture>;
using GlFramebuffer = GlObject<gl_delete::framebuffer>;
using GlRenderbuffer = GlObject<gl_delete::renderbuffer>;

// Compiles and links; throws MachineLacks with the driver's words when it cannot.
GlProgram make_program(const char* vertex, const char* fragment);
GlBuffer make_buffer();
GlVertexArray make_vertex_array();
GlTexture make_texture();

}  // namespace pliant::viewer
