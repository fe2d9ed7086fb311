// What is shown and watched: fields, probes, the residuals of the solvers, and where the projection holds.
#include "fluids/flow/flow_fields.h"
#include "projection.h"

#include <pliant/fluids/diagnostics.h>
#include <pliant/text/format.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace pliant::projection {
namespace {

// No accepted parameters come near it.
constexpr Real largest = 1e15;
// More divergence left than this share, and the loss of volume is seen.
constexpr Real loose = 1e-2;

}  // namespace

void Projection::declare_state() {
    state = {state_array("tally", "", tally_)};  // each projection begins anew from the given field
}

void Projection::declare_fields() {
    const auto on_faces = [this] { return staggered(); };
    const auto in_cells = [this] { return !staggered(); };
    const auto vector = [](Field field) {
        field.rank = Rank::vector, field.components = 2;
        return field;
    };
    fields = {
        vector({.name = "velocity",
                .symbol = "u",
                .unit = "m/s",
                .on = On::cell,
                .view = view_of(centre_),
                .help = "at cell centres; on a staggered grid the mean of the two faces across each axis, where it is stored",
                .defined_by = {"u_on_faces", "v_on_faces", "u_in_cells", "v_in_cells"},
                .explain = [this](const Question& q) { return why_velocity(q); }}),
        scalar_field("pressure", "p", "m²/s²", On::cell, pressure_,
                     "kinematic pressure p/ρ, of mean 0: what turns the given velocity into one without divergence"),
        scalar_field("divergence_before", "∇·ũ", "1/s", On::cell, before_,
                     "of the given velocity: what flows out of each cell, per area"),
        scalar_field("divergence_after", "∇·u", "1/s", On::cell, after_,
                     "of the velocity that is left; after a pass of the solver, that which the pressure so far would leave"),
        vector(scalar_field("gradient_part", "Δt ∇p", "m/s", On::cell, gradient_,
                            "the part of the given velocity that is a gradient, and is taken out")),
        vector(scalar_field("solenoidal_part", "s", "m/s", On::cell, solenoidal_,
                            "the part without divergence; in a periodic box without its mean")),
        scalar_field("u_on_faces", "u", "m/s", On::x_face, velocity_[0],
                     "x component, where it is stored: on the upright faces of the cells"),
        scalar_field("v_on_faces", "v", "m/s", On::y_face, velocity_[1],
                     "y component, where it is stored: on the level faces of the cells"),
        scalar_field("u_in_cells", "u", "m/s", On::cell, central_[0], "x component, stored at cell centres"),
        scalar_field("v_in_cells", "v", "m/s", On::cell, central_[1], "y component, stored at cell centres")};
    for (Field& f : fields) {
        f.bound = [] { return largest; };
        if (f.on == On::x_face || f.on == On::y_face) f.used = on_faces;
        if (f.name == "u_in_cells" || f.name == "v_in_cells") f.used = in_cells;
    }
}

// -------------------------------------------------------------------------------------------------------------- probes

Real Projection::fluid_area() const { return grid_->cell_volume() * static_cast<Real>(grid_->fluid_cells()); }

Real Projection::specific_energy() const {
    if (grid_->fluid_cells() == 0) return 0;
    if (staggered()) return kinetic_energy(*grid_, velocity_) / fluid_area();
    return 0.5 * centre_.squaredNorm() * dx() * dx() / fluid_area();
}

Index Projection::selected_cell() const {
    const auto along = [this](Real place) {
        return std::clamp<Index>(static_cast<Index>(place * static_cast<Real>(Index(resolution))), 0, resolution - 1);
    };
    return grid_->cells().index({along(cell_x), along(cell_y)});
}

