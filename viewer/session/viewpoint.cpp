#include "session/viewpoint.h"

#include <cmath>
#include <utility>

namespace pliant::viewer {
namespace {

constexpr Real ease_seconds = 0.25;     // in which all but 1/e of the way is done
constexpr Real arrived = 1e-4;          // of the distance: nobody sees the rest of the way
constexpr Real farthest = 4;            // of the distance from which the frame is seen
constexpr float followed_part = 0.95f;  // of the picture: what moves beyond it is followed
constexpr float seen_part = 0.99f;      // and never leaves this one, while the camera is on its way

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

Camera Viewpoint::belonging(const Sighting& s) const {
    Camera framed = framing(s.frame, s.aspect);
    if (turned_) framed.yaw = camera_.yaw, framed.pitch = camera_.pitch;
    return keeping_in_sight(framed, s.moving, s.frame.dimension, {s.aspect, followed_part, farthest * framed.distance});
}

const Camera& Viewpoint::look(const Sighting& s) {
    const Shown shown{s.frame, s.aspect, s.run}, before = std::exchange(shown_, shown);
    if (s.held && before.frame.dimension == s.frame.dimension && before.run >= 0) return camera_;
    const Camera there = belonging(s);
    moving_ = s.seconds > 0 && shown == before && !close(camera_, there);
    if (!moving_) return camera_ = there;
    camera_ = between(camera_, there, 1 - std::exp(-s.seconds / ease_seconds));
    return camera_ = keeping_in_sight(camera_, s.moving, s.frame.dimension, {s.aspect, seen_part, 2 * there.distance});
}

void Viewpoint::turn_to(Real yaw, Real pitch) {
    camera_.yaw = yaw, camera_.pitch = pitch;
    turned_ = true;
}

void Viewpoint::turn(float dx, float dy) {
    orbit(camera_, dx, dy);
    turned_ = true;
}

}  // namespace pliant::viewer
