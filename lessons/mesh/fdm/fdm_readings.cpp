// Probes, and what is measured.
#include "fdm.h"

#include <pliant/solids/point_masses.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant::fdm {

std::string_view FdmLesson::error_probe() const {
    return is(GridShape::block) ? "u_y_top_middle" : is(GridShape::rod) ? "tip" : "nodal_error";
}

ColourBy FdmLesson::first_colours() const {
    switch (GridShape(setting)) {
        case GridShape::rod:
            return {"strain", 0};
        case GridShape::block:
            return {"stress", 3};
        case GridShape::manufactured:
        case GridShape::disc:
            break;
    }
    return {"displacement", -1};
}

std::vector<std::string_view> FdmLesson::first_plots() const {
    if (is(GridShape::rod)) return {"displacement_profile", "tip", "energy"};
    if (is(GridShape::block)) return {"side_profile", "u_y_top_middle", "energy"};
    if (has_exact()) return {"error_by_spacing", "displacement_profile"};
    return {"displacement_profile"};
}

std::vector<std::string_view> FdmLesson::key_numbers() const {
    if (is(GridShape::rod)) return {"tip", "frequency", "stable_time_step"};
    if (is(GridShape::block)) return {"u_y_top_middle", "u_x_corner", "u_y_corner"};
    if (has_exact()) return {"nodal_error", "finite_elements_error", "observed_order"};
    return {"largest_strain"};
}

// ---------------------------------------------------------------------------------------------------------------- probes

void FdmLesson::declare_probes() {
    const auto in_rod = [this] { return is(GridShape::rod); };
    const auto in_block = [this] { return is(GridShape::block); };
    const auto in_motion = [this] { return moves(); };
    const auto done = [this] { return !moves() && solved() && has_exact(); };
    const auto of_energy = [](std::string_view name, std::string_view symbol, std::string_view help,
                              std::function<Real()> value) { return probe_of(name, symbol, "J/m", help, std::move(value)); };
    probes = {
        probe_of("tip", "u_L", "m", "of the free end of the rod; exact: a triangle wave of the period 4L/c",
                 [this] { return tip(); })
            .exactly([this](Real t) { return linear() ? std::optional(released().displacement(length, t)) : std::nullopt; })
            .when(in_rod),
        probe_of("u_y_top_middle", "", "m", "of the middle of the block's top", [this] { return top_displacement().y(); })
            .when(in_block),
        probe_of("u_x_corner", "", "m", "of the block's upper right corner", [this] { return corner_displacement().x(); })
            .when(in_block),
        probe_of("u_y_corner", "", "m", "of the block's upper right corner", [this] { return corner_displacement().y(); })
            .when(in_block),
        probe_of("nodal_error", "", "m", "largest component of u − u_exact at a node", [this] { return nodal_error(); })
            .when([this, done] { return is(GridShape::rod) ? linear() : done(); }),
        probe_of("relative_error", "", "", "the largest error at a node over the largest exact displacement",
                 [this]() -> std::optional<Real> {
                     const Real size = largest_exact();
                     return size > 0 ? std::optional(nodal_error() / size) : std::nullopt;
                 })
            .when(done),
        of_energy("energy", "E", "kinetic, elastic, and of the weight; for 1 m of depth", [this] { return total_energy(); })
            .exactly([this](Real) { return damped() || pulled() ? std::nullopt : std::optional(start_energy_); })
            .when(in_motion),
        of_energy("elastic_energy", "U", "of the stress in the body, for 1 m of depth", [this] { return elastic_energy(); }),
        of_energy("kinetic_energy", "T", "½ Σ m v²", [this] { return kinetic_energy(); }).when(in_motion),
        of_energy("load_energy", "W", "−Σ V b·u: 0 where the body is at rest without load", [this] { return load_energy(); })
            .when([this] { return loaded(); }),
        probe_of("momentum_x", "p_x", "N s/m", "Σ m v along x; supports take it and give it back", [this] { return momentum(0); })
            .when(in_motion),
        probe_of("momentum_y", "p_y", "N s/m", "Σ m v along y", [this] { return momentum(1); }).when(in_motion),
        probe_of("largest_strain", "", "", "largest entry of the strain", [this] { return largest_strain(); }),
    };
}

void FdmLesson::declare_measured_probes() {
    const auto in_motion = [this] { return moves(); };
    const auto done = [this] { return !moves() && solved() && has_exact(); };
    const std::vector<Probe> more{
        probe_of("stable_time_step", "Δt_max", "s",
                 "Δx/√(c_p² + c_s²): the longest step for waves inside, by which none passes more than a cell; of a rod Δx/c")
            .formula(*this, "Δt_max = Δx / √(c_p² + c_s²)",
                     {why_spacing(),
                      Input::live("c_p", "m/s", "speed of pressure waves, √((λ + 2μ)/ρ); of a rod √(Y/ρ)",
                                  [this] { return pressure_wave_speed(); }),
                      Input::live("c_s", "m/s", "speed of shear waves, √(μ/ρ); a rod has none",
                                  [this] { return std::sqrt(material().mu / density); })}),
        probe_of("longest_step", "", "s",
                 "that the integrator bears on this body: by its fastest motion, edges and supports counted",
                 [this] {
                     const Real step = longest_step();
                     return std::isfinite(step) ? std::optional(step) : std::nullopt;
                 })
            .when(in_motion),
        probe_of("frequency", "f₁", "Hz", "of the tip, over its latest periods; exact: c/(4L)",
                 [this]() -> std::optional<Real> {
                     const auto period = rhythm_.period();
                     return period ? std::optional(1 / *period) : std::nullopt;
                 })
            .exactly([this](Real) { return linear() ? std::optional(released().frequency(1)) : std::nullopt; })
            .when([this] { return is(GridShape::rod); }),
        probe_of("force_sum", "|Σ V f|", "N/m", "what the stress pulls the body as a whole with: nothing",
                 [this] { return Vec<2>((force_ * grid().volumes().asDiagonal()).rowwise().sum()).norm(); }),
        probe_of("stencil_difference", "", "N/m³",
                 "largest difference between the difference formula and differences of the stress",
                 [this] { return stencil_difference(); })
            .when([this] { return linear(); }),
        probe_of("finite_elements_error", "", "m", "largest error at a node of linear finite elements, as many along the body",
                 [this]() -> std::optional<Real> {
                     const FemBeside* elements = beside();
                     return elements ? std::optional(elements->error) : std::nullopt;
                 })
            .when(done),
        probe_of("observed_order", "p", "", "log₂ of the error at half the resolution over that at this one",
                 [this] { return observed_order(); })
            .when(done),
    };
    probes.insert(probes.end(), more.begin(), more.end());
}

