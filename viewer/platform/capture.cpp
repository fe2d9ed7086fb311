#include <algorithm>

#include "platform/gl.h"
#include "platform/image.h"

namespace pliant::viewer {

Image read_pixels(Context& context) {
    context.make_current();
    const Size size = context.framebuffer_size();
    Image image{size.width, size.height, {}};
    const std::size_t pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);

    // Four bytes per pixel is the layout of the framebuffer: the driver copies rows as they are.
    GLint framebuffer = 0, alignment = 4;
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &framebuffer);
    glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    std::vector<std::uint8_t> rgba(4 * pixels);
    glReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    glPixelStorei(GL_PACK_ALIGNMENT, alignment);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(framebuffer));

    // GL counts rows from the bottom, a picture from the top.
    image.rgb.resize(3 * pixels);
    const std::size_t width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
    for (std::size_t y = 0; y < height; ++y) {
        const std::uint8_t* from = rgba.data() + 4 * width * (height - 1 - y);
        std::uint8_t* to = image.rgb.data() + 3 * width * y;
        for (std::size_t x = 0; x < width; ++x, from += 4, to += 3) std::copy_n(from, 3, to);
    }
    return image;
}

}  // namespace pliant::viewer
