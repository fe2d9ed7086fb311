// Exact flows and modes that lessons compare with, and the histories of the pressure solvers.
#include <pliant/fluids/carried_blob.h>
#include <pliant/fluids/diagnostics.h>
#include <pliant/fluids/diffusion.h>
#include <pliant/fluids/flow_fields.h>
#include <pliant/fluids/padded_field.h>
#include <pliant/fluids/samples_beyond.h>
#include <pliant/fluids/solver_histories.h>
#include <pliant/fluids/wave_modes.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>

using namespace pliant;
using Catch::Matchers::WithinAbs;

TEST_CASE("the stencil multiplies each of its modes by −Λ and mixes none", "[diffusion]") {
    using Boundary = WaveModes::Boundary;
    const auto [boundary, beyond] = GENERATE(table<Boundary, Beyond>({{Boundary::periodic, Beyond::periodic},
                                                                      {Boundary::fixed, Beyond::wall_value},
                                                                      {Boundary::insulated, Beyond::zero_gradient}}));
    const int dims = GENERATE(1, 2);
    constexpr Index n = 12;
    Lattice<2> lattice;
    lattice.count = {n, dims == 2 ? n : 1};
    lattice.offset = {0.5, 0.5};
    for (int axis = 0; axis < dims; ++axis) lattice.sides[axis] = {LatticeSide{beyond, 0}, LatticeSide{beyond, 0}};
    const WaveModes modes(boundary, n, dims);
    Diffusion<2> diffusion(lattice);
    for (Index m = modes.least(); m <= modes.greatest(); ++m) {
        const VecX wave = modes.on_cells(m);
        VecX sums;
        diffusion.stencil(wave, sums);
        CHECK((sums + modes.stencil_factor(m) * wave).lpNorm<Eigen::Infinity>() < 1e-12);
        if (!modes.vanishes(m)) CHECK_THAT(modes.amplitude(3 * wave, m), WithinAbs(3, 1e-12));
    }
}

TEST_CASE("a steady flow goes there and back, and has no divergence on a grid", "[advection]") {
    const FlowKind kind = GENERATE(FlowKind::translation, FlowKind::rotation, FlowKind::vortex);
    const SteadyFlow flow{kind, 0.4};
    const Vec<2> x(0.6, 0.7);
    // The vortex is followed in Runge–Kutta steps of 0.05 m at most.
    CHECK((flow.before(flow.before(x, 0.3), -0.3) - x).norm() < 1e-5);
    const Real h = 1e-5;
    CHECK(((x - flow.before(x, h)) / h - flow.velocity(x)).norm() < 1e-3);
    StaggeredGridInfo<2> info;
    info.cells = {16, 16};
    info.dx = Real(1) / 16;
    info.periodic.fill(flow.periodic());
    const StaggeredGrid<2> grid(info);
    CHECK(max_divergence(grid, face_velocity(grid, flow)) < 1e-12);
}

TEST_CASE("a blob is 1 in its middle and 0 far away", "[advection]") {
    const BlobKind kind = GENERATE(BlobKind::hill, BlobKind::slotted_disc, BlobKind::smooth);
    const Blob blob{.kind = kind};
    // The slot of the disc reaches up to its middle and beyond.
    CHECK(blob.value(blob.centre + Vec<2>(0, 0.9 * blob.radius)) > (kind == BlobKind::slotted_disc ? 0.99 : 0));
    if (kind != BlobKind::slotted_disc) CHECK(blob.value(blob.centre) == 1);
    if (kind == BlobKind::slotted_disc) CHECK(blob.value(blob.centre) == 0);
    CHECK(blob.value(blob.centre + Vec<2>(0.9, 0)) < 1e-6);
    CHECK((shortest_way({0.9, 0.5}, {0.1, 0.5}, true) - Vec<2>(-0.2, 0)).norm() < 1e-12);
}

TEST_CASE("samples beyond the sides are those that the padded field holds", "[grid]") {
    StaggeredGridInfo<2> info;
    info.cells = {6, 5};
    info.walls[1][1].velocity = {2, 0};
    for (auto& axis : info.walls)
        for (Wall<2>& wall : axis) wall.slip = Slip::none;
    const StaggeredGrid<2> grid(info);
    for (int axis = 0; axis < 2; ++axis) {
        const Lattice<2>& faces = grid.faces(axis);
        const VecX values = VecX::LinSpaced(faces.size(), 1, 4).array().square();
        PaddedField<2> padded(faces);
        padded.fill(values);
        for (Index j = -1; j <= faces.count[1]; ++j)
            for (Index i = -1; i <= faces.count[0]; ++i) {
                const SampleBeyond s = sample_beyond(faces, {i, j});
                CHECK_THAT(s.factor * values[s.index] + s.offset, WithinAbs(padded.sample({i, j}), 1e-12));
            }
    }
}

TEST_CASE("what a pressure solver leaves falls to its tolerance; a flow that does not balance has no history", "[projection]") {
    StaggeredGridInfo<2> info;
    info.cells = {12, 12};
    info.dx = Real(1) / 12;
    const StaggeredGrid<2> grid(info);
    FaceField<2> u = grid.zero_velocity();
    u[0][40] = 1;
    const ProjectionSettings settings{.tolerance = 1e-6, .max_iterations = 500};
    SolverHistories histories;
    histories.reset(grid, u, 0.1, settings);
    const auto& plain = histories.of(PressurePreconditioner::none);
    const auto& multigrid = histories.of(PressurePreconditioner::multigrid);
    CHECK(plain.back() <= 1e-6);
    CHECK(multigrid.back() <= 1e-6);
    CHECK(multigrid.size() < plain.size());
    histories.reset(grid, grid.zero_velocity(), 0.1, settings);
    CHECK(histories.of(PressurePreconditioner::multigrid).empty());
}

TEST_CASE("what is looked at in a flow is made anew when the velocity has changed", "[grid]") {
    StaggeredGridInfo<2> info;
    info.cells = {4, 4};
    const StaggeredGrid<2> grid(info);
    FaceField<2> u = grid.zero_velocity();
    FlowFields fields;
    fields.reset(grid, u);
    CHECK(fields.speed().maxCoeff() == 0);
    u[0].setConstant(2);
    CHECK(fields.speed().maxCoeff() == 0);
    fields.renew();
    CHECK(fields.speed().maxCoeff() == 2);
    CHECK(as_span(fields.speed()).size() == 16);
}
