// What is integrated: a mass of 1 kg on a spring, a pendulum, or two masses on a soft and a stiff spring. With its solution in
// closed form.
#pragma once
#include <pliant/time/exact_motion.h>
#include <pliant/time/implicit.h>

#include <optional>

namespace pliant {

enum class SwingingKind { oscillator, pendulum, stiff_pair };

struct SwingingOptions {
    SwingingKind system = SwingingKind::oscillator;
    Real omega = 1;            // rad/s, >= 0: of the mass on the (soft) spring, of small swings of the pendulum
    Real zeta = 0;             // damping ratio, >= 0; in the pair the same of both modes
    Real stiffness_ratio = 1;  // of the pair: stiff spring over soft one
    Motion start;              // m, m/s, the same of both masses
    bool operator==(const SwingingOptions&) const;
};

// Every mass is 1 kg. oscillator: f = -omega^2 x - 2 zeta omega v. pendulum, with x along its arc of radius l = g/omega^2:
// f = -g sin(x/l) - 2 zeta omega v. stiff_pair: a wall, the soft spring omega^2, mass 0, the stiff spring, mass 1; f = -K x - C v
// with C = 2 zeta sqrt(K), so that each mode is an oscillator of damping ratio zeta.
class Swinging final : public SecondOrderSystem {
public:
    explicit Swinging(const SwingingOptions& options);

    const SwingingOptions& options() const { return options_; }
    Index size() const { return options_.system == SwingingKind::stiff_pair ? 2 : 1; }
    bool linear() const { return options_.system != SwingingKind::pendulum; }

    // K [N/m] and C [N s/m] of the linear systems; of the pendulum those of small swings.
    const Mat<2>& stiffness_matrix() const { return K_; }
    const Mat<2>& damping_matrix() const { return C_; }
    Real length() const { return length_; }     // m, of the pendulum; infinite for omega = 0
    Real slow_rate() const { return slow_; }    // rad/s
    Real fast_rate() const { return fast_; }    // rad/s, of the fastest mode
    Real scale() const { return scale_; }       // m: how far the start can swing, > 0
    Real top_speed() const { return speed_; }   // m/s: what its energy allows, > 0
    bool can_leave() const { return leaves_; }  // does the exact motion go beyond every bound?

    VecX start_position() const { return VecX::Constant(size(), options_.start.x); }
    VecX start_velocity() const { return VecX::Constant(size(), options_.start.v); }
    Real energy(ConstDofs x, ConstDofs v) const { return 0.5 * v.squaredNorm() + potential(x); }
    // Of one mass at time t; empty for a damped pendulum, which has no closed form.
    std::optional<Motion> exact(Index mass, Real t) const;
    std::optional<Real> exact_energy(Real t) const;
    // Of one undamped swing of the pendulum to and fro [s]; empty for other systems, and where it reaches the top or is damped.
    std::optional<Real> pendulum_period() const;

    void begin_step(ConstDofs) override {}
    bool damped() const override { return options_.zeta > 0 && options_.omega > 0; }
    Real potential(ConstDofs x) const override;
    Real dissipation(ConstDofs v) const override;
    void force(ConstDofs x, ConstDofs v, Dofs f) const override;
    const SparseMatrix& stiffness(ConstDofs x, Real velocity_rate, Curvature curvature) override;
    Real length_scale(ConstDofs) const override { return scale_; }

    static constexpr Real gravity = 9.81;

private:
    Motion exact_mode(Index mode, Real t) const;

    SwingingOptions options_;
    Mat<2> K_ = Mat<2>::Zero(), C_ = Mat<2>::Zero();
    Mat<2> modes_ = Mat<2>::Identity();                // columns
    Eigen::Vector2d rates_ = Eigen::Vector2d::Zero();  // rad/s, of the modes
    Real length_ = 0, slow_ = 0, fast_ = 0, scale_ = 1, speed_ = 1;
    bool leaves_ = false;
    std::optional<Pendulum> pendulum_;
    SparseMatrix matrix_;
};

}  // namespace pliant
