#include <pliant/fluids/carried_blob.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant {
namespace {

using std::numbers::pi;

constexpr Real rotation_rate = 2 * SteadyFlow::top_speed;  // rad/s: top speed half a metre from the middle
constexpr Real longest_part = 0.05;                        // m of path in one Runge–Kutta step

constexpr Real slot_width = 1.0 / 3, slot_height = 5.0 / 3;  // of the radius; the slot opens downwards [Zalesak1979]

}  // namespace

Real SteadyFlow::stream_function(const Vec<2>& x) const {
    switch (kind) {
        case FlowKind::translation:
            return top_speed * (std::cos(direction) * x[1] - std::sin(direction) * x[0]);
        case FlowKind::rotation:
            return -rotation_rate / 2 * (x - Vec<2>(0.5, 0.5)).squaredNorm();
        case FlowKind::vortex: {
            const Real s = std::sin(pi * x[0]) * std::sin(pi * x[1]);
            return -top_speed / pi * s * s;
        }
    }
    return 0;
}

Vec<2> SteadyFlow::velocity(const Vec<2>& x) const {
    switch (kind) {
        case FlowKind::translation:
            return top_speed * Vec<2>(std::cos(direction), std::sin(direction));
        case FlowKind::rotation:
            return rotation_rate * Vec<2>(-(x[1] - 0.5), x[0] - 0.5);
        case FlowKind::vortex: {
            const Real sx = std::sin(pi * x[0]), sy = std::sin(pi * x[1]);
            return top_speed * Vec<2>(-sx * sx * std::sin(2 * pi * x[1]), sy * sy * std::sin(2 * pi * x[0]));
        }
    }
    return Vec<2>::Zero();
}

Real SteadyFlow::turn() const { return kind == FlowKind::rotation ? 2 * pi / rotation_rate : 1 / top_speed; }

Vec<2> SteadyFlow::before(const Vec<2>& x, Real dt) const {
    if (kind == FlowKind::translation) return x - dt * velocity(x);
    const Vec<2> middle(0.5, 0.5);
    if (kind == FlowKind::rotation) return middle + Eigen::Rotation2D<Real>(-rotation_rate * dt) * (x - middle);
    Vec<2> y = x;
    const auto parts = std::max<Index>(1, static_cast<Index>(std::ceil(std::abs(dt) * top_speed / longest_part)));
    const Real h = dt / static_cast<Real>(parts);
    for (Index k = 0; k < parts; ++k) {
        const Vec<2> k1 = velocity(y), k2 = velocity(y - h / 2 * k1), k3 = velocity(y - h / 2 * k2), k4 = velocity(y - h * k3);
        y -= h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return y;
}

FaceField<2> face_velocity(const StaggeredGrid<2>& grid, const SteadyFlow& flow) {
    FaceField<2> velocity = grid.zero_velocity();
    const Real dx = grid.dx();
    for (int a = 0; a < 2; ++a) {
        const Lattice<2>& faces = grid.faces(a);
        const Vec<2> half = dx / 2 * Vec<2>::Unit(1 - a);
        for (Index f = 0; f < faces.size(); ++f) {
            const GridPlace<2> at = faces.place(faces.coordinates(f));
            const Vec<2> x = dx * Vec<2>(at[0], at[1]);
            const Real across = (flow.stream_function(x + half) - flow.stream_function(x - half)) / dx;
            velocity[a][f] = a == 0 ? across : -across;
        }
    }
    return velocity;
}

Real Blob::value(const Vec<2>& x) const {
    const Real r = distance(x) / radius;
    switch (kind) {
        case BlobKind::smooth:
            return std::exp(-2 * r * r);
        case BlobKind::hill:
            return r < 1 ? (1 + std::cos(pi * r)) / 2 : Real{0};
        case BlobKind::slotted_disc: {
            const Vec<2> from_edge = x - centre + radius * Vec<2>::UnitY();
            const bool in_slot = std::abs(from_edge[0]) < slot_width / 2 * radius && from_edge[1] < slot_height * radius;
            return r < 1 && !in_slot ? 1 : 0;
        }
    }
    return 0;
}

Vec<2> shortest_way(const Vec<2>& x, const Vec<2>& centre, bool periodic) {
    Vec<2> d = x - centre;
    if (periodic) d -= d.array().round().matrix();
    return d;
}

}  // namespace pliant
