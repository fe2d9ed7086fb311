// What is shown and watched: fields, probes, the residuals of the solvers, and where the projection holds.
#include "projection.h"

#include <pliant/fluids/diagnostics.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::projection {
namespace {

// No accepted parameters come near it.
constexpr Real largest = 1e15;
// More divergence left than this share, and the loss of volume is seen.
constexpr Real loose = 1e-2;

}  // namespace

void Projection::declare_fields() {
    state = {state_array("tally", "", tally_)};  // each projection begins anew from the given field
    const auto on_faces = [this] { return staggered(); };
    const auto in_cells = [this] { return !staggered(); };
    fields = {
        plane_vector_field("velocity", "u", "m/s", On::cell, centre_,
                           "at cell centres; on a staggered grid the mean of the two faces across each axis, where it is stored")
            .follows({"u_on_faces", "v_on_faces", "u_in_cells", "v_in_cells"},
                     [this](const Question& q) { return why_velocity(q); }),
        scalar_field("pressure", "p", "m²/s²", On::cell, pressure_,
                     "kinematic pressure p/ρ, of mean 0: what turns the given velocity into one without divergence")
            .of_both_signs(),
        scalar_field("divergence_before", "∇·ũ", "1/s", On::cell, before_,
                     "of the given velocity: what flows out of each cell, per area")
            .of_both_signs(),
        scalar_field("divergence_after", "∇·u", "1/s", On::cell, after_,
                     "of the velocity that is left; after a pass of the solver, that which the pressure so far would leave")
            .of_both_signs(),
        plane_vector_field("gradient_part", "Δt ∇p", "m/s", On::cell, gradient_,
                           "the part of the given velocity that is a gradient, and is taken out"),
        plane_vector_field("solenoidal_part", "s", "m/s", On::cell, solenoidal_,
                           "the part without divergence; in a periodic box without its mean"),
        scalar_field("u_on_faces", "u", "m/s", On::x_face, velocity_[0],
                     "x component, where it is stored: on the upright faces of the cells")
            .of_both_signs()
            .when(on_faces),
        scalar_field("v_on_faces", "v", "m/s", On::y_face, velocity_[1],
                     "y component, where it is stored: on the level faces of the cells")
            .of_both_signs()
            .when(on_faces),
        scalar_field("u_in_cells", "u", "m/s", On::cell, central_[0], "x component, stored at cell centres")
            .of_both_signs()
            .when(in_cells),
        scalar_field("v_in_cells", "v", "m/s", On::cell, central_[1], "y component, stored at cell centres")
            .of_both_signs()
            .when(in_cells)};
    for (Field& f : fields) f = f.stops_at(largest);
}

// -------------------------------------------------------------------------------------------------------------- probes

Index Projection::selected_cell() const {
    const auto along = [this](Real place) {
        return std::clamp<Index>(static_cast<Index>(place * resolution.value()), 0, resolution - 1);
    };
    return grid_->cells().index({along(cell_x), along(cell_y)});
}

// The inflow on the left less the outflow on the right, as far as there are fluid cells behind the walls.
Real Projection::net_inflow() const {
    Real net = 0;
    for (const Index face : grid_->closed_faces(0)) {
        const bool right = grid_->cell_beside(0, face, 1) < 0;
        if (right || grid_->cell_beside(0, face, 0) < 0) net += (right ? -1 : 1) * velocity_[0][face] * dx();
    }
    return net;
}

void Projection::declare_probes() {
    probes = {
        grid2d::largest_probe("max_divergence_before", "max|∇·ũ|", "1/s", "what the projection was given", before_,
                              "divergence_before"),
        grid2d::largest_probe("max_divergence", "max|∇·u|", "1/s", "what it leaves", after_, "divergence_after"),
        probe_of("solver_iterations", "", "", "passes of the pressure solver", [this] { return tally_[passes]; })
            .once("iterations"),
        probe_of("kinetic_energy_before", "ẽ", "J/kg", "½|ũ|² per mass, mean over the fluid",
                 [this] { return tally_[energy_given]; }),
        probe_of(
            "kinetic_energy", "e", "J/kg", "½|u|² per mass, mean over the fluid; walls at rest can only take energy out",
            [this] { return specific_energy(); }, [this] { return why_energy(); }),
        probe_of("energy_left", "e/ẽ", "", "share of the kinetic energy that the projection leaves")
            .formula(*this, "e/ẽ = e / ẽ", {Input::now("e", "kinetic_energy", 0), Input::now("ẽ", "kinetic_energy_before", 0)})
            .when([this] { return tally_[energy_given] > 0; }),
        probe_of("orthogonality", "⟨Δt∇p, u⟩/⟨ũ, ũ⟩", "",
                 "0: what was taken out is at right angles to what is left, so that the energies of the two add up",
                 [this] { return tally_[overlap]; }),
        probe_of("net_inflow", "", "m²/s",
                 "through the walls, per metre of depth; a pressure exists only if it is 0 in every closed region",
                 [this] { return net_inflow(); })
            .when([this] { return walls_move(); }),
        probe_of("null_dimension", "", "",
                 "how many pressures the grid cannot tell from none: the constant of each region; on a periodic collocated grid "
                 "three checkerboards more",
                 [this] { return static_cast<Real>(invisible_count()); }),
        probe_of(
            "cell_divergence", "∇·u of the cell", "1/s", "of the velocity now, in the cell that is drawn large",
            [this] {
                VecX now;
                divergence_of(now);
                return now[selected_cell()];
            },
            [this] { return why_divergence(selected_cell(), Input::From::now); }),
        probe_of(
            "cell_pressure", "p of the cell", "m²/s²", "", [this] { return pressure_[selected_cell()]; },
            [this]() -> Explanation {
                return {"p_cell = p   (of the cell that is drawn large)", {Input::now("p", "pressure", selected_cell())}};
            })};
}

