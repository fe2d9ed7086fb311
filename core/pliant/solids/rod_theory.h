// A uniform elastic rod along a line, in closed form: hanging by its own weight, its modes, and waves that run along it; and the
// same of a chain of equal springs and masses. u: displacement along the rod, m, of the point that lies s from its held end at
// rest. Both are held at s = 0.
#pragma once
#include <pliant/math/types.h>

namespace pliant {

enum class RodEnd { free, fixed };  // at s = L

struct UniformRod {
    Real length = 1;           // L, m
    Real axial_stiffness = 1;  // EA, N
    Real mass = 1;             // M, kg

    Real wave_speed() const;  // c = √(EA L/M), m/s

    // Hanging at rest with its free end down: u = (M g/EA)(s − s²/(2L)), ε = (M g/EA)(1 − s/L). gravity: m/s².
    Real hanging_displacement(Real s, Real gravity) const;
    Real hanging_strain(Real s, Real gravity) const;
    Real hanging_tip(Real gravity) const { return hanging_displacement(length, gravity); }  // M g L/(2EA)
    Real hanging_energy(Real gravity) const;                                                // elastic, J: M² g² L/(6EA)

    // Let go unstretched at t = 0, without damping: d'Alembert's solution, of period 4L/c.
    Real released_displacement(Real s, Real t, Real gravity) const;

    // Mode j = 1, 2, ...: sin κ_j s, with κ_j = (2j − 1)π/(2L) at a free end, jπ/L at a fixed one; ω = c κ.
    Real wave_number(Index j, RodEnd end) const;                                              // 1/m
    Real frequency(Index j, RodEnd end) const { return wave_speed() * wave_number(j, end); }  // rad/s
};

// u = A exp(−((s − s₀)/w)²) at t = 0, running towards larger s with speed c, and what the ends make of it: a free end reflects it
// as it is, a fixed one with its sign turned. Its width is at most a few lengths: of a wider one the ends leave nothing.
struct RunningPulse {
    Real amplitude = 0, width = 1, start = 0;  // A, w, s₀, m
    Real length = 1, speed = 1;                // m, m/s
    RodEnd end = RodEnd::free;

    Real displacement(Real s, Real t) const;  // m
    Real velocity(Real s, Real t) const;      // m/s
    Real strain(Real s, Real t) const;

private:
    Real image(Real xi, bool slope) const;
};

// N springs of stiffness k, N/m, between N masses m, kg, and a support.
struct MassChain {
    Index springs = 1;
    Real stiffness = 1, mass = 1;

    Real hanging_tip(Real gravity) const;  // m g N(N + 1)/(2k), m
    Index modes(RodEnd end) const { return end == RodEnd::free ? springs : springs - 1; }
    // ω_j = 2√(k/m) sin(θ_j/2), with θ_j = (2j − 1)π/(2N + 1) at a free end and jπ/N at a fixed one; mode j: sin i θ_j.
    Real phase(Index j, RodEnd end) const;
    Real frequency(Index j, RodEnd end) const;  // rad/s
};

}  // namespace pliant
