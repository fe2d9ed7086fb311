// F = R S for every F, what F does to lengths, areas and volumes, and strains that do not see a rotation.
#include <pliant/continuum/deformation.h>
#include <pliant/math/small_eigen.h>
#include <Eigen/Geometry>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace pliant;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr int many = 2000;

class Draw {
public:
    Real number() { return spread_(engine_); }
    template <int Dim>
    Mat<Dim> matrix() {
        return Mat<Dim>::NullaryExpr([this] { return number(); });
    }
    template <int Dim>
    Vec<Dim> direction() {
        return Vec<Dim>::NullaryExpr([this] { return number(); }).normalized();
    }
    template <int Dim>
    Mat<Dim> rotation() {
        if constexpr (Dim == 2) {
            const Real a = 4 * number();
            Mat<2> R;
            R << std::cos(a), -std::sin(a), std::sin(a), std::cos(a);
            return R;
        } else {
            return Eigen::AngleAxis<Real>(4 * number(), direction<3>()).toRotationMatrix();
        }
    }

private:
    std::mt19937_64 engine_{7};
    std::uniform_real_distribution<Real> spread_{-1, 1};
};

template <int Dim>
void check_polar(const Mat<Dim>& F) {
    const auto [R, S] = polar_decomposition<Dim>(F);
    const Real size = F.cwiseAbs().maxCoeff();
    INFO("F =\n" << F << "\nR =\n" << R << "\nS =\n" << S);
    REQUIRE(R.allFinite());
    REQUIRE(S.allFinite());
    CHECK((R.transpose() * R - Mat<Dim>::Identity()).norm() <= 1e-12);
    CHECK_THAT(R.determinant(), WithinAbs(1, 1e-12));
    CHECK((F - R * S).cwiseAbs().maxCoeff() <= 1e-12 * size);
    CHECK((S - S.transpose()).cwiseAbs().maxCoeff() <= 1e-15 * size);
    // No rotation is nearer: tr S is the sum of the singular values, the least with the sign of det F.
    Mat<3> scaled = Mat<3>::Zero();
    scaled.topLeftCorner<Dim, Dim>() = size > 0 ? Mat<Dim>(F / size) : F;
    const Vec<3> sigma = singular_values(scaled).sigma;
    const Real sum = sigma.sum(), least = sigma[Dim - 1];
    const Real best = size * ((F / (size > 0 ? size : 1)).determinant() < 0 ? sum - 2 * least : sum);
    CHECK_THAT(S.trace(), WithinAbs(best, 1e-11 * size));
}

