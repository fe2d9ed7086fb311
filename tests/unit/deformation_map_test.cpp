// Maps of a body: their gradients against central differences, their closed forms against what F says.
#include <pliant/continuum/deformation.h>
#include <pliant/continuum/deformation_map.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>
#include <random>
#include <vector>

using namespace pliant;
using Catch::Matchers::WithinAbs;

namespace {

std::vector<DeformationMap> some_maps() {
    std::vector<DeformationMap> maps;
    const Vec<3> t(0.3, -1.2, 2);
    const auto add = [&](DeformationMap map) {
        map.translation = t;
        maps.push_back(map);
    };
    add({});
    for (int axis = 0; axis < 3; ++axis)
        for (const Real angle : {0.0, 1e-9, 0.7, -2.0, 3.1}) add({.kind = MapKind::rotation, .angle = angle, .axis = axis});
    for (const Vec<3>& s : std::vector<Vec<3>>{{1, 1, 1}, {1.5, 0.8, 1.1}, {-1.2, -0.5, 2}, {-0.3, 2, 1}, {0, 1, 2}})
        add({.kind = MapKind::stretch, .stretches = s});
    for (const Real gamma : {0.0, 0.4, -1.7}) add({.kind = MapKind::shear, .shear = gamma});
    for (const Real curvature : {0.0, 1e-9, 1.5, -2.5, 6.0}) add({.kind = MapKind::bend, .curvature = curvature});
    for (const Real twist : {0.0, 1e-9, 2.0, -5.0}) add({.kind = MapKind::twist, .twist = twist});
    Mat<3> F;
    F << 1.2, 0.3, 0, 0, 0.9, 0.1, 0.05, 0, 1.1;
    add({.kind = MapKind::free, .gradient = F});
    return maps;
}

std::vector<Vec<3>> some_points() {
    std::mt19937_64 engine(3);
    std::uniform_real_distribution<Real> spread(-0.5, 0.5);
    std::vector<Vec<3>> points{Vec<3>::Zero()};
    for (int k = 0; k < 20; ++k) points.emplace_back(Vec<3>::NullaryExpr([&] { return spread(engine); }));
    return points;
}

}  // namespace

TEST_CASE("deformation maps: the gradient is that of central differences", "[deformation]") {
    const Real h = 1e-5;
    for (const DeformationMap& map : some_maps())
        for (const Vec<3>& X : some_points()) {
            INFO("map " << static_cast<int>(map.kind) << " at " << X.transpose());
            const Mat<3> F = map.deformation_gradient(X);
            for (int j = 0; j < 3; ++j) {
                const Vec<3> step = h * Vec<3>::Unit(j);
                const Vec<3> slope = (map.position(X + step) - map.position(X - step)) / (2 * h);
                CHECK((slope - F.col(j)).norm() < 3e-9);
            }
            CHECK((F - Mat<3>::Identity() - map.displacement_gradient(X)).norm() < 1e-14);
        }
}

TEST_CASE("deformation maps: closed forms agree with F", "[deformation]") {
    for (const DeformationMap& map : some_maps())
        for (const Vec<3>& X : some_points()) {
            INFO("map " << static_cast<int>(map.kind) << " at " << X.transpose());
            const Mat<3> F = map.deformation_gradient(X);
            CHECK_THAT(map.volume_ratio(X), WithinAbs(volume_ratio<3>(F), 1e-12));
            if (const auto C = map.right_cauchy_green(X)) CHECK((*C - right_cauchy_green<3>(F)).norm() < 1e-12);
            if (const auto s = map.principal_stretches(X)) CHECK((*s - principal_stretches<3>(F).stretches).norm() < 1e-12);
            if (const auto angle = map.rotation_angle(X)) {
                const Mat<3> R = nearest_rotation<3>(F);
                const Vec<3> axial(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
                CHECK_THAT(std::atan2(axial.norm(), R.trace() - 1), WithinAbs(*angle, 1e-12));
            }
        }
}

TEST_CASE("deformation maps: a translation moves every point alike and deforms nothing", "[deformation]") {
    const DeformationMap map{.translation = {1, 2, 3}};
    for (const Vec<3>& X : some_points()) {
        CHECK((map.displacement(X) - Vec<3>(1, 2, 3)).norm() < 1e-15);
        CHECK(map.deformation_gradient(X) == Mat<3>::Identity());
        CHECK(green_strain<3>(map.displacement_gradient(X)).isZero(0));
    }
}

TEST_CASE("deformation maps: dx = F dX holds to second order where the map bends, and exactly where it does not",
          "[deformation]") {
    const Vec<3> X(0.2, -0.1, 0.15), along = Vec<3>(1, 2, -0.5).normalized();
    for (const DeformationMap& map : some_maps()) {
        INFO("map " << static_cast<int>(map.kind));
        const auto error = [&](Real length) {
            const Vec<3> dX = length * along;
            return (map.displacement(X + dX) - map.displacement(X) - map.displacement_gradient(X) * dX).norm();
        };
        if (map.homogeneous())
            CHECK(error(0.1) < 1e-15 * 30);
        else if (std::abs(map.curvature) + std::abs(map.twist) > 1)
            CHECK_THAT(std::log10(error(1e-2) / error(1e-3)), WithinAbs(2, 0.05));
    }
}

TEST_CASE("deformation maps: an almost straight bend and an almost untwisted twist lose no digits", "[deformation]") {
    const Vec<3> X(0.3, 0.2, 0.1);
    const DeformationMap bend{.kind = MapKind::bend, .curvature = 1e-9};
    CHECK_THAT(bend.position(X)[1], WithinAbs(0.2 + 0.5e-9 * 0.09, 1e-16));
    CHECK_THAT(bend.displacement_gradient(X)(0, 0) / -2e-10, WithinAbs(1, 1e-6));
}
