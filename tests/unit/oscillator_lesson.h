// A damped oscillator whose stability is known in closed form: the lesson that the tests of the stability map run.
#pragma once
#include <pliant/lesson/registry.h>

#include <array>
#include <cmath>
#include <limits>

namespace pliant::test {

class OscillatorLesson final : public Lesson {
public:
    enum class Method { explicit_euler, semi_implicit_euler, implicit_euler, velocity_verlet, runge_kutta_4, midpoint, stubborn };

    Choice<Method> scheme{*this,
                          {.key = "scheme", .initial = 1},
                          {{"explicit_euler", "explicit Euler"},
                           {"semi_implicit_euler", "semi-implicit Euler"},
                           {"implicit_euler", "implicit Euler"},
                           {"velocity_verlet", "velocity Verlet"},
                           {"runge_kutta_4", "Runge–Kutta 4"},
                           {"midpoint", "implicit midpoint"},
                           {"stubborn", "a solver that gives up above Δt ω = 1"}}};
    Number dt{*this,
              {.key = "time_step",
               .symbol = "Δt",
               .unit = "s",
               .initial = 0.01,
               .useful = {1e-3, 1},
               .accepted = Interval{0, 10, true},
               .scale = Scale::log}};
    Number omega{*this,
                 {.key = "omega",
                  .symbol = "ω",
                  .unit = "rad/s",
                  .initial = 10,
                  .useful = {1, 100},
                  .accepted = Interval{0, 1e4},
                  .scale = Scale::log}};
    Number zeta{*this, {.key = "damping_ratio", .symbol = "ζ", .useful = {0, 2}, .accepted = Interval{0, 100}}};
    Number offset{*this, {.key = "offset", .symbol = "E₀", .unit = "J", .useful = {-100, 100}, .accepted = Interval{-1e6, 1e6}}};
    Number speed{*this,
                 {.key = "speed",
                  .symbol = "v₀",
                  .unit = "m/s",
                  .useful = {-1, 1},
                  .accepted = Interval{-10, 10},
                  .effect = Effect::rebuild}};
    Whole count{*this, {.key = "count", .initial = 1, .useful = {1, 9}, .accepted = Interval{1, 9}, .effect = Effect::rebuild}};
    Switch forbidding{*this, {.key = "forbidding", .help = "refuses ω above 50 rad/s"}};

    OscillatorLesson() {
        state = {state_array("x", "m", x_), state_array("v", "m/s", v_)};
        fields = {{.name = "x", .unit = "m", .view = view_of(x_), .bound = [] { return 1e9; }},
                  {.name = "v", .unit = "m/s", .view = view_of(v_)}};
        stages = {{.name = "move", .run = [this] { move(); }, .writes = {"x", "v"}}};
        probes = {{.name = "energy", .unit = "J", .value = [this] { return energy(); }},
                  {.name = "x", .unit = "m", .value = [this] { return x_[0]; }}};
        assumptions = {{.name = "stability",
                        .unit = "s",
                        .value = [this] { return Real(dt); },
                        .limit = [this] { return limit(); },
                        .used = [this] { return scheme != Method::implicit_euler && scheme != Method::midpoint; }}};
    }
    int dimension() const override { return 2; }
    Real time_step() const override { return dt; }
    void check() const override {
        if (forbidding && omega > 50) throw Refused("omega", omega, "rad/s", "at most 50");
    }
    void reset() override { x_ = VecX::Ones(1), v_ = VecX::Constant(1, speed); }
    void draw(Scene&) const override {}

    Real limit() const {
        const Real w = omega, z = zeta;
        if (w == 0) return std::numeric_limits<Real>::infinity();
        switch (scheme) {
            case Method::explicit_euler:
                return z <= 1 ? 2 * z / w : 2 / (w * (z + std::sqrt(z * z - 1)));
            case Method::semi_implicit_euler:
                return 2 / w * (std::sqrt(1 + z * z) - z);
            case Method::velocity_verlet:
                return 2 / w;
            case Method::runge_kutta_4:
                return undamped_runge_kutta / w;
            default:
                return std::numeric_limits<Real>::infinity();
        }
    }

private:
    static constexpr Real undamped_runge_kutta = 2.8284271247461903;

    Real energy() const { return 0.5 * v_[0] * v_[0] + 0.5 * omega * omega * x_[0] * x_[0] + offset; }
    Real acceleration(Real x, Real v) const { return -omega * omega * x - 2 * zeta * omega * v; }

    void move() {
        Real &x = x_[0], &v = v_[0];
        const Real h = dt, w2 = omega * omega, d = 2 * zeta * omega;
        switch (scheme) {
            case Method::explicit_euler: {
                const Real a = acceleration(x, v);
                x += h * v, v += h * a;
                return;
            }
            case Method::semi_implicit_euler:
                v += h * acceleration(x, v), x += h * v;
                return;
            case Method::stubborn:
                if (h * omega > 1) give_up();
                [[fallthrough]];
            case Method::implicit_euler:
                v = (v - h * w2 * x) / (1 + h * d + h * h * w2), x += h * v;
                return;
            case Method::velocity_verlet: {  // undamped
                v += h / 2 * acceleration(x, 0), x += h * v, v += h / 2 * acceleration(x, 0);
                return;
            }
            case Method::runge_kutta_4:
                return runge_kutta(x, v);
            case Method::midpoint: {
                const Real middle = (v - h / 2 * w2 * x) / (1 + h / 2 * d + h * h / 4 * w2);
                x += h * middle, v = 2 * middle - v;
                return;
            }
        }
    }
    void runge_kutta(Real& x, Real& v) const {
        const Real h = dt;
        std::array<Real, 4> a{}, b{};
        constexpr std::array<Real, 4> part{0, 0.5, 0.5, 1};
        for (std::size_t k = 0; k < 4; ++k) {
            const Real xk = k ? x + part[k] * h * a[k - 1] : x, vk = k ? v + part[k] * h * b[k - 1] : v;
            a[k] = vk, b[k] = acceleration(xk, vk);
        }
        x += h / 6 * (a[0] + 2 * a[1] + 2 * a[2] + a[3]), v += h / 6 * (b[0] + 2 * b[1] + 2 * b[2] + b[3]);
    }
    [[noreturn]] static void give_up() {
        Failure failure;
        failure.kind = FailureKind::not_converged;
        failure.what = "the iteration did not converge";
        throw Diverged(failure);
    }

    VecX x_, v_;
};

inline const LessonEntry& oscillator() {
    static const LessonEntry entry{{.id = "test/oscillator", .title = "Oscillator", .summary = "For tests."},
                                   [] { return std::unique_ptr<Lesson>(new OscillatorLesson); }};
    return entry;
}

}  // namespace pliant::test
