#include "projection.h"

#include <pliant/fluids/diagnostics.h>
#include <pliant/fluids/pressure_gradient.h>

namespace pliant::projection {
namespace {

const Registration<Projection> registration{
    {.id = "fluids/projection",
     .title = "Pressure projection",
     .summary = "Any velocity in; its divergence, the pressure pass by pass, and a velocity without divergence out.",
     .demo_steps = 1}};

constexpr Real push_radius = 0.11;  // m

Points<2> columns(const AxisArrays<2>& cells) {
    Points<2> points(2, cells[0].size());
    for (int a = 0; a < 2; ++a) points.row(a) = cells[a].transpose();
    return points;
}

void from_columns(const Points<2>& points, AxisArrays<2>& cells) {
    for (int a = 0; a < 2; ++a) cells[a] = points.row(a).transpose();
}

}  // namespace

// ------------------------------------------------------------------------------------------------------ the initial state

GivenField Projection::given_field() const {
    const Input s = Input::of(speed, "s");
    const auto push = [&](Push::Shape shape, Vec<2> middle, Vec<2> share = Vec<2>::Ones()) {
        return Push{shape, middle, push_radius, {s, s}, speed * share};
    };
    std::vector<Push> pushes;
    switch (Given(given)) {
        case Given::swirl:
            pushes = {push(Push::Shape::around, {0.6, 0.44}), push(Push::Shape::away, {0.32, 0.64})};
            break;
        case Given::source_sink:
            pushes = {push(Push::Shape::away, {0.3, 0.5}), push(Push::Shape::toward, {0.7, 0.5})};
            break;
        case Given::jet: {
            Push along = push(Push::Shape::along, {0.35, 0.5}, {1, 0});
            along.speed[1] = Input::constant("s", 0, "m/s", "the jet points along x");
            pushes = {along};
            break;
        }
        case Given::drawn:
            for (const DrawnArrow& arrow : drawn)
                pushes.push_back({Push::Shape::along,
                                  arrow.place(),
                                  drawn_radius,
                                  {Input::of(arrow.u, "s"), Input::of(arrow.v, "s")},
                                  arrow.velocity()});
            break;
        default:
            break;
    }
    return {given, speed, Input::of(speed), periodic(), std::move(pushes)};
}

void Projection::reset() {
    const bool through = walls_move();
    grid_ = std::make_unique<StaggeredGrid<2>>(
        unit_square(resolution, periodic(), solids(), through ? Real(speed) : Real{0}, through ? speed * outflow : Real{0}));
    projection_.reset();
    central_projection_.reset();
    if (staggered())
        projection_ = std::make_unique<PressureProjection<2>>(*grid_, settings());
    else
        central_projection_ = std::make_unique<CollocatedProjection<2>>(grid_->cells(), dx(), settings());
    field_ = given_field();
    const Index cells = grid_->cells().size();
    pressure_ = before_ = after_ = VecX::Zero(cells);
    gradient_ = solenoidal_ = Points<2>::Zero(2, cells);
    drift_.setZero();
    velocity_ = grid_->zero_velocity();
    for (VecX& component : central_.components) component = VecX::Zero(cells);
    tally_.setZero();
    give();
    if (staggered())
        histories_.reset(*grid_, tentative_, dt, settings());
    else
        histories_.reset(*grid_, centre_, dt, settings());
}

// The velocity at the cell centres, for pictures and parts.
void Projection::renew_centre() {
    if (staggered())
        cell_velocity(*grid_, velocity_, centre_);
    else
        centre_ = columns(central_);
}

// ------------------------------------------------------------------------------------------------------------- the stages

void Projection::declare_stages() {
    stages = {{.name = "tentative_velocity",
               .formula = "ũ: given;  on walls and solids the velocity of the wall",
               .source = "survey, best guess velocity ũ; Utrecht slides, pressure projection",
               .run = [this] { give(); },
               .reads = {},
               .writes = {"u_on_faces", "v_on_faces", "u_in_cells", "v_in_cells"},
               .explain = [this](const Question& q) { return why_given(q); }},
              {.name = "divergence",
               .formula = "d̃ = ∇·ũ = (flux out of the cell) / Δx²",
               .source = "Utrecht slides: the flux through all faces of each cell is to be zero; Bridson2007 §4.3",
               .run = [this] { take_divergence(); },
               .reads = {"u_on_faces", "v_on_faces", "u_in_cells", "v_in_cells"},
               .writes = {"divergence_before"},
               .explain = [this](const Question& q) { return why_divergence(q.index, Input::From::before); }},
              {.name = "pressure",
               .formula = "Δt ∇²p = d̃,  one pass of the solver after the other",
               .source = "Utrecht slides, Δt ∇²p = ∇·u (p is p/ρ); Chorin1968; Bridson2007 §4.3",
               .run = [this] { pressure_pass(); },
               .reads = {"divergence_before"},
               .writes = {"pressure", "divergence_after"},
               .again = [this] { return staggered() ? !projection_->converged() : !central_projection_->converged(); },
               .begin = [this] { begin_pressure(); },
               .explain = [this](const Question& q) { return why_pressure_pass(q); }},
              {.name = "disturbance",
               .formula = "p ← p + A q,  q = ±1 in turn from cell to cell",
               .source = "the checkerboard that a collocated grid does not see: HarlowWelch1965",
               .run = [this] { disturb(); },
               .reads = {"pressure"},
               .writes = {"pressure"},
               .active = [this] { return disturbance != 0; },
               .explain = [this](const Question& q) { return why_disturbed(q.index); }},
              {.name = "projection",
               .formula = "u = ũ − Δt ∇p",
               .source = "Utrecht slides, u(t+Δt) = u(t) − Δt ∇p; survey, pressure projection",
               .run = [this] { project(); },
               .reads = {"u_on_faces", "v_on_faces", "u_in_cells", "v_in_cells", "pressure"},
               .writes = {"u_on_faces", "v_on_faces", "u_in_cells", "v_in_cells", "divergence_after"},
               .explain =
                   [this](const Question& q) {
                       return q.field == "divergence_after" ? why_divergence(q.index, Input::From::now) : why_projected(q);
                   }},
              {.name = "helmholtz_parts",
               .formula = "ũ = Δt ∇p + s + m,  ∇·s = 0,  m: mean flow around a periodic box",
               .source = "Helmholtz decomposition; Bridson2007 §4.3; Chorin1968",
               .run = [this] { split(); },
               .reads = {"pressure", "u_on_faces", "v_on_faces", "u_in_cells", "v_in_cells"},
               .writes = {"gradient_part", "solenoidal_part"},
               .explain = [this](const Question& q) { return why_part(q); }}};
}

void Projection::give() {
    tally_[done] = tally_[projected] = 0;
    const auto number = static_cast<std::uint64_t>(Index(seed));
    for (int a = 0; a < 2; ++a) {
        if (staggered())
            field_.fill(a, grid_->faces(a), dx(), number, velocity_[a]);
        else
            field_.fill(a, grid_->cells(), dx(), number, central_[a]);
    }
    if (staggered()) grid_->impose_walls(velocity_);
    tentative_ = velocity_;
    renew_centre();
    tally_[energy_given] = specific_energy();
}

void Projection::take_divergence() {
    if (staggered())
        divergence(*grid_, velocity_, before_);
    else
        central_divergence(grid_->cells(), dx(), centre_, before_);
    tally_[initial] = before_.lpNorm<Eigen::Infinity>();
}

void Projection::begin_pressure() {
    if (staggered()) {
        projection_->pressure().setZero();
        projection_->begin(velocity_, dt);
    } else {
        central_projection_->pressure().setZero();
        central_projection_->begin(centre_, dt);
    }
    tally_[passes] = 0;
}

void Projection::pressure_pass() {
    const auto pass = [this](auto& solve) {
        solve.iterate();
        pressure_ = solve.pressure();
        // The residual of the solver is the divergence that this pressure leaves.
        after_ = -dt / (dx() * dx()) * solve.residual();
        tally_[passes] = static_cast<Real>(solve.iterations());
    };
    if (staggered())
        pass(*projection_);
    else
        pass(*central_projection_);
}

Real Projection::parity(Index cell) const {
    const Counts<2> at = grid_->cells().coordinates(cell);
    return (at[0] + at[1]) % 2 == 0 ? 1 : -1;
}

void Projection::disturb() {
    for (Index c = 0; c < pressure_.size(); ++c)
        if (grid_->is_fluid(c)) pressure_[c] += disturbance * parity(c);
    (staggered() ? projection_->pressure() : central_projection_->pressure()) = pressure_;
}

void Projection::project() {
    if (staggered()) {
        projection_->apply(velocity_);
        renew_centre();
        divergence(*grid_, velocity_, after_);
    } else {
        central_projection_->apply(centre_);
        from_columns(centre_, central_);
        central_divergence(grid_->cells(), dx(), centre_, after_);
    }
    tally_[projected] = 1;
}

Points<2> Projection::pressure_gradient() const {
    Points<2> gradient;
    if (staggered()) {
        FaceField<2> faces = grid_->zero_velocity();
        subtract_gradient(*grid_, pressure_, -dt, faces);
        cell_velocity(*grid_, faces, gradient);
    } else {
        central_gradient(grid_->cells(), dx(), pressure_, gradient);
        gradient *= dt;
    }
    return gradient;
}

// What was taken out of the velocity, and what is left of it.
void Projection::split() {
    gradient_ = pressure_gradient();
    const Real given_twice = 2 * tally_[energy_given] * fluid_area();
    Real product = 0;
    if (staggered()) {
        const HelmholtzParts<2> parts = helmholtz_parts(*grid_, tentative_, VecX(dt * pressure_));
        drift_ = parts.drift;
        product = inner_product(*grid_, parts.gradient, velocity_);
    } else {
        for (int a = 0; a < 2; ++a) drift_[a] = grid_->periodic(a) ? centre_.row(a).mean() : Real{0};
        product = gradient_.cwiseProduct(centre_).sum() * dx() * dx();
    }
    tally_[overlap] = given_twice > 0 ? product / given_twice : 0;
    solenoidal_ = centre_.colwise() - drift_;
    tally_[done] = 1;
}

}  // namespace pliant::projection
