#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::viewer {
namespace {

constexpr Real field_of_view = 35 * std::numbers::pi / 180;  // vertical, rad
constexpr Real steepest = 1.5;                               // rad: just short of straight up or down

// Rows: right, up and towards the eye.
Eigen::Matrix3d eye_axes(const Camera& c) {
    const Vec<3> back(std::cos(c.pitch) * std::sin(c.yaw), std::sin(c.pitch), std::cos(c.pitch) * std::cos(c.yaw));
    const Vec<3> right = Vec<3>::UnitY().cross(back).normalized();
    Eigen::Matrix3d axes;
    axes << right.transpose(), back.cross(right).transpose(), back.transpose();
    return axes;
}

}  // namespace

Projection::Projection(const Camera& c, int dimension, float width, float height, float right_margin)
    : width_(width), height_(height) {
    const Eigen::Matrix3d axes = dimension == 3 ? eye_axes(c) : Eigen::Matrix3d::Identity();
    const float d = static_cast<float>(c.distance), aspect = width / height;
    view_.setIdentity();
    view_.topLeftCorner<3, 3>() = axes.cast<float>();
    view_.topRightCorner<3, 1>() = (-axes * c.target).cast<float>();
    Eigen::Matrix4f clip = Eigen::Matrix4f::Zero();
    if (dimension == 3) {
        view_(2, 3) -= d;
        const float f = static_cast<float>(1 / std::tan(field_of_view / 2)), near = d * 0.02f, far = d * 50;
        clip(0, 0) = f / aspect, clip(1, 1) = f, clip(2, 2) = (far + near) / (near - far),
                clip(2, 3) = 2 * far * near / (near - far), clip(3, 2) = -1;
        metres_per_pixel_ = 2 * c.distance * std::tan(field_of_view / 2) / height;
    } else {
        clip(0, 0) = 2 / (d * aspect), clip(1, 1) = 2 / d, clip(2, 2) = -1 / d, clip(3, 3) = 1;
        metres_per_pixel_ = c.distance / height;
    }
    // Moves the middle to that of the free part.
    clip.row(0) -= right_margin / width * clip.row(3);
    matrix_ = clip * view_;
    inverse_ = matrix_.inverse();
}

Eigen::Vector3f Projection::pixel(const Position& p) const {
    const Eigen::Vector4f c = matrix_ * Eigen::Vector4f(p[0], p[1], p[2], 1);
    if (c.w() <= 0) return {0, 0, 2};
    return {(c.x() / c.w() + 1) / 2 * width_, (1 - c.y() / c.w()) / 2 * height_, c.z() / c.w()};
}

Vec<3> Projection::at_depth_of(const Eigen::Vector2f& pixel_at, const Vec<3>& like) const {
    const Eigen::Vector4f c =
        matrix_ * Eigen::Vector4f(static_cast<float>(like[0]), static_cast<float>(like[1]), static_cast<float>(like[2]), 1);
    const Eigen::Vector4f clip(2 * pixel_at.x() / width_ - 1, 1 - 2 * pixel_at.y() / height_, c.z() / c.w(), 1);
    const Eigen::Vector4f world = inverse_ * clip;
    return (world.head<3>() / world.w()).cast<Real>();
}

Camera framing(const Scene& scene, int dimension, float aspect) {
    Camera camera;
    const Eigen::Map<const Eigen::Vector3f> lower(scene.lower.data()), upper(scene.upper.data());
    const Vec<3> size = (upper - lower).cast<Real>();
    camera.target = ((lower + upper) / 2).cast<Real>();
    if (dimension == 2) {
        camera.distance = 1.12 * std::max({size.y(), size.x() / aspect, 1e-30});
        return camera;
    }
    // The sphere about the box fits in the narrower angle of view.
    camera.yaw = 0.55, camera.pitch = 0.32;
    const Real half_angle = std::atan(std::tan(field_of_view / 2) * std::min(1.f, aspect));
    camera.distance = std::max(0.5 * size.norm() / std::sin(half_angle), 1e-30) * 0.92;
    return camera;
}

void orbit(Camera& camera, float dx, float dy) {
    camera.yaw -= 0.008 * dx;
    camera.pitch = std::clamp(camera.pitch + 0.008 * dy, -steepest, steepest);
}

void pan(Camera& camera, int dimension, const Projection& projection, float dx, float dy) {
    const Eigen::Matrix3d axes = dimension == 3 ? eye_axes(camera) : Eigen::Matrix3d::Identity();
    camera.target -= projection.metres_per_pixel() * (axes.row(0).transpose() * dx - axes.row(1).transpose() * dy);
}

void zoom(Camera& camera, int dimension, const Projection& projection, const Eigen::Vector2f& pixel_at, Real factor) {
    if (dimension == 2) {
        const Vec<3> fixed = projection.at_depth_of(pixel_at, camera.target);
        camera.target = fixed + factor * (camera.target - fixed);
    }
    camera.distance *= factor;
}

}  // namespace pliant::viewer
