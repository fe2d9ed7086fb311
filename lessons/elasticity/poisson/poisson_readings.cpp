// What cube and panel show: fields, probes, curves, where the laws hold, and what mends a run.
#include "poisson.h"

#include <pliant/continuum/contraction_law.h>
#include <pliant/solids/cooks_membrane_table.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pliant::poisson {
namespace {

// In lengths of the cube, beyond any that the parameters allow.
constexpr Real largest_displacement = 1e4;
// Over those at rest: at ν near −1 a stretch of a hundred lengths widens as much, in three directions.
constexpr Real largest_volume = 1e9;
// The panel under its unit force; locked or not, it moves by about 20 m.
constexpr Real largest_deflection = 1e4;

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
    const auto nodal = [this](std::string_view name, std::string_view symbol, const Points<3>& points, std::string_view help) {
        return vector_field(name, symbol, "m", On::node, points, help).stops_at([this] {
            return bends() ? largest_deflection : largest_displacement * length;
        });
    };
    fields = {
        nodal("displacement", "u", displacement_, "of the cube or of the panel from the place at rest"),
        nodal("increment", "Δu", increment_, "of the latest step").when(stretched()),
        nodal("prescribed", "Δx", prescribed_, "by which the step moves the far face").when(stretched()),
        scalar_field("element_volume", "V/V₀", "", On::element, element_volumes_, "volume of each tetrahedron over that at rest")
            .stops_at(largest_volume)
            .when(stretched())};
}

void PoissonLesson::declare_probes() {
    const auto add = [this](std::string_view name, std::string_view symbol, std::string_view help, std::function<Real()> value,
                            std::function<Real()> exact = {}) {
        Probe probe = probe_of(name, symbol, "", help, [value] { return value(); });
        if (exact) probe.exact = [exact](Real) { return exact(); };
        probes.push_back(probe.when(stretched()));
    };
    add(
        "transverse_fem", "ΔL′/L", "narrowing of the computed cube; exact: 1 − (1 + ΔL/L)^(−ν)",
        [this] { return contractions_[done()]; }, [this] { return exact_contraction(poisson_ratio, reached()); });
    add("transverse_exact", "1 − (1+s)^(−ν)", "narrowing by the lecture's law",
        [this] { return exact_contraction(poisson_ratio, reached()); });
    add("transverse_linear", "ν ΔL/L", "narrowing by the estimate ν ≈ ΔL′/ΔL",
        [this] { return linear_contraction(poisson_ratio, reached()); });
    add("transverse_error", "|fem − exact|", "of the computed narrowing; halves when the number of steps is doubled",
        [this] { return std::abs(contractions_[done()] - exact_contraction(poisson_ratio, reached())); });
    add(
        "strain", "ΔL/L", "lengthening of the computed cube", [this] { return strains_[done()]; }, [this] { return reached(); });
    add(
        "volume_ratio", "V/V₀", "of the computed cube; exact: (1 + ΔL/L)^(1 − 2ν)", [this] { return volumes_[done()]; },
        [this] { return exact_volume_ratio(poisson_ratio, reached()); });
    const auto where_off = [this](std::string_view name, std::string_view symbol, std::string_view help, Real share) {
        probes.push_back(probe_of(name, symbol, "", help, [this, share] {
                             return strain_of_overestimate(poisson_ratio, share);
                         }).when(stretched()));
    };
    where_off("strain_off_by_1_percent", "s(1 %)", "lengthening at which ν ΔL/L is 1 % above the narrowing", 0.01);
    where_off("strain_off_by_5_percent", "s(5 %)", "lengthening at which ν ΔL/L is 5 % above the narrowing", 0.05);
    const auto bent = [this] { return bends() && done() > 0; };
    probes.push_back(probe_of(
                         "deflection", "u_y", "m",
                         "of the middle of the panel's loaded edge; exact: converged values of cubic triangles",
                         [this] { return deflections_[done() - 1]; },
                         [this] {
                             return Explanation{"u_y = u", {Input::now("u", "displacement", membrane_->tip(), 1)}};
                         })
                         .exactly([this](Real) { return converged_deflection(ratios()[static_cast<std::size_t>(done() - 1)]); })
                         .when(bent));
    probes.push_back(probe_of("times_too_stiff", "u_ref/u", "",
                              "converged deflection over that of these triangles: 1 is right, 3 is locked",
                              [this] { return stiffness_ratio(); }));
}

std::optional<Real> PoissonLesson::stiffness_ratio() const {
    if (!bends() || done() == 0) return std::nullopt;
    const auto right = converged_deflection(ratios()[static_cast<std::size_t>(done() - 1)]);
    if (!right) return std::nullopt;
    return *right / deflections_[done() - 1];
}

// From rest to the end that was asked for.
void PoissonLesson::sample_law(Real (*law)(Real nu, Real strain), Curve& curve) const {
    constexpr int samples = 60;
    for (int k = 0; k <= samples; ++k) {
        curve.position.push_back(axial_strain * k / samples);
        curve.value.push_back(law(poisson_ratio, curve.position.back()));
    }
}

