// The velocities that the lesson can be given: sums of smooth pushes, waves, noise and a checkerboard.
#pragma once
#include <pliant/fluids/lattice.h>
#include <pliant/lesson/explanation.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pliant::projection {

enum class Given { swirl, source_sink, jet, random, checkerboard, gradient, drawn, through_flow };

// A push about a place, at a distance r = |d| from it. With speed s:
//   away    s (d/ρ) exp(½ − ½ (r/ρ)²), away from the middle, largest at r = ρ
//   toward  the same, toward the middle
//   around  the same, turned to the left by 90°
//   along   s exp(−½ (r/ρ)²) in both components, each with an s of its own
struct Push {
    enum class Shape { away, toward, around, along };
    Shape shape = Shape::along;
    Vec<2> middle = Vec<2>::Zero();  // m
    Real radius = 0.1;               // ρ, m
    std::array<Input, 2> speed;      // m/s, of each component, as it stands in formulas
    Vec<2> value = Vec<2>::Zero();   // of these inputs
};

class GivenField {
public:
    GivenField() = default;
    // Over the unit square; with `periodic` the nearest image of a push counts.
    GivenField(Given kind, Real speed, Input speed_input, bool periodic, std::vector<Push> pushes);

    // Component `axis` at the samples of a lattice with cells of the edge dx, m/s. Noise takes its numbers from the seed and
    // the axis.
    void fill(int axis, const Lattice<2>& lattice, Real dx, std::uint64_t seed, VecX& out) const;

    // Why sample `index` is `value`. left: the symbol of the number, "ũ".
    Explanation why(const std::string& left, int axis, const Lattice<2>& lattice, Real dx, Index index, Real value) const;

private:
    Vec<2> way_from(const Push& push, const Vec<2>& x) const;
    Vec<2> heading(const Push& push, const Vec<2>& x) const;  // m, of the length r
    Real pushed(const Push& push, int axis, const Vec<2>& x) const;
    Explanation why_pushed(const std::string& left, const Push& push, int axis, const Vec<2>& x) const;

    Given kind_ = Given::swirl;
    Real speed_ = 1;
    Input speed_input_;
    bool periodic_ = false;
    std::vector<Push> pushes_;
};

}  // namespace pliant::projection
