// The fastest vibration of a system, which limits the time step of explicit schemes: K v = omega^2 M v.
#pragma once
#include <pliant/time/mass.h>

namespace pliant {

struct VibrationMode {
    Real omega = 0;      // rad/s; 0 where nothing can vibrate
    VecX shape{};        // of v . M v = 1; 0 where fixed
    Index products = 0;  // with K, which it took
};

// By Lanczos' method with all vectors kept orthogonal [Golub2013 §10.1], from the same start each time. stiffness: symmetric,
// N/m, both triangles stored. omega is approached from below, until the residual of the mode says that it is right to about the
// square of `tolerance`, relative.
VibrationMode fastest_mode(const SparseMatrix& stiffness, const Mass& mass, Real tolerance = 1e-5);

// Damping ratio of a mode under Rayleigh's damping alpha M + beta K [1/s, s]; 0 for omega = 0. stability_limit() takes both.
inline Real rayleigh_damping_ratio(Real omega, Real alpha, Real beta) {
    return omega > 0 ? (alpha / omega + beta * omega) / 2 : 0;
}

}  // namespace pliant
