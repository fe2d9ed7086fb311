// What the lectures say of strains and Hooke's law, measured.
#include <pliant/continuum/deformation.h>
#include <pliant/continuum/deformation_map.h>
#include <pliant/continuum/moduli.h>
#include <pliant/continuum/strain_cost.h>
#include <pliant/math/small_eigen.h>
#include <pliant/run/runner.h>
#include <pliant/study/claims.h>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace pliant::strain_measures {
namespace {

constexpr int tries = 1000;

class Draw {
public:
    Real number() { return spread_(engine_); }
    Mat<3> matrix() {
        return Mat<3>::NullaryExpr([this] { return number(); });
    }
    Vec<3> direction() {
        return Vec<3>::NullaryExpr([this] { return number(); }).normalized();
    }
    Mat<3> rotation() { return Eigen::AngleAxis<Real>(std::numbers::pi * number(), direction()).toRotationMatrix(); }
    // Any orthogonal matrix, proper or not.
    Mat<3> orthogonal() { return orthogonal_part(matrix()) * Vec<3>(1, 1, number() < 0 ? -1 : 1).asDiagonal(); }

private:
    std::mt19937_64 engine_{23};
    std::uniform_real_distribution<Real> spread_{-1, 1};
};

Real largest(const Mat<3>& m) { return m.cwiseAbs().maxCoeff(); }

Verdict held(bool so, Verdict when = Verdict::reproduced) { return so ? when : Verdict::refuted; }

// ---------------------------------------------------------------------------------------------------------------- E10

Finding rotations() {
    Draw draw;
    Real after = 0, before = 0, principal = 0;
    for (int k = 0; k < tries; ++k) {
        const Mat<3> F = Mat<3>::Identity() + 0.3 * draw.matrix(), Q = draw.rotation();
        const auto green = [](const Mat<3>& G) { return green_strain<3>(displacement_gradient<3>(G)); };
        const auto values = [](const Mat<3>& E) { return symmetric_eigenvalues<3>(E); };
        after = std::max(after, largest(green(Q * F) - green(F)));
        before = std::max(before, largest(green(F * Q) - green(F)));
        principal = std::max(principal, (values(green(F * Q)) - values(green(F))).cwiseAbs().maxCoeff());
    }
    Real off = 0, along_axis = 0;
    Runner runner(find_lesson("elasticity/strain_measures"), {{"map", "rotation"}});
    for (int angle = -180; angle <= 180; angle += 3) {
        runner.assign("angle", angle);
        runner.step();
        const Real foretold = std::cos(angle * one_degree) - 1;
        off = std::max({off, std::abs(runner.value("cauchy_11") - foretold), std::abs(runner.value("cauchy_22") - foretold)});
        along_axis = std::max(along_axis, std::abs(runner.value("cauchy_33")));
    }
    const Real figure = std::max(after, off);
    return {.figure = figure,
            .verdict = held(figure <= 1e-13 && along_axis <= 1e-13),
            .text = fmt::format("A rotation that follows changes no entry of Green's strain by more than {:.0e} ({} random F). "
                                "Cauchy's strain of a rotation is cos θ − 1 across the axis, to {:.0e}, and 0 along it: −0.134 "
                                "at 30°, −1 at 90°, −2 at 180°. A rotation of the body before it is deformed does turn Green's "
                                "strain (entries by up to {:.2f}), but not its principal values ({:.0e}).",
                                after, tries, off, before, principal),
            .condition = {}};
}

// ---------------------------------------------------------------------------------------------------------------- E11

// The stretch e at which a measured relative error reaches the share, by bisection.
Real reached_at(Real share) {
    const auto error = [](Real e) {
        const Mat<3> H = Vec<3>(e, 0, 0).asDiagonal();
        return (cauchy_strain<3>(H) - green_strain<3>(H)).norm() / green_strain<3>(H).norm();
    };
    Real low = 1e-9, high = 10;
    for (int k = 0; k < 200; ++k) (error((low + high) / 2) < share ? low : high) = (low + high) / 2;
    return low;
}

// Linear solutions that a block takes to be pulled to 1.3 times its length: with Cauchy's strain in the energy one, with Green's
// one in each of Newton's iterations.
Real solutions(const char* energy) {
    Runner runner(find_lesson("elasticity/energy_density"), {{"energy", energy}, {"path", "uniaxial"}, {"stretch", "1.3"}});
    runner.step();
    return runner.value("block_iterations");
}

Finding cost() {
    const OperationCounts counted = count_operations();
    const Real ratio = static_cast<Real>(counted.green) / static_cast<Real>(counted.cauchy);
    const Real one_percent = reached_at(0.01), angle = std::acos(1 - one_percent) / one_degree;
    const Real linear = solutions("linear"), nonlinear = solutions("stvk");
    return {.figure = ratio,
            .verdict = held(ratio > 1 && linear == 1 && nonlinear > linear, Verdict::qualified),
            .text = fmt::format(
                "One evaluation of Green's strain takes {} additions and multiplications, of Cauchy's {}. "
                "What costs more is that Green's is not linear: a block pulled to 1.3 times its length takes "
                "{:.0f} linear solution with Cauchy's, and {:.0f} with Green's. Without rotation Cauchy's error reaches 1 % "
                "of the strain at a strain of {:.2f} %.",
                counted.green, counted.cauchy, linear, nonlinear, 100 * one_percent),
            .condition = fmt::format(
                "cheaper at any deformation, but right to 1 % only up to a strain of {:.2f} % without rotation; a turn by "
                "{:.0f}° alone makes up as much strain",
                100 * one_percent, angle)};
}

// ---------------------------------------------------------------------------------------------------------------- E12

Finding rigid() {
    Draw draw;
    Real of_rotations = 0, proper = 0, mirrored = 10, lengths = 0;
    int mirrors = 0;
    for (int k = 0; k < tries; ++k) {
        const Mat<3> Q = draw.rotation(), O = draw.orthogonal(), F = draw.matrix();
        of_rotations = std::max(of_rotations, largest(right_cauchy_green<3>(Q) - Mat<3>::Identity()));
        // How far an F with FᵀF = I is from the nearest rotation.
        const Real away = (O - nearest_rotation<3>(O)).norm();
        if (O.determinant() > 0)
            proper = std::max(proper, away);
        else
            mirrored = std::min(mirrored, away), ++mirrors;
        const Vec<3> v = draw.direction();
        lengths = std::max(lengths, std::abs((F * v).squaredNorm() - v.dot(right_cauchy_green<3>(F) * v)));
    }
    // Rigid at one place says nothing of the body: on the axis of a twist.
    const DeformationMap twist{.kind = MapKind::twist, .twist = 2};
    const auto strained = [&](const Vec<3>& X) {
        return largest(right_cauchy_green<3>(twist.deformation_gradient(X)) - Mat<3>::Identity());
    };
    const Real on_axis = strained({0.2, 0, 0}), beside = strained({0.2, 0.3, 0.2});
    const Real figure = std::max({of_rotations, proper, lengths});
    return {.figure = figure,
            .verdict = held(figure <= 1e-13 && mirrors > 0 && mirrored > 1, Verdict::qualified),
            .text = fmt::format(
                "Rotations give FᵀF = I to {:.0e}, and |dv'|² = vᵀFᵀF v holds to {:.0e} for any F. Of {} matrices with FᵀF = I "
                "those with det F = 1 are rotations to {:.0e}; the {} with det F = −1 are mirrors, {:.1f} away from every "
                "rotation. On the axis of a twist FᵀF = I to {:.0e}, 0.36 m beside it FᵀF − I has entries of {:.2f}.",
                of_rotations, lengths, tries, proper, mirrors, mirrored, on_axis, beside),
            .condition = "FᵀF = I means rigid only together with det F > 0, and only if it holds at every point of the body"};
}

// ---------------------------------------------------------------------------------------------------------------- E13

Finding hooke() {
    Draw draw;
    Real forms = 0, trips = 0;
    const auto differ = [](Real a, Real b) { return std::abs(a - b) / std::abs(b); };
    for (int k = 0; k < tries; ++k) {
        const Real Y = std::pow(10.0, 6 + 5 * draw.number()), nu = -0.2 + 0.69 * draw.number();
        const auto given = IsotropicModuli::from_young_poisson(Y, nu);
        const Mat<3> H = draw.matrix(), strain = cauchy_strain<3>(H);
        const Mat<3> tensor = hooke_stress<3>(given.lame(), strain),
                     voigt = tensor_from_voigt_stress<3>(elasticity_matrix(given) * voigt_strain<3>(strain));
        forms = std::max(forms, largest(tensor - voigt) / largest(tensor));
        for (const auto& back : {IsotropicModuli::from_lame(given.lambda(), given.mu()),
                                 IsotropicModuli::from_shear_bulk(given.shear_modulus(), given.bulk_modulus())})
            trips = std::max({trips, differ(back.youngs_modulus(), Y), differ(1 + back.poisson_ratio(), 1 + nu),
                              differ(back.lambda() + 2 * back.mu(), given.lambda() + 2 * given.mu()),
                              differ(back.bulk_modulus(), given.bulk_modulus())});
    }
    const Real near = 0.5 - 1e-9;
    const auto soft = IsotropicModuli::from_young_poisson(1e6, near);
    const Real lost = differ(0.5 - IsotropicModuli::from_lame(soft.lambda(), soft.mu()).poisson_ratio(), 0.5 - near);
    const Real figure = std::max(forms, trips);
    return {.figure = figure,
            .verdict = held(figure <= 1e-12),
            .text = fmt::format(
                "For {} random strains and materials with ν from −0.89 to 0.49 the 6×6 form equals λ tr(ε) I + 2 μ ε to {:.0e}, "
                "and (Y, ν) come back through (λ, μ) and (G, K) to {:.0e}; at ν = ½ − 10⁻⁹ what is missing to ½ comes back to "
                "{:.0e} of it.",
                tries, forms, trips, lost),
            .condition = {}};
}

const ClaimRegistration e10{"E10", rotations};
const ClaimRegistration e11{"E11", cost};
const ClaimRegistration e12{"E12", rigid};
const ClaimRegistration e13{"E13", hooke};

}  // namespace
}  // namespace pliant::strain_measures
