// The figure: a circle of directions and what F makes of it, the direction v, and the ellipses of the three tensors.
#include "strain_measures.h"

#include <pliant/continuum/deformation.h>
#include <pliant/math/small_eigen.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::strain_measures {
namespace {

Position at(const Vec<2>& p) { return position(p[0], p[1]); }
Vec<2> seen(const Vec<3>& v) { return v.head<2>(); }

// The image of a circle under A, about `middle`.
LineMarks closed_curve(const Vec<2>& middle, const Mat<2>& A, Ink ink, float width, bool dashed = false) {
    constexpr int pieces = 72;
    LineMarks marks{.ends = {}, .ink = ink, .width = width};
    const auto place = [&](int k) {
        const Real angle = 2 * std::numbers::pi * k / pieces;
        return at(middle + A * Vec<2>(std::cos(angle), std::sin(angle)));
    };
    // The pieces are too short to be dashed one by one.
    for (int k = 0; k < pieces; k += dashed ? 2 : 1) marks.ends.push_back(place(k)), marks.ends.push_back(place(k + 1));
    return marks;
}

// The ellipse of a symmetric tensor: in each principal direction as far as its principal value; arrows point outward where it is
// positive and inward where it is negative.
void draw_ellipse(Scene& scene, const Vec<2>& middle, Real scale, const Mat<2>& tensor, Ink ink) {
    const SymmetricEigen<2> eigen = symmetric_eigen<2>(tensor);
    scene.lines.push_back(closed_curve(middle, scale * tensor, ink, 2.5f));
    for (int k = 0; k < 2; ++k) {
        const Real value = eigen.values[k];
        const Vec<2> end = scale * std::abs(value) * eigen.vectors.col(k);
        if (scale * std::abs(value) < 1e-3 * scale) continue;
        for (const Real side : {-1.0, 1.0}) {
            ArrowMarks arrow{.from = {at(middle)}, .to = {at(middle + side * end)}, .ink = ink, .width = 2};
            if (value < 0) std::swap(arrow.from, arrow.to);
            scene.arrows.push_back(std::move(arrow));
        }
    }
}

// "F = [1.2 0.3 0; 0 0.9 0.1; 0.05 0 1.1]"
std::string row_by_row(std::string_view name, const Mat<3>& m) {
    std::string text = fmt::format("{} = [", name);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            text += fmt::format("{}{}", format_quantity(std::abs(m(i, j)) < 5e-13 ? 0 : m(i, j), "", 3),
                                j < 2   ? "  "
                                : i < 2 ? " ;  "
                                        : "]");
    return text;
}

// Entries that are only what rounding left are drawn as 0.
template <class Derived>
typename Derived::PlainObject plain(const Eigen::MatrixBase<Derived>& m, Real size) {
    return m.unaryExpr([size](Real x) { return std::abs(x) < 1e-13 * size ? Real{0} : x; });
}

std::string principal_values(const Mat<2>& tensor) {
    const Vec<2> values = symmetric_eigenvalues<2>(tensor);
    const auto text = [](Real x) { return format_quantity(std::abs(x) < 5e-13 ? 0 : x, "", 3); };
    return fmt::format("{}, {}", text(values[1]), text(values[0]));
}

}  // namespace

// The largest stretch decides; the same for a range of them, so that a slider does not zoom.
Real StrainMeasuresLesson::reach() const {
    const Real most = principal_stretches<3>(Mat<3>(Mat<3>::Identity() + slope_after(0))).stretches.cwiseAbs().maxCoeff();
    return 1.15 * std::max(Real{1.5}, std::exp2(std::ceil(std::log2(std::max(most, Real{0.1})) * 2 - 1e-9) / 2));
}

void StrainMeasuresLesson::draw(Scene& scene) const {
    draw_circle(scene);
    draw_direction(scene);
    draw_ellipses(scene);
    write_numbers(scene);
    // Words above and matrices below take the room that is left to them.
    const Real r = reach();
    scene.frame(position(-r, -2.3 * r), position(3.1 * r, 1.15 * r));
}

void StrainMeasuresLesson::draw_circle(Scene& scene) const {
    const Vec<2> middle = Vec<2>::Zero();
    scene.lines.push_back(closed_curve(middle, Mat<2>::Identity(), Ink::rest, 2, true));
    const Mat<3> F = of(deformation_);
    LineMarks curve{.ends = {}, .values = scene.values(*this, On::edge), .ink = Ink::body, .width = 4};
    const Index count = stretch_.size();
    for (Index k = 0; k < count; ++k) {
        // Each piece stands for the direction in its middle.
        const Vec<3> here = sampled(k), next = sampled((k + 1) % count), before = sampled((k + count - 1) % count);
        curve.ends.push_back(at(seen(F * (here + before) / 2)));
        curve.ends.push_back(at(seen(F * (here + next) / 2)));
    }
    curve.pick = {true, On::edge, 0, {}};
    scene.lines.push_back(std::move(curve));
    const Vec<2> named = seen(F * sampled(count / 8 * 3));
    scene.labels.push_back({.at = at(named), .text = "F n", .ink = Ink::rest, .away_from = at(middle)});
}

