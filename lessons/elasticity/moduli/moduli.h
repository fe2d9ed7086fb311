// Virtual tension, shear and pressure tests that measure the three moduli of a soft block.
#pragma once
#include "elasticity/linear_body/linear_body_why.h"
#include "specimen.h"

#include <pliant/continuum/energy_density.h>
#include <pliant/lesson/registry.h>

#include <memory>
#include <optional>

namespace pliant::moduli {

// Beyond this the quadratic term of the strain, which Cauchy's leaves out, is no longer small.
inline constexpr Real small_strain = 0.05;

// A static lesson: one step is the whole test, from no load to the full one.
class ModuliLesson final : public Lesson {
public:
    ModuliLesson();

    int dimension() const override { return 3; }
    void check() const override;
    void reset() override;
    Real time_step() const override { return 0; }
    bool at_rest() const override { return level() == load_levels; }
    void draw(Scene& scene) const override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override { return "measured_modulus"; }
    ColourBy first_colours() const override { return {"displacement", 0}; }
    std::vector<std::string_view> first_plots() const override { return {"measured_stress", "displacement"}; }
    std::vector<std::string_view> key_numbers() const override { return {"stress", "strain", "measured_modulus"}; }

private:
    Choice<Test> test;
    Number youngs_modulus, poisson_ratio, load;
    Number length, width;
    Whole resolution, load_levels;
    Number tolerance;
    Whole max_iterations;
    Number magnification;

    void declare_fields();
    void declare_stages();
    void declare_probes();
    void declare_lines();
    void declare_checks();

    // --- the stages ---
    void apply_load();
    void begin_solve();
    void solve_pass();
    void end_solve();
    void strain_and_stress();
    void fit_modulus();

    IsotropicModuli material() const { return IsotropicModuli::from_young_poisson(youngs_modulus, poisson_ratio); }
    Index level() const { return static_cast<Index>(level_[0]); }
    // Stress that is applied now [Pa].
    Real applied() const { return load * level_[0] / static_cast<Real>(load_levels); }
    std::optional<Real> measured_modulus() const;
    // Stress against strain of a material that knows finite strain, over the strains of this test and beyond them: all three
    // tests are uniform, so that one deformation gradient stands for the block.
    void finite_strain_curve(Energy energy, Curve& curve) const;
    Real force_imbalance() const;

    // --- why a number is what it is (moduli_why.cpp) ---
    Input applied_stress() const;
    Explanation why_load(Index node, int component) const;
    std::optional<Explanation> why_solved(const Question& q) const;
    Explanation why_strain_or_stress(const Question& q) const;
    linear_body::Hooke hooke() const;
    // --- (moduli_why_probes.cpp) ---
    void explain_probes();
    Explanation why_force() const;
    Explanation why_area() const;
    Explanation why_specimen_strain() const;
    Explanation why_modulus() const;
    Explanation why_volume_change(std::string_view symbol) const;
    Explanation why_lengthening(std::string_view symbol, std::string_view axis, int component, const Parameter& over) const;
    Explanation why_strain_energy() const;

    // --- what would mend a run (moduli_fixes.cpp) ---
    std::optional<Fix> smaller_load() const;
    std::optional<Fix> compressible() const;
    std::optional<Fix> more_iterations() const;

    // --- the picture (moduli_picture.cpp) ---
    Real drawn_magnification() const;
    Vec<3> drawn_stretch() const;
    // Length and width of the drawn block at rest.
    struct DrawnSize {
        Real length, width;
    };
    DrawnSize drawn_size() const { return {length * drawn_stretch()[0], width * drawn_stretch()[1]}; }
    Vec<3> drawn(const Vec<3>& X, const Vec<3>& u) const;
    Vec<3> drawn_exact(const Vec<3>& X) const { return drawn(X, specimen_->exact_displacement(applied(), X)); }
    void draw_body(Scene& scene) const;
    void draw_supports(Scene& scene) const;
    void draw_tension(Scene& scene) const;
    void draw_shear(Scene& scene) const;
    void draw_pressure(Scene& scene) const;
    void write_notes(Scene& scene) const;

    using One = Eigen::Matrix<Real, 1, 1>;

    std::unique_ptr<Specimen> specimen_;
    std::unique_ptr<ConjugateGradients> solver_;
    VecX right_side_, first_guess_, residual_vector_;
    bool advancing_ = false;  // does this pass through the stages go on to another load?

    // What defines now: displacement and support forces [m, N], measured points, loads done, iterations spent, residual left.
    Points<3> displacement_, reaction_;
    VecX strains_, stresses_;
    One level_, iterations_, residual_;
    // What the stages make of it: nodal load [N], b - K u [N], strain, stress [Pa].
    Points<3> load_force_, residual_force_;
    Tensors<3> strain_, stress_;
};

}  // namespace pliant::moduli
