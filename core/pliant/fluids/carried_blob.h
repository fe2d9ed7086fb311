// What is carried, and by which flow: shapes with values in [0, 1], steady flows through the unit square, and the exact solution.
#pragma once
#include <pliant/fluids/staggered_grid.h>

namespace pliant {

enum class FlowKind { translation, rotation, vortex };
enum class BlobKind { smooth, hill, slotted_disc };

// The exact flow. All lengths in m, speeds in m/s.
struct SteadyFlow {
    static constexpr Real top_speed = 1;  // m/s, of the fastest fluid that a blob meets
    FlowKind kind = FlowKind::rotation;
    Real direction = 0;  // of the translation, radians from the x axis

    bool periodic() const { return kind == FlowKind::translation; }
    Vec<2> velocity(const Vec<2>& x) const;
    // ψ with u = ∂ψ/∂y, v = −∂ψ/∂x, m²/s.
    Real stream_function(const Vec<2>& x) const;
    // Once around: a metre of translation, a whole rotation; for the vortex a metre at top speed. s
    Real turn() const;
    // Where the particle that is at x now was dt seconds ago (will be, when dt is negative), not yet moved into the box. Exact
    // for translation and rotation; in the vortex by Runge–Kutta steps of order 4 that are far finer than a step.
    Vec<2> before(const Vec<2>& x, Real dt) const;
};

// The velocity on the faces of a grid over the unit square: differences of ψ between the ends of each face, so that no cell has a
// divergence.
FaceField<2> face_velocity(const StaggeredGrid<2>& grid, const SteadyFlow& flow);

struct Blob {
    BlobKind kind = BlobKind::smooth;
    Vec<2> centre{0.5, 0.75};  // m, at the start
    Real radius = 0.15;        // m

    // The value at a place of the plane.
    Real value(const Vec<2>& x) const;
    Real distance(const Vec<2>& x) const { return (x - centre).norm(); }
};

// From `centre` to x, by the shortest way where the box is periodic.
Vec<2> shortest_way(const Vec<2>& x, const Vec<2>& centre, bool periodic);

}  // namespace pliant
