// The samples of a quantity on a lattice and what lies one step beyond its sides, each as a multiple of a sample plus a number.
#pragma once
#include <pliant/fluids/lattice.h>

namespace pliant {

// factor × (the sample `index`) + offset
struct SampleBeyond {
    Index index = 0;
    Real factor = 1, offset = 0;
};

// at: coordinates of the sample; up to two steps beyond either end, or three beyond the last, as interpolation takes them.
SampleBeyond sample_beyond(const Lattice<2>& lattice, Counts<2> at);

}  // namespace pliant
