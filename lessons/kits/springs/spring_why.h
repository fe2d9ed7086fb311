// What the explanations of spring nets share: springs and dampers of a node, loads, energies, from the fields "position" and
// "velocity" with so many components per node as the net has dimensions.
#pragma once
#include <pliant/lesson/explanation.h>
#include <pliant/solids/springs.h>
#include <pliant/solids/springs_system.h>

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pliant::springs {

using Reading = Input (*)(std::string symbol, std::string_view field, Index index, int component);  // Input::now, ...

// Strains below this are rounding.
inline constexpr Real strain_rounding = 1e-12;

// Appends the coordinates of two nodes in turns: x_j, x_i, y_j, y_i, ... with `before` before each letter.
void append_ends(std::vector<Input>& inputs, Reading at, std::string_view field, std::string_view before, Index j, Index i,
                 int dimension = 3);
// Every number of a nodal vector, node by node: x_0, y_0, z_0, x_1, ..., as families, x, y and z, or v_x, v_y and v_z.
void append_all(std::vector<Input>& inputs, std::string_view before, std::string_view field, Index nodes, int dimension = 3);
// The same as one family under this symbol; and the points that their values make.
void append_points(std::vector<Input>& inputs, const std::string& symbol, std::string_view before, std::string_view field,
                   Index nodes, int dimension = 3);
template <int Dim = 3>
Eigen::Map<const Points<Dim>> points(Values x) {
    return {x.data(), Dim, static_cast<Index>(x.size() / Dim)};
}

// |x_j − x_i|, from the positions.
Input length_between(Reading at, Index j, Index i, int dimension = 3);
Input rest_length(const Springs& springs, Index s);
// m = M / N
Input shared_mass(const Parameter& total, Index nodes);

// The sum over the springs of a node, in N, "f = Σ_j f_j, f_j = …": `term` explains what spring s adds, which is called "f_7"
// with node 7 at its far end; said: what all of them are.
Explanation sum_over_springs(const Springs& springs, Index node, std::string_view left, std::string_view said,
                             std::string_view symbol, const std::function<Explanation(Index s, Index other)>& term);
// k (|x_ij| − l) (x_j − x_i) / |x_ij|, 0 where both ends are at one place and not apart. k and l by their own symbols.
Explanation spring_on_node(Input stiffness, Input rest, bool apart, Index other, Index node, int component, int dimension = 3);
// kᵈ (v_j − v_i), or along the spring kᵈ w (x_j − x_i). damping: factors of kᵈ. direction_at: where directions are taken from.
Explanation damper_on_node(std::vector<Input> damping, bool projected, Index other, Index node, int component,
                           Reading direction_at, int dimension = 3);
// (|x_ij| − l) / l, and 0 where that is rounding. strain: as it is now.
Explanation strain_of(const Springs& springs, Index s, Real strain);

// Weight, where gravity is given, and the pull of a hand, on a node of mass m.
Explanation load_on_node(const ExternalLoad<3>& load, const Input& mass, const Parameter& gravity,
                         const Parameter& pull_stiffness, Index node, int component);

// E = K + U + V, and H of the spring of a hand that pulls.
Explanation energy_in_all(const ExternalLoad<3>& load, const Parameter& pull_stiffness);
// ½ m Σ v²
Explanation kinetic_energy_of(Input mass, Index nodes, int dimension = 3);
// m g Σ y
Explanation gravitational_energy_of(Input mass, const Parameter& gravity, Index nodes);
// Σ (|x_ij| − l)² of the springs from first to before last, m²
Real elongation_squares(const Springs& springs, Index first, Index last, PointsIn<3> x);

inline Index other_end(const Springs& springs, Index s, Index node) { return springs.i(s) == node ? springs.j(s) : springs.i(s); }

}  // namespace pliant::springs
