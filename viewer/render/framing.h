// Where a camera stands so that a scene fills the picture, and so that what moves stays in it.
#pragma once
#include "render/camera.h"

#include <span>

namespace pliant::viewer {

// The part of the picture's width and height that a framed scene takes.
inline constexpr float framed_part = 1 / 1.12f;

// What a scene is framed by.
struct Frame {
    Position lower{}, upper{};  // m
    int dimension = 3;
    bool operator==(const Frame&) const = default;
};
Frame frame_of(const Scene& scene, int dimension);
// The smallest one about both.
Frame about(const Frame& a, const Frame& b);

// Shows the frame with a margin; aspect is that of the part of the picture that is free.
Camera framing(const Frame& frame, float aspect);

// How to keep points in sight: within `part` of the picture's width and height, by a camera that goes no farther away than
// `farthest`, m. Where that is too near for all of them, their middle is in the middle.
struct Sight {
    float aspect, part;
    Real farthest;
};

// The camera moved as little as it takes for all the points to be in the picture, and taken farther away where they do not fit
// otherwise. It does not turn. Points that are not finite are left out.
Camera keeping_in_sight(const Camera& camera, std::span<const Position> points, int dimension, const Sight& sight);

}  // namespace pliant::viewer
