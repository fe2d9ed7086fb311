// Advection: a blob carried by a steady flow, and what each scheme makes of it.
#pragma once
#include "carried_blob.h"

#include <pliant/fluids/advection.h>
#include <pliant/fluids/interpolation_stencil.h>
#include <pliant/lesson/registry.h>

#include "fluids/flow/grid_why.h"

#include <array>
#include <memory>
#include <optional>

namespace pliant::carrying {

enum class Scheme { linear, monotone_cubic, mac_cormack };
inline constexpr std::array<Scheme, 3> schemes{Scheme::linear, Scheme::monotone_cubic, Scheme::mac_cormack};
inline constexpr std::array<std::string_view, 3> scheme_fields{"linear", "cubic", "mac_cormack"};

class AdvectionLesson final : public Lesson {
public:
    AdvectionLesson();

    int dimension() const override { return 2; }
    void reset() override;
    Real time_step() const override { return dt(); }
    std::string unrest() const override { return "the flow carries the blob around without end"; }
    void draw(Scene& scene) const override;
    std::optional<On> can_pull() const override { return On::handle; }
    std::vector<std::pair<std::string, Real>> dragged(const Pull& pull) const override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure&) const override { return Fix{"CFL = 1", {{"cfl", "1"}}}; }
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override { return "difference"; }
    ColourBy first_colours() const override { return {"quantity"}; }
    std::vector<std::string_view> first_plots() const override;
    std::vector<std::string_view> key_numbers() const override { return {"turns", "peak", "variance_left"}; }

private:
    Choice<Flow> field;
    Number direction;
    Choice<Blob> blob;
    Number radius;
    Whole resolution;
    Number cfl;
    Choice<Scheme> scheme;
    Choice<BackTrace> back_trace;
    Switch compare;
    Whole cell_x, cell_y;

    void declare_fields();
    void declare_stages();
    void declare_probes();
    void declare_viscosity_probes();
    void declare_lines();
    void declare_checks();

    // --- the stages ---
    void find_velocity();
    void trace_back();
    void interpolate();
    void correct();
    void carry_rivals();
    void compare_with_exact();

    Real dx() const { return Real(1) / static_cast<Real>(Index(resolution)); }
    Real dt() const { return cfl * dx() / top_speed; }
    Real time() const { return elapsed_[0]; }
    SteadyFlow flow() const;
    Shape shape() const;
    // The place that the fluid at a cell's centre was at when all began, m, by the shortest way around a periodic box.
    Vec<2> origin_of(Index cell) const;
    Vec<2> centre_of(Index cell) const;
    AdvectionSettings settings(Scheme of) const;
    void renew_advection();
    Index selected() const;
    bool corrected() const { return scheme == Scheme::mac_cormack; }

    // --- how the numbers came about (advection_why.cpp) ---
    Input step() const;
    Explanation why_on_face(int axis, Index face) const;
    Explanation why_velocity(Index cell, int component) const;
    Explanation why_middle(Index cell, int component) const;
    Explanation why_departure(Index cell, int component) const;
    Explanation why_way(Index cell) const;
    Input carrying_speed(Index cell, int component, std::string symbol) const;
    Explanation moved_into_box(Explanation why, Real free, Real place) const;
    Input why_fraction(Index cell, int axis, Index sample) const;
    Explanation why_interpolated(Index cell) const;
    Explanation why_returned(Index cell) const;
    Explanation why_corrected(Index cell) const;
    Explanation why_rival(std::size_t k, Index cell) const;
    Explanation why_exact(Index cell) const;
    Explanation why_mass() const;
    Explanation why_peak() const;
    Explanation why_variance_left() const;
    Explanation why_theory() const;

    // --- what is measured (advection_readings.cpp) ---
    Real variance(const VecX& q) const;                   // ∫q² dA, m²
    Real second_moment(const VecX& q) const;              // mean square distance from the exact middle, m²
    std::optional<Real> measured_viscosity() const;       // m²/s
    std::optional<Real> interpolation_viscosity() const;  // m²/s, of linear interpolation
    std::optional<Real> loss_per_turn() const;
    Vec<2> exact_centre() const;
    void profile(const VecX& q, Curve& curve) const;
    Real viscosity_at(Real courant, Real edge) const;  // edge: of a cell, m
    void viscosity_curve(Real edge, Curve& curve) const;
    Real turn_of_step() const;  // rad: how far the flow turns in a step

    // --- the picture (advection_picture.cpp) ---
    void draw_map(Scene& scene, const VecX& values, const Vec<2>& corner, std::string_view title, bool chosen) const;
    void draw_all_schemes(Scene& scene) const;
    void draw_path(Scene& scene) const;
    void draw_magnifier(Scene& scene) const;
    void write_notes(Scene& scene) const;

    std::unique_ptr<StaggeredGrid<2>> grid_;
    FaceField<2> velocity_;
    std::unique_ptr<SemiLagrangian<2>> advection_;
    std::array<std::unique_ptr<SemiLagrangian<2>>, 3> rivals_;

    // What defines now: the quantity, those of the other schemes where they are compared, where the fluid of each cell was at the
    // start [m], and the time [s].
    VecX quantity_;
    std::array<VecX, 3> rival_;
    Points<2> origin_;
    Eigen::Array<Real, 1, 1> elapsed_ = Eigen::Array<Real, 1, 1>::Zero();
    // What the stages make of it.
    VecX previous_, returned_, exact_, error_, way_;
    Points<2> centre_velocity_, middle_, departure_;
    Real first_variance_ = 1, first_moment_ = 0;
};

}  // namespace pliant::carrying
