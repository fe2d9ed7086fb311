// What stress and strain are: force over area, change of length over length, and the force on a plane that cuts the body.
#pragma once
#include "elasticity/linear_body/linear_body_why.h"
#include "loaded_body.h"

#include <pliant/lesson/registry.h>
#include <pliant/math/sparse_cholesky.h>

#include <cmath>
#include <memory>
#include <optional>

namespace pliant::stress_strain {

// Beyond this the quadratic term of the strain, which Cauchy's leaves out, is no longer small.
inline constexpr Real small_strain = 0.05;

// A static lesson: one step is the whole loading. Its load, radius and angle are also handles in the picture.
class StressStrainLesson final : public Lesson {
public:
    StressStrainLesson();

    int dimension() const override { return 3; }
    void check() const override;
    void reset() override;
    Real time_step() const override { return 0; }
    bool at_rest() const override { return done_[0] != 0; }
    void draw(Scene& picture) const override;
    std::optional<On> can_pull() const override { return On::handle; }
    std::vector<std::pair<std::string, Real>> dragged(const Pull& pull) const override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override { return loading == Load::cut ? "shear_stress" : "stress"; }
    ColourBy first_colours() const override { return {"displacement", -1}; }
    std::vector<std::string_view> first_plots() const override;
    std::vector<std::string_view> key_numbers() const override;

private:
    Choice<Load> loading;
    Number mass, gravity, radius, force;
    Number sigma_xx, sigma_yy, sigma_xy, angle;
    Number length, width;
    Number youngs_modulus, poisson_ratio;
    Whole resolution;

    void declare_fields();
    void declare_stages();
    void declare_probes();
    void declare_lines();
    void declare_checks();

    void apply_load();
    void solve();
    void cut();

    IsotropicModuli material() const { return IsotropicModuli::from_young_poisson(youngs_modulus, poisson_ratio); }
    // --- closed forms ---
    Real weight() const { return mass * gravity; }  // N
    Real applied_force() const { return loading == Load::disc ? -weight() : Real{force}; }
    Real loaded_area() const;                                              // m^2
    Real axial_stress() const { return applied_force() / loaded_area(); }  // Pa, positive in tension
    Mat<3> applied_stress() const;
    Mat<3> exact_strain() const;
    Vec<3> normal() const;  // of the cut
    Vec<3> normal_at(Real degrees) const;

    // --- why a number is what it is (stress_strain_why.cpp) ---
    linear_body::Hooke hooke() const;
    Input applied_stress_input(int row, int column) const;
    Explanation why_load(const Question& q) const;
    Explanation why_traction(const Question& q) const;
    Input normal_input(int axis) const;
    void explain_probes();

    // --- the picture (stress_strain_picture.cpp) ---
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
