#include "platform/image.h"

#include <pliant/math/error.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace pliant::viewer {

Image crop(const Image& image, int left, int top, int width, int height) {
    const int x0 = std::clamp(left, 0, image.width), x1 = std::clamp(left + width, x0, image.width);
    const int y0 = std::clamp(top, 0, image.height), y1 = std::clamp(top + height, y0, image.height);
    Image part{x1 - x0, y1 - y0, {}};
    part.rgb.reserve(part.row_bytes() * static_cast<std::size_t>(part.height));
    for (int y = y0; y < y1; ++y) {
        const auto row = image.row(y).subspan(std::size_t{3} * static_cast<std::size_t>(x0), part.row_bytes());
        part.rgb.insert(part.rgb.end(), row.begin(), row.end());
    }
    return part;
}

ImageDifference compare(const Image& a, const Image& b, int amount) {
    if (a.width != b.width || a.height != b.height) {
        const auto size = [](const Image& image) {
            return std::to_string(image.width) + "x" + std::to_string(image.height) + " px";
        };
        throw Refused("Pictures of different sizes cannot be compared: " + size(a) + " and " + size(b) + ".");
    }
    ImageDifference difference;
    std::size_t over = 0;
    for (std::size_t pixel = 0; pixel + 2 < a.rgb.size(); pixel += 3) {
        int largest = 0;
        for (std::size_t c = pixel; c < pixel + 3; ++c) largest = std::max(largest, std::abs(int{a.rgb[c]} - int{b.rgb[c]}));
        difference.largest = std::max(difference.largest, largest);
        if (largest > amount) ++over;
    }
    if (!a.rgb.empty()) difference.fraction_over = static_cast<Real>(over) / static_cast<Real>(a.rgb.size() / 3);
    return difference;
}

}  // namespace pliant::viewer
