// What tells a picture that is kept from one that has to be drawn.
#pragma once
#include "session/inspector.h"

#include <string>

namespace pliant::viewer {

// All that a picture depends on.
struct PictureKey {
    int opened = 0;
    long revision = 0;
    int beside_opened = 0;
    long beside_revision = 0;
    int pinned = 0;
    std::string field{};
    int component = -1;
    bool arrows = true, labels = true, smooth = true, difference = false, change = false;
    Compare compare = Compare::now;
    std::string stage{};
    bool operator==(const PictureKey&) const = default;
};

}  // namespace pliant::viewer
