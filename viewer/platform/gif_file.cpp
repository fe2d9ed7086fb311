#include "platform/gif_file.h"

#include <gif_lib.h>
#include <pliant/math/error.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

#include "platform/palette_of_frames.h"

namespace pliant::viewer {
namespace {

constexpr std::uint8_t unchanged = FramePalette::size;

void good(int result) {
    if (result == GIF_ERROR) throw Refused("the animation cannot be encoded as a GIF");
}

// What of a frame differs from the one before.
struct Changes {
    int left = 0, top = 0, width = 0, height = 0;
};

Changes changes(const std::vector<std::uint8_t>& now, const std::vector<std::uint8_t>& before, int width, int height) {
    if (before.empty()) return {0, 0, width, height};
    int left = width, right = -1, top = height, bottom = -1;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
            if (now[i] == before[i]) continue;
            left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = y;
        }
    if (right < 0) return {0, 0, 1, 1};
    return {left, top, right - left + 1, bottom - top + 1};
}

// A GIF being written to memory.
class Encoder {
public:
    Encoder(int width, int height, const FramePalette& palette) : width_(width), height_(height) {
        int error = 0;
        file_ = EGifOpen(
            &bytes_,
            [](GifFileType* file, const GifByteType* data, int count) {
                static_cast<std::string*>(file->UserData)
                    ->append(reinterpret_cast<const char*>(data), static_cast<std::size_t>(count));
                return count;
            },
            &error);
        if (!file_) throw std::bad_alloc();
        EGifSetGifVersion(file_, true);
        const std::unique_ptr<ColorMapObject, void (*)(ColorMapObject*)> map(GifMakeMapObject(256, nullptr), GifFreeMapObject);
        if (!map) throw std::bad_alloc();
        for (int i = 0; i < FramePalette::size; ++i) {
            const auto& c = palette.colour(i);
            map->Colors[i] = {c[0], c[1], c[2]};
        }
        good(EGifPutScreenDesc(file_, width, height, 8, 0, map.get()));
        repeat_for_ever();
    }
    ~Encoder() {
        int ignored = 0;
        if (file_) EGifCloseFile(file_, &ignored);
    }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;

    void add(const std::vector<std::uint8_t>& indices, int delay) {
        const Changes c = changes(indices, before_, width_, height_);
        const GraphicsControlBlock control{DISPOSE_DO_NOT, false, delay, before_.empty() ? NO_TRANSPARENT_COLOR : unchanged};
        GifByteType extension[4];
        EGifGCBToExtension(&control, extension);
        good(EGifPutExtension(file_, GRAPHICS_EXT_FUNC_CODE, sizeof extension, extension));
        good(EGifPutImageDesc(file_, c.left, c.top, c.width, c.height, false, nullptr));
        std::vector<GifPixelType> line(static_cast<std::size_t>(c.width));
        for (int y = c.top; y < c.top + c.height; ++y) {
            const auto first = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(c.left);
            for (std::size_t x = 0; x < line.size(); ++x)
                line[x] = !before_.empty() && indices[first + x] == before_[first + x] ? unchanged : indices[first + x];
            good(EGifPutLine(file_, line.data(), c.width));
        }
        before_ = indices;
    }

    std::string finished() {
        int error = 0;
        good(EGifCloseFile(std::exchange(file_, nullptr), &error));
        return std::move(bytes_);
    }

private:
    // The application extension that browsers know (Netscape 2.0).
    void repeat_for_ever() {
        constexpr GifByteType always[] = {1, 0, 0};
        good(EGifPutExtensionLeader(file_, APPLICATION_EXT_FUNC_CODE));
        good(EGifPutExtensionBlock(file_, 11, "NETSCAPE2.0"));
        good(EGifPutExtensionBlock(file_, sizeof always, always));
        good(EGifPutExtensionTrailer(file_));
    }

    int width_, height_;
    std::string bytes_;
    GifFileType* file_ = nullptr;
    std::vector<std::uint8_t> before_;
};

}  // namespace

