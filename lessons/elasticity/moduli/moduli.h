// Virtual tension, shear and pressure tests that measure the three moduli of a soft block.
#pragma once
#include "kits/linear_body/linear_body_why.h"
#include "kits/material/material_parameters.h"

#include <pliant/continuum/energy_density.h>
#include <pliant/lesson/registry.h>
#include <pliant/solids/specimen.h>

#include <memory>
#include <optional>

namespace pliant::moduli {

using Test = MaterialTest;

// Beyond this the quadratic term of the strain, which Cauchy's leaves out, is no longer small.
inline constexpr Real small_strain = 0.05;

// A static lesson: one step is the whole test, from no load to the full one.
struct ModuliLesson final : Lesson {
    ModuliLesson() { declare_fields(), declare_stages(), declare_probes(), explain_probes(), declare_lines(), declare_checks(); }

    int dimension() const override { return 3; }
    void check() const override;
    void reset() override;
    Real time_step() const override { return 0; }
    bool at_rest() const override { return level() == load_levels; }
    void draw(Scene& scene) const override;
    std::optional<UnstructuredGrid> unstructured_grid() const override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override { return "measured_modulus"; }
    ColourBy first_colours() const override { return {"displacement", 0}; }
    std::vector<Group> first_groups() const override { return {Group::scene, Group::material, Group::forces}; }
    std::vector<std::string_view> first_plots() const override { return {"measured_stress", "displacement"}; }
    std::vector<std::string_view> key_numbers() const override { return {"stress", "strain", "measured_modulus"}; }

    Choice<Test> test{*this,
                      setting_of("test", "what the machine does to the block").in(Group::scene).rebuilds(),
                      {{"tension", "tension: Y"}, {"shear", "shear: G"}, {"pressure", "pressure: B"}}};
    Number youngs_modulus{*this, youngs_modulus_info("stress per strain in tension; rubber 1 MPa, steel 200 GPa", {1e3, 1e12})};
    Number poisson_ratio{
        *this, poisson_ratio_info("narrowing over lengthening; 0.5 would be incompressible, below 0 the block widens when pulled",
                                  {-0.5, 0.49})};
    Number load{*this, quantity("load", "σ", "Pa", 2e4, {0, 1e5}, {-1e15, 1e15},
                                "force per area of the pull, the shear or the pressure at the end of the test")
                           .in(Group::forces)
                           .rebuilds()};
    Number length{
        *this,
        log_quantity("length", "L", "m", 0.2, {0.02, 2}, {1e-9, 1e9}, "of the block, along x").in(Group::shape).rebuilds()};
    Number width{
        *this,
        log_quantity("width", "w", "m", 0.1, {0.01, 1}, {1e-9, 1e9}, "of the block, along y and z").in(Group::shape).rebuilds()};
    Whole resolution{
        *this, quantity("resolution", "n", "", 4, {1, 8}, {1, 16},
                        "cells across the width, of 5 tetrahedra each; along the length as many as keep them cubes, at most 4 n")
                   .in(Group::shape)
                   .rebuilds()};
    Whole load_levels{*this, quantity("load_levels", "m", "", 5, {1, 10}, {1, 100},
                                      "loads between none and the full one, each solved and measured")
                                 .in(Group::method)
                                 .rebuilds()};
    Number tolerance{*this, log_quantity("tolerance", "τ", "", 1e-12, {1e-13, 1e-1}, {1e-15, 0.9},
                                         "conjugate gradients stop when |f − K u| ≤ τ |f|")
                                .in(Group::solver)
                                .rebuilds()};
    Whole max_iterations{*this, log_quantity("max_iterations", "", "", 5000, {1, 5000}, {1, 1000000},
                                             "of the solver at each load; more are needed on fine meshes and near ν = ½")
                                    .in(Group::solver)
                                    .rebuilds()};
    Number magnification{*this, quantity("magnification", "", "", 0, {0, 100}, {0, 1e12},
                                         "of the drawn deformation, the numbers are not touched; 0 chooses one")
                                    .in(Group::view)
                                    .looks()};

    void declare_fields(), declare_stages(), declare_probes(), explain_probes(), declare_lines(), declare_checks();

    // --- the stages ---
    void apply_load(), begin_solve(), solve_pass(), end_solve(), strain_and_stress(), fit_modulus();

    IsotropicModuli material() const { return IsotropicModuli::from_young_poisson(youngs_modulus, poisson_ratio); }
    Index level() const { return static_cast<Index>(level_[0]); }
    // The last load whose strain and stress are measured: while the present one is being solved, the one before.
    Index measured_level() const;
    // Stress that is applied now [Pa].
    Real applied() const { return load * level_[0] / static_cast<Real>(load_levels); }
    std::optional<Real> measured_modulus() const;
    // Stress against strain of a material that knows finite strain, over the strains of this test and beyond them: all three
    // tests are uniform, so that one deformation gradient stands for the block.
    void finite_strain_curve(Energy energy, Curve& curve) const;
    // What is left of all loads and support forces together.
    Real force_imbalance() const { return (applied() * specimen_->unit_load() + reaction_).rowwise().sum().norm(); }

    // --- why a number is what it is ---
    Input applied_stress() const;
    Explanation why_load(Index node, int component) const;
    std::optional<Explanation> why_solved(const Question& q) const;
    Explanation why_strain_or_stress(const Question& q) const;
    linear_body::Hooke hooke() const;
    Explanation why_force() const, why_area() const, why_specimen_strain() const, why_modulus() const,
        why_volume_change(std::string_view symbol) const, why_strain_energy() const;
    Explanation why_lengthening(std::string_view symbol, std::string_view axis, int component, const Parameter& over) const;

    // --- what would mend a run ---
    std::optional<Fix> smaller_load() const, compressible() const, more_iterations() const;

    // --- the picture ---
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
