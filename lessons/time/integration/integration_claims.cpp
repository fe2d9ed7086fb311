// What the lecture says of its three schemes, measured.
#include <pliant/run/runner.h>
#include <pliant/study/claims_report.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pliant::integration {
namespace {

constexpr Real close_enough = 1e-6;
constexpr std::array<const char*, 3> lecture_schemes{"explicit_euler", "semi_implicit_euler", "implicit_euler"};

using Settings = Runner::Assignments;

Runner started(Settings settings) {
    settings.emplace_back("compare", "none");
    return Runner(find_lesson("time/integration"), settings);
}

Settings oscillator(const char* scheme, Real omega, Real zeta, Real dt) {
    return {{"integrator", scheme},
            {"omega", format_exact(omega)},
            {"damping_ratio", format_exact(zeta)},
            {"time_step", format_exact(dt)}};
}

// By which a step multiplies the motion: from the states that three steps of a run went through.
Real growth(const char* scheme, Real omega, Real zeta, Real dt) {
    Runner runner = started(oscillator(scheme, omega, zeta, dt));
    for (int k = 0; k < 3; ++k) runner.step();
    return runner.value("growth_measured");
}

// The Δt at which runs begin to grow, by halving an interval that holds it.
Real limit_found(const char* scheme, Real omega, Real zeta, Real stable, Real unstable) {
    constexpr Real rounding = 1e-13;
    for (int k = 0; k < 44; ++k) {
        const Real middle = (stable + unstable) / 2;
        (growth(scheme, omega, zeta, middle) > 1 + rounding ? unstable : stable) = middle;
    }
    return stable;
}

// ------------------------------------------------------------------------------------------------------------------ I1

Finding explicit_limit() {
    constexpr Real omega = 10;
    Real off = 0, grown_off = 0, least_growth = HUGE_VAL;
    for (const Real zeta : {0.02, 0.1, 0.3, 0.5, 0.9})
        off = std::max(off, std::abs(limit_found("explicit_euler", omega, zeta, 1e-3, 1) / (2 * zeta / omega) - 1));
    for (const Real dt : {1e-4, 1e-3, 1e-2, 1e-1, 1.}) {
        const Real measured = growth("explicit_euler", omega, 0, dt);
        least_growth = std::min(least_growth, measured - 1);
        grown_off = std::max(grown_off, std::abs(measured / std::hypot(1, omega * dt) - 1));
    }
    const bool sound = off <= close_enough && grown_off <= close_enough && least_growth > 0;
    return {.figure = off,
            .verdict = sound ? Verdict::qualified : Verdict::refuted,
            .text = fmt::format(
                "With ζ from 0.02 to 0.9 runs begin to grow at 2ζ/ω, {} off. Without damping they grow at each of five "
                "Δt from 10⁻⁴ to 1 s (ω = 10 rad/s), by √(1 + ω²Δt²) in a step, {} off.",
                steady_figure(off), steady_figure(grown_off)),
            .condition =
                "with damping. An undamped oscillator has no stable Δt at all: at Δt = 10⁻⁴ s its amplitude still grows by "
                "5 · 10⁻⁷ in every step"};
}

const ClaimRegistration i1{"I1", explicit_limit};

// ------------------------------------------------------------------------------------------------------------------ I2

Finding implicit_everywhere() {
    Real most_energy = 0, off = 0, most_iterations = 0;
    std::array<Real, 2> kept{};
    for (const Real dt : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1., 10.})
        for (const Settings& motion :
             {Settings{}, Settings{{"system", "stiff_pair"}, {"stiffness_ratio", "10000"}},
              Settings{{"system", "pendulum"}, {"x0", "6"}}, Settings{{"damping_ratio", "100"}, {"v0", "5"}}}) {
            Settings settings = motion;
            settings.insert(settings.end(), {{"integrator", "implicit_euler"}, {"time_step", format_exact(dt)}});
            Runner runner = started(settings);
            const Real before = runner.value("energy");
            for (int k = 0; k < 100; ++k) {
                runner.step();
                most_energy = std::max(most_energy, runner.value("energy") / before);
                most_iterations = std::max(most_iterations, runner.value("newton_iterations_used"));
            }
            if (!motion.empty()) continue;
            const Real factor = std::sqrt(runner.value("energy") / before);
            const Real exact = std::pow(std::hypot(1, 2 * dt), -100);
            if (exact > 1e-100) off = std::max(off, std::abs(factor / exact - 1));
            if (dt == 1e-2) kept[0] = factor;
            if (dt == 1e-1) kept[1] = factor;
        }
    const bool sound = most_energy <= 1 + close_enough && off <= close_enough;
    return {.figure = most_energy,
            .verdict = sound ? Verdict::qualified : Verdict::refuted,
            .text = fmt::format(
                "In 32 runs with Δt from 10⁻⁶ to 10 s, of a spring, a strongly damped one, a pendulum and a pair with a "
                "spring 10⁴ times stiffer, no energy exceeds {:.6f} of its start. A step takes up to {:.0f} Newton "
                "iterations, each with a linear system, where explicit Euler takes one force.",
                most_energy, most_iterations),
            .condition = fmt::format(
                "where Newton's method converges, and at the price of a drag that nobody asked for: an undamped swing "
                "keeps 1/√(1 + ω²Δt²) of its amplitude in a step. Of ω = 2 rad/s a hundred steps of 10 ms leave "
                "{:.0f} %, of 0.1 s {:.0f} %",
                100 * kept[0], 100 * kept[1])};
}

