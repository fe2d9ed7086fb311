// A slender cantilever that bends as far as it likes, in closed form [Bisshopp1945]: its length stays, its curvature is moment
// over E I, and the force on its tip keeps its direction across the beam at rest.
#pragma once
#include <pliant/math/types.h>

namespace pliant {

struct Elastica {
    Real deflection = 0;  // of the tip over the length, along the force
    Real reach = 1;       // of the tip along the beam at rest, over the length
    Real angle = 0;       // rad, of the tip
};

// a = P L² / (E I) >= 0. Throws Refused for another a, or one above 100, where the beam is all but parallel to the force.
Elastica elastica(Real a);

}  // namespace pliant
