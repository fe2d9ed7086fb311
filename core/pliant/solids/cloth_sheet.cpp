#include <pliant/solids/cloth_sheet.h>

#include <cmath>

namespace pliant {
namespace {

NodeLattice<3> lattice_of(Index nodes, Real side) {
    const Real cell = side / Real(nodes - 1);
    return {{nodes - 1, nodes - 1, 0}, Vec<3>::Constant(cell), Vec<3>(-side / 2, -side / 2, 0)};
}

}  // namespace

ClothSheet::ClothSheet(Index nodes, Real side) : nodes_(nodes), side_(side) {
    const NodeLattice<3> lattice = lattice_of(nodes, side);
    rest_ = lattice.points();
    for (Index j = 0; j + 1 < nodes; ++j)
        for (Index i = 0; i + 1 < nodes; ++i) {
            const Index a = node(i, j), b = node(i + 1, j), c = node(i, j + 1), d = node(i + 1, j + 1);
            if ((i + j) % 2)
                triangles_.insert(triangles_.end(), {{a, b, c}, {b, d, c}});
            else
                triangles_.insert(triangles_.end(), {{a, b, d}, {a, d, c}});
        }
    std::vector<Spring> list;
    for (const SpringFamily family : {structural, shear, bending}) {
        first_[family] = static_cast<Index>(list.size());
        append_springs<3>(rest_,
                          family == structural ? lattice.structural()
                          : family == shear    ? lattice.face_diagonals()
                                               : lattice.bending(),
                          0, 0, list);
    }
    first_[spring_families] = static_cast<Index>(list.size());
    springs_ = Springs(rest_.cols(), list);
    of_node_.resize(static_cast<std::size_t>(rest_.cols()));
    for (Index s = 0; s < springs_.size(); ++s)
        for (const Index n : {springs_.i(s), springs_.j(s)}) of_node_[static_cast<std::size_t>(n)].push_back(s);
}

void ClothSheet::set_springs(const Stiffnesses& stiffness, Real damping) {
    for (const SpringFamily family : {structural, shear, bending}) {
        const Index count = last(family) - first(family);
        springs_.set_stiffness(first(family), count, stiffness[family]);
        springs_.set_damping(first(family), count, stiffness[family] > 0 ? damping : 0);
    }
}

void ClothSheet::set_mass(Real total, const std::vector<Index>& fixed) {
    mass_ = VecX::Constant(rest_.cols(), total / Real(rest_.cols()));
    inertia_ = DiagonalMass(mass_, 3, fixed);
}

Real ClothSheet::energy(SpringFamily family, PointsIn<3> x) const {
    Real energy = 0;
    for (Index s = first(family); s < last(family); ++s) {
        const Real elongation = (x.col(springs_.j(s)) - x.col(springs_.i(s))).norm() - springs_.rest_length()[s];
        energy += 0.5 * springs_.stiffness()[s] * elongation * elongation;
    }
    return energy;
}

Real ClothSheet::shadow(PointsIn<3> x) const {
    Real twice = 0;
    for (const auto& [a, b, c] : triangles_) {
        const Vec<3> p = x.col(b) - x.col(a), q = x.col(c) - x.col(a);
        twice += p[0] * q[2] - p[2] * q[0];
    }
    return std::abs(twice) / 2;
}

}  // namespace pliant