const ClaimRegistration i2{"I2", implicit_everywhere};

// ------------------------------------------------------------------------------------------------------------------ I3

// The damping ratio at which explicit and semi-implicit Euler begin to grow at the same Δt: with less the latter is stable
// longer.
Real equally_stable_damping(Real omega) {
    Real less = 0.1, more = 0.9;
    for (int k = 0; k < 32; ++k) {
        const Real zeta = (less + more) / 2;
        const Real old_velocity = limit_found("explicit_euler", omega, zeta, 0.01, 0.3),
                   new_velocity = limit_found("semi_implicit_euler", omega, zeta, 0.01, 0.3);
        (new_velocity > old_velocity ? less : more) = zeta;
    }
    return (less + more) / 2;
}

Finding semi_implicit() {
    constexpr Real omega = 10, dt = 0.05;
    const Real limit = omega * limit_found("semi_implicit_euler", omega, 0, 0.15, 0.3), off = std::abs(limit / 2 - 1);
    std::array<Real, 2> forces{};
    for (std::size_t k = 0; k < 2; ++k) {
        Runner runner = started(oscillator(lecture_schemes[k], omega, 0, 1e-3));
        for (int n = 0; n < 100; ++n) runner.step();
        forces[k] = runner.value("force_evaluations_in_all") / 100;
    }
    Runner runner = started(oscillator("semi_implicit_euler", omega, 0, dt));
    Real least = runner.value("energy"), most = least;
    for (int k = 0; k < 20000; ++k) {
        runner.step();
        const Real now = runner.value("energy");
        least = std::min(least, now), most = std::max(most, now);
    }
    const Real band = (1 + omega * dt / 2) / (1 - omega * dt / 2);
    const bool bounded = most / least <= band * (1 + close_enough);
    const Real equal = equally_stable_damping(omega), equal_off = std::abs(equal * std::sqrt(Real{3}) - 1);
    constexpr Real zeta = 0.9, step = 0.15;
    const Real old_velocity = growth("explicit_euler", omega, zeta, step),
               new_velocity = growth("semi_implicit_euler", omega, zeta, step);
    const bool sound = off <= close_enough && forces[0] == forces[1] && bounded && equal_off <= close_enough &&
                       old_velocity < 1 && new_velocity > 1;
    return {
        .figure = off,
        .verdict = sound ? Verdict::qualified : Verdict::refuted,
        .text = fmt::format(
            "Both take {:.0f} force in a step. Without drag runs begin to grow at ωΔt = {:.6f}, {} off 2, where explicit Euler "
            "grows at every Δt. At ωΔt = 0.5 the energy of 20 000 steps stays within a band of {:.4f}, that of theory is "
            "{:.4f}. With drag both have a limit: the two are equal at ζ = {:.6f}, {} off 1/√3.",
            forces[1], limit, steady_figure(off), most / least, band, equal, steady_figure(equal_off)),
        .condition = fmt::format("with little drag, ζ < 1/√3 = 0.577. Its drag force is taken with the old velocity, and with "
                                 "more drag it is the less stable of the two: at ζ = 0.9 and ωΔt = 1.5 a step of explicit Euler "
                                 "multiplies the motion by {:.3f}, one of semi-implicit Euler by {:.2f}",
                                 old_velocity, new_velocity)};
}

const ClaimRegistration i3{"I3", semi_implicit};

// ------------------------------------------------------------------------------------------------------------------ I4

Finding first_order() {
    std::array<Real, 3> slope{};
    Real off = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        slope[k] = started({{"integrator", lecture_schemes[k]}, {"damping_ratio", "0.1"}}).value("order");
        off = std::max(off, std::abs(slope[k] - 1));
    }
    constexpr Real band = 0.1;
    return {.figure = off,
            .verdict = off <= band ? Verdict::reproduced : Verdict::refuted,
            .text = fmt::format(
                "Of the error of the state at a fixed time over Δt, in logarithms, the slope is {:.2f} for explicit, {:.2f} "
                "for semi-implicit and {:.2f} for implicit Euler.",
                slope[0], slope[1], slope[2])};
}

const ClaimRegistration i4{"I4", first_order};

}  // namespace
}  // namespace pliant::integration
