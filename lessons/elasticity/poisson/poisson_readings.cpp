// What cube and panel show: fields, probes, curves, where the laws hold, and what mends a run.
#include "poisson.h"

#include <map>

namespace pliant::poisson {
namespace {

// In lengths of the cube, beyond any that the parameters allow.
constexpr Real largest_displacement = 1e4;
// Over those at rest: at ν near −1 a stretch of a hundred lengths widens as much, in three directions.
constexpr Real largest_volume = 1e9;
// The panel under its unit force; locked or not, it moves by about 20 m.
constexpr Real largest_deflection = 1e4;
// Of the narrowing, that an estimate may be off.
constexpr Real accurate = 0.05;
// Linear triangles and tetrahedra lock above it wherever the strain is not uniform.
constexpr Real locking_ratio = 0.49;

}  // namespace

void PoissonLesson::declare_fields() {
    state = {state_array("displacement", "m", displacement_),
             state_array("increment", "m", increment_),
             state_array("prescribed", "m", prescribed_),
             state_array("element_volume", "", element_volumes_),
             state_array("strains", "", strains_),
             state_array("contractions", "", contractions_),
             state_array("volumes", "", volumes_),
             state_array("deflections", "m", deflections_),
             state_array("done", "", done_)};
    const auto reach = [this] { return bends() ? largest_deflection : largest_displacement * length; };
    fields = {
        vector_field("displacement", "u", "m", On::node, displacement_, "of the cube or of the panel from the place at rest")
            .stops_at(reach),
        vector_field("increment", "Δu", "m", On::node, increment_, "of the latest step").stops_at(reach).when(stretched),
        vector_field("prescribed", "Δx", "m", On::node, prescribed_, "by which the step moves the far face")
            .stops_at(reach)
            .when(stretched),
        scalar_field("element_volume", "V/V₀", "", On::element, element_volumes_, "volume of each tetrahedron over that at rest")
            .stops_at(largest_volume)
            .when(stretched)};
}

void PoissonLesson::declare_probes() {
    const auto law = [this](Real (*of)(Real nu, Real strain)) { return [this, of] { return of(poisson_ratio, reached()); }; };
    const auto off_by = [this](Real share) { return [this, share] { return strain_of_overestimate(poisson_ratio, share); }; };
    probes = {
        probe_of("narrowing", "ΔL′/L", "", "narrowing of the computed cube; exact: 1 − (1 + ΔL/L)^(−ν)",
                 [this] { return contractions_[done()]; })
            .once("transverse_fem")
            .exactly(law(exact_contraction)),
        probe_of("narrowing_by_law", "1 − (1+s)^(−ν)", "", "narrowing by the lecture's law", law(exact_contraction))
            .once("transverse_exact"),
        probe_of("narrowing_by_estimate", "ν ΔL/L", "", "narrowing by the estimate ν ≈ ΔL′/ΔL")
            .once("transverse_linear")
            .formula(*this, "ΔL′/L = ν s", {poisson_ratio, why_reached()}),
        probe_of("narrowing_error", "|ΔL′/L − exact|", "",
                 "of the computed narrowing; halves when the number of steps is doubled")
            .once("transverse_error")
            .formula(*this, "error = |c − e|", {Input::now("c", "narrowing", 0), Input::now("e", "narrowing_by_law", 0)}),
        probe_of("strain", "ΔL/L", "", "lengthening of the computed cube", [this] { return strains_[done()]; }).exactly([this] {
            return reached();
        }),
        probe_of("volume_ratio", "V/V₀", "", "of the computed cube; exact: (1 + ΔL/L)^(1 − 2ν)",
                 [this] { return volumes_[done()]; })
            .exactly(law(exact_volume_ratio)),
        probe_of("strain_off_by_1_percent", "s(1 %)", "", "lengthening at which ν ΔL/L is 1 % above the narrowing", off_by(0.01)),
        probe_of("strain_off_by_5_percent", "s(5 %)", "", "lengthening at which ν ΔL/L is 5 % above the narrowing",
                 off_by(0.05))};
    for (Probe& of_cube : probes) of_cube = of_cube.when(stretched);
    probes.push_back(probe_of("deflection", "u_y", "m",
                              "of the middle of the panel's loaded edge; exact: converged values of cubic triangles",
                              [this] { return deflections_[done() - 1]; })
                         .exactly([this] { return converged_deflection(ratio_of_round(done() - 1)); })
                         .when([this] { return bends() && done() > 0; }));
    probes.push_back(probe_of("times_too_stiff", "u_ref/u", "",
                              "converged deflection over that of these triangles: 1 is right, 3 is locked",
                              [this]() -> std::optional<Real> {
                                  const auto right = probe("deflection").exact(0);
                                  return right ? std::optional(*right / deflections_[done() - 1]) : std::nullopt;
                              }));
}

void PoissonLesson::declare_lines() {
    const auto reached_so_far = [this](const VecX& values) {
        return [this, &values](Curve& curve) {
            for (Index k = 0; k <= done(); ++k) curve.add(strains_[k], values[k]);
        };
    };
    // From rest to the end that was asked for.
    const auto by_law = [this](Real (*law)(Real nu, Real strain)) {
        return [this, law](Curve& curve) {
            curve.add_range(0, axial_strain, 61, [this, law](Real s) { return law(poisson_ratio, s); });
        };
    };
    const auto estimated_volume = [](Real nu, Real s) { return (1 + s) * (1 - nu * s) * (1 - nu * s); };
    lines = {line_of("narrowing_over_lengthening", "", "lengthening ΔL/L", "",
                     "narrowing of the cube, step by step, beside the law and the estimate", reached_so_far(contractions_))
                 .against("1 − (1 + ΔL/L)^(−ν)", by_law(exact_contraction))
                 .beside({{"ν ΔL/L", by_law(linear_contraction)}})
                 .measures("narrowing ΔL′/L")
                 .when(stretched),
             line_of("volume_over_strain", "", "lengthening ΔL/L", "", "volume over that at rest; it stays 1 only for ν = ½",
                     reached_so_far(volumes_))
                 .against("(1 + ΔL/L)^(1 − 2ν)", by_law(exact_volume_ratio))
                 .beside({{"with the estimate", by_law(estimated_volume)}})
                 .measures("volume V/V₀")
                 .when(stretched),
             line_of("locking", "m", "Poisson's ratio ν", "",
                     "deflection of the panel: the true one falls by a sixth up to ν = ½, that of linear triangles collapses",
                     [this](Curve& curve) {
                         std::map<Real, Real> by_ratio;
                         for (Index k = 0; k < done(); ++k) by_ratio[ratio_of_round(k)] = deflections_[k];
                         for (const auto& [nu, deflection] : by_ratio) curve.add(nu, deflection);
                     })
                 .against(
                     "cubic triangles",
                     [](Curve& curve) {
                         for (const auto& [nu, deflection] : converged_membrane) curve.add(nu, deflection);
                     },
                     true)
                 .measures("deflection u_y")
                 .when(bent)};
}

void PoissonLesson::declare_checks() {
    const auto after_a_step = [this] { return !bends() && done() > 0; };
    assumptions = {
        assumption_of(
            "estimate good enough", "", [this] { return std::abs(linear_overestimate(poisson_ratio, reached())); },
            [] { return accurate; }, "|ν s / (1 − (1 + s)^(−ν)) − 1| ≤ 5 %",
            "ν ΔL/L is meant for small strain: it overestimates the narrowing of a pulled cube, and underestimates the "
            "widening of a pushed one")
            .otherwise("estimate too rough")
            .when(after_a_step)
            .mended_by([this] {
                const auto limit = strain_of_overestimate(std::max<Real>(poisson_ratio, -0.5), accurate);
                return fix_by(axial_strain, std::copysign(rounded_down(0.9 * limit.value_or(0.05), 2), axial_strain.value()));
            }),
        assumption_of(
            "enough steps", "",
            [this] {
                const Real law = exact_contraction(poisson_ratio, reached());
                return law == 0 ? Real{0} : std::abs(contractions_[done()] / law - 1);
            },
            [] { return accurate; }, "|ΔL′/L − exact| ≤ 5 % of it",
            "each step takes the strain over the length at its start: the error is of first order in the step")
            .otherwise("too few steps")
            .when(after_a_step)
            .mended_by([this] {
                const Index more = std::min<Index>(std::max<Index>(20, 4 * increments), 1000);
                return Fix{fmt::format("incremental, N = {}", more),
                           {{"method", "incremental"}, {"increments", std::to_string(more)}}};
            }),
        assumption_of(
            "no locking", "", [this] { return Real(poisson_ratio); }, [] { return locking_ratio; }, "ν ≤ 0.49",
            "linear triangles and tetrahedra cannot bend without changing their volume, so near ν = ½ they hardly bend at all; "
            "the stretched cube, whose strain is uniform, stays right")
            .otherwise("locking")
            .mended_by(fix_by(poisson_ratio, 0.45))};
}

std::vector<std::pair<std::string, std::string>> PoissonLesson::finer() const {
    if (bends()) return {{"membrane_cells", std::to_string(std::min<Index>(2 * membrane_cells, 32))}};
    return {{"method", "incremental"}, {"increments", std::to_string(std::min<Index>(4 * increments, 1000))}};
}

}  // namespace pliant::poisson
