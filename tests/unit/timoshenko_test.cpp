// Timoshenko's cantilever: a beam of the plane under a parabolic shear at its end, with its exact displacement at the support
// [Augarde2008].
#include <pliant/continuum/moduli.h>
#include <pliant/mesh/block_mesh.h>
#include <pliant/solids/fem_loads.h>
#include <pliant/solids/hyperelastic_fem.h>
#include <pliant/solids/newton_equilibrium.h>

#include <catch2/catch_test_macros.hpp>

#include <cmath>

using namespace pliant;

namespace {

constexpr Real beam_length = 48, beam_depth = 12, beam_modulus = 3e7, beam_ratio = 0.3, beam_load = 1000;
constexpr Real beam_inertia = beam_depth * beam_depth * beam_depth / 12;

Vec<2> timoshenko_displacement(const Vec<2>& X) {
    const Real x = X.x(), y = X.y(), D2 = beam_depth * beam_depth, scale = beam_load / (6 * beam_modulus * beam_inertia);
    return {scale * y * ((6 * beam_length - 3 * x) * x + (2 + beam_ratio) * (y * y - D2 / 4)),
            -scale *
                (3 * beam_ratio * y * y * (beam_length - x) + (4 + 5 * beam_ratio) * D2 * x / 4 + (3 * beam_length - x) * x * x)};
}

// Of the middle of the end, over the exact 0.0089.
template <int Order>
Real timoshenko_tip_error(int cells) {
    const SimplexMesh<2> mesh = block_mesh<2>({.size = {beam_length, beam_depth},
                                               .cells = {4 * cells, cells},
                                               .origin = {0, -beam_depth / 2},
                                               .split = CellSplit::diagonal});
    const IsotropicModuli moduli = IsotropicModuli::from_young_poisson(beam_modulus, beam_ratio);
    const HyperelasticFem<2, Order> body(mesh, Energy::linear, moduli.plane_stress_lame());
    const Points<2>& X = body.elements().positions();
    DisplacementConstraints<2> held(body.node_count());
    Index tip = 0;
    for (Index n = 0; n < body.node_count(); ++n) {
        if (X(0, n) == 0)
            for (int c = 0; c < 2; ++c) held.prescribe(n, c, timoshenko_displacement(X.col(n))[c]);
        if ((X.col(n) - Vec<2>(beam_length, 0)).norm() < (X.col(tip) - Vec<2>(beam_length, 0)).norm()) tip = n;
    }
    Points<2> force = Points<2>::Zero(2, body.node_count());
    const LoadFunction<2> shear = [](const Vec<2>& at) {
        return Vec<2>(0, -beam_load / (2 * beam_inertia) * (beam_depth * beam_depth / 4 - at.y() * at.y()));
    };
    add_traction<2, Order>(body.elements(), mesh.facets("x_max"), shear, 2, force);
    CHECK(std::abs(force.row(1).sum() + beam_load) < 1e-9 * beam_load);

    NewtonEquilibrium<2> newton(body, held, {});
    newton.begin(Points<2>::Zero(2, body.node_count()), force, held);
    newton.solve();
    newton.require_convergence();
    const Real exact = -0.0089;
    CHECK(std::abs(timoshenko_displacement({beam_length, 0}).y() - exact) < 1e-12);
    return newton.displacement()(1, tip) / exact - 1;
}

}  // namespace

TEST_CASE("Timoshenko's cantilever sinks by 0.0089: linear triangles come to it by the square, quadratic ones at once", "[fem]") {
    const Real coarse = timoshenko_tip_error<1>(8), fine = timoshenko_tip_error<1>(16);
    CHECK(coarse < 0);  // too stiff
    CHECK(std::abs(fine) < 0.02);
    CHECK(std::abs(std::log2(coarse / fine) - 2) < 0.15);
    CHECK(std::abs(timoshenko_tip_error<2>(4)) < 1e-3);
}
