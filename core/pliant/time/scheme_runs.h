// The same motion by other schemes and other steps: what is drawn and plotted beside the run itself. Computed when it is looked
// at, never in a step.
#pragma once
#include <pliant/time/swinging.h>

#include <pliant/time/time_integrator.h>

#include <array>
#include <memory>
#include <vector>

namespace pliant {

struct SchemeMethod {
    Scheme scheme = Scheme::semi_implicit_euler;
    NewtonOptions newton{};
};

// A run from the start of the motion.
class SchemeRun {
public:
    SchemeRun(const SwingingOptions& options, const SchemeMethod& method);

    // False when Newton's method failed, or the motion has become larger than what its energy allows by `blown_up`.
    bool step(Real dt);
    const Swinging& system() const { return system_; }
    const VecX& position() const { return x_; }
    const VecX& velocity() const { return v_; }
    // Force evaluations so far; of an implicit scheme Newton iterations, each of which evaluates the force once.
    Index cost() const { return cost_; }

    static constexpr Real blown_up = 1000;

private:
    Swinging system_;
    DiagonalMass mass_;
    TimeIntegrator integrator_;
    VecX x_, v_;
    Index cost_ = 0;
};

// One scheme's path: the state of one mass and the energy after every step.
struct SchemePath {
    std::vector<Motion> motion;
    std::vector<Real> energy;  // J
    bool ended = false;        // blown up
};

// The paths of all schemes from the start, in lockstep.
class SchemePaths {
public:
    // Forgets what belongs to other parameters.
    void follow(const SwingingOptions& options, NewtonOptions newton, Real dt, Index mass);
    // Of `steps` steps, or as many as there are: at most `longest`.
    const SchemePath& of(Scheme scheme, Index steps);

    static constexpr Index longest = 10000;

private:
    SwingingOptions options_;
    NewtonOptions newton_;
    Real dt_ = 0;
    Index mass_ = 0;
    struct Runner {
        std::unique_ptr<SchemeRun> run;
        SchemePath path;
    };
    std::array<Runner, 8> runs_;
};

// Error of the state at a fixed time against the step, and against the cost.
struct ErrorCurve {
    std::vector<Real> dt, error, cost;  // s, part of the scale, force evaluations
};
// halvings: of the step, from about one radian of the fastest mode on. Empty without a solution in closed form.
ErrorCurve error_curve(const SwingingOptions& options, const SchemeMethod& method, int halvings);
// The slope of log error against log dt over its smallest steps; empty when rounding is all there is.
std::optional<Real> measured_order(const ErrorCurve& curve);

}  // namespace pliant
