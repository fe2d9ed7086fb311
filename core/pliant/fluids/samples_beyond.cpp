#include <pliant/fluids/samples_beyond.h>

#include <algorithm>

namespace pliant {

SampleBeyond sample_beyond(const Lattice<2>& lattice, Counts<2> at) {
    SampleBeyond s;
    // The layer beyond the last axis is made from the layers beyond the first, so that is undone first.
    for (int axis = 1; axis >= 0; --axis) {
        const Index n = lattice.count[axis];
        if (at[axis] >= 0 && at[axis] < n) continue;
        const LatticeSide& side = lattice.sides[axis][at[axis] < 0 ? 0 : 1];
        if (side.beyond == Beyond::periodic) {
            at[axis] = (at[axis] % n + n) % n;
            continue;
        }
        if (side.beyond == Beyond::wall_value) {
            s.offset += s.factor * 2 * side.value;
            s.factor = -s.factor;
        }
        // What lies beyond mirrors what lies within; a sample on the wall itself is repeated.
        if (side.beyond != Beyond::held) at[axis] = at[axis] < 0 ? -1 - at[axis] : 2 * n - 1 - at[axis];
        at[axis] = std::clamp<Index>(at[axis], 0, n - 1);
    }
    s.index = lattice.index(at);
    return s;
}

}  // namespace pliant
