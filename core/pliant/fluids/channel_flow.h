// Flows between two parallel plates that have a closed form. y runs from the lower plate (0) to the upper one (height).
#pragma once
#include <pliant/math/types.h>

namespace pliant {

// Poiseuille: both plates at rest, an acceleration along them. The steady speed is G y (H − y)/(2ν) [Batchelor1967 §4.2].
// y and height in m, acceleration in m/s², viscosity > 0 in m²/s. Result in m/s.
Real poiseuille_speed(Real y, Real height, Real acceleration, Real viscosity);

// The same from rest, `time` seconds after the acceleration sets in; viscosity ≥ 0.
Real poiseuille_start_up(Real y, Real height, Real acceleration, Real viscosity, Real time);

// Couette: the upper plate moves at `speed` from time 0 on, the fluid was at rest. Tends to speed y/H [Batchelor1967 §4.3].
// viscous_time: ∫ν dt in m², at least 0. Result in the unit of speed.
Real couette_start_up(Real y, Real height, Real speed, Real viscous_time);

}  // namespace pliant
