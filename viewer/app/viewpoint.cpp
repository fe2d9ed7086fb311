#include "app/viewpoint.h"

#include <cmath>
#include <utility>

namespace pliant::viewer {
namespace {

constexpr Real ease_seconds = 0.25;  // in which all but 1/e of the way is done
constexpr Real arrived = 1e-4;       // of the distance: nobody sees the rest of the way
constexpr Real largest_step = 4;     // away from where the scene is framed, of that distance
constexpr float in_sight = 0.98f;    // the part of the picture that nothing leaves while the camera is on its way

Camera between(const Camera& from, const Camera& to, Real part) {
    Camera c = to;
    c.target = from.target + part * (to.target - from.target);
    c.distance = from.distance + part * (to.distance - from.distance);
    return c;
}

bool close(const Camera& a, const Camera& b) {
    return (a.target - b.target).norm() + std::abs(a.distance - b.distance) < arrived * b.distance;
}

}  // namespace

Camera Viewpoint::belonging(const Sighting& s, const Camera* angles) {
    Camera framed = framing(*s.scene, s.dimension, s.aspect);
    if (angles && s.dimension == 3) framed.yaw = angles->yaw, framed.pitch = angles->pitch;
    return keeping_in_sight(framed, s.moving, s.dimension, {s.aspect, framed_part, largest_step * framed.distance});
}

const Camera& Viewpoint::look(const Sighting& s) {
    const Frame frame{s.scene->lower, s.scene->upper, s.dimension, s.run, s.aspect};
    const Frame before = std::exchange(frame_, frame);
    if (s.held && before.dimension == s.dimension) return camera_;
    const Camera there = belonging(s, turned_ ? &camera_ : nullptr);
    moving_ = s.seconds > 0 && frame == before && !close(camera_, there);
    if (!moving_) return camera_ = there;
    camera_ = between(camera_, there, 1 - std::exp(-s.seconds / ease_seconds));
    const Real farthest = largest_step * framing(*s.scene, s.dimension, s.aspect).distance;
    return camera_ = keeping_in_sight(camera_, s.moving, s.dimension, {s.aspect, in_sight, farthest});
}

void Viewpoint::turn(float dx, float dy) {
    orbit(camera_, dx, dy);
    turned_ = true;
}

}  // namespace pliant::viewer
