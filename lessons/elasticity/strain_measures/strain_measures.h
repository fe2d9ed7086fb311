// Measures of one homogeneous deformation: right Cauchy-Green, Green's and Cauchy's strain, what they say of the stretch of a
// direction, and the stress that Hooke's law makes of them.
#pragma once
#include "kits/deformation_maps/map_controls.h"
#include "kits/material/material_parameters.h"

#include <pliant/continuum/moduli.h>
#include <pliant/continuum/strain.h>
#include <pliant/continuum/strain_cost.h>
#include <pliant/lesson/registry.h>

namespace pliant::strain_measures {

// Relative error from which on Cauchy's strain is said to be wrong.
inline constexpr Real tolerated = 0.01;

// A static lesson: one step measures everything. F is that of the chosen map, followed by a turn about z.
struct StrainMeasuresLesson final : Lesson {
    StrainMeasuresLesson();

    int dimension() const override { return 2; }
    void check() const override { material(); }
    void reset() override;
    void looked() override;
    Real time_step() const override { return 0; }
    bool at_rest() const override { return done_[0] != 0; }
    void draw(Scene& scene) const override;
    std::optional<On> can_pull() const override { return On::particle; }
    std::vector<std::pair<std::string, Real>> dragged(const Pull& pull) const override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure&) const override { return Fix{"shear", {{"map", "shear"}}}; }
    ColourBy first_colours() const override { return {"stretch", -1}; }
    std::vector<std::string_view> first_plots() const override { return {"strain_over_turn", "error_over_strain"}; }
    std::vector<std::string_view> key_numbers() const override { return {"green_11", "cauchy_11", "stretch_of_v"}; }

    // One tensor, row by row, and one vector.
    using Nine = Eigen::Matrix<Real, 9, 1>;
    using RowMajor = Eigen::Matrix<Real, 3, 3, Eigen::RowMajor>;
    using One = Eigen::Matrix<Real, 1, 1>;

    MapControls controls;
    Number turn{*this, quantity("turn", "θ", "°", 0, {-180, 180}, {-3600, 3600},
                                "rotation about z that follows the map; no strain should see it")
                           .in(Group::scene)
                           .rebuilds()};
    Number v_angle{*this, quantity("v_angle", "ψ", "°", 30, {-180, 180}, {-3600, 3600},
                                   "of the direction v in the plane of the picture, from x; drag the head of v")
                              .in(Group::view)
                              .looks()};
    Number v_elevation{
        *this, quantity("v_elevation", "η", "°", 0, {-90, 90}, {-90, 90}, "of the direction v out of that plane, towards you")
                   .in(Group::view)
                   .looks()};
    Number youngs_modulus{*this, youngs_modulus_info("stress per strain in tension; rubber 1 MPa, steel 200 GPa", {1e3, 1e12})};
    Number poisson_ratio{*this, poisson_ratio_info("narrowing over lengthening", {-0.5, 0.49})};

    void declare_fields(), declare_stages(), declare_probes(), declare_components(), declare_lines(), declare_checks(),
        explain_probes();

    // --- the stages ---
    void deform(), measure_stretches(), apply_hooke();

    IsotropicModuli material() const { return IsotropicModuli::from_young_poisson(youngs_modulus, poisson_ratio); }
    // F - I of the chosen map, followed by a turn by this angle [rad].
    Mat<3> slope_after(Real angle) const;
    Vec<3> direction() const;       // v at rest, of length 1
    Vec<3> sampled(Index k) const;  // a direction of the plane of the picture
    std::optional<Mat<3>> exact_C() const { return map_.right_cauchy_green(Vec<3>::Zero()); }
    static Mat<3> of(const Nine& tensor) { return Eigen::Map<const RowMajor>(tensor.data()); }

    // --- why a number is what it is ---
    Explanation why_deformation(const Question& q) const;
    Explanation why_stretch(const Question& q) const;
    Explanation why_stress(const Question& q) const;
    Input map_entry(int i, int j) const;
    std::vector<Input> sampled_inputs(Index k) const;

    // --- what would mend a run ---
    std::optional<Fix> smaller() const, not_inverted() const;

    // --- the picture ---
    void draw_circle(Scene& scene) const;
    void draw_direction(Scene& scene) const;
    void draw_ellipses(Scene& scene) const;
    void write_numbers(Scene& scene) const;
    void write_hookes_law(Scene& scene) const;
    Real reach() const;  // half the height of the framed picture

    DeformationMap map_;
    OperationCounts operations_;

    Nine deformation_, slope_, C_, green_, cauchy_, stress_green_, stress_cauchy_;
    Vec<3> v_, deformed_v_;
    VecX stretch_, cauchy_stretch_;  // of the sampled directions
    bool stretched_ = false;         // are the stretches measured?
    One done_;
};

}  // namespace pliant::strain_measures
