// Parameters, the start, and the stages.
#include "projection.h"

#include <pliant/fluids/diagnostics.h>
#include <pliant/fluids/pressure_gradient.h>

namespace pliant::projection {
namespace {

struct ArrowKeys {
    std::string_view x, y, u, v;
    std::string_view x_symbol, y_symbol, u_symbol, v_symbol;
    Real at_x, at_y, at_u, at_v;
};
constexpr std::array<ArrowKeys, arrow_count> arrows{
    {{"arrow1_x", "arrow1_y", "arrow1_u", "arrow1_v", "x₁", "y₁", "u₁", "v₁", 0.25, 0.3, 1, 0.2},
     {"arrow2_x", "arrow2_y", "arrow2_u", "arrow2_v", "x₂", "y₂", "u₂", "v₂", 0.7, 0.45, -0.6, 0.8},
     {"arrow3_x", "arrow3_y", "arrow3_u", "arrow3_v", "x₃", "y₃", "u₃", "v₃", 0.4, 0.75, 0.2, -0.9}}};

ParameterInfo place_of(std::string_view key, std::string_view symbol, Real initial) {
    return quantity(key, symbol, "m", initial, {0, 1}, "where the arrow begins; drag its dot in the picture").rebuilds();
}
ParameterInfo speed_of(std::string_view key, std::string_view symbol, Real initial) {
    return quantity(key, symbol, "m/s", initial, {-2, 2}, {-100, 100},
                    "of the fluid about the arrow; drag its head in the picture")
        .rebuilds();
}

}  // namespace

DrawnArrow::DrawnArrow(Lesson& owner, std::size_t which, std::function<bool()> used)
    : x(owner, place_of(arrows[which].x, arrows[which].x_symbol, arrows[which].at_x), used),
      y(owner, place_of(arrows[which].y, arrows[which].y_symbol, arrows[which].at_y), used),
      u(owner, speed_of(arrows[which].u, arrows[which].u_symbol, arrows[which].at_u), used),
      v(owner, speed_of(arrows[which].v, arrows[which].v_symbol, arrows[which].at_v), used) {}

Projection::Projection() {
    for (std::size_t k = 0; k < arrow_count; ++k) drawn.emplace_back(*this, k, [this] { return given == Given::drawn; });
    declare_fields(), declare_stages(), declare_probes(), declare_lines(), declare_checks();
}

// A handle goes where the hand goes.
std::vector<std::pair<std::string, Real>> Projection::dragged(const Pull& pull) const {
    if (pull.index == cell_handle) return {{"cell_x", pull.to[0]}, {"cell_y", pull.to[1]}};
    const bool tip = pull.index >= first_tip;
    const Index k = pull.index - (tip ? first_tip : first_place);
    if (given != Given::drawn || k < 0 || k >= Index(arrow_count)) return {};
    const ArrowKeys& keys = arrows[static_cast<std::size_t>(k)];
    if (!tip) return {{std::string(keys.x), pull.to[0]}, {std::string(keys.y), pull.to[1]}};
    const Vec<2> velocity = (pull.to.head<2>() - drawn[static_cast<std::size_t>(k)].place()) / drawn_scale;
    return {{std::string(keys.u), velocity[0]}, {std::string(keys.v), velocity[1]}};
}

namespace {

const Registration<Projection> registration{
    {.id = "fluids/projection",
     .title = "Pressure projection",
     .summary = "Any velocity in; its divergence, the pressure pass by pass, and a velocity without divergence out.",
     .demo_steps = 1}};

constexpr Real push_radius = 0.11;  // m

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
    return {given, speed, speed, periodic(), std::move(pushes)};
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
    staggered() ? histories_.reset(*grid_, tentative_, dt, settings()) : histories_.reset(*grid_, centre_, dt, settings());
}

void Projection::divergence_of(VecX& out) const {
    staggered() ? divergence(*grid_, velocity_, out) : central_divergence(grid_->cells(), dx(), centre_, out);
}

// ------------------------------------------------------------------------------------------------------------- the stages

void Projection::declare_stages() {
    formula_symbols = grid2d::symbols_and({{"d̃", "1/s"}, {"Φ", "m²/s"}, {"q"}, {"m", "m/s"}, {"n"}, {"n_before"}});
    stages = {
        stage_of("tentative_velocity", "ũ: given;  on walls and solids the velocity of the wall",
                 "survey, best guess velocity ũ; Utrecht slides, pressure projection", [this] { give(); })
            .done_in("lessons/fluids/projection/given_field.cpp: GivenField::fill")
            .maps({}, {"u_on_faces", "v_on_faces", "u_in_cells", "v_in_cells"})
            .because([this](const Question& q) { return why_given(q); }),
        stage_of("divergence", "d̃ = ∇·ũ = Φ/Δx²,  Φ: flux out of the cell",
                 "Utrecht slides: the flux through all faces of each cell is to be zero; Bridson2007 §4.3",
                 [this] { take_divergence(); })
            .done_in("core/pliant/fluids/diagnostics.cpp: divergence")
            .maps({"u_on_faces", "v_on_faces", "u_in_cells", "v_in_cells"}, {"divergence_before"})
            .because([this](const Question& q) { return why_divergence(q.index, Input::From::before); }),
        stage_of("pressure", "Δt ∇²p = d̃,  one pass of the solver after the other",
                 "Utrecht slides, Δt ∇²p = ∇·u (p is p/ρ); Chorin1968; Bridson2007 §4.3", [this] { pressure_pass(); })
            .done_in("core/pliant/fluids/pressure_solve.cpp: iterate")
            .maps({"divergence_before"}, {"pressure", "divergence_after", "solver_iterations"})
            .repeats([this] { return staggered() ? !projection_->converged() : !central_projection_->converged(); },
                     [this] { begin_pressure(); })
            .because([this](const Question& q) { return why_pressure_pass(q); }),
        stage_of("disturbance", "p ← p + A q,  q = ±1 in turn from cell to cell",
                 "the checkerboard that a collocated grid does not see: HarlowWelch1965", [this] { disturb(); })
            .done_in("lessons/fluids/projection/projection.h: disturb")
            .maps({"pressure"}, {"pressure"})
            .when([this] { return disturbance != 0; })
            .because([this](const Question& q) -> Explanation {
                if (!grid_->is_fluid(q.index)) return fixed_value("p′ = 0   (a solid cell)");
                return {"p′ = p + A q",
                        {Input::before("p", "pressure", q.index), disturbance,
                         Input::constant("q", parity(q.index), "", "+1 and −1 in turn, along x and along y")}};
            }),
        stage_of("projection", "u = ũ − Δt ∇p", "Utrecht slides, u(t+Δt) = u(t) − Δt ∇p; survey, pressure projection",
                 [this] { project(); })
            .done_in("core/pliant/fluids/pressure_gradient.cpp: subtract_gradient")
            .maps({"u_on_faces", "v_on_faces", "u_in_cells", "v_in_cells", "pressure"},
                  {"u_on_faces", "v_on_faces", "u_in_cells", "v_in_cells", "divergence_after"})
            .because([this](const Question& q) { return why_pressure_pass(q); }),
        stage_of("helmholtz_parts", "ũ = Δt ∇p + s + m,  ∇·s = 0,  m: mean flow around a periodic box",
                 "Helmholtz decomposition; Bridson2007 §4.3; Chorin1968", [this] { split(); })
            .done_in("core/pliant/fluids/helmholtz.cpp: helmholtz_parts")
            .maps({"pressure", "u_on_faces", "v_on_faces", "u_in_cells", "v_in_cells"}, {"gradient_part", "solenoidal_part"})
            .because([this](const Question& q) { return why_part(q); })};
}

void Projection::give() {
    tally_[done] = tally_[projected] = 0;
    const auto number = static_cast<std::uint64_t>(Index(seed));
    for (int a = 0; a < 2; ++a)
        staggered() ? field_.fill(a, grid_->faces(a), dx(), number, velocity_[a])
                    : field_.fill(a, grid_->cells(), dx(), number, central_[a]);
    if (staggered()) grid_->impose_walls(velocity_);
    tentative_ = velocity_;
    renew_centre();
    tally_[energy_given] = specific_energy();
}

void Projection::begin_pressure() {
    const auto begin = [this](auto& solve, const auto& velocity) {
        solve.pressure().setZero();
        solve.begin(velocity, dt);
    };
    staggered() ? begin(*projection_, velocity_) : begin(*central_projection_, centre_);
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
    staggered() ? pass(*projection_) : pass(*central_projection_);
}

Real Projection::parity(Index cell) const {
    const Counts<2> at = grid_->cells().coordinates(cell);
    return (at[0] + at[1]) % 2 == 0 ? 1 : -1;
}

void Projection::project() {
    if (staggered()) {
        projection_->apply(velocity_);
        renew_centre();
    } else {
        central_projection_->apply(centre_);
        for (int a = 0; a < 2; ++a) central_[a] = centre_.row(a).transpose();
    }
    divergence_of(after_);
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
