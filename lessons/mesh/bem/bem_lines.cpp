// Curves, and the conditions under which all of it holds.
#include "bem.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::bem {
namespace {

constexpr Real near_enough = 0.1;       // of an element: nearer to the boundary the error grows
constexpr Real accurate_enough = 0.02;  // largest error of the displacement
constexpr Real balanced_enough = 0.02;
constexpr Real small_enough = 0.05;  // displacement over size

}  // namespace

void BemLesson::declare_lines() {
    const auto along_x = [this](Curve& curve) {
        if (tally_[found_inside] == 0) return;
        const InsideMesh& mesh = body_->inside();
        for (Index k = mesh.section_first; k < mesh.section_first + mesh.section_count; ++k)
            curve.add(mesh.particles[static_cast<std::size_t>(k)].x(), inside_stress_(4, k));
    };
    const auto exact_along_x = [this](Curve& curve) {
        const auto from = [&](Real start, Real end, auto of) { curve.add_range(start, end, 60, of); };
        if (is(Setting::ring)) from(inner_radius, outer_radius, [this](Real r) { return exact_ring().hoop_stress(r); });
        if (in_space()) from(inner_radius, 4 * inner_radius, [this](Real r) { return exact_cavity().hoop_stress(r); });
        if (is(Setting::hole) && hole_a == hole_b)
            from(hole_a, 4 * hole_a, [this](Real x) { return exact_hole().stress_beside(x); });
    };
    const auto efforts = [this](const std::vector<Effort> Comparison::*which) {
        return [this, which](Curve& curve) {
            if (!comparison_) return;
            for (const Effort& e : (*comparison_).*which) curve.add(e.unknowns, e.error);
        };
    };
    lines = {
        line_of("stress_along_x", "Pa", "x", "m", "stress along y at points inside, from the wall outward along the x axis",
                along_x)
            .against("exact", exact_along_x)
            .measures("σ_yy")
            .when([this] { return !is(Setting::outline) && inside; }),
        line_of("hoop_around", "Pa", "angle from the x axis", "°", "stress along the wall of the hole, from element to element",
                [this](Curve& curve) {
                    if (tally_[done] == 0) return;
                    std::vector<std::pair<Real, Real>> all;
                    for (Index k = 0; k < body_->element_count(); ++k) {
                        if (!body_->on_inner(k)) continue;
                        const Vec<3> X = body_->middles.col(k);
                        const Real angle = std::atan2(X.y() / hole_b, X.x() / hole_a) / one_degree;
                        all.emplace_back(angle < -1e-9 ? angle + 360 : angle, hoop_at(k));
                    }
                    std::ranges::sort(all);
                    for (const auto& [angle, stress] : all) curve.add(angle, stress);
                })
            .against("plane without end",
                     [this](Curve& curve) {
                         curve.add_range(0, 360, 121,
                                         [this](Real angle) { return exact_hole().hoop_stress(angle * one_degree); });
                     })
            .measures("σ_θ")
            .when([this] { return has_hole(); }),
        line_of("stress_along_outline", "Pa", "from corner 1 along the outline", "m",
                "stress along the outline, from element to element",
                [this](Curve& curve) {
                    if (tally_[done] == 0) return;
                    Real before = 0;
                    for (Index k = 0; k < body_->element_count(); before += size_[k++])
                        curve.add(before + size_[k] / 2, hoop_at(k));
                })
            .measures("σ_τ")
            .when([this] { return is(Setting::outline); }),
        line_of("error_over_unknowns", "", "unknowns", "",
                "largest error on the boundary: boundary elements of the present kind, and linear finite elements",
                efforts(&Comparison::boundary))
            .beside({{"finite elements", efforts(&Comparison::finite)},
                     {"these elements",
                      [this](Curve& curve) {
                          if (comparison_) curve.add(comparison_->own.unknowns, comparison_->own.error);
                      },
                      true}})
            .measures("error")
            .on_log_axes()
            .when([this] { return is(Setting::ring); })};
}

void BemLesson::declare_checks() {
    const auto twice = [this]() -> std::optional<Fix> {
        const auto more = finer();
        if (more.empty()) return std::nullopt;
        return Fix{fmt::format("N = {}", more.front().second), more};
    };
    assumptions = {
        assumption_of(
            "point off the boundary", "", [this] { return body_->contains(point()) ? 1 / body_->distance(point()) : 0; },
            [] { return 1 / near_enough; }, "1/d ≤ 10",
            "nearer to the boundary than a tenth of an element, the sums over the boundary follow its shape functions rather "
            "than the body; "
            "read the stress of the boundary itself")
            .otherwise("point too near")
            .when([this] { return body_ != nullptr; })
            .mended_by([this]() -> std::optional<Fix> {
                return finer().empty() ? std::nullopt : std::optional(Fix{"more elements", finer()});
            }),
        assumption_of(
            "enough elements", "", [this] { return worst_error().value_or(0); }, [] { return accurate_enough; },
            "|u − exact| ≤ 2 %", "the boundary is too coarse for its displacements: take more elements, or better ones")
            .otherwise("too few elements")
            .when([this] { return has_exact() && tally_[done] != 0; })
            .mended_by(twice),
        assumption_of(
            "support carries the load", "", [this] { return unbalanced(); }, [] { return balanced_enough; },
            "|∫ t dS| ≤ 2 % of ∫ |t| dS",
            "tractions that are found do not balance those that are given, since the outline is too coarse at its corners")
            .otherwise("out of balance")
            .when([this] { return is(Setting::outline) && tally_[done] != 0; })
            .mended_by(twice),
        assumption_of(
            "small displacements", "", [this] { return largest_displacement() / size(); }, [] { return small_enough; },
            "|u| ≤ 5 % of the body", "the equations are those of the shape at rest; where it changes much, they hold no longer")
            .otherwise("large displacements")
            .when([this] { return tally_[done] != 0; })
            .mended_by([this] {
                return fix_by(youngs_modulus,
                              rounded_down(youngs_modulus * 3 * largest_displacement() / (small_enough * size())));
            })};
}

}  // namespace pliant::bem
