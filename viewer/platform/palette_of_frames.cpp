#include "platform/palette_of_frames.h"

#include <gif_lib.h>

#include <algorithm>
#include <limits>
#include <new>

namespace pliant::viewer {
namespace {

constexpr int bits = 6, cells = 1 << bits, spread = 8 - bits;

std::size_t cell_of(int red, int green, int blue) {
    return static_cast<std::size_t>(((red >> spread) * cells + (green >> spread)) * cells + (blue >> spread));
}

// The ordered pattern of Bayer (1973), 0 to 15.
constexpr int pattern[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};

}  // namespace

FramePalette::FramePalette(const std::vector<Image>& samples) {
    std::vector<GifByteType> red, green, blue;
    for (const Image& image : samples)
        for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3) {
            red.push_back(image.rgb[i]);
            green.push_back(image.rgb[i + 1]);
            blue.push_back(image.rgb[i + 2]);
        }
    std::vector<GifByteType> output(red.size());
    std::array<GifColorType, size> map{};
    int count = size;
    if (GifQuantizeBuffer(static_cast<unsigned>(red.size()), 1, &count, red.data(), green.data(), blue.data(), output.data(),
                          map.data()) == GIF_ERROR)
        throw std::bad_alloc();
    std::array<std::array<std::uint64_t, 4>, size> sums{};
    for (std::size_t i = 0; i < red.size(); ++i) {
        auto& s = sums[std::min<std::size_t>(output[i], size - 1)];
        s[0] += red[i], s[1] += green[i], s[2] += blue[i], ++s[3];
    }
    for (std::size_t c = 0; c < size; ++c) {
        const auto& s = sums[c];
        colours_[c] = {map[c].Red, map[c].Green, map[c].Blue};
        for (std::size_t k = 0; s[3] && k < 3; ++k) colours_[c][k] = static_cast<std::uint8_t>((s[k] + s[3] / 2) / s[3]);
    }
    make_table();
}

int FramePalette::nearest(int red, int green, int blue) const {
    int best = 0, least = std::numeric_limits<int>::max();
    for (int i = 0; i < size; ++i) {
        const auto& c = colour(i);
        const int dr = red - c[0], dg = green - c[1], db = blue - c[2];
        const int distance = 2 * dr * dr + 4 * dg * dg + 3 * db * db;  // the eye tells greens apart best
        if (distance < least) least = distance, best = i;
    }
    return best;
}

void FramePalette::make_table() {
    table_.resize(static_cast<std::size_t>(cells) * cells * cells);
    constexpr int middle = 1 << (spread - 1), step = 1 << spread;
    for (int r = 0; r < cells; ++r)
        for (int g = 0; g < cells; ++g)
            for (int b = 0; b < cells; ++b)
                table_[cell_of(r * step, g * step, b * step)] =
                    static_cast<std::uint8_t>(nearest(r * step + middle, g * step + middle, b * step + middle));
    // A colour of the palette stands for itself.
    for (int i = 0; i < size; ++i) {
        const auto& c = colour(i);
        table_[cell_of(c[0], c[1], c[2])] = static_cast<std::uint8_t>(nearest(c[0], c[1], c[2]));
    }
}

std::uint8_t FramePalette::looked_up(const std::uint8_t* rgb, int shift) const {
    const auto moved = [&](int k) { return std::clamp(rgb[k] + shift, 0, 255); };
    return table_[cell_of(moved(0), moved(1), moved(2))];
}

std::vector<std::uint8_t> FramePalette::indices(const Image& image) const {
    std::vector<std::uint8_t> result;
    result.reserve(image.rgb.size() / 3);
    constexpr int close = 3;  // of 255, per colour: such a pixel is not mixed, so that flat areas stay flat
    for (int y = 0; y < image.height; ++y) {
        const auto row = image.row(y);
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t* rgb = &row[3 * static_cast<std::size_t>(x)];
            const std::uint8_t plain = looked_up(rgb, 0);
            const auto& c = colour(plain);
            const bool flat =
                std::abs(c[0] - rgb[0]) <= close && std::abs(c[1] - rgb[1]) <= close && std::abs(c[2] - rgb[2]) <= close;
            result.push_back(flat ? plain : looked_up(rgb, (pattern[y % 4][x % 4] - 7) / 2));
        }
    }
    return result;
}

}  // namespace pliant::viewer
