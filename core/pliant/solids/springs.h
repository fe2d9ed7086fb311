// Springs between point masses: forces, damping forces, energies.
//
// The vector from node i to node j is x_ij = x_j - x_i, and l is the rest length. A spring of current length 0 has no
// direction: it pulls with zero force and its projected damping is zero, until something else parts its nodes. A rest length
// of 0 is a spring that pulls its nodes together with f = k x_ij. Positions, velocities and forces have one column per node.
#pragma once
#include <pliant/math/types.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace pliant {

template <int Dim>
using PointsIn = const Eigen::Ref<const Points<Dim>>&;
template <int Dim>
using PointsOut = Eigen::Ref<Points<Dim>>;

struct Spring {
    Index i, j;        // nodes
    Real rest_length;  // m, >= 0
    Real stiffness;    // N/m, >= 0
    Real damping = 0;  // N s/m, >= 0
};

// Springs in contiguous arrays, in the order in which they were given; valid once made.
class Springs {
public:
    Springs() = default;
    // Throws Refused, naming the spring, when a node does not exist, a spring joins a node to itself or doubles another
    // spring, or a number is negative or not finite.
    Springs(Index node_count, const std::vector<Spring>& springs);

    Index size() const { return static_cast<Index>(nodes_.size()); }
    Index node_count() const { return node_count_; }
    Spring operator[](Index s) const { return {i(s), j(s), rest_length_[s], stiffness_[s], damping_[s]}; }

    Index i(Index s) const { return nodes_[static_cast<std::size_t>(s)][0]; }
    Index j(Index s) const { return nodes_[static_cast<std::size_t>(s)][1]; }
    const std::array<std::int32_t, 2>* nodes() const { return nodes_.data(); }
    const VecX& rest_length() const { return rest_length_; }  // m
    const VecX& stiffness() const { return stiffness_; }      // N/m
    const VecX& damping() const { return damping_; }          // N s/m

    // Change a run of springs, as a slider does. Throw Refused like the constructor.
    void set_stiffness(Index first, Index count, Real stiffness);
    void set_damping(Index first, Index count, Real damping);

private:
    Index node_count_ = 0;
    std::vector<std::array<std::int32_t, 2>> nodes_;
    VecX rest_length_, stiffness_, damping_;
};

// Springs between pairs of points, at rest where the points are. pairs: node pairs; points: m. Appends to `springs`.
template <int Dim>
void append_springs(PointsIn<Dim> points, const std::vector<std::array<Index, 2>>& pairs, Real stiffness, Real damping,
                    std::vector<Spring>& springs);

// Damping of the relative velocity v_ij = v_j - v_i of a spring's nodes.
enum class SpringDamping {
    none,
    naive,     // f_i = k_d v_ij: damps every relative motion, rigid rotation too
    projected  // f_i = k_d (v_ij . x_ij / x_ij . x_ij) x_ij: damps only the change of length
};
// In symbols; "" of none.
std::string_view formula_of(SpringDamping mode);

// f_i += k (|x_ij| - l) x_ij / |x_ij|, f_j -= the same, N [Nealen2006 §3].
template <int Dim>
void add_spring_forces(const Springs& springs, PointsIn<Dim> x, PointsOut<Dim> f);

// Energy sum 1/2 k (|x_ij| - l)^2, J, whose negative gradient add_spring_forces adds.
template <int Dim>
Real spring_energy(const Springs& springs, PointsIn<Dim> x);

// Of that energy, J, what may be rounding alone after many steps, of places that lie as far from the origin as x does and
// `extent` [m] more.
template <int Dim>
Real spring_energy_rounding(const Springs& springs, PointsIn<Dim> x, Real extent);

// Adds damping forces, N [Nealen2006 §3]. Each formula is -C v with a symmetric, positive semidefinite C that depends on the
// positions alone.
template <int Dim>
void add_damping_forces(const Springs& springs, SpringDamping mode, PointsIn<Dim> x, PointsIn<Dim> v, PointsOut<Dim> f);

// Power that the damping takes out of the motion, v . C v, W.
template <int Dim>
Real damping_power(const Springs& springs, SpringDamping mode, PointsIn<Dim> x, PointsIn<Dim> v);

// Tension k (|x_ij| - l) of each spring, N: positive when it pulls.
template <int Dim>
void spring_tension(const Springs& springs, PointsIn<Dim> x, Eigen::Ref<VecX> tension);

// Strain (|x_ij| - l) / l of each spring, dimensionless; 0 where l = 0, for which strain has no meaning.
template <int Dim>
void spring_strain(const Springs& springs, PointsIn<Dim> x, Eigen::Ref<VecX> strain);

}  // namespace pliant
