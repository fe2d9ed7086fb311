// What stress and strain are: force over area, change of length over length, and the force on a plane that cuts the body.
#pragma once
#include "kits/linear_body/linear_body_why.h"
#include "kits/material/material_parameters.h"

#include <pliant/lesson/registry.h>
#include <pliant/math/sparse_cholesky.h>
#include <pliant/solids/loaded_body.h>

#include <cmath>
#include <memory>
#include <optional>

namespace pliant::stress_strain {

using Load = LoadCase;

// Beyond this the quadratic term of the strain, which Cauchy's leaves out, is no longer small.
inline constexpr Real small_strain = 0.05;

// A static lesson: one step is the whole loading. Its load, radius and angle are also handles in the picture.
struct StressStrainLesson final : Lesson {
    StressStrainLesson() {
        declare_fields(), declare_stages(), declare_probes(), explain_probes(), declare_lines(), declare_checks();
    }

    int dimension() const override { return 3; }
    void check() const override;
    void reset() override;
    void looked() override {
        if (loading == Load::cut && at_rest()) cut();
    }
    Real time_step() const override { return 0; }
    bool at_rest() const override { return done_[0] != 0; }
    void draw(Scene& picture) const override;
    std::optional<UnstructuredGrid> unstructured_grid() const override;
    std::optional<On> can_pull() const override { return On::handle; }
    std::vector<std::pair<std::string, Real>> dragged(const Pull& pull) const override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure&) const override { return Fix{"Y = 1 MPa", {{"youngs_modulus", "1e6"}}}; }
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override { return loading == Load::cut ? "shear_stress" : "stress"; }
    ColourBy first_colours() const override { return {"displacement", -1}; }
    std::vector<Group> first_groups() const override { return {Group::scene, Group::material, Group::forces}; }
    std::vector<std::string_view> first_plots() const override;
    std::vector<std::string_view> key_numbers() const override;

    std::function<bool()> of(Load which) const {
        return [this, which] { return loading == which; };
    }
    static ParameterInfo metres(std::string_view key, std::string_view symbol, std::string_view help, Real initial,
                                Interval useful) {
        return log_quantity(key, symbol, "m", initial, useful, {1e-9, 1e9}, help).rebuilds();
    }
    static ParameterInfo stress_of(std::string_view key, std::string_view symbol, std::string_view help, Real initial) {
        return quantity(key, symbol, "Pa", initial, {-4e4, 4e4}, {-1e15, 1e15}, help).rebuilds();
    }

    Choice<Load> loading{*this,
                         setting_of("scene", "what is loaded").in(Group::scene).rebuilds(),
                         {{"disc", "a weight on a disc"}, {"rod", "a rod, pulled or pressed"}, {"cut", "a cut through a block"}}};
    Number mass{*this,
                quantity("mass", "m", "kg", 50, {1, 100}, {0, 1e15, true}, "of the body that rests on the disc")
                    .in(Group::forces)
                    .rebuilds(),
                of(Load::disc)};
    Number gravity{*this,
                   quantity("gravity", "g", "m/s²", 9.81, {0, 25}, {0, 1e6}, "weight of a mass of 1 kg; 1.62 on the Moon")
                       .in(Group::forces)
                       .rebuilds(),
                   of(Load::disc)};
    Number radius{*this, metres("radius", "r", "of the disc", 0.1, {0.05, 0.2}).in(Group::shape), of(Load::disc)};
    Number force{*this,
                 quantity("force", "F", "N", 300, {-500, 500}, {-1e15, 1e15},
                          "on the end of the rod: it pulls where positive and presses where negative")
                     .in(Group::forces)
                     .rebuilds(),
                 of(Load::rod)};
    Number sigma_xx{*this, stress_of("sigma_xx", "σ_xx", "pull along x on the faces across x", 3e4).in(Group::forces),
                    of(Load::cut)};
    Number sigma_yy{*this, stress_of("sigma_yy", "σ_yy", "pull along y on the faces across y", -1e4).in(Group::forces),
                    of(Load::cut)};
    Number sigma_xy{*this, stress_of("sigma_xy", "σ_xy", "shear on all four of these faces", 1e4).in(Group::forces),
                    of(Load::cut)};
    Number angle{*this,
                 quantity("angle", "θ", "°", 30, {-90, 90}, {-360, 360}, "from the x axis to the normal of the cut").looks(),
                 of(Load::cut)};
    Number length{*this,
                  metres("length", "L", "height of the disc, or length of the rod or block", 0.2, {0.05, 0.5}).in(Group::shape)};
    Number width{*this, metres("width", "w", "thickness of the rod or block", 0.1, {0.05, 0.2}).in(Group::shape),
                 [this] { return loading != Load::disc; }};
    Number youngs_modulus{*this, youngs_modulus_info("stress per strain; rubber 1 MPa, steel 200 GPa", {1e5, 1e12})};
    Number poisson_ratio{*this, poisson_ratio_info("narrowing over lengthening", {-0.5, 0.49})};
    Whole resolution{*this, quantity("resolution", "n", "", 4, {2, 8}, {1, 12},
                                     "cells across, of 5 tetrahedra each; the stress is uniform and does not depend on it")
                                .in(Group::shape)
                                .rebuilds()};

    void declare_fields(), declare_stages(), declare_probes(), explain_probes(), declare_lines(), declare_checks();

    void apply_load(), solve(), cut();

    IsotropicModuli material() const { return IsotropicModuli::from_young_poisson(youngs_modulus, poisson_ratio); }
    // --- closed forms ---
    Real weight() const { return mass * gravity; }  // N
    Real applied_force() const { return loading == Load::disc ? -weight() : Real{force}; }
    Real loaded_area() const;                                              // m^2
    Real axial_stress() const { return applied_force() / loaded_area(); }  // Pa, positive in tension
    Mat<3> applied_stress() const;
    Mat<3> exact_strain() const;
    Vec<3> normal() const { return normal_at(angle); }  // of the cut
    Vec<3> normal_at(Real degrees) const;

    // --- why a number is what it is ---
    linear_body::Hooke hooke() const;
    Input applied_stress_input(int row, int column) const;
    Explanation why_load(const Question& q) const;
    Explanation why_traction(const Question& q) const;
    Input normal_input(int axis) const;

    // --- the picture ---
    Real magnification() const;
    struct WeightArrow {
        Vec<3> foot;
        Real reach;  // m, at the end of the slider
    };
    WeightArrow weight_arrow() const;
    Vec<3> drawn(Index node) const;
    void draw_disc(Scene& picture) const;
    void draw_rod(Scene& picture) const;
    void draw_cut(Scene& picture) const;

    using One = Eigen::Matrix<Real, 1, 1>;

    std::unique_ptr<LoadedBody> body_;
    SparseCholesky factor_;
    VecX right_side_, solution_;

    // What defines now: displacement and support forces [m, N], and whether the load is on.
    Points<3> displacement_, reaction_;
    One done_;
    // What the stages make of it: nodal load [N], strain, stress and the force per area on the cut with its two parts [Pa].
    Points<3> load_force_, traction_, normal_part_, shear_part_;
    Tensors<3> strain_, stress_;
};

// The largest and the smallest normal stress over all cuts that stand upright on the picture [Pa]: the middle of Mohr's circle,
// and its radius to both sides.
inline Vec<2> principal_stresses(const Mat<3>& stress) {
    const Real middle = (stress(0, 0) + stress(1, 1)) / 2, radius = std::hypot((stress(0, 0) - stress(1, 1)) / 2, stress(0, 1));
    return {middle + radius, middle - radius};
}

}  // namespace pliant::stress_strain
