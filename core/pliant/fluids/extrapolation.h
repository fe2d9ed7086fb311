// Continuing values beyond where they are known.
#pragma once
#include <pliant/fluids/staggered_grid.h>

#include <cstdint>
#include <vector>

namespace pliant {

// What is known of a sample, before its neighbours are asked.
enum class Known : std::uint8_t {
    no,     // to be filled
    yes,    // fills its neighbours
    aside,  // keeps its value and fills no one
};

// Layer by layer, each sample to be filled takes the mean of its neighbours that are known [Bridson2007]. Samples that no
// layer reaches keep their values. known: one per sample; those that were filled are `yes` afterwards.
//
// layers(): of the latest fill, the layer in which each sample got its value: 0 where it was known, -1 where nothing was done.
template <int Dim>
class Extrapolation {
public:
    void fill(const Lattice<Dim>& lattice, std::vector<Known>& known, VecX& values);
    const std::vector<int>& layers() const { return layers_; }

private:
    std::vector<Index> layer_, next_;
    std::vector<Real> means_;
    std::vector<int> layers_;
};

// Continues the velocity of the fluid into the air, and into the solids that it slides along, so that what is carried from there
// finds the velocity of the nearest fluid. Faces of walls and solids keep theirs; where there is no fluid at all the velocity is
// 0.
template <int Dim>
class VelocityExtrapolation {
public:
    void extrapolate(const StaggeredGrid<Dim>& grid, FaceField<Dim>& velocity);
    const std::vector<int>& layers(int axis) const { return components_[axis].layers(); }

private:
    std::array<Extrapolation<Dim>, Dim> components_;
    std::vector<Known> known_;
};

extern template class Extrapolation<2>;
extern template class Extrapolation<3>;
extern template class VelocityExtrapolation<2>;
extern template class VelocityExtrapolation<3>;

}  // namespace pliant