// ------------------------------------------------------------------------------------------------------- what is measured

Vec<2> FdmLesson::exact_at(Index node) const {
    const Vec<2> X = grid().positions().col(node);
    if (is(GridShape::rod)) return {released().displacement(X.x(), clock_[elapsed]), 0};
    return body().exact(X);
}

Real FdmLesson::nodal_error() const {
    Real worst = 0;
    for (Index k = 0; k < displacement_.cols(); ++k)
        worst = std::max(worst, (displacement_.col(k) - exact_at(k)).cwiseAbs().maxCoeff());
    return worst;
}

Real FdmLesson::largest_exact() const {
    Real largest = 0;
    for (Index k = 0; k < displacement_.cols(); ++k) largest = std::max(largest, exact_at(k).cwiseAbs().maxCoeff());
    return largest;
}

Real FdmLesson::kinetic_energy() const {
    if (!moves()) return 0;
    return rows() * 0.5 * density * (velocity_.colwise().squaredNorm() * grid().volumes()).value();
}

Real FdmLesson::load_energy() const {
    if (!loaded()) return 0;
    return -problem_->nodal_force().cwiseProduct(displacement_).sum();
}

Real FdmLesson::momentum(int axis) const { return rows() * density * (velocity_.row(axis) * grid().volumes()).value(); }

Real FdmLesson::largest_strain() const { return strain_.size() > 0 ? strain_.cwiseAbs().maxCoeff() : Real{0}; }

// Of the free components at nodes with all neighbours.
Real FdmLesson::stencil_difference() const { return (stencil_force_ - force_).cwiseAbs().maxCoeff(); }

// Of what cancels in the differences of stress, or in second differences of the displacement.
Real FdmLesson::force_rounding() const {
    constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
    const Lame m = material();
    return 64 * epsilon * (m.lambda + 2 * m.mu) * displacement_.cwiseAbs().maxCoeff() / (spacing() * spacing());
}

Vec<2> FdmLesson::corner_displacement() const {
    const int n = static_cast<int>(Index(resolution));
    return displacement_.col(grid().node_at({n, n}));
}

// Between two nodes where none lies in the middle.
Vec<2> FdmLesson::top_displacement() const {
    const int n = static_cast<int>(Index(resolution));
    return 0.5 * (displacement_.col(grid().node_at({n / 2, n})) + displacement_.col(grid().node_at({(n + 1) / 2, n})));
}

Real FdmLesson::tip() const { return displacement_(0, grid().node_at({static_cast<int>(Index(resolution)), 0})); }

// Swings that rounding would hide are none.
void FdmLesson::note_swing() {
    if (!is(GridShape::rod)) return;
    const Real swing = std::abs(start_strain) * length;
    rhythm_.note(clock_[elapsed], tip(), swing > 1e-12 * length ? 1e-3 * swing : 0);
}

// -------------------------------------------------------------------------------------------------------- what takes a solve

FdmLesson::Body FdmLesson::body_key(Index cells) const {
    const GridBody b = body_at(cells);
    return {setting, form, cells, b.youngs_modulus, b.poisson_ratio, b.length, b.body_force, b.amplitude};
}

const FemBeside* FdmLesson::beside() const {
    constexpr Index most = 64;  // a lecture does not wait for more
    if (is(GridShape::rod) || (!is(GridShape::block) && resolution > most)) return nullptr;
    const auto& found =
        beside_.of(body_key(is(GridShape::block) ? Index{1} : Index(resolution)), [this]() -> std::optional<FemBeside> {
            try {
                return finite_elements_beside(body());
            } catch (const Diverged&) {
                return std::nullopt;
            }
        });
    return found ? &*found : nullptr;
}

std::optional<Real> FdmLesson::error_at(Index cells) const try {
    const GridProblem problem(body_at(cells));
    return problem.error(problem.equilibrium());
} catch (const Diverged&) {
    return std::nullopt;
}

std::optional<Real> FdmLesson::observed_order() const {
    if (resolution < 4 || resolution % 2 != 0) return std::nullopt;
    const auto& coarse = coarse_error_.of(body_key(resolution / 2), [this] { return error_at(resolution / 2); });
    const Real fine = nodal_error();
    if (!coarse || !(fine > 1e-12 * largest_exact())) return std::nullopt;
    return std::log2(*coarse / fine);
}

}  // namespace pliant::fdm
