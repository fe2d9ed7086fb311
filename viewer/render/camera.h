// From metres to pixels: a flat view of a 2D scene, or an orbit about a target in 3D.
#pragma once
#include <pliant/document/scene_file.h>
#include <pliant/lesson/scene.h>

#include <Eigen/Geometry>

namespace pliant::viewer {

// A camera over a rectangle of the screen. Pixel coordinates have y down and their origin at the rectangle's upper left corner.
class Projection {
public:
    // right_margin px stay free of the framed scene: the colour bar's place.
    Projection(const Camera& camera, int dimension, float width, float height, float right_margin = 0);

    const Eigen::Matrix4f& matrix() const { return matrix_; }  // metres to clip space
    const Eigen::Matrix4f& view() const { return view_; }      // metres to eye space, in which the eye looks along -z

    // Pixel and depth (−1 near to 1 far) of a point; behind the eye the depth is above 1.
    Eigen::Vector3f pixel(const Position& p) const;
    // The point seen at a pixel that is as far from the eye as `like`.
    Vec<3> at_depth_of(const Eigen::Vector2f& pixel, const Vec<3>& like) const;
    // Metres per pixel at the target.
    Real metres_per_pixel() const { return metres_per_pixel_; }

private:
    Eigen::Matrix4f view_, matrix_, inverse_;
    float width_, height_;
    Real metres_per_pixel_;
};

// The camera's axes, in rows: right, up and towards the eye.
Eigen::Matrix3d eye_axes(const Camera& camera, int dimension);
// Half of the height that is seen at a distance from the eye, per metre of that distance; in 2D per metre of the camera's.
Real seen_half_height(int dimension);

// Mouse moves, in pixels.
void orbit(Camera& camera, float dx, float dy);
void pan(Camera& camera, int dimension, const Projection& projection, float dx, float dy);
// Zooms about a pixel: factor < 1 comes nearer.
void zoom(Camera& camera, int dimension, const Projection& projection, const Eigen::Vector2f& pixel, Real factor);

}  // namespace pliant::viewer
