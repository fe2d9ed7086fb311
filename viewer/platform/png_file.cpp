#include "platform/png_file.h"

#include <pliant/math/error.h>
#include <pliant/text/file.h>
#include <png.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace pliant::viewer {
namespace {

namespace fs = std::filesystem;
constexpr png_uint_32 largest_read = 32768;  // px per side

[[noreturn]] void cannot(const char* verb, const fs::path& path, const std::string& reason) {
    throw Refused(std::string("Cannot ") + verb + " the picture '" + path.string() + "': " + reason + ".");
}

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::string encoded(const Image& image, const fs::path& path) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr))
        cannot("write", path, png.message);
    bytes.resize(size);
    return bytes;
}

}  // namespace

void write_png(const Image& image, const fs::path& path) {
    if (image.width <= 0 || image.height <= 0) cannot("write", path, "it has no pixels");
    write_file(path.string(), encoded(image, path));
}

std::string png_bytes(const Image& image) { return encoded(image, "the picture"); }

Image read_png(const fs::path& path) {
    const File file(std::fopen(path.c_str(), "rb"));
    if (!file) cannot("read", path, std::strerror(errno));
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_stdio(&png, file.get())) cannot("read", path, png.message);
    const std::unique_ptr<png_image, void (*)(png_image*)> free_later(&png, png_image_free);
    if (png.width > largest_read || png.height > largest_read) {
        cannot("read", path,
               "it has " + std::to_string(png.width) + "x" + std::to_string(png.height) + " px, at most 32768 per side are read");
    }
    png.format = PNG_FORMAT_RGB;
    Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
    image.rgb.resize(PNG_IMAGE_SIZE(png));
    const png_color black{0, 0, 0};
    if (!png_image_finish_read(&png, &black, image.rgb.data(), 0, nullptr)) cannot("read", path, png.message);
    return image;
}

}  // namespace pliant::viewer
