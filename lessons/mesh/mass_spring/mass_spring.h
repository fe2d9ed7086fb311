// A soft block of point masses and springs that falls, hangs or spins: forces, damping, three integrators, contact.
#pragma once
#include "spring_block.h"

#include <pliant/lesson/registry.h>
#include <pliant/solids/contact.h>
#include <pliant/solids/springs_frequency.h>
#include <pliant/solids/springs_system.h>

#include <memory>
#include <optional>

namespace pliant::mass_spring {

enum class Setting { drop, hang, spin };
enum class Support { top, side };

// Strains below this are rounding.
inline constexpr Real strain_rounding = 1e-12;

class MassSpringLesson final : public Lesson {
public:
    MassSpringLesson();

    int dimension() const override { return 3; }
    void check() const override;
    void reset() override;
    Real time_step() const override { return dt; }
    bool at_rest() const override;
    void draw(Scene& picture) const override;
    std::optional<On> can_pull() const override { return On::node; }
    void pull(const std::optional<Pull>& hand) override;
    std::string blow_up_hint() const override;
    ColourBy first_colours() const override { return {"tension", -1}; }
    std::vector<std::string_view> first_plots() const override { return {"energy", telling_probe(), "stretch"}; }
    std::vector<std::string_view> key_numbers() const override { return first_plots(); }
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override { return telling_probe(); }

private:
    // --- parameters ---
    Choice<Setting> setting;
    Choice<Support> support;
    Whole cells_x, cells_y, cells_z;
    Number size, total_mass;
    Number k_structural, k_shear, k_bending;
    Choice<SpringDamping> damping_mode;
    Number damping;
    Number gravity;
    Choice<Scheme> integrator;
    Number dt;
    Number drop_height, tilt, spin_rate;
    Switch ground;
    Number restitution, friction;
    Number pull_stiffness;
    Number newton_tolerance;
    Whole newton_cap;

    // --- declarations ---
    void declare_fields();
    void declare_stages();
    void declare_probes();
    void declare_checks();

    // --- what the parameters mean ---
    bool implicit() const { return integrator == Scheme::implicit_euler; }
    bool semi_implicit() const { return integrator == Scheme::semi_implicit_euler; }
    bool grounded() const { return ground && setting != Setting::spin; }
    bool damped() const { return damping_mode != SpringDamping::none; }
    std::string_view telling_probe() const { return setting == Setting::spin ? "angular_momentum" : held() ? "sag" : "height"; }
    bool held() const { return setting == Setting::hang; }
    bool pulled() const { return load_.pull.node >= 0 && pull_stiffness > 0; }
    Real weight_acceleration() const { return setting == Setting::spin ? Real{0} : Real{gravity}; }
    bool loaded() const { return weight_acceleration() > 0 || pulled(); }
    std::vector<Index> held_nodes() const;
    Points<3> start_positions() const;
    Points<3> start_velocities() const;

    // --- the stages ---
    void follow_parameters();
    void spring_stage();
    void damping_stage();
    void external_stage();
    void begin_integration();
    void integrate();
    void end_integration();
    void contact_stage();

    // --- what can be read off (mass_spring_readings.cpp) ---
    Real elastic_energy() const { return spring_energy<3>(block_->springs(), position_); }
    Real total_energy() const;
    std::optional<Real> shadow_energy() const;
    Real energy_tolerance() const;
    Real shadow_tolerance() const;
    Real momentum_tolerance() const;
    Real stretch() const;
    std::optional<Real> sag() const;
    std::optional<Real> falling_height(Real t) const;
    const SpringRates& rates() const;
    Real stable_time_step() const;
    Real growth_per_step() const;
    std::string too_large_a_step() const;

    // --- the picture (mass_spring_picture.cpp) ---
    void draw_surface(Scene& picture, float opacity) const;
    void draw_cell_edges(Scene& picture) const;
    void draw_springs(Scene& picture) const;
    void draw_nodes(Scene& picture) const;
    void draw_ground(Scene& picture) const;
    void draw_arrows(Scene& picture) const;
    void write_notes(Scene& picture) const;
    void set_frame(Scene& picture) const;
    Real frame_side() const;

    std::unique_ptr<SpringBlock> block_;
    std::unique_ptr<SpringSystem<3>> system_;  // of the implicit scheme
    std::unique_ptr<ImplicitSolver> solver_;
    ExternalLoad<3> load_;

    // What the closed forms start from; they end when a hand or a slider has interfered.
    Real start_height_ = 0, start_angular_momentum_ = 0, start_gravity_ = 0, start_mass_ = 0;
    bool interfered_ = false;

    // State [m, m/s], forces on the nodes [N], tension [N] and strain of the springs.
    Points<3> position_, velocity_;
    Points<3> spring_force_, damping_force_, external_force_, total_force_;
    VecX tension_, strain_;
    std::vector<Real> arrested_;  // by the ground within an implicit step, m/s
    Index touching_ = 0;
    Real energy_wobble_ = 0;  // largest Δt/2 |v·f| since the start, J

    // Rates of the net at rest, with the parameters that they belong to.
    struct RatesKey {
        SpringBlock::Stiffnesses stiffness{};
        Real damping = 0, mass = 0;
        SpringDamping mode = SpringDamping::none;
        bool operator==(const RatesKey&) const = default;
    };
    mutable std::optional<RatesKey> rates_key_;
    mutable SpringRates rates_;
};

}  // namespace pliant::mass_spring
