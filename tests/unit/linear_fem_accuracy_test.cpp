// Accuracy of linear triangles against closed forms and published values: orders of convergence, Cook's membrane, locking.
#include "fem_body.h"

#include <pliant/mesh/simplex_quadrature.h>
#include <pliant/solids/cooks_membrane.h>
#include <pliant/solids/fem_loads.h>
#include <pliant/solids/linear_fem_static.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <numbers>

using namespace pliant;
using namespace pliant::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using std::numbers::pi;

namespace {

// A displacement of the unit square that vanishes on its boundary, and what follows from it by differentiation.
struct SineField {
    Lame material = IsotropicModuli::from_young_poisson(1e4, 0.3).lame();

    static Vec<2> displacement(const Vec<2>& X) {
        return {0.1 * std::sin(pi * X[0]) * std::sin(pi * X[1]), 0.05 * std::sin(pi * X[0]) * std::sin(2 * pi * X[1])};
    }
    static Mat<2> gradient(const Vec<2>& X) {
        const Real sx = std::sin(pi * X[0]), cx = std::cos(pi * X[0]), sy = std::sin(pi * X[1]), cy = std::cos(pi * X[1]);
        const Real s2y = std::sin(2 * pi * X[1]), c2y = std::cos(2 * pi * X[1]);
        Mat<2> H;
        H << 0.1 * pi * cx * sy, 0.1 * pi * sx * cy, 0.05 * pi * cx * s2y, 0.1 * pi * sx * c2y;
        return H;
    }
    // -div stress = -(lambda + mu) grad div u - mu laplace u.
    Vec<2> force_density(const Vec<2>& X) const {
        const Real sx = std::sin(pi * X[0]), cx = std::cos(pi * X[0]), sy = std::sin(pi * X[1]), cy = std::cos(pi * X[1]);
        const Real s2y = std::sin(2 * pi * X[1]), c2y = std::cos(2 * pi * X[1]);
        const Vec<2> laplace(-0.2 * pi * pi * sx * sy, -0.25 * pi * pi * sx * s2y);
        const Vec<2> grad_div(-0.1 * pi * pi * sx * sy + 0.1 * pi * pi * cx * c2y,
                              0.1 * pi * pi * cx * cy - 0.2 * pi * pi * sx * s2y);
        return -(material.lambda + material.mu) * grad_div - material.mu * laplace;
    }
};

struct Errors {
    Real l2, h1;  // norm of the error, and of its gradient
};

Errors errors(const SimplexMesh<2>& mesh, const Points<2>& u) {
    const auto rule = simplex_rule<2>(8);
    Real l2 = 0, h1 = 0;
    for (Index e = 0; e < mesh.simplex_count(); ++e) {
        const Mat<2> H = mesh.field_gradient(e, u);
        for (Index q = 0; q < rule.weights.size(); ++q) {
            Vec<2> X = Vec<2>::Zero(), here = Vec<2>::Zero();
            for (int a = 0; a < 3; ++a) {
                X += rule.barycentric(a, q) * mesh.points().col(mesh.simplices()(a, e));
                here += rule.barycentric(a, q) * u.col(mesh.simplices()(a, e));
            }
            const Real weight = mesh.volumes()[e] * rule.weights[q];
            l2 += weight * (here - SineField::displacement(X)).squaredNorm();
            h1 += weight * (H - SineField::gradient(X)).squaredNorm();
        }
    }
    return {std::sqrt(l2), std::sqrt(h1)};
}

Errors sine_errors(int n, Real share) {
    const SineField field;
    const auto mesh = irregular_block<2>({Vec<2>::Ones(), {n, n}, Vec<2>::Zero(), CellSplit::diagonal}, share);
    const LinearFem<2> body(mesh, field.material);
    Points<2> force = Points<2>::Zero(2, mesh.node_count());
    add_body_force<2>(
        mesh, [&field](const Vec<2>& X) { return field.force_density(X); }, 6, force);
    const auto edge = affine_boundary<2>(mesh, Mat<2>::Zero(), Vec<2>::Zero());
    return errors(mesh, solve_static<2>(body, edge, force).displacement);
}

// Upward displacement of the middle of the loaded edge.
Real cook_membrane(int n, const Lame& material, Real force) {
    const CooksMembrane membrane(n);
    return membrane.displacement(material, force)(1, membrane.tip());
}

}  // namespace

