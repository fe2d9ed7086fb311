#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::viewer {
namespace {

constexpr Real field_of_view = 35 * std::numbers::pi / 180;  // vertical, rad
constexpr Real steepest = 1.5;                               // rad: just short of straight up or down

}  // namespace

Eigen::Matrix3d eye_axes(const Camera& c, int dimension) {
    if (dimension == 2) return Eigen::Matrix3d::Identity();
    const Vec<3> back(std::cos(c.pitch) * std::sin(c.yaw), std::sin(c.pitch), std::cos(c.pitch) * std::cos(c.yaw));
    const Vec<3> right = Vec<3>::UnitY().cross(back).normalized();
    Eigen::Matrix3d axes;
    axes << right.transpose(), back.cross(right).transpose(), back.transpose();
    return axes;
}

Real seen_half_height(int dimension) { return dimension == 3 ? std::tan(field_of_view / 2) : 0.5; }

Projection::Projection(const Camera& c, int dimension, float width, float height, float right_margin)
    : width_(width), height_(height) {
    const Eigen::Matrix3d axes = eye_axes(c, dimension);
    const float d = static_cast<float>(c.distance), aspect = width / height;
    view_.setIdentity();
    view_.topLeftCorner<3, 3>() = axes.cast<float>();
    view_.topRightCorner<3, 1>() = (-axes * c.target).cast<float>();
    Eigen::Matrix4f clip = Eigen::Matrix4f::Zero();
    if (dimension == 3) {
        view_(2, 3) -= d;
        const float f = static_cast<float>(1 / seen_half_height(3)), near = d * 0.02f, far = d * 50;
        clip(0, 0) = f / aspect, clip(1, 1) = f, clip(2, 2) = (far + near) / (near - far),
                clip(2, 3) = 2 * far * near / (near - far), clip(3, 2) = -1;
        metres_per_pixel_ = 2 * c.distance * seen_half_height(3) / height;
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

void orbit(Camera& camera, float dx, float dy) {
    camera.yaw -= 0.008 * dx;
    camera.pitch = std::clamp(camera.pitch + 0.008 * dy, -steepest, steepest);
}

void pan(Camera& camera, int dimension, const Projection& projection, float dx, float dy) {
    const Eigen::Matrix3d axes = eye_axes(camera, dimension);
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