// Of how many pressures does the gradient of the grid see nothing?
Index Projection::invisible_count() const {
    if (staggered()) return projection_->regions().count();
    return static_cast<Index>(invisible_pressures(grid_->cells()).size());
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
        {.name = "max_divergence_before",
         .symbol = "max|∇·ũ|",
         .unit = "1/s",
         .help = "what the projection was given",
         .value = [this] { return before_.lpNorm<Eigen::Infinity>(); },
         .explain = [this] { return flow::largest("max|∇·ũ|", before_, "divergence_before"); }},
        {.name = "max_divergence",
         .symbol = "max|∇·u|",
         .unit = "1/s",
         .help = "what it leaves",
         .value = [this] { return after_.lpNorm<Eigen::Infinity>(); },
         .explain = [this] { return flow::largest("max|∇·u|", after_, "divergence_after"); }},
        {.name = "iterations", .help = "passes of the pressure solver", .value = [this] { return tally_[passes]; }},
        {.name = "kinetic_energy_before",
         .symbol = "ẽ",
         .unit = "J/kg",
         .help = "½|ũ|² per mass, mean over the fluid",
         .value = [this] { return tally_[energy_given]; }},
        {.name = "kinetic_energy",
         .symbol = "e",
         .unit = "J/kg",
         .help = "½|u|² per mass, mean over the fluid; walls at rest can only take energy out",
         .value = [this] { return specific_energy(); },
         .explain = [this] { return why_energy(); }},
        {.name = "energy_left",
         .symbol = "e/ẽ",
         .help = "share of the kinetic energy that the projection leaves",
         .value = [this]() -> std::optional<Real> {
             if (!(tally_[energy_given] > 0)) return std::nullopt;
             return specific_energy() / tally_[energy_given];
         },
         .explain =
             [] {
                 return Explanation{"e/ẽ = e / ẽ",
                                    {Input::now("e", "kinetic_energy", 0), Input::now("ẽ", "kinetic_energy_before", 0)}};
             }},
        {.name = "orthogonality",
         .symbol = "⟨Δt∇p, u⟩/⟨ũ, ũ⟩",
         .help = "0: what was taken out is at right angles to what is left, so that the energies of the two add up",
         .value = [this] { return tally_[overlap]; }},
        {.name = "net_inflow",
         .unit = "m²/s",
         .help = "through the walls, per metre of depth; a pressure exists only if it is 0 in every closed region",
         .value = [this]() -> std::optional<Real> { return walls_move() ? std::optional(net_inflow()) : std::nullopt; }},
        {.name = "null_dimension",
         .help = "how many pressures the grid cannot tell from none: the constant of each region; on a periodic collocated grid "
                 "three checkerboards more",
         .value = [this] { return static_cast<Real>(invisible_count()); }},
        {.name = "cell_divergence",
         .symbol = "∇·u of the cell",
         .unit = "1/s",
         .help = "of the velocity now, in the cell that is drawn large",
         .value =
             [this] {
                 VecX div;
                 if (staggered())
                     divergence(*grid_, velocity_, div);
                 else
                     central_divergence(grid_->cells(), dx(), centre_, div);
                 return div[selected_cell()];
             },
         .explain = [this] { return why_divergence(selected_cell(), Input::From::now); }},
        {.name = "cell_pressure",
         .symbol = "p of the cell",
         .unit = "m²/s²",
         .value = [this] { return pressure_[selected_cell()]; },
         .explain =
             [this] {
                 return Explanation{"p_cell = p   (of the cell that is drawn large)",
                                    {Input::now("p", "pressure", selected_cell())}};
             }}};
}

// --------------------------------------------------------------------------------------------------------------- lines

void Projection::sample_history(Curve& curve, PressurePreconditioner which, Index most) const {
    curve.position.clear();
    curve.value.clear();
    for (const Real left : histories_.of(which)) {
        if (static_cast<Index>(curve.value.size()) >= most) return;
        curve.position.push_back(static_cast<Real>(curve.value.size() + 1));
        curve.value.push_back(left);
    }
}