// U diag(s) V^T with random rotations U, V.
template <int Dim>
Mat<Dim> with_stretches(Draw& draw, const Vec<Dim>& s) {
    return draw.rotation<Dim>() * s.asDiagonal() * draw.rotation<Dim>().transpose();
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("polar decomposition: proper and exact for random deformations, inverted ones included", "[deformation]",
                       ((int Dim), Dim), 2, 3) {
    Draw draw;
    for (int k = 0; k < many; ++k) check_polar<Dim>(draw.matrix<Dim>());
}

TEMPLATE_TEST_CASE_SIG("polar decomposition: proper and exact at any size", "[deformation]", ((int Dim), Dim), 2, 3) {
    Draw draw;
    for (const Real size : {1e-300, 1e-150, 1e-30, 1e-8, 1e8, 1e30, 1e150, 1e300})
        for (int k = 0; k < 50; ++k) check_polar<Dim>(size * draw.matrix<Dim>());
}

TEST_CASE("polar decomposition: proper and exact where F is singular, nearly so, or inverted", "[deformation]") {
    Draw draw;
    for (const Vec<3>& s : std::vector<Vec<3>>{{0, 0, 0},
                                               {1, 0, 0},
                                               {1, 1, 0},
                                               {2, 1, 0},
                                               {1, 1, 1},
                                               {1, 1, -1},
                                               {2, 1, -1},
                                               {2, 1, -1 + 1e-9},
                                               {2, 1, -0.5},
                                               {1, 1e-3, -1e-3},
                                               {1, 1e-6, 1e-6},
                                               {1, 1e-8, -1e-9},
                                               {1, 1e-14, 1e-15},
                                               {1, 1e-160, 0},
                                               {1e5, 1, 1e-5},
                                               {1e5, 1, -1e-5}})
        for (int k = 0; k < 100; ++k) {
            INFO("stretches " << s.transpose());
            check_polar<3>(with_stretches<3>(draw, s));
        }
    for (const Vec<2>& s : std::vector<Vec<2>>{{0, 0}, {1, 0}, {1, 1}, {1, -1}, {1, 1e-9}, {1, -1e-9}, {1e9, 1}})
        for (int k = 0; k < 100; ++k) check_polar<2>(with_stretches<2>(draw, s));
    for (int axis = 0; axis < 3; ++axis) {
        Mat<3> mirror = Mat<3>::Identity();
        mirror(axis, axis) = -1;
        check_polar<3>(mirror);
    }
    check_polar<3>(-Mat<3>::Identity());
    check_polar<2>(Mat<2>::Zero());
}

TEST_CASE("polar decomposition: rank one by outer product", "[deformation]") {
    Draw draw;
    for (int k = 0; k < 200; ++k) {
        check_polar<3>(draw.direction<3>() * draw.direction<3>().transpose());
        check_polar<2>(draw.direction<2>() * draw.direction<2>().transpose());
    }
}

TEMPLATE_TEST_CASE_SIG("objectivity: a rotation afterwards turns R alone; one before turns both", "[deformation]",
                       ((int Dim), Dim), 2, 3) {
    Draw draw;
    for (int k = 0; k < 300; ++k) {
        const Mat<Dim> F = Mat<Dim>::Identity() + 0.4 * draw.matrix<Dim>(), Q = draw.rotation<Dim>();
        const auto [R, S] = polar_decomposition<Dim>(F);
        const auto after = polar_decomposition<Dim>(Q * F), before = polar_decomposition<Dim>(F * Q);
        CHECK((after.R - Q * R).norm() < 1e-12);
        CHECK((after.S - S).norm() < 1e-12);
        CHECK((before.R - R * Q).norm() < 1e-12);
        CHECK((before.S - Q.transpose() * S * Q).norm() < 1e-12);
        // Green's strain and C do not see what follows; Cauchy's does.
        const Mat<Dim> H = displacement_gradient<Dim>(F), turned = displacement_gradient<Dim>(Q * F);
        CHECK((green_strain<Dim>(turned) - green_strain<Dim>(H)).norm() < 1e-14);
        CHECK((right_cauchy_green<Dim>(Q * F) - right_cauchy_green<Dim>(F)).norm() < 1e-14);
    }
}

TEST_CASE("principal stretches: the singular values, and the directions that F keeps at right angles", "[deformation]") {
    Draw draw;
    for (int k = 0; k < 300; ++k) {
        const Mat<3> F = draw.matrix<3>(), R = nearest_rotation<3>(F);
        const auto [stretches, directions] = principal_stretches<3>(F);
        CHECK((stretches.cwiseAbs() - singular_values(F).sigma).norm() < 1e-12);
        CHECK_THAT(stretches.prod(), WithinAbs(F.determinant(), 1e-12));
        CHECK((directions.transpose() * directions - Mat<3>::Identity()).norm() < 1e-12);
        CHECK((F * directions - R * directions * stretches.asDiagonal()).norm() < 1e-12);
    }
}

TEST_CASE("the rotation changes with F as its differential says", "[deformation]") {
    Draw draw;
    for (int k = 0; k < 100; ++k) {
        const Mat<3> F = Mat<3>::Identity() + 0.4 * draw.matrix<3>(), dF = draw.matrix<3>();
        const Real h = 1e-5;
        const Mat<3> difference = (nearest_rotation<3>(F + h * dF) - nearest_rotation<3>(F - h * dF)) / (2 * h);
        CHECK((difference - rotation_differential<3>(polar_decomposition<3>(F), dF)).norm() < 1e-7);
        const Mat<2> G = Mat<2>::Identity() + 0.4 * draw.matrix<2>(), dG = draw.matrix<2>();
        const Mat<2> plane = (nearest_rotation<2>(G + h * dG) - nearest_rotation<2>(G - h * dG)) / (2 * h);
        CHECK((plane - rotation_differential<2>(polar_decomposition<2>(G), dG)).norm() < 1e-7);
    }
}

TEST_CASE("areas change as those of a parallelogram that F takes along; volumes as those of a box", "[deformation]") {
    Draw draw;
    for (int k = 0; k < 200; ++k) {
        const Mat<3> F = draw.matrix<3>();
        const Vec<3> a = draw.direction<3>(), b = draw.direction<3>(), c = draw.direction<3>(), normal = a.cross(b);
        const Real at_rest = normal.norm(), now = (F * a).cross(F * b).norm();
        CHECK_THAT(area_ratio<3>(F, normal.normalized()), WithinRel(now / at_rest, 1e-9));
        const Real box = normal.dot(c), box_now = (F * a).cross(F * b).dot(F * c);
        CHECK_THAT(volume_ratio<3>(F) * box, WithinAbs(box_now, 1e-13));
        // In the plane: a line, whose normal is at right angles to it.
        const Mat<2> G = draw.matrix<2>();
        const Vec<2> line = draw.direction<2>();
        CHECK_THAT(area_ratio<2>(G, Vec<2>(line[1], -line[0])), WithinRel((G * line).norm(), 1e-12));
    }
    CHECK(cofactor<3>(Mat<3>::Zero()).isZero(0));
    const Mat<3> flat = Vec<3>(2, 3, 0).asDiagonal();
    CHECK(cofactor<3>(flat)(2, 2) == 6);
}

TEST_CASE("the tensor case of the catalogue, and rotations by 90 and 30 degrees", "[deformation]") {
    Mat<3> F, C, green, cauchy;
    F << 1.2, 0.3, 0, 0, 0.9, 0.1, 0.05, 0, 1.1;
    C << 1.4425, 0.36, 0.055, 0.36, 0.9, 0.09, 0.055, 0.09, 1.22;
    green << 0.22125, 0.18, 0.0275, 0.18, -0.05, 0.045, 0.0275, 0.045, 0.11;
    cauchy << 0.2, 0.15, 0.025, 0.15, -0.1, 0.05, 0.025, 0.05, 0.1;
    const Mat<3> H = displacement_gradient<3>(F);
    CHECK((right_cauchy_green<3>(F) - C).cwiseAbs().maxCoeff() < 1e-12);
    CHECK((green_strain<3>(H) - green).cwiseAbs().maxCoeff() < 1e-12);
    CHECK((cauchy_strain<3>(H) - cauchy).cwiseAbs().maxCoeff() < 1e-12);
    CHECK_THAT(volume_ratio<3>(F), WithinAbs(1.1895, 1e-12));
    const Mat<3> R = nearest_rotation<3>(F);
    CHECK((R.row(0) - Eigen::RowVector3d(0.989396739, 0.143205931, -0.024210632)).norm() < 2e-9);

    for (const Real degrees : {90.0, 30.0}) {
        const Real a = degrees * std::numbers::pi / 180;
        const Mat<3> turn = Eigen::AngleAxis<Real>(a, Vec<3>::UnitZ()).toRotationMatrix(), slope = displacement_gradient<3>(turn);
        CHECK(green_strain<3>(slope).norm() < 1e-15);
        CHECK_THAT(cauchy_strain<3>(slope)(0, 0), WithinAbs(std::cos(a) - 1, 1e-15));
        CHECK_THAT(cauchy_strain<3>(slope)(1, 1), WithinAbs(std::cos(a) - 1, 1e-15));
    }
}

TEST_CASE("principal stretches: the negative one comes last, also where another has its size", "[deformation]") {
    Draw draw;
    for (int k = 0; k < 200; ++k) {
        const auto s = principal_stretches<3>(with_stretches<3>(draw, {1.9, 1, -1})).stretches;
        CHECK((s - Vec<3>(1.9, 1, -1)).norm() < 1e-12);
        CHECK((principal_stretches<2>(with_stretches<2>(draw, {1, -1})).stretches - Vec<2>(1, -1)).norm() < 1e-12);
    }
}