// --------------------------------------------------------------------------------------------------------------- lines

void Projection::sample_history(Curve& curve, PressurePreconditioner which, Index most) const {
    curve = {};
    for (const Real left : histories_.of(which)) {
        if (static_cast<Index>(curve.value.size()) >= most) return;
        curve.position.push_back(static_cast<Real>(curve.value.size() + 1));
        curve.value.push_back(left);
    }
}

void Projection::declare_lines() {
    constexpr Index all = 1 << 30;
    lines = {
        line_of("residual", "", "iteration", "",
                "largest divergence left over the largest before, after each pass so far of the solver that is chosen; beside it "
                "all four in full, on the same field, each in a colour of its own. CG: conjugate gradients, without or with a "
                "preconditioner",
                [this](Curve& curve) { sample_history(curve, solver, static_cast<Index>(tally_[passes])); })
            .measures("max|∇·u| / max|∇·ũ|")
            .on_log_axes()};
    constexpr std::array<std::string_view, SolverHistories::solver_count> names{"CG", "CG, Jacobi", "CG, incomplete Cholesky",
                                                                                "CG, multigrid"};
    for (std::size_t k = 0; k < SolverHistories::solver_count; ++k)
        lines[0].others.push_back({.name = names[k], .sample = [this, k](Curve& curve) {
                                       const auto which = static_cast<PressurePreconditioner>(k);
                                       sample_history(curve, which, staggered() ? all : 0);
                                   }});
}

// -------------------------------------------------------------------------------------------------- assumptions and laws

void Projection::declare_checks() {
    assumptions = {assumption_of(
                       "balanced flux", "m²/s", [this] { return std::abs(net_inflow()); },
                       [this] { return 1e-10 * std::abs(speed); }, "|inflow − outflow| ≤ 10⁻¹⁰ |inflow|",
                       "more flows in than out: no velocity without divergence fits the walls, and no pressure exists")
                       .otherwise("unbalanced flux")
                       .when([this] { return walls_move() && grid_->fluid_cells() > 0; })
                       .mended_by(fix_by(outflow, 1)),
                   assumption_of(
                       "pressures that the grid does not see", "", [this] { return static_cast<Real>(invisible_count()); },
                       [] { return Real{1}; }, "dim ker ∇ ≤ 1",
                       "a checkerboard of the pressure has no gradient on this grid, and one of the velocity no divergence: "
                       "it is never found and never removed")
                       .otherwise("pressures that the grid does not see")
                       .when([this] { return !staggered(); })
                       .mended_by(Fix{"staggered grid", {{"grid", "staggered"}}}),
                   assumption_of(
                       "solver tolerance", "", [this] { return Real(tolerance); }, [] { return loose; }, "τ ≤ 0.01",
                       "so much divergence is left that the fluid loses or gains volume where one looks")
                       .otherwise("loose solver tolerance")
                       .mended_by(Fix{"τ = 10⁻⁶", {{"tolerance", "1e-6"}}})};
    conserved = {
        {"max_divergence", Law::zero,
         [this] {
             const Real fastest = std::max(max_speed(tentative_), centre_.cwiseAbs().maxCoeff());
             return tolerance * tally_[initial] * (1 + 1e-6) + 1e-12 * fastest / dx();
         },
         [this] { return tally_[done] != 0; }},
        {"kinetic_energy", Law::never_grows, [this] { return 1e-12 * tally_[energy_given]; }, [this] { return !walls_move(); }},
        {"orthogonality", Law::zero, [] { return 1e-10; }, [this] { return tally_[done] != 0 && !walls_move(); }}};
}

// --------------------------------------------------------------------------------------------------- what would mend it

std::optional<Fix> Projection::fix(const Failure& failure) const {
    if (failure.field == "velocity") {
        if (outflow == 1 && solids() != Obstacle::none) return Fix{"no obstacle", {{"obstacle", "none"}}};
        return fix_by(outflow, 1);
    }
    if (staggered() && solver != PressurePreconditioner::multigrid && max_iterations >= 20)
        return Fix{"multigrid", {{"solver", "multigrid"}}};
    return Fix{"1000 iterations, τ = 10⁻⁶", {{"max_iterations", "1000"}, {"tolerance", "1e-6"}}};
}

std::string Projection::blow_up_hint() const {
    return fmt::format(
        "The equation is linear, so that only its parameters can make the pressure large: take a speed below {} and a time step "
        "above {}",
        format_quantity(1e3, "m/s"), format_quantity(1e-6, "s"));
}

}  // namespace pliant::projection