void PoissonLesson::declare_lines() {
    const auto reached_so_far = [this](const VecX& values) {
        return [this, &values](Curve& curve) {
            curve.position.assign(strains_.data(), strains_.data() + done() + 1);
            curve.value.assign(values.data(), values.data() + done() + 1);
        };
    };
    lines = {line_of("contraction", "", "lengthening ΔL/L", "",
                     "narrowing of the cube, step by step, beside the law and the estimate", reached_so_far(contractions_))
                 .against("1 − (1 + ΔL/L)^(−ν)", [this](Curve& c) { sample_law(exact_contraction, c); })
                 .beside({{"ν ΔL/L", [this](Curve& c) { sample_law(linear_contraction, c); }}})
                 .measures("narrowing ΔL′/L")
                 .when(stretched()),
             line_of("volume_over_strain", "", "lengthening ΔL/L", "", "volume over that at rest; it stays 1 only for ν = ½",
                     reached_so_far(volumes_))
                 .against("(1 + ΔL/L)^(1 − 2ν)", [this](Curve& c) { sample_law(exact_volume_ratio, c); })
                 .beside({{"with the estimate",
                           [this](Curve& c) {
                               sample_law([](Real nu, Real s) { return (1 + s) * (1 - nu * s) * (1 - nu * s); }, c);
                           }}})
                 .measures("volume V/V₀")
                 .when(stretched()),
             line_of("locking", "m", "Poisson's ratio ν", "",
                     "deflection of the panel: the true one falls by a sixth up to ν = ½, that of linear triangles collapses",
                     [this](Curve& curve) {
                         const std::vector<Real> all = ratios();
                         std::vector<std::size_t> order(static_cast<std::size_t>(done()));
                         std::iota(order.begin(), order.end(), std::size_t{0});
                         std::ranges::sort(order, {}, [&](std::size_t k) { return all[k]; });
                         for (const std::size_t k : order) {
                             curve.position.push_back(all[k]);
                             curve.value.push_back(deflections_[static_cast<Index>(k)]);
                         }
                     })
                 .against(
                     "cubic triangles",
                     [](Curve& curve) {
                         for (const auto& [nu, deflection] : converged_membrane) {
                             curve.position.push_back(nu);
                             curve.value.push_back(deflection);
                         }
                     },
                     true)
                 .measures("deflection u_y")
                 .when([this] { return bends(); })};
}

// Where the laws of the cube and the elements of the panel hold, and what mends a run.

namespace {

// Of the narrowing, that an estimate may be off.
constexpr Real accurate = 0.05;
// Linear triangles and tetrahedra lock above it wherever the strain is not uniform.
constexpr Real locking_ratio = 0.49;

}  // namespace

void PoissonLesson::declare_checks() {
    const auto small_strain = [this]() -> std::optional<Fix> {
        const auto limit = strain_of_overestimate(std::max<Real>(poisson_ratio, -0.5), accurate);
        const Real strain = std::copysign(rounded_down(0.9 * limit.value_or(0.05), 2), axial_strain.value());
        return Fix{fmt::format("ΔL/L = {}", format_quantity(strain, "")), {{"axial_strain", format_exact(strain)}}};
    };
    assumptions = {
        assumption_of(
            "estimate good enough", "", [this] { return std::abs(linear_overestimate(poisson_ratio, reached())); },
            [] { return accurate; }, "|ν s / (1 − (1 + s)^(−ν)) − 1| ≤ 5 %",
            "ν ΔL/L is meant for small strain: it overestimates the narrowing of a pulled cube, and underestimates the "
            "widening of a pushed one")
            .when([this] { return !bends() && done() > 0; })
            .mended_by(small_strain),
        assumption_of(
            "enough steps", "",
            [this] {
                const Real law = exact_contraction(poisson_ratio, reached());
                return law == 0 ? Real{0} : std::abs(contractions_[done()] / law - 1);
            },
            [] { return accurate; }, "|ΔL′/L − exact| ≤ 5 % of it",
            "each step takes the strain over the length at its start: the error is of first order in the step")
            .when([this] { return !bends() && done() > 0; })
            .mended_by([this]() -> std::optional<Fix> {
                const Index more = std::min<Index>(std::max<Index>(20, 4 * increments), 1000);
                return Fix{fmt::format("incremental, N = {}", more),
                           {{"method", "incremental"}, {"increments", std::to_string(more)}}};
            }),
        assumption_of(
            "no locking", "", [this] { return Real(poisson_ratio); }, [] { return locking_ratio; }, "ν ≤ 0.49",
            "linear triangles and tetrahedra cannot bend without changing their volume, so near ν = ½ they hardly bend at all; "
            "the stretched cube, whose strain is uniform, stays right")
            .mended_by([]() -> std::optional<Fix> {
                return Fix{"ν = 0.45", {{"poisson_ratio", "0.45"}}};
            })};
}

std::optional<Fix> PoissonLesson::fix(const Failure&) const { return Fix{"ν = 0.3", {{"poisson_ratio", "0.3"}}}; }

std::vector<std::pair<std::string, std::string>> PoissonLesson::finer() const {
    if (bends()) return {{"membrane_cells", std::to_string(std::min<Index>(2 * membrane_cells, 32))}};
    return {{"method", "incremental"}, {"increments", std::to_string(std::min<Index>(4 * increments, 1000))}};
}

}  // namespace pliant::poisson
