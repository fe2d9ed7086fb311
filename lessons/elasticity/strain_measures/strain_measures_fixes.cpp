// Which parameters would mend what the lights show.
#include <fmt/format.h>
#include <pliant/text/format.h>

#include "strain_measures.h"

namespace pliant::strain_measures {

// First without the turn; then so much less of the map that the error, which is proportional to it, falls below the limit.
std::optional<Fix> StrainMeasuresLesson::smaller() const {
    if (turn != 0) return Fix{"θ = 0", {{"turn", "0"}}};
    const Real off = (of(cauchy_) - of(green_)).norm();
    const Real share = rounded_down(0.8 * tolerated * of(green_).norm() / off, 2);
    const auto less = [share](Real rest, Real value) { return format_exact(rest + share * (value - rest)); };
    switch (map_.kind) {
        case MapKind::rotation:
            return Fix{"α = 0", {{"angle", "0"}}};
        case MapKind::shear:
            return Fix{fmt::format("γ = {}", less(0, map_.shear)), {{"shear", less(0, map_.shear)}}};
        case MapKind::stretch:
            return Fix{fmt::format("strain × {}", format_quantity(share, "")),
                       {{"stretch_x", less(1, map_.stretches[0])},
                        {"stretch_y", less(1, map_.stretches[1])},
                        {"stretch_z", less(1, map_.stretches[2])}}};
        case MapKind::free: {
            // What is left of a large rotation is not small: only the symmetric part of F is kept.
            Fix fix{fmt::format("∇u × {}", format_quantity(share, "")), {}};
            const Mat<3> kept = 0.5 * (map_.gradient + map_.gradient.transpose());
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) fix.assign.emplace_back(controls.entry(i, j).info.key, less(i == j, kept(i, j)));
            return fix;
        }
        default:
            return std::nullopt;
    }
}

std::optional<Fix> StrainMeasuresLesson::not_inverted() const {
    if (map_.kind == MapKind::stretch) {
        const Vec<3> s = map_.stretches.cwiseAbs();
        return Fix{"stretches > 0",
                   {{"stretch_x", format_exact(s[0])}, {"stretch_y", format_exact(s[1])}, {"stretch_z", format_exact(s[2])}}};
    }
    if (map_.kind != MapKind::free) return std::nullopt;
    // The mirror image.
    Fix fix{"first row of F × −1", {}};
    for (int j = 0; j < 3; ++j) fix.assign.emplace_back(controls.entry(0, j).info.key, format_exact(-map_.gradient(0, j)));
    return fix;
}

std::optional<Fix> StrainMeasuresLesson::fix(const Failure&) const { return Fix{"shear", {{"map", "shear"}}}; }

std::string StrainMeasuresLesson::blow_up_hint() const {
    return "Every measure is a formula in F and cannot blow up by itself: take parameters nearer to their defaults";
}

}  // namespace pliant::strain_measures