GifRecording::GifRecording(int frames_per_second) : frames_per_second_(frames_per_second) {
    if (frames_per_second < 1 || frames_per_second > 50)
        throw Refused("frames per second", frames_per_second, "", "a whole number from 1 to 50");
}

int GifRecording::delay(std::size_t frame) const {
    const auto time = [this](std::size_t number) { return static_cast<Real>(number) / frames_per_second_; };
    const Real end = end_ && frame + 1 == frames() ? *end_ : time(frame + 1);
    return static_cast<int>(std::lround(100 * end) - std::lround(100 * time(frame)));
}

void GifRecording::add(const Image& image) {
    if (image.width <= 0 || image.height <= 0) throw Refused("a frame of an animation has no pixels");
    if (frames_.empty()) width_ = image.width, height_ = image.height;
    if (image.width != width_ || image.height != height_)
        throw Refused("the frames of an animation differ in size: do not resize the window while one is made");
    uLongf size = compressBound(static_cast<uLong>(image.rgb.size()));
    std::vector<unsigned char> bytes(size);
    if (compress2(bytes.data(), &size, image.rgb.data(), static_cast<uLong>(image.rgb.size()), Z_BEST_SPEED) != Z_OK)
        throw std::bad_alloc();
    bytes.resize(size);
    bytes.shrink_to_fit();
    frames_.push_back(std::move(bytes));
}

Image GifRecording::frame(std::size_t number) const {
    Image image{width_, height_, {}};
    image.rgb.resize(image.row_bytes() * static_cast<std::size_t>(height_));
    uLongf size = static_cast<uLongf>(image.rgb.size());
    if (uncompress(image.rgb.data(), &size, frames_[number].data(), static_cast<uLong>(frames_[number].size())) != Z_OK)
        throw std::bad_alloc();
    return image;
}

std::string GifRecording::encoded() const {
    GifWriting writing(*this);
    while (writing.next()) {
    }
    return writing.finished();
}

struct GifWriting::Parts {
    Parts(int width, int height, const std::vector<Image>& samples) : palette(samples), encoder(width, height, palette) {}
    FramePalette palette;
    Encoder encoder;
};

// The palette is that of the first, the middle and the last frame.
GifWriting::GifWriting(const GifRecording& recording) : recording_(recording) {
    const std::size_t count = recording.frames();
    if (count == 0) throw Refused("an animation needs a frame");
    std::vector<std::size_t> numbers{0, count / 2, count - 1};
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    std::vector<Image> samples;
    for (const std::size_t n : numbers) samples.push_back(recording.frame(n));
    parts_ = std::make_unique<Parts>(recording.width_, recording.height_, samples);
}

GifWriting::~GifWriting() = default;

bool GifWriting::next() {
    if (done_ == recording_.frames()) return false;
    parts_->encoder.add(parts_->palette.indices(recording_.frame(done_)), recording_.delay(done_));
    ++done_;
    return true;
}

std::string GifWriting::finished() { return parts_->encoder.finished(); }

Image narrowed(const Image& image, int width) {
    if (width >= image.width || width < 1) return image;
    const int height = std::max(1, static_cast<int>(std::lround(static_cast<double>(image.height) * width / image.width)));
    Image small{width, height,
                std::vector<std::uint8_t>(std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
    const auto edge = [](int i, int count, int whole) { return static_cast<int>(static_cast<long>(i) * whole / count); };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int x0 = edge(x, width, image.width), x1 = std::max(x0 + 1, edge(x + 1, width, image.width));
            const int y0 = edge(y, height, image.height), y1 = std::max(y0 + 1, edge(y + 1, height, image.height));
            for (std::size_t k = 0; k < 3; ++k) {
                int sum = 0;
                for (int v = y0; v < y1; ++v)
                    for (int u = x0; u < x1; ++u) sum += image.row(v)[3 * static_cast<std::size_t>(u) + k];
                const int count = (x1 - x0) * (y1 - y0);
                small.rgb[small.row_bytes() * static_cast<std::size_t>(y) + 3 * static_cast<std::size_t>(x) + k] =
                    static_cast<std::uint8_t>((sum + count / 2) / count);
            }
        }
    return small;
}

}  // namespace pliant::viewer