void StrainMeasuresLesson::draw_direction(Scene& scene) const {
    const Position middle = position(0, 0), head = at(seen(v_)), deformed = at(seen(deformed_v_));
    scene.arrow(middle, head, Ink::accent);
    scene.arrow(middle, deformed, Ink::force);
    PointMarks handle{.at = {head}, .values = scene.values(*this, On::particle), .ink = Ink::accent, .radius = 7};
    handle.pick = {true, On::particle, 0, {}};
    scene.points.push_back(std::move(handle));
    const bool apart = (v_ - deformed_v_).head<2>().norm() > 0.15;
    // On the side where v′ is not.
    const float side = v_[0] * deformed_v_[1] > v_[1] * deformed_v_[0] ? 16.f : -16.f;
    if (apart) scene.label(head, "v", Ink::accent, side * static_cast<float>(v_[1]), side * static_cast<float>(v_[0]));
    scene.labels.push_back({.at = deformed, .text = apart ? "v′ = F v" : "v, v′", .ink = Ink::force, .away_from = middle});
}

// The part of each tensor in the plane of the picture. The two strains share a scale.
void StrainMeasuresLesson::draw_ellipses(Scene& scene) const {
    const Real r = reach(), size = 0.32 * r, across = 2.05 * r;
    const Mat<2> C = of(C_).topLeftCorner<2, 2>(), green = of(green_).topLeftCorner<2, 2>(),
                 small = of(cauchy_).topLeftCorner<2, 2>();
    const auto largest = [](const Mat<2>& m) { return symmetric_eigenvalues<2>(m).cwiseAbs().maxCoeff(); };
    const Real strains = std::max({largest(green), largest(small), Real{1e-6}}), squares = std::max(largest(C), Real{1});
    const auto one = [&](Real up, std::string_view name, const Mat<2>& tensor, Real scale, Ink ink) {
        const Vec<2> middle(across, up);
        draw_ellipse(scene, middle, scale, tensor, ink);
        scene.label(position(across + size, up), fmt::format("{}", name), ink, 70, -10);
        scene.label(position(across + size, up), principal_values(tensor), ink, 70, 10);
    };
    scene.lines.push_back(closed_curve({across, 0.8 * r}, size / squares * Mat<2>::Identity(), Ink::rest, 1.5f, true));
    one(0.8 * r, "C = FᵀF", C, size / squares, Ink::text);
    one(0.1 * r, "Green E", green, size / strains, Ink::velocity);
    one(-0.6 * r, "Cauchy ε", small, size / strains, Ink::force);
}

void StrainMeasuresLesson::write_numbers(Scene& scene) const {
    if (scene.colour_by.field.starts_with("stress")) {
        if (done_[0] != 0) write_hookes_law(scene);
    } else {
        scene.matrix("C", plain(of(C_), 1));
        scene.matrix("E", plain(of(green_), 1), "", Ink::velocity);
        scene.matrix("ε", plain(of(cauchy_), 1), "", Ink::force);
    }
    if (done_[0] == 0) return;
    scene.notes.push_back(row_by_row("F", of(deformation_)));
    const auto text = [](Real x) { return format_quantity(std::abs(x) < 5e-13 ? 0 : x, "", 5); };
    scene.notes.push_back(fmt::format("|v′|² = {}² = {},  vᵀC v = {}", text(deformed_v_.norm()), text(deformed_v_.squaredNorm()),
                                      text(v_.dot(of(C_) * v_))));
    scene.notes.push_back(fmt::format("Cauchy predicts |v′| = 1 + vᵀε v = {}", text(1 + v_.dot(of(cauchy_) * v_))));
}

void StrainMeasuresLesson::write_hookes_law(Scene& scene) const {
    scene.matrix("D", elasticity_matrix(material()), "Pa");
    // As columns, in the order of D: xx, yy, zz, yz, xz, xy.
    const auto column = [](const Mat<3>& s) -> Vec<6> { return {s(0, 0), s(1, 1), s(2, 2), s(1, 2), s(0, 2), s(0, 1)}; };
    Eigen::Matrix<Real, 6, 2> stresses;
    stresses << column(of(stress_green_)), column(of(stress_cauchy_));
    scene.matrix("σ of E, ε", plain(stresses, youngs_modulus), "Pa");
}

}  // namespace pliant::strain_measures
