// What the lectures say of displacement and deformation gradient, measured.
#include <pliant/continuum/deformation.h>
#include <pliant/continuum/deformation_map.h>
#include <pliant/math/line_fit.h>
#include <pliant/run/runner.h>
#include <pliant/study/claims.h>

#include <fmt/format.h>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <random>

namespace pliant::deformation {
namespace {

// The gradient that a body's points show: the affine map that fits rest and present positions best.
Mat<3> fitted_gradient(const Points<3>& X, const Points<3>& x) {
    const Points<3> from = X.colwise() - X.rowwise().mean(), to = x.colwise() - x.rowwise().mean();
    const Mat<3> A = to * from.transpose(), B = from * from.transpose();
    return A * B.inverse();
}

Finding constant_displacement() {
    std::mt19937_64 engine(11);
    std::uniform_real_distribution<Real> shift(-2, 2);
    Real off = 0, strain = 0, farthest = 0;
    constexpr int tries = 20;
    for (int k = 0; k < tries; ++k) {
        Runner runner(find_lesson("elasticity/deformation_gradient"), {{"map", "translation"}});
        const Points<3> X = Eigen::Map<const Points<3>>(runner.lesson().field("position").view().data(), 3,
                                                        runner.lesson().field("position").size());
        for (const char* key : {"shift_x", "shift_y", "shift_z"}) runner.assign(key, shift(engine));
        runner.step();
        const Points<3> x = Eigen::Map<const Points<3>>(runner.lesson().field("position").view().data(), 3, X.cols());
        const Mat<3> F = fitted_gradient(X, x), H = displacement_gradient<3>(F);
        off = std::max(off, (F - Mat<3>::Identity()).cwiseAbs().maxCoeff());
        strain = std::max({strain, green_strain<3>(H).cwiseAbs().maxCoeff(), cauchy_strain<3>(H).cwiseAbs().maxCoeff(),
                           (right_cauchy_green<3>(F) - Mat<3>::Identity()).cwiseAbs().maxCoeff()});
        farthest = std::max(farthest, (x - X).colwise().norm().maxCoeff());
    }
    const Real largest = std::max(off, strain);
    return {.figure = largest,
            .verdict = largest <= 1e-12 ? Verdict::reproduced : Verdict::refuted,
            .text = fmt::format(
                "Moved by up to {:.2f} m in {} directions, the body's points show an F that differs from I by {:.1e} and "
                "strains of at most {:.1e}: rounding.",
                farthest, tries, off, strain),
            .condition = {}};
}

// Slope of log error against log |dX|, from 10^-3 m to 10^-1.5 m, where rounding and the next term of the series are small.
Real order_of_error(const DeformationMap& map, const Vec<3>& X, const Vec<3>& along) {
    std::vector<Real> lengths, errors;
    for (Real exponent = -3; exponent <= -1.5; exponent += 0.25) {
        const Vec<3> dX = std::pow(10.0, exponent) * along;
        const Vec<3> dx = map.position(X + dX) - map.position(X);
        lengths.push_back(exponent);
        errors.push_back(std::log10((dx - map.deformation_gradient(X) * dX).norm()));
    }
    const auto fit = fit_line(lengths, errors);
    return fit ? fit->slope : 0;
}

Finding neighbours() {
    std::mt19937_64 engine(5);
    std::uniform_real_distribution<Real> spread(-1, 1);
    const auto random = [&] { return Vec<3>(Vec<3>::NullaryExpr([&] { return spread(engine); })); };
    Real least = 10, most = 0, linear = 0;
    constexpr int tries = 100;
    for (int k = 0; k < tries; ++k) {
        const Vec<3> X = 0.3 * random();
        Vec<3> along = random().normalized();
        along[0] = std::copysign(std::max(std::abs(along[0]), 0.3), along[0]);
        along.normalize();
        for (const DeformationMap& map :
             {DeformationMap{.kind = MapKind::bend, .curvature = 1.5}, DeformationMap{.kind = MapKind::twist, .twist = 2}}) {
            const Real order = order_of_error(map, X, along);
            least = std::min(least, order), most = std::max(most, order);
        }
        const DeformationMap free{.kind = MapKind::free, .gradient = Mat<3>::NullaryExpr([&] { return spread(engine); })};
        const Vec<3> dX = 0.3 * along;
        linear = std::max(linear, (free.position(X + dX) - free.position(X) - free.gradient * dX).norm());
    }
    const DeformationMap bend{.kind = MapKind::bend, .curvature = 1.5};
    const Vec<3> X(0.2, 0.1, 0), across(0, 0, 0.3);
    const Real unbent = (bend.position(X + across) - bend.position(X) - bend.deformation_gradient(X) * across).norm();
    const Real worst = std::max(std::abs(most - 2), std::abs(least - 2));
    return {.figure = worst,
            .verdict = worst <= 0.1 ? Verdict::reproduced : Verdict::refuted,
            .text = fmt::format(
                "Over {} points and directions of a bend and a twist the error falls with an order between {:.3f} and "
                "{:.3f}. Where F is the same everywhere there is none at any distance ({:.0e} m at 0.3 m), nor along "
                "directions in which the map does not bend ({:.0e} m).",
                tries, least, most, linear, unbent),
            .condition = {}};
}

const ClaimRegistration e8{"E8", constant_displacement};
const ClaimRegistration e9{"E9", neighbours};

}  // namespace
}  // namespace pliant::deformation
