#include <pliant/math/constrained_system.h>
#include <pliant/math/error.h>
#include <pliant/math/null_dimension.h>
#include <pliant/math/sparse_cholesky.h>
#include <pliant/solids/lattice_elasticity.h>
#include <pliant/solids/springs_matrix.h>
#include <pliant/time/mass.h>

#include <fmt/format.h>

#include <cmath>

namespace pliant {
namespace {

// Beyond this many unknowns mechanisms are reported, but not counted.
constexpr Index most_counted = 600;

constexpr int axis_across = 0, axis_along = 1, axis_deep = 2;

// Prescribed displacements of a test, and which unknowns they belong to.
struct Plates {
    Points<3> value;
    std::vector<char> flags;
    void set(Index node, int component, Real u) {
        value(component, node) = u;
        flags[static_cast<std::size_t>(3 * node + component)] = 1;
    }
};

// The middle of the smallest and one corner of the lowest layer are kept from drifting and turning where a test leaves them free.
void hold_rigid_motions(const SpringLattice& lattice, Plates& plates) {
    const auto& cells = lattice.nodes().cells();
    const Index middle = lattice.nodes().node({cells[0] / 2, 0, cells[2] / 2}),
                corner = lattice.nodes().node({cells[0], 0, cells[2] / 2});
    for (const int component : {axis_across, axis_deep}) plates.set(middle, component, 0);
    plates.set(corner, axis_deep, 0);
    if (lattice.kind() != LatticeKind::cubic_body) return;
    // Edges and body diagonals let columns slide in turns, u_x = (-1)^(y + z) and u_z = (-1)^(x + y). No load drives these
    // motions; each is held at one more node.
    plates.set(lattice.nodes().node({cells[0] / 2, 0, cells[2] / 2 + 1}), axis_across, 0);
    plates.set(lattice.nodes().node({cells[0] / 2, 1, cells[2] / 2}), axis_deep, 0);
}

Plates plates_of(const SpringLattice& lattice, const Points<3>& rest, BlockTest test) {
    Plates plates{Points<3>::Zero(3, rest.cols()), std::vector<char>(static_cast<std::size_t>(3 * rest.cols()))};
    for (const bool last : {false, true})
        for (const Index n : lattice.layer(axis_along, last)) {
            const Real side = last ? 0.5 : -0.5;
            plates.set(n, axis_along,
                       test == BlockTest::stretch ? side
                       : test == BlockTest::bend  ? side * rest(axis_across, n)
                                                  : 0);
            if (test != BlockTest::shear) continue;
            plates.set(n, axis_across, side);
            plates.set(n, axis_deep, 0);
        }
    if (test != BlockTest::shear) hold_rigid_motions(lattice, plates);
    // Out of its line or plane nothing resists, and nothing is asked.
    const int dimension = dimension_of(lattice.kind());
    for (Index n = 0; n < rest.cols(); ++n) {
        if (dimension < 3) plates.set(n, axis_deep, 0);
        if (dimension < 2) plates.set(n, axis_across, 0);
    }
    return plates;
}

std::string against_mechanisms(const FamilyStiffness& stiffness) {
    if (stiffness[shear] == 0) return "Give shear springs a stiffness: edges alone fold";
    if (stiffness[structural] == 0) return "Give structural springs a stiffness: diagonals alone leave their nodes loose";
    return "Bring the stiffnesses of the springs nearer to each other: next to the stiffest the others are lost in rounding";
}

[[noreturn]] void report_mechanisms(const SparseMatrix& matrix, const FamilyStiffness& stiffness, const Diverged& cause) {
    std::string mechanisms = "mechanisms";
    if (matrix.cols() <= most_counted) {
        const Index count = null_dimension(matrix.cols(), [&](const VecX& x, VecX& y) { y = matrix * x; });
        mechanisms = fmt::format("{} mechanism{}", count, count == 1 ? "" : "s");
    }
    Failure failure = cause.failure;
    failure.index = -1;
    failure.what = fmt::format("singular: {} unconstrained, motions that no spring resists", mechanisms);
    failure.limit = against_mechanisms(stiffness);
    throw Diverged(failure);
}

// Displacements in balance, with the plates where they shall be.
Points<3> solve(const SparseMatrix& K, const Plates& plates, const FamilyStiffness& stiffness) {
    ConstrainedSystem system(K, plates.flags);
    VecX u = flat(plates.value), right_side, free;
    system.reduce(VecX(-(K * u)), right_side);
    SparseCholesky cholesky;
    try {
        cholesky.factorize(system.matrix());
    } catch (const Diverged& cause) {
        report_mechanisms(system.matrix(), stiffness, cause);
    }
    cholesky.solve(right_side, free);
    system.expand(free, u);
    return Eigen::Map<const Points<3>>(u.data(), 3, plates.value.cols());
}

// Mean of du_x/dx: the slope of the plane that fits u_x best.
Real mean_strain_across(const Points<3>& rest, const Points<3>& u) {
    const Points<3> x = rest.colwise() - Vec<3>(rest.rowwise().mean());
    const VecX from_mean = u.row(axis_across).array() - u.row(axis_across).mean();
    return least_squares(x.transpose(), from_mean, 1e-10)[axis_across];
}

}  // namespace

Real LatticeConstants::youngs_modulus() const {
    if (dimension == 1 || c11 == 0) return c11;
    if (dimension == 2) return (c11 * c11 - c12 * c12) / c11;
    return (c11 - c12) * (c11 + 2 * c12) / (c11 + c12);
}

Real LatticeConstants::poisson_ratio() const {
    if (dimension == 1 || c11 == 0) return 0;
    return dimension == 2 ? c12 / c11 : c12 / (c11 + c12);
}

LatticeConstants lattice_constants(LatticeKind kind, const FamilyStiffness& stiffness, Real edge) {
    LatticeConstants constants{.dimension = dimension_of(kind)};
    const Real measure = cell_measure(kind) * std::pow(edge, constants.dimension - 2);
    for (const LatticeBond& bond : lattice_bonds(kind)) {
        const Real k = stiffness[bond.family] / measure, length = bond.offset.norm();
        const Vec<3> n = bond.offset / length;
        // Energy 1/2 k (n . strain n)^2 length^2 of one spring per cell.
        const Real x = n[0] * n[0], y = n[1] * n[1], weight = k * length * length;
        constants.c11 += weight * y * y;
        constants.c12 += weight * x * y;
        constants.c44 += weight * x * y;
    }
    return constants;
}

std::vector<Spring> lattice_springs(const SpringLattice& lattice, const FamilyStiffness& stiffness, bool shared) {
    std::vector<Spring> springs;
    const Points<3> rest = lattice.points();
    for (const SpringFamily family : {structural, shear, bending}) {
        if (stiffness[family] == 0) continue;
        const std::vector<NodePair> pairs = lattice.pairs(family);
        append_springs<3>(rest, pairs, stiffness[family], 0, springs);
        if (!shared) continue;
        for (std::size_t p = 0; p < pairs.size(); ++p)
            springs[springs.size() - pairs.size() + p].stiffness *= lattice.share(pairs[p], family);
    }
    return springs;
}

BlockResponse test_block(const SpringLattice& lattice, const FamilyStiffness& stiffness, BlockTest test, bool shared) {
    const int dimension = dimension_of(lattice.kind());
    if (dimension == 1 && test != BlockTest::stretch)
        throw Refused("a chain can be stretched, but neither sheared nor bent: test = stretch");
    const auto& cells = lattice.nodes().cells();
    for (const int axis : {axis_along, axis_across, axis_deep})
        if (cells[axis] < 1 && (axis == axis_along || dimension > (axis == axis_across ? 1 : 2)))
            throw Refused(fmt::format("cells[{}]", axis), Real(cells[axis]), "", "at least 1 cell, to have two faces");

    const Points<3> rest = lattice.points();
    const Springs springs(rest.cols(), lattice_springs(lattice, stiffness, shared));
    SpringMatrix<3> matrix(springs);
    matrix.add_stiffness(springs, rest, SpringCurvature::exact);
    BlockResponse response;
    response.displacement = solve(matrix.matrix(), plates_of(lattice, rest, test), stiffness);

    // Energy of each spring, family by family, in the order in which lattice_springs appends them.
    const Points<3>& u = response.displacement;
    Index s = 0;
    for (const SpringFamily family : {structural, shear, bending}) {
        if (stiffness[family] == 0) continue;
        for (const Index end = s + static_cast<Index>(lattice.pairs(family).size()); s < end; ++s) {
            const Vec<3> n = (rest.col(springs.j(s)) - rest.col(springs.i(s))).normalized();
            const Real elongation = n.dot(u.col(springs.j(s)) - u.col(springs.i(s)));
            response.coupling[family] += springs.stiffness()[s] * elongation * elongation;
        }
    }
    for (const Real twice_energy : response.coupling) response.stiffness += twice_energy;
    for (Real& part : response.coupling) part = response.stiffness > 0 ? part / response.stiffness : 0;
    if (test == BlockTest::stretch) {
        const Vec<3> length = lattice.lengths();
        const Real section = (dimension > 1 ? length[axis_across] : 1) * (dimension > 2 ? length[axis_deep] : 1);
        response.youngs_modulus = response.stiffness * length[axis_along] / section;
        if (dimension > 1) response.poisson_ratio = -mean_strain_across(rest, u) * length[axis_along];
    }
    return response;
}

}  // namespace pliant
