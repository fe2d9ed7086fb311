// N beads on springs between two walls, released in the first normal mode: a whole lesson.
#include <pliant/lesson/registry.h>

#include <cmath>
#include <numbers>

namespace {
using namespace pliant;

class BeadChain final : public Lesson {
    static constexpr Index beads = 20;
    Number stiffness{*this, {.key = "stiffness", .symbol = "k", .unit = "N/m", .help = "of each spring", .initial = 100, .useful = {1, 1e5}, .scale = Scale::log}};
    Number mass{*this, {.key = "mass", .symbol = "m", .unit = "kg", .help = "of each bead", .initial = 1, .useful = {0.01, 100}, .scale = Scale::log}};
    Number amplitude{*this, {.key = "amplitude", .symbol = "A", .unit = "m", .help = "of the mode at t = 0", .initial = 0.1, .useful = {0, 1}, .effect = Effect::rebuild}};
    Number dt{*this, {.key = "time_step", .symbol = "Δt", .unit = "s", .initial = 1e-2, .useful = {1e-5, 0.2}, .accepted = Interval{0, 10, true}, .scale = Scale::log}};
    VecX u, v, force;  // displacement [m], velocity [m/s], force [N]

    Real angle() const { return std::numbers::pi / (beads + 1); }
    Real omega() const { return 2 * std::sqrt(stiffness / mass) * std::sin(angle() / 2); }
    Real at(Index i) const { return i < 0 || i >= beads ? 0 : u[i]; }
    Input neighbour(std::string symbol, Index i) const {
        return i < 0 || i >= beads ? Input::constant(std::move(symbol), 0, "m", "a wall") : Input::now(std::move(symbol), "u", i);
    }
    Explanation why_force(Index i) const {
        return {"f_i = k (u_left − 2 u_i + u_right)",
                {Input::of(stiffness), neighbour("u_left", i - 1), neighbour("u_i", i), neighbour("u_right", i + 1)}};
    }
    Explanation why_velocity(Index i) const {
        return {"v′ = v + Δt f / m", {Input::before("v", "v", i), Input::of(dt), Input::now("f", "force", i), Input::of(mass)}};
    }
    Explanation why_place(Index i) const {
        return {"u′ = u + Δt v", {Input::before("u", "u", i), Input::of(dt), Input::now("v", "v", i)}};
    }
    Real energy() const {
        Real e = 0.5 * mass * v.squaredNorm();
        for (Index i = 0; i <= beads; ++i) e += 0.5 * stiffness * (at(i) - at(i - 1)) * (at(i) - at(i - 1));
        return e;
    }

public:
    BeadChain() {
        state = {state_array("u", "m", u), state_array("v", "m/s", v)};
        fields = {{.name = "u", .symbol = "u", .unit = "m", .view = view_of(u), .bound = [] { return 1e3; }},
                  {.name = "v", .symbol = "v", .unit = "m/s", .view = view_of(v)},
                  {.name = "force", .symbol = "f", .unit = "N", .view = view_of(force)}};
        stages = {{.name = "force", .formula = "fᵢ = k (uᵢ₋₁ − 2 uᵢ + uᵢ₊₁)", .source = "spring chain", .run = [this] {
                       for (Index i = 0; i < beads; ++i) force[i] = stiffness * (at(i - 1) - 2 * u[i] + at(i + 1));
                   }, .reads = {"u"}, .writes = {"force"}, .explain = [this](const Question& q) { return why_force(q.index); }},
                  {.name = "kick", .formula = "v ← v + Δt f / m", .source = "semi-implicit Euler", .run = [this] { v += dt / mass * force; }, .reads = {"force"}, .writes = {"v"}, .explain = [this](const Question& q) { return why_velocity(q.index); }},
                  {.name = "drift", .formula = "u ← u + Δt v", .source = "semi-implicit Euler", .run = [this] { u += dt * v; }, .reads = {"v"}, .writes = {"u"}, .explain = [this](const Question& q) { return why_place(q.index); }}};
        probes = {{.name = "energy", .symbol = "E", .unit = "J", .value = [this] { return energy(); }},
                  {.name = "middle", .symbol = "u₁₀", .unit = "m", .value = [this] { return u[beads / 2]; },
                   .exact = [this](Real t) { return amplitude * std::sin((beads / 2 + 1) * angle()) * std::cos(omega() * t); }}};
        assumptions = {{.name = "stability", .unit = "s", .value = [this] { return Real(dt); }, .limit = [this] { return std::sqrt(mass / stiffness); },
                        .formula = "Δt ≤ 2/ω, ω = 2√(k/m)", .broken = "the highest mode grows without bound",
                        .otherwise_named = "unstable step"}};
        conserved = {{.probe = "energy", .tolerance = [this] { return 0.05 * stiffness * amplitude * amplitude; }}};
    }
    int dimension() const override { return 2; }
    Real time_step() const override { return dt; }
    void reset() override {
        v = force = VecX::Zero(beads);
        u = VecX::LinSpaced(beads, 1, beads).unaryExpr([this](Real i) { return amplitude * std::sin(i * angle()); });
    }
    void draw(Scene& scene) const override {
        PointMarks marks{.at = {}, .values = scene.values(*this, On::node), .radius = 6, .pick = {.pickable = true}};
        for (Index i = 0; i < beads; ++i) marks.at.push_back(position((i + 1) / Real(beads + 1), u[i]));
        scene.points.push_back(marks);
        scene.frame(position(0, -0.3), position(1, 0.3));
    }
};

const Registration<BeadChain> registration{{.id = "time/bead_chain", .title = "Bead chain", .summary = "Beads on springs, released in their first normal mode."}};
}  // namespace
