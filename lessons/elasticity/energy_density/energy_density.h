// A cube under a deformation F: what four energy densities make of it.
#pragma once
#include "deformation_path.h"
#include "stretched_block.h"

#include <pliant/lesson/registry.h>

#include <array>
#include <memory>
#include <optional>

namespace pliant::energies {

// A static lesson: one step goes from F to the strain, the energy density and the stress, and checks one against the other.
class EnergyDensityLesson final : public Lesson {
public:
    EnergyDensityLesson();

    int dimension() const override { return 3; }
    void check() const override;
    void reset() override;
    Real time_step() const override { return 0; }
    bool at_rest() const override { return done_[0] != 0 && (!has_block() || done_[1] != 0); }
    void draw(Scene& scene) const override;
    std::optional<On> can_pull() const override { return On::node; }
    std::vector<std::pair<std::string, Real>> dragged(const Pull& pull) const override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    std::string_view error_probe() const override { return "derivative_check"; }
    std::vector<std::string_view> first_plots() const override { return {"stress_curve", "energy_curve"}; }
    std::vector<std::string_view> key_numbers() const override { return {"psi", "P11", "det_F"}; }

private:
    Choice<Energy> energy;
    Choice<Path> path;
    Choice<Ends> ends;
    Number youngs_modulus, poisson_ratio, stretch, shear;
    Number F11, F12, F13, F21, F22, F23, F31, F32, F33;

    void declare_fields();
    void declare_stages();
    void declare_probes();
    void declare_block_probes();
    void declare_lines();
    void declare_checks();

    // --- the stages ---
    void deform();
    void measure_strain();
    void evaluate_energy();
    void evaluate_stress();
    void check_derivative();
    void begin_block();
    void block_pass();

    using Rows = Eigen::Matrix<Real, 3, 3, Eigen::RowMajor>;
    using One = Eigen::Matrix<Real, 1, 1>;

    bool is(Energy wanted) const { return Energy(energy) == wanted; }
    bool is(Path wanted) const { return Path(path) == wanted; }
    Lame material() const { return IsotropicModuli::from_young_poisson(youngs_modulus, poisson_ratio).lame(); }
    EnergyDensity<3> density() const { return {energy, material()}; }
    EnergyDensity<3> density(Energy other) const { return {other, material()}; }
    Mat<3> given() const;
    DeformationPath way() const { return {path, given()}; }
    // The amount of deformation: s, gamma, or t = 1.
    Real amount() const { return is(Path::shear) ? shear : is(Path::free) ? Real{1} : stretch; }
    // Step of the central difference.
    Real difference_step() const;
    std::optional<Real> derivative_error() const;
    // Along the path `uniaxial` a block is pulled beside the cube; its nodes follow the corners of the cube in the fields.
    bool has_block() const { return is(Path::uniaxial); }
    static constexpr Index corners = 8;
    Real stiffness() const { return way().stiffness(density(), F_); }

    // --- curves (energy_density_curves.cpp) ---
    enum class Shown { psi, stress };
    std::array<Real, 2> plotted_amounts() const;
    Real shown_value(Shown what, const EnergyDensity<3>& energy, const Mat<3>& F) const;
    Real largest_shown(Shown what) const;
    void sample(Shown what, Energy of, Curve& curve) const;
    void mark_now(Shown what, Curve& curve) const;
    void mark_softest(Curve& curve) const;
    Line curve_of(Shown what) const;

    // --- why a number is what it is (energy_density_why.cpp, ..._why_stress.cpp) ---
    Input width() const;
    std::optional<Explanation> why_deformed(const Question& q) const;
    Explanation why_F(int row, int column) const;
    Explanation why_strain(const Question& q) const;
    Explanation why_psi() const;
    Explanation why_stress(int row, int column) const;
    Explanation why_difference(int row, int column) const;
    Input strain_stress(int row, int column) const;
    Input inverse_transposed(int row, int column) const;
    void explain_probes();
    // --- (energy_density_why_block.cpp) ---
    std::optional<Explanation> why_block(const Question& q) const;
    Explanation why_direction(Index node, int component) const;
    Explanation why_unbalanced(Index node, int component) const;
    Explanation why_block_stress() const;
    Explanation why_block_width() const;

    // --- what would mend it (energy_density_fixes.cpp) ---
    Fix towards_rest() const;
    Fix another_energy(Energy better) const;

    // --- the picture (energy_density_picture.cpp) ---
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
