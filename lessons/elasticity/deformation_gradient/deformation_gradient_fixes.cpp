// Which parameters would mend what the lights show.
#include <fmt/format.h>
#include <pliant/text/format.h>

#include "deformation_gradient.h"

#include <cmath>

namespace pliant::deformation {

// The relative error is proportional to the distance.
std::optional<Fix> DeformationGradientLesson::nearer() const {
    const Real share = rounded_down(0.8 * near_enough * rest_vector_.norm() / gap_.norm(), 2);
    if (!(share > 0)) return std::nullopt;
    const Vec<3> there = material(0) + share * rest_vector();
    Fix fix{fmt::format("|dX| × {}", format_quantity(share, "")), {}};
    for (std::size_t k = 0; k < 3; ++k) fix.assign.emplace_back(Q[k].info.key, format_exact(there[static_cast<Index>(k)]));
    return fix;
}

std::optional<Fix> DeformationGradientLesson::not_inverted() const {
    switch (controls.kind()) {
        case MapKind::bend: {
            const Real most = rounded_down(0.9 / body_.half()[1], 2);
            const Real gentler = std::copysign(most, map_.curvature);
            return Fix{fmt::format("κ = {}", format_quantity(gentler, "1/m")), {{"bend_curvature", format_exact(gentler)}}};
        }
        case MapKind::stretch: {
            Fix fix{"stretches > 0", {}};
            constexpr std::array<const char*, 3> keys{"stretch_x", "stretch_y", "stretch_z"};
            for (Index k = 0; k < 3; ++k)
                fix.assign.emplace_back(keys[static_cast<std::size_t>(k)], format_exact(std::abs(map_.stretches[k])));
            return fix;
        }
        case MapKind::free: {
            Fix fix{"F = I", {}};
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) fix.assign.emplace_back(controls.entry(i, j).info.key, i == j ? "1" : "0");
            return fix;
        }
        default:
            return std::nullopt;
    }
}

std::optional<Fix> DeformationGradientLesson::fix(const Failure&) const { return Fix{"bend", {{"map", "bend"}}}; }

std::string DeformationGradientLesson::blow_up_hint() const {
    return "The map is evaluated in closed form, so that only its parameters can make it large: take ones nearer to their "
           "defaults";
}

}  // namespace pliant::deformation
