// A cube under a deformation F: what four energy densities make of it.
#pragma once
#include "kits/deformation_maps/gradient_entries.h"
#include "kits/material/material_parameters.h"

#include <pliant/continuum/deformation_path.h>
#include <pliant/lesson/registry.h>
#include <pliant/solids/stretched_block.h>

#include <array>
#include <memory>
#include <optional>

namespace pliant::energies {

using Path = PathKind;
using Ends = BlockEnds;

// A static lesson: one step goes from F to the strain, the energy density and the stress, and checks one against the other.
struct EnergyDensityLesson final : Lesson {
    EnergyDensityLesson();

    int dimension() const override { return 3; }
    void check() const override;
    void reset() override;
    Real time_step() const override { return 0; }
    bool at_rest() const override { return done_[0] != 0 && (!has_block() || done_[1] != 0); }
    void draw(Scene& scene) const override;
    std::optional<UnstructuredGrid> unstructured_grid() const override;
    std::optional<On> can_pull() const override { return On::node; }
    std::vector<std::pair<std::string, Real>> dragged(const Pull& pull) const override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure&) const override { return towards_rest(); }
    std::string_view error_probe() const override { return "derivative_check"; }
    std::vector<std::string_view> first_plots() const override { return {"stress_curve", "energy_curve"}; }
    std::vector<std::string_view> key_numbers() const override { return {"psi", "P11", "det_F"}; }

    Choice<Energy> energy{*this,
                          setting_of("energy", "how much energy a deformation stores", 1).in(Group::material).rebuilds(),
                          {{"linear", "linear"},
                           {"stvk", "St. Venant–Kirchhoff"},
                           {"corotated", "corotated linear"},
                           {"neo_hookean", "neo-Hookean"}}};
    Choice<Path> path{*this,
                      setting_of("path", "how the cube is deformed").in(Group::scene).rebuilds(),
                      {{"uniaxial", "stretch, free across"},
                       {"held", "stretch, held across"},
                       {"volumetric", "stretch on all sides"},
                       {"shear", "shear"},
                       {"free", "any F"}}};
    Choice<Ends> ends{
        *this,
        setting_of("ends", "of the block that is pulled beside the cube: may they narrow?").in(Group::scene).rebuilds(),
        {{"sliding", "sliding: uniform"}, {"glued", "glued"}},
        [this] { return has_block(); }};
    Number youngs_modulus{*this, youngs_modulus_info("all four energies have it for small strain; rubber 1 MPa", {1e3, 1e9})};
    Number poisson_ratio{
        *this, poisson_ratio_info("narrowing over lengthening for small strain; near ½ every energy resists a change of volume",
                                  {-0.5, 0.4999})};
    Number stretch{*this,
                   quantity("stretch", "s", "", 1.3, {-0.3, 2}, {-0.9, 10},
                            "length now over length at rest; at 0 the cube is flat, below 0 it is turned inside out")
                       .in(Group::scene)
                       .rebuilds(),
                   [this] { return way().stretches(); }};
    Number shear{*this,
                 quantity("shear", "γ", "", 0.5, {-1.5, 1.5}, {-10, 10}, "sideways shift of the top over the height")
                     .in(Group::scene)
                     .rebuilds(),
                 [this] { return is(Path::shear); }};
    GradientEntries entries;

    void declare_fields(), declare_stages(), declare_probes(), declare_block_probes(), declare_lines(), declare_checks();

    // --- the stages ---
    void deform(), measure_strain(), evaluate_energy(), evaluate_stress(), check_derivative(), begin_block(), block_pass();

    using Rows = Eigen::Matrix<Real, 3, 3, Eigen::RowMajor>;
    using One = Eigen::Matrix<Real, 1, 1>;

    bool is(Energy wanted) const { return Energy(energy) == wanted; }
    bool is(Path wanted) const { return Path(path) == wanted; }
    Input mu() const { return lame_mu(youngs_modulus, poisson_ratio); }
    Input lambda() const { return lame_lambda(youngs_modulus, poisson_ratio); }
    Lame material() const { return IsotropicModuli::from_young_poisson(youngs_modulus, poisson_ratio).lame(); }
    EnergyDensity<3> density() const { return {energy, material()}; }
    EnergyDensity<3> density(Energy other) const { return {other, material()}; }
    DeformationPath way() const { return {path, entries.matrix()}; }
    // The amount of deformation: s, gamma, or t = 1.
    Real amount() const { return is(Path::shear) ? shear : is(Path::free) ? Real{1} : stretch; }
    // Step of the central difference.
    Real difference_step() const;
    std::optional<Real> derivative_error() const;
    // Along the path `uniaxial` a block is pulled beside the cube; its nodes follow the corners of the cube in the fields.
    bool has_block() const { return is(Path::uniaxial); }
    static constexpr Index corners = 8;
    Real stiffness() const { return way().stiffness(density(), F_); }

    // --- curves ---
    enum class Shown { psi, stress };
    std::array<Real, 2> plotted_amounts() const;
    Real largest_shown(Shown what) const;
    Real shown_value(Shown what, const EnergyDensity<3>& energy, const Mat<3>& F) const;
    void sample(Shown what, Energy of, Curve& curve) const;
    void mark_now(Shown what, Curve& curve) const;
    void mark_softest(Curve& curve) const;
    Line curve_of(Shown what) const;

    // --- why a number is what it is ---
    Input width() const;
    std::optional<Explanation> why_deformed(const Question& q) const;
    Explanation why_F(int row, int column) const, why_psi() const, why_stress(int row, int column) const,
        why_difference(int row, int column) const;
    Explanation why_strain(const Question& q) const;
    Input strain_stress(int row, int column) const, inverse_transposed(int row, int column) const;
    void explain_probes();
    std::optional<Explanation> why_block(const Question& q) const;
    Explanation why_direction(Index node, int component) const, why_unbalanced(Index node, int component) const,
        why_block_stress() const, why_block_width() const;

    // --- what would mend it ---
    Fix towards_rest() const, another_energy(Energy better) const;

    // --- the picture ---
    void draw_cube(Scene& scene) const;
    void draw_measures(Scene& scene) const;
    void draw_block(Scene& scene) const;
    void draw_tractions(Scene& scene) const;
    void draw_principal(Scene& scene) const;
    void write_notes(Scene& scene) const;

    // What defines now.
    Rows F_ = Rows::Identity(), strain_ = Rows::Zero(), rotation_ = Rows::Identity(), P_ = Rows::Zero(),
         difference_ = Rows::Zero();
    One J_{1}, I1_{3}, ln_J_{0}, psi_{0};
    // The corners of the cube, then the nodes of the block: displacement and Newton's direction [m], unbalanced force [N].
    Points<3> displacement_, direction_, unbalanced_;
    // Derivative checked; block in equilibrium or given up; iterations and relative residual of the block.
    Eigen::Matrix<Real, 4, 1> done_;

    std::unique_ptr<StretchedBlock> block_;
};

// The corner n of the unit cube, x counted fastest.
inline Vec<3> cube_corner(Index n) { return {static_cast<Real>(n % 2), static_cast<Real>(n / 2 % 2), static_cast<Real>(n / 4)}; }

}  // namespace pliant::energies
