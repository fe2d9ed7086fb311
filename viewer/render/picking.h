// What lies under the pointer.
#pragma once
#include <pliant/lesson/scene.h>

#include "render/camera.h"

#include <optional>

namespace pliant::viewer {

struct Picked {
    On on;
    Index index;
    Vec<3> at;  // m
    bool operator==(const Picked& other) const { return on == other.on && index == other.index; }
};

// The pickable mark nearest to the pixel, within `reach` px: points first, then lines, then triangles, then grid cells.
std::optional<Picked> pick(const Scene& scene, const Projection& projection, const Eigen::Vector2f& pixel, float reach);

}  // namespace pliant::viewer
