// What the cube and the panel show: fields, probes and curves.
#include "poisson.h"

#include "contraction_law.h"
#include "membrane_table.h"

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
    const auto stretched = [this] { return !bends(); };
    const auto nodal = [&](std::string_view name, std::string_view symbol, const Points<3>& points, std::string_view help) {
        Field f = vector_field(name, symbol, "m", On::node, points, help);
        f.bound = [this] { return bends() ? largest_deflection : largest_displacement * length; };
        f.used = stretched;
        return f;
    };
    fields = {nodal("displacement", "u", displacement_, "of the cube or of the panel from the place at rest"),
              nodal("increment", "Δu", increment_, "of the latest step"),
              nodal("prescribed", "Δx", prescribed_, "by which the step moves the far face"),
              {.name = "element_volume",
               .symbol = "V/V₀",
               .on = On::element,
               .view = view_of(element_volumes_),
               .help = "volume of each tetrahedron over that at rest",
               .bound = [] { return largest_volume; },
               .used = stretched}};
    fields[0].used = {};
}

void PoissonLesson::declare_probes() {
    declare_stretch_probes();
    declare_bending_probes();
}

void PoissonLesson::declare_stretch_probes() {
    const auto add = [this](std::string_view name, std::string_view symbol, std::string_view help, std::function<Real()> value,
                            std::function<Real()> exact = {}) {
        Probe probe{.name = name, .symbol = symbol, .help = help, .value = {}};
        probe.value = [this, value]() -> std::optional<Real> { return bends() ? std::nullopt : std::optional<Real>(value()); };
        if (exact)
            probe.exact = [this, exact](Real) -> std::optional<Real> {
                return bends() ? std::nullopt : std::optional<Real>(exact());
            };
        probes.push_back(std::move(probe));
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
        probes.push_back({.name = name, .symbol = symbol, .help = help, .value = [this, share]() -> std::optional<Real> {
                              return bends() ? std::nullopt : strain_of_overestimate(poisson_ratio, share);
                          }});
    };
    where_off("strain_off_by_1_percent", "s(1 %)", "lengthening at which ν ΔL/L is 1 % above the narrowing", 0.01);
    where_off("strain_off_by_5_percent", "s(5 %)", "lengthening at which ν ΔL/L is 5 % above the narrowing", 0.05);
}

void PoissonLesson::declare_bending_probes() {
    const auto latest = [this]() -> std::optional<Real> {
        if (!bends() || done() == 0) return std::nullopt;
        return deflections_[done() - 1];
    };
    probes.push_back({.name = "deflection",
                      .symbol = "u_y",
                      .unit = "m",
                      .help = "of the middle of the panel's loaded edge; exact: converged values of cubic triangles",
                      .value = latest,
                      .exact = [this](Real) -> std::optional<Real> {
                          if (!bends() || done() == 0) return std::nullopt;
                          return converged_deflection(ratios()[static_cast<std::size_t>(done() - 1)]);
                      },
                      .explain =
                          [this] {
                              return Explanation{.formula = "u_y = u",
                                                 .inputs = {Input::now("u", "displacement", membrane_->tip(), 1)}};
                          }});
    probes.push_back({.name = "times_too_stiff",
                      .symbol = "u_ref/u",
                      .help = "converged deflection over that of these triangles: 1 is right, 3 is locked",
                      .value = [this] { return stiffness_ratio(); }});
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
    curve.position.clear(), curve.value.clear();
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
    const auto stretched = [this] { return !bends(); };
    lines = {{.name = "contraction",
              .position_name = "lengthening ΔL/L",
              .help = "narrowing of the cube, step by step, beside the law and the estimate",
              .sample = reached_so_far(contractions_),
              .reference = [this](Curve& c) { sample_law(exact_contraction, c); },
              .reference_name = "1 − (1 + ΔL/L)^(−ν)",
              .value_name = "narrowing ΔL′/L",
              .used = stretched,
              .others = {{.name = "ν ΔL/L", .sample = [this](Curve& c) { sample_law(linear_contraction, c); }}}},
             {.name = "volume_over_strain",
              .position_name = "lengthening ΔL/L",
              .help = "volume over that at rest; it stays 1 only for ν = ½",
              .sample = reached_so_far(volumes_),
              .reference = [this](Curve& c) { sample_law(exact_volume_ratio, c); },
              .reference_name = "(1 + ΔL/L)^(1 − 2ν)",
              .value_name = "volume V/V₀",
              .used = stretched,
              .others = {{.name = "with the estimate",
                          .sample =
                              [this](Curve& c) {
                                  sample_law([](Real nu, Real s) { return (1 + s) * (1 - nu * s) * (1 - nu * s); }, c);
                              }}}},
             {.name = "locking",
              .unit = "m",
              .position_name = "Poisson's ratio ν",
              .help = "deflection of the panel: the true one falls by a sixth up to ν = ½, that of linear triangles collapses",
              .sample =
                  [this](Curve& curve) {
                      const std::vector<Real> all = ratios();
                      std::vector<std::size_t> order(static_cast<std::size_t>(done()));
                      std::iota(order.begin(), order.end(), std::size_t{0});
                      std::ranges::sort(order, {}, [&](std::size_t k) { return all[k]; });
                      for (const std::size_t k : order) {
                          curve.position.push_back(all[k]);
                          curve.value.push_back(deflections_[static_cast<Index>(k)]);
                      }
                  },
              .reference =
                  [](Curve& curve) {
                      for (const auto& [nu, deflection] : converged_membrane) {
                          curve.position.push_back(nu);
                          curve.value.push_back(deflection);
                      }
                  },
              .reference_name = "cubic triangles",
              .value_name = "deflection u_y",
              .reference_points = true,
              .used = [this] { return bends(); }}};
}

}  // namespace pliant::poisson