void Projection::declare_lines() {
    constexpr Index all = 1 << 30;
    lines = {{.name = "residual",
              .position_name = "iteration",
              .help = "largest divergence left over the largest before, after each pass of the solver that is chosen; the others "
                      "beside it, on the same field",
              .sample = [this](Curve& curve) { sample_history(curve, solver, static_cast<Index>(tally_[passes])); },
              .value_name = "max|∇·u| / max|∇·ũ|",
              .log_log = true}};
    constexpr std::array<std::string_view, solver_count> names{"plain", "Jacobi", "incomplete Cholesky", "multigrid"};
    for (std::size_t k = 0; k < solver_count; ++k)
        lines[0].others.push_back({.name = names[k], .sample = [this, k](Curve& curve) {
                                       const auto which = static_cast<PressurePreconditioner>(k);
                                       sample_history(curve, which, which == solver || !staggered() ? 0 : all);
                                   }});
}

// -------------------------------------------------------------------------------------------------- assumptions and laws

void Projection::declare_checks() {
    const auto assign = [](std::string label, std::string key, std::string value) {
        return [fix = Fix{std::move(label), {{std::move(key), std::move(value)}}}] { return std::optional(fix); };
    };
    assumptions = {
        {.name = "balanced flux",
         .unit = "m²/s",
         .value = [this] { return std::abs(net_inflow()); },
         .limit = [this] { return 1e-10 * std::abs(speed); },
         .formula = "|inflow − outflow| ≤ 10⁻¹⁰ |inflow|",
         .broken = "more flows in than out: no velocity without divergence fits the walls, and no pressure exists",
         .used = [this] { return walls_move() && grid_->fluid_cells() > 0; },
         .fix = assign("outflow = 1", "outflow", "1")},
        {.name = "pressures that the grid does not see",
         .value = [this] { return static_cast<Real>(invisible_count()); },
         .limit = [] { return Real{1}; },
         .formula = "dim ker ∇ ≤ 1",
         .broken = "a checkerboard of the pressure has no gradient on this grid, and one of the velocity no divergence: "
                   "it is never found and never removed",
         .used = [this] { return !staggered(); },
         .fix = assign("staggered grid", "grid", "staggered")},
        {.name = "solver tolerance",
         .value = [this] { return Real(tolerance); },
         .limit = [] { return loose; },
         .formula = "τ ≤ 0.01",
         .broken = "so much divergence is left that the fluid loses or gains volume where one looks",
         .fix = assign("τ = 1e-6", "tolerance", "1e-6")}};
    conserved = {{.probe = "max_divergence",
                  .law = Law::zero,
                  .tolerance =
                      [this] {
                          const Real fastest = std::max(max_speed(tentative_), centre_.cwiseAbs().maxCoeff());
                          return tolerance * tally_[initial] * (1 + 1e-6) + 1e-12 * fastest / dx();
                      },
                  .expected = [this] { return tally_[done] != 0; }},
                 {.probe = "kinetic_energy",
                  .law = Law::never_grows,
                  .tolerance = [this] { return 1e-12 * tally_[energy_given]; },
                  .expected = [this] { return !walls_move(); }},
                 {.probe = "orthogonality",
                  .law = Law::zero,
                  .tolerance = [] { return 1e-10; },
                  .expected = [this] { return tally_[done] != 0 && !walls_move(); }}};
}

// --------------------------------------------------------------------------------------------------- what would mend it

std::optional<Fix> Projection::fix(const Failure& failure) const {
    if (failure.field == "velocity") {
        if (outflow == 1 && solids() != Obstacle::none) return Fix{"no obstacle", {{"obstacle", "none"}}};
        return Fix{"outflow = 1", {{"outflow", "1"}}};
    }
    if (staggered() && solver != PressurePreconditioner::multigrid && max_iterations >= 20)
        return Fix{"multigrid", {{"solver", "multigrid"}}};
    return Fix{"max_iterations = 1000, τ = 1e-6", {{"max_iterations", "1000"}, {"tolerance", "1e-6"}}};
}

std::string Projection::blow_up_hint() const {
    return fmt::format(
        "The equation is linear, so that only its parameters can make the pressure large: take a speed below {} and a time step "
        "above {}",
        format_quantity(1e3, "m/s"), format_quantity(1e-6, "s"));
}

}  // namespace pliant::projection
