// Animated GIFs, read back with giflib's own reader.
#include "platform/gif_file.h"

#include <gif_lib.h>
#include <pliant/math/error.h>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numeric>
#include <string_view>

using namespace pliant;
using namespace pliant::viewer;

namespace {

// A slope of colours over the frame, and a white square that moves.
Image picture(int width, int height, int at) {
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool square = x >= at && x < at + 8 && y >= 4 && y < 12;
            image.rgb.push_back(static_cast<std::uint8_t>(square ? 255 : 20 + 150 * x / width));
            image.rgb.push_back(static_cast<std::uint8_t>(square ? 255 : 30 + 100 * y / height));
            image.rgb.push_back(static_cast<std::uint8_t>(square ? 255 : 60));
        }
    return image;
}

struct Decoded {
    int width = 0, height = 0;
    bool repeats = false;
    std::vector<int> delays;
    std::vector<Image> frames;  // as they are seen, one over the other
};

struct Source {
    std::string_view bytes;
    std::size_t at = 0;
};

int read_bytes(GifFileType* file, GifByteType* to, int count) {
    auto& source = *static_cast<Source*>(file->UserData);
    const std::size_t taken = std::min(static_cast<std::size_t>(count), source.bytes.size() - source.at);
    std::memcpy(to, source.bytes.data() + source.at, taken);
    source.at += taken;
    return static_cast<int>(taken);
}

void lay_over(Image& canvas, const SavedImage& image, const ColorMapObject& colours, int transparent) {
    const GifImageDesc& d = image.ImageDesc;
    for (int y = 0; y < d.Height; ++y)
        for (int x = 0; x < d.Width; ++x) {
            const int index = image.RasterBits[y * d.Width + x];
            if (index == transparent) continue;
            const GifColorType& c = colours.Colors[index];
            const auto at = 3 * static_cast<std::size_t>((d.Top + y) * canvas.width + d.Left + x);
            canvas.rgb[at] = c.Red, canvas.rgb[at + 1] = c.Green, canvas.rgb[at + 2] = c.Blue;
        }
}

Decoded decoded(const std::string& bytes) {
    Source source{bytes};
    int error = 0;
    GifFileType* file = DGifOpen(&source, read_bytes, &error);
    REQUIRE(file);
    const std::unique_ptr<GifFileType, void (*)(GifFileType*)> close_later(file,
                                                                           [](GifFileType* f) { DGifCloseFile(f, nullptr); });
    REQUIRE(DGifSlurp(file) == GIF_OK);
    Decoded result{file->SWidth, file->SHeight, bytes.find("NETSCAPE2.0") != bytes.npos, {}, {}};
    REQUIRE(file->SColorMap);
    Image canvas{file->SWidth, file->SHeight, {}};
    canvas.rgb.resize(canvas.row_bytes() * static_cast<std::size_t>(canvas.height));
    for (int i = 0; i < file->ImageCount; ++i) {
        GraphicsControlBlock control{};
        REQUIRE(DGifSavedExtensionToGCB(file, i, &control) == GIF_OK);
        result.delays.push_back(control.DelayTime);
        lay_over(canvas, file->SavedImages[i], *file->SColorMap, control.TransparentColor);
        result.frames.push_back(canvas);
    }
    return result;
}

}  // namespace

TEST_CASE("gif: frames come back in size, number, time and colours") {
    GifRecording gif(20);
    std::vector<Image> given;
    for (int i = 0; i < 7; ++i) given.push_back(picture(64, 40, 6 * i)), gif.add(given.back());
    given.push_back(given.back());  // nothing changes
    gif.add(given.back());
    const std::string bytes = gif.encoded();
    CHECK(bytes.starts_with("GIF89a"));
    const Decoded back = decoded(bytes);
    CHECK(back.width == 64);
    CHECK(back.height == 40);
    CHECK(back.repeats);
    CHECK(back.delays == std::vector<int>(8, 5));
    REQUIRE(back.frames.size() == given.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
        INFO("frame " << i);
        CHECK(compare(given[i], back.frames[i]).largest <= 16);
        CHECK(compare(given[i], back.frames[i], 8).fraction_over < 0.02);
    }
    GifRecording again(20);
    for (const Image& image : given) again.add(image);
    CHECK(again.encoded() == bytes);
}

TEST_CASE("gif: at every number of frames a second the whole lasts as long as it should") {
    const Image image = picture(16, 16, 2);
    for (int frames_per_second = 1; frames_per_second <= 50; ++frames_per_second) {
        INFO(frames_per_second << " frames a second");
        GifRecording gif(frames_per_second);
        for (int i = 0; i < 2 * frames_per_second; ++i) gif.add(image);
        const std::vector<int> delays = decoded(gif.encoded()).delays;
        CHECK(std::accumulate(delays.begin(), delays.end(), 0) == 200);
        const auto [shortest, longest] = std::ranges::minmax(delays);
        CHECK(longest - shortest <= 1);
        CHECK(shortest >= 2);  // browsers show what is shorter for a tenth of a second
        // No frame begins more than half a hundredth away from its time.
        int begin = 0;
        for (std::size_t i = 0; i < delays.size(); begin += delays[i++])
            CHECK(std::abs(begin - 100.0 * static_cast<double>(i) / frames_per_second) <= 0.5 + 1e-9);
    }
}

TEST_CASE("gif: the last frame stays until the end that is asked for") {
    GifRecording gif(15);
    for (int i = 0; i < 22; ++i) gif.add(picture(16, 16, 2));
    gif.end_at(1.5);
    const std::vector<int> delays = decoded(gif.encoded()).delays;
    CHECK(std::accumulate(delays.begin(), delays.end(), 0) == 150);
    CHECK(delays.back() == 10);
}

TEST_CASE("gif: a flat area keeps its colour") {
    Image flat{32, 32, {}};
    for (int i = 0; i < 32 * 32; ++i) flat.rgb.insert(flat.rgb.end(), {19, 22, 30});
    for (std::size_t i = 0; i < 3 * 40; ++i) flat.rgb[i] = 255;
    GifRecording gif(10);
    gif.add(flat);
    const Decoded back = decoded(gif.encoded());
    CHECK(back.delays == std::vector<int>{10});
    CHECK(compare(flat, back.frames.at(0)).largest <= 1);
}

TEST_CASE("gif: what cannot be an animation is refused") {
    CHECK_THROWS_AS(GifRecording(0), Refused);
    CHECK_THROWS_AS(GifRecording(51), Refused);
    GifRecording gif(20);
    CHECK_THROWS_AS(gif.encoded(), Refused);
    CHECK_THROWS_AS(gif.add(Image{}), Refused);
    gif.add(picture(20, 20, 3));
    CHECK_THROWS_AS(gif.add(picture(21, 20, 3)), Refused);
    CHECK(gif.frames() == 1);
}

TEST_CASE("a narrowed picture is the mean of what it covers") {
    Image image{4, 2, {}};
    for (const int grey : {0, 100, 200, 200, 50, 50, 200, 200})
        for (int k = 0; k < 3; ++k) image.rgb.push_back(static_cast<std::uint8_t>(grey));
    const Image small = narrowed(image, 2);
    CHECK(small.width == 2);
    CHECK(small.height == 1);
    CHECK(small.rgb == std::vector<std::uint8_t>{50, 50, 50, 200, 200, 200});
    CHECK(narrowed(image, 4) == image);
    CHECK(narrowed(image, 9) == image);
    CHECK(narrowed(picture(101, 57, 3), 33).height == 19);
}
