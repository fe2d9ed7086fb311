#include <pliant/solids/sheet_wind.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pliant {

Mat<3> triangle_drag(const Air& air, const Mat<3>& corners, const Mat<3>& v) {
    const Vec<3> ab = corners.col(1) - corners.col(0), ac = corners.col(2) - corners.col(0);
    const Vec<3> area = 0.5 * ab.cross(ac);
    const Real squared = area.squaredNorm();
    if (squared == 0) return Mat<3>::Zero();
    const Vec<3> u = air.velocity - (v.col(0) + v.col(1) + v.col(2)) / 3;
    return air.density * air.drag / 6 * std::abs(u.dot(area)) / squared * (area * area.transpose());
}

void wind_drag(const std::vector<NodeTriple>& triangles, const Air& air, PointsIn<3> x, PointsIn<3> v,
               std::vector<Mat<3>>& drag) {
    drag.resize(static_cast<std::size_t>(x.cols()));
    for (Mat<3>& c : drag) c.setZero();
    Mat<3> corners, velocities;
    for (const NodeTriple& nodes : triangles) {
        for (int k = 0; k < 3; ++k) {
            corners.col(k) = x.col(nodes[static_cast<std::size_t>(k)]);
            velocities.col(k) = v.col(nodes[static_cast<std::size_t>(k)]);
        }
        const Mat<3> share = triangle_drag(air, corners, velocities);
        for (const Index node : nodes) drag[static_cast<std::size_t>(node)] += share;
    }
}

}  // namespace pliant
