#include "render/framing.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace pliant::viewer {
namespace {

constexpr Real infinite = std::numeric_limits<Real>::infinity();
// How far from the target things may be along the view, per metre of the camera's distance.
constexpr Real depth_of_sight = 0.35;

// The places of a camera along one of its axes from which every point is in the picture: between lowest and highest where the
// camera is at least `needed` away. A point at x along the axis and z towards the eye is inside for |x − place| ≤ slope (d − z).
class Span {
public:
    explicit Span(Real slope) : slope_(slope) {}
    void add(Real x, Real z) {
        low_ = std::max(low_, x + slope_ * z);
        high_ = std::min(high_, x - slope_ * z);
    }
    Real needed() const { return (low_ - high_) / (2 * slope_); }
    Real middle() const { return (low_ + high_) / 2; }
    Real nearest(Real place, Real distance) const {
        const Real low = low_ - slope_ * distance, high = high_ + slope_ * distance;
        return low > high ? middle() : std::clamp(place, low, high);
    }

private:
    Real slope_, low_ = -infinite, high_ = infinite;
};

// Of points in the axes of a camera, from its target on.
struct Extent {
    Span across, up;
    Extent(int dimension, float aspect, Real part)
        : across(seen_half_height(dimension) * part * static_cast<Real>(aspect)), up(seen_half_height(dimension) * part) {}
    void add(const Vec<3>& seen) {
        across.add(seen[0], seen[2]);
        up.add(seen[1], seen[2]);
    }
    Real needed() const { return std::max({across.needed(), up.needed(), Real{1e-30}}); }
};

// Those that are finite, in the axes of the camera and from its target on; in 2D all are equally far.
std::vector<Vec<3>> seen_by(const Camera& camera, std::span<const Position> points, int dimension) {
    const Eigen::Matrix3d axes = eye_axes(camera, dimension);
    std::vector<Vec<3>> seen;
    seen.reserve(points.size());
    for (const Position& p : points) {
        Vec<3> at = axes * (Vec<3>(p[0], p[1], p[2]) - camera.target);
        if (dimension == 2) at[2] = 0;
        if (at.allFinite()) seen.push_back(at);
    }
    return seen;
}

std::vector<Position> corners_of(const Frame& f) {
    std::vector<Position> corners;
    for (const float x : {f.lower[0], f.upper[0]})
        for (const float y : {f.lower[1], f.upper[1]})
            for (const float z : {f.lower[2], f.upper[2]}) corners.push_back({x, y, z});
    return corners;
}

// How far the target has to move along the view for things to be no farther from it than `reach`, or as far behind as before it.
Real move_in_depth(const std::vector<Vec<3>>& seen, Real reach) {
    const auto [back, front] = std::ranges::minmax(seen, {}, [](const Vec<3>& at) { return at[2]; });
    const Real low = front[2] - reach, high = back[2] + reach;
    return low > high ? (low + high) / 2 : std::clamp(Real{0}, low, high);
}

}  // namespace

Frame frame_of(const Scene& scene, int dimension) { return {scene.lower, scene.upper, dimension}; }

Frame about(const Frame& a, const Frame& b) {
    Frame both = a;
    for (std::size_t k = 0; k < 3; ++k)
        both.lower[k] = std::min(a.lower[k], b.lower[k]), both.upper[k] = std::max(a.upper[k], b.upper[k]);
    return both;
}

Camera framing(const Frame& frame, float aspect) {
    Camera camera;
    if (frame.dimension == 3) camera.yaw = 0.55, camera.pitch = 0.32;
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        camera.target[k] = (Real{frame.lower[i]} + frame.upper[i]) / 2;
    }
    Extent extent(frame.dimension, aspect, framed_part);
    for (const Vec<3>& at : seen_by(camera, corners_of(frame), frame.dimension)) extent.add(at);
    camera.distance = extent.needed();
    camera.target += eye_axes(camera, frame.dimension).transpose() * Vec<3>(extent.across.middle(), extent.up.middle(), 0);
    return camera;
}

Camera keeping_in_sight(const Camera& camera, std::span<const Position> points, int dimension, const Sight& sight) {
    std::vector<Vec<3>> seen = seen_by(camera, points, dimension);
    if (seen.empty()) return camera;
    const Real depth = move_in_depth(seen, depth_of_sight * camera.distance);
    Extent extent(dimension, sight.aspect, sight.part);
    for (Vec<3>& at : seen) at[2] -= depth, extent.add(at);
    Camera moved = camera;
    moved.distance = std::clamp(extent.needed(), camera.distance, std::max(sight.farthest, camera.distance));
    const Vec<3> move(extent.across.nearest(0, moved.distance), extent.up.nearest(0, moved.distance), depth);
    if (!move.isZero(0)) moved.target += eye_axes(camera, dimension).transpose() * move;
    return moved;
}

}  // namespace pliant::viewer