TEST_CASE("Linear triangles converge with order 2 in displacement and order 1 in strain", "[fem]") {
    // Computed with an independent finite-element package.
    const Errors at8 = sine_errors(8, 0), at16 = sine_errors(16, 0), at32 = sine_errors(32, 0), at64 = sine_errors(64, 0);
    CHECK_THAT(at8.l2, WithinRel(3.4716e-3, 1e-3));
    CHECK_THAT(at8.h1, WithinRel(6.6812e-2, 1e-3));
    CHECK_THAT(at16.l2, WithinRel(9.3133e-4, 1e-3));
    CHECK_THAT(at16.h1, WithinRel(3.3588e-2, 1e-3));
    CHECK_THAT(at32.l2, WithinRel(2.3786e-4, 1e-3));
    CHECK_THAT(at32.h1, WithinRel(1.6804e-2, 1e-3));
    CHECK_THAT(at64.l2, WithinRel(5.9806e-5, 1e-3));
    CHECK_THAT(at64.h1, WithinRel(8.4023e-3, 1e-3));
    CHECK_THAT(std::log2(at32.l2 / at64.l2), WithinAbs(2, 0.05));
    CHECK_THAT(std::log2(at32.h1 / at64.h1), WithinAbs(1, 0.05));
}

TEST_CASE("The orders hold on irregular meshes", "[fem]") {
    const Errors coarse = sine_errors(16, 0.2), fine = sine_errors(64, 0.2);
    CHECK_THAT(0.5 * std::log2(coarse.l2 / fine.l2), WithinAbs(2, 0.2));
    CHECK_THAT(0.5 * std::log2(coarse.h1 / fine.h1), WithinAbs(1, 0.2));
}

TEST_CASE("Cook's membrane in plane stress", "[fem]") {
    // Values of linear triangles on the same meshes from an independent package; 23.96 in the limit [Cook1974].
    const Lame material = IsotropicModuli::from_young_poisson(1, 1.0 / 3).plane_stress_lame();
    const Real at8 = cook_membrane(8, material, 1), at16 = cook_membrane(16, material, 1), at32 = cook_membrane(32, material, 1),
               at64 = cook_membrane(64, material, 1);
    CHECK_THAT(at8, WithinRel(17.3312, 1e-4));
    CHECK_THAT(at16, WithinRel(21.5922, 1e-4));
    CHECK_THAT(at32, WithinRel(23.2751, 1e-4));
    CHECK_THAT(at64, WithinRel(23.7742, 1e-4));
    CHECK(at64 < 23.96);
    CHECK_THAT(at64, WithinRel(23.96, 0.01));
}

TEST_CASE("Linear triangles lock as Poisson's ratio nears one half", "[fem]") {
    // Converged values fall only from 21.94 to 18.46 between nu = 0.3 and 0.4999.
    struct Row {
        Real nu, at8, at16, at32;
    };
    const auto [nu, at8, at16, at32] =
        GENERATE(Row{0.3, 15.61, 19.60, 21.24}, Row{0.45, 11.10, 15.37, 18.05}, Row{0.49, 7.395, 10.49, 14.45},
                 Row{0.499, 5.549, 6.334, 8.289}, Row{0.4999, 5.247, 5.365, 5.743});
    const Lame material = IsotropicModuli::from_young_poisson(1, nu).lame();
    CHECK_THAT(cook_membrane(8, material, 1), WithinRel(at8, 1e-3));
    CHECK_THAT(cook_membrane(16, material, 1), WithinRel(at16, 1e-3));
    const Real fine = cook_membrane(32, material, 1);
    CHECK_THAT(fine, WithinRel(at32, 1e-3));
    if (nu == 0.4999) CHECK(18.46 / fine > 3.2);
}
