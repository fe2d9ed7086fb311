// Poisson's ratio: a cube that narrows as it is stretched, and linear triangles that lock where it may not change its volume.
#pragma once
#include "kits/linear_body/linear_body_picture.h"
#include "kits/linear_body/linear_body_why.h"
#include "kits/material/material_parameters.h"

#include <pliant/continuum/contraction_law.h>
#include <pliant/continuum/deformation.h>
#include <pliant/lesson/registry.h>
#include <pliant/solids/cooks_membrane.h>
#include <pliant/solids/cooks_membrane_table.h>
#include <pliant/solids/stretched_cube.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace pliant::poisson {

enum class Setting { stretch, bending };
enum class Method { incremental, linear };

// A static lesson: one step is the whole stretch, increment by increment, or the panel for one ratio after another.
struct PoissonLesson final : Lesson {
    PoissonLesson() { declare_fields(), declare_stages(), declare_probes(), explain_probes(), declare_lines(), declare_checks(); }

    int dimension() const override { return bends() ? 2 : 3; }
    void check() const override;
    void reset() override;
    Real time_step() const override { return 0; }
    bool at_rest() const override { return done() == rounds(); }
    void draw(Scene& scene) const override;
    std::optional<UnstructuredGrid> unstructured_grid() const override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure&) const override { return fix_by(poisson_ratio, 0.3); }
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override { return bends() ? "deflection" : "narrowing"; }
    ColourBy first_colours() const override { return {"displacement", -1}; }
    std::vector<std::string_view> first_plots() const override {
        return {"narrowing_over_lengthening", "volume_over_strain", "locking"};
    }
    std::vector<std::string_view> key_numbers() const override {
        if (bends()) return {"deflection", "times_too_stiff"};
        return {"narrowing", "narrowing_by_law", "volume_ratio"};
    }

    const std::function<bool()> stretched = [this] { return !bends(); }, bent = [this] { return bends(); };

    Choice<Setting> setting{*this,
                            setting_of("scene", "a cube that is pulled, or a panel that is bent").in(Group::scene).rebuilds(),
                            {{"stretch", "stretched cube"}, {"bending", "bent panel: locking"}}};
    Choice<Method> method{
        *this,
        setting_of("method", "linear elasticity in small steps, each on the shape reached before, or in one step")
            .in(Group::method)
            .rebuilds(),
        {{"incremental", "many small steps"}, {"linear", "one linear step"}},
        stretched};
    Number poisson_ratio{
        *this, poisson_ratio_info("narrowing over lengthening; 0.5 would be incompressible, below 0 the cube widens when pulled",
                                  {-0.9, 0.4999})};
    Number axial_strain{*this,
                        quantity("axial_strain", "ΔL/L", "", 0.5, {-0.6, 2}, {-1, 100, true, false},
                                 "lengthening over length, at the end; negative pushes")
                            .in(Group::scene)
                            .rebuilds(),
                        stretched};
    Whole increments{*this,
                     quantity("increments", "N", "", 20, {1, 60}, {1, 1000},
                              "steps of equal lengthening; the error of the contraction halves when they are doubled")
                         .in(Group::method)
                         .rebuilds(),
                     [this] { return !bends() && method == Method::incremental; }};
    Number length{
        *this,
        log_quantity("length", "L", "m", 0.1, {0.01, 1}, {1e-6, 1e6}, "of the edges of the cube").in(Group::shape).rebuilds(),
        stretched};
    Whole resolution{*this,
                     quantity("resolution", "n", "", 2, {1, 4}, {1, 8},
                              "cells along each edge of the cube, of 5 tetrahedra each; the strain is uniform, so one would do")
                         .in(Group::shape)
                         .rebuilds(),
                     stretched};
    Whole membrane_cells{*this,
                         quantity("membrane_cells", "m", "", 8, {2, 16}, {1, 32},
                                  "pairs of cells along each edge of the panel; every cell is two linear triangles")
                             .in(Group::shape)
                             .rebuilds(),
                         bent};

    void declare_fields(), declare_stages(), declare_probes(), explain_probes(), declare_lines(), declare_checks();

    // --- what the parameters mean ---
    bool bends() const { return setting == Setting::bending; }
    Index steps() const { return method == Method::linear ? 1 : Index(increments); }
    // How often the loop runs: steps of the cube, or ratios of the panel.
    Index rounds() const { return bends() ? static_cast<Index>(ratios().size()) : steps(); }
    // Ratios for which the panel is bent; the present one last.
    std::vector<Real> ratios() const;
    Real ratio_of_round(Index k) const { return ratios()[static_cast<std::size_t>(k)]; }

    // --- the stages ---
    void stretch_cube(), solve(), move(), measure(), bend(), read_deflection();
    Index done() const { return static_cast<Index>(done_[0]); }
    Real reached() const { return axial_strain * done_[0] / static_cast<Real>(steps()); }  // dL/L so far
    Input why_reached() const;

    // --- why a number is what it is ---
    std::optional<Explanation> why_number(const Question& q) const;
    Input number_of_steps() const { return Input::constant("N", static_cast<Real>(steps()), "", "number of steps"); }
    Explanation why_increment(Index node, int component) const, why_volume(Index element) const;
    Explanation why_bent(Index node, int component) const;

    // --- the picture ---
    void draw_cube(Scene&) const, draw_pull(Scene&) const, draw_measures(Scene&) const;
    void write_notes(Scene&) const, draw_panel(Scene&) const, draw_deflection(Scene&, Position) const;

    std::unique_ptr<StretchedCube> cube_;
    std::unique_ptr<CooksMembrane> membrane_;
    bool advancing_ = false;  // does this pass through the stages go on?

    // What defines now: displacements of the cube or of the panel [m]; lengthening, narrowing and volume after each round, and
    // the panel's deflection for each ratio; rounds that are done.
    Points<3> displacement_;
    VecX strains_, contractions_, volumes_, deflections_;
    std::array<Real, 1> done_{};
    // What the stages make of it.
    Points<3> prescribed_, increment_;
    VecX element_volumes_;
};

}  // namespace pliant::poisson
