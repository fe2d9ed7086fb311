#include "platform/png_file.h"

#include <pliant/math/error.h>
#include <png.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

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

// A file beside `path` that no one else has, open for writing. It goes away unless it is kept.
class TemporaryFile {
public:
    explicit TemporaryFile(const fs::path& path) {
        for (int number = 0; !file_ && number < 100; ++number) {
            name_ = path;
            name_ += ".part" + std::to_string(number);
            file_.reset(std::fopen(name_.c_str(), "wbx"));
            if (!file_ && errno != EEXIST) cannot("write", path, std::strerror(errno));
        }
        if (!file_) cannot("write", path, "the folder is full of unfinished pictures (*.part*), remove them");
    }
    ~TemporaryFile() {
        std::error_code ignored;
        if (!kept_) fs::remove(name_, ignored);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    std::FILE* get() const { return file_.get(); }
    // Gives the finished file its name.
    void keep_as(const fs::path& path) {
        if (std::fclose(file_.release()) != 0) cannot("write", path, std::strerror(errno));
        std::error_code failed;
        fs::rename(name_, path, failed);
        if (failed) cannot("write", path, failed.message());
        kept_ = true;
    }

private:
    fs::path name_;
    File file_;
    bool kept_ = false;
};

void encode(const Image& image, std::FILE* file, const fs::path& path) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGB;
    if (!png_image_write_to_stdio(&png, file, 0, image.rgb.data(), 0, nullptr)) cannot("write", path, png.message);
    if (std::fflush(file) != 0) cannot("write", path, std::strerror(errno));
}

}  // namespace

void write_png(const Image& image, const fs::path& path) {
    if (image.width <= 0 || image.height <= 0) cannot("write", path, "it has no pixels");
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (fs::is_directory(status)) cannot("write", path, "it is a folder");
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        // A pipe or a device is written to, never replaced.
        const File file(std::fopen(path.c_str(), "wb"));
        if (!file) cannot("write", path, std::strerror(errno));
        return encode(image, file.get(), path);
    }
    // A link stays a link: the file it leads to is replaced.
    const fs::path target = fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : path;
    TemporaryFile file(target);
    encode(image, file.get(), path);
    file.keep_as(target);
}

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
