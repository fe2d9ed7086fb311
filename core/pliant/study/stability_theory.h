// A stability map beside theory: the line on which the time step equals its limit, and the cells that contradict it.
#pragma once
#include <pliant/study/stability_map.h>

#include <array>
#include <optional>
#include <vector>

namespace pliant {

// A place on a map, counted in cells: (0, 0) is the centre of the first one, and cells reach half a unit to each side.
struct MapPlace {
    Real across = 0, up = 0;
};

// The bound as separate segments: Δt over its limit is interpolated between the centres in its logarithm, in which a power law on
// log axes is straight, and carried on to the outer edges. Along a knob of named options nothing is interpolated. Empty without
// a theory, or where the bound does not cross the map.
std::vector<std::array<MapPlace, 2>> theory_bound(const StabilityMap& map);

// What became of the prediction in the cells that have one and that are stable, dissipative or diverged.
struct Agreement {
    Index compared = 0;
    Index at_bound = 0;     // contradict it, within one cell of the bound
    Index contradicts = 0;  // contradict it elsewhere
};
// Empty without a theory.
std::optional<Agreement> agreement(const StabilityMap& map);
// Is the cell among `contradicts`?
bool contradicts_theory(const StabilityMap& map, Index i, Index j);

// The centre of a cell or a place between, as a value of the knob.
Real knob_value(const Knob& knob, Real place);
// The place of a value among those of the knob; empty outside of the map. Lists know their own values alone.
std::optional<Real> knob_place(const Knob& knob, Real value);

}  // namespace pliant
