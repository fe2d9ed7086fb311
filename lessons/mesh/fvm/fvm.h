// Finite volumes: an elastic body moves by the forces on the faces of its elements, each shared evenly among the nodes of its
// face; beside them the nodal forces of finite elements.
#pragma once
#include "kits/schemes/scheme_options.h"
#include "kits/solid_mesh/solid_motion.h"
#include "kits/solid_mesh/solid_parameters.h"
#include "kits/solid_mesh/solid_picture.h"
#include "kits/solid_mesh/solid_why.h"
#include "kits/springs/net_parameters.h"

#include <pliant/lesson/registry.h>
#include <pliant/solids/face_forces.h>
#include <pliant/time/stability.h>

#include <memory>
#include <optional>

namespace pliant::fvm {

using solid_mesh::Drawn, solid_mesh::Law, solid_mesh::Plane, solid_mesh::Shape, solid_mesh::Small, solid_mesh::Solid;

enum class Setting { panel, beam, free };

// Of implicit steps, whose matrix is factorised in every iteration.
inline constexpr Index most_implicit_nodes = 3000;

struct FvmLesson final : Lesson {
    FvmLesson() { declare_fields(), declare_stages(), declare_probes(), explain_probes(), declare_lines(), declare_checks(); }

    int dimension() const override { return in_space() ? 3 : 2; }
    void check() const override;
    void reset() override;
    Real time_step() const override { return dt; }
    bool at_rest() const override;
    std::string unrest() const override;
    void draw(Scene& scene) const override;
    std::optional<UnstructuredGrid> unstructured_grid() const override { return solid_->grid(displacement()); }
    std::optional<On> can_pull() const override { return On::node; }
    void pull(const std::optional<Pull>& hand) override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    std::vector<Fix> other_fixes(const Failure& failure) const override;
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override { return is(Setting::free) ? "elastic_energy" : "tip_y"; }
    ColourBy first_colours() const override { return {"cauchy_stress", 0}; }
    std::vector<std::string_view> first_plots() const override;
    std::vector<std::string_view> key_numbers() const override;
    std::vector<Group> first_groups() const override { return {Group::scene, Group::method, Group::material, Group::forces}; }
    std::vector<std::string_view> map_knobs() const override { return {"time_step", "youngs_modulus"}; }

    bool is(Setting wanted) const { return Setting(setting) == wanted; }
    bool in_space() const { return is(Setting::beam); }

    Choice<Setting> setting{*this,
                            setting_of("scene", "what moves").in(Group::scene).rebuilds(),
                            {{"panel", "a panel of triangles, held at one edge"},
                             {"beam", "a beam of tetrahedra, held at one end"},
                             {"free", "a panel that spins freely"}}};
    solid_mesh::SolidParameters body{
        *this,
        {.law = {},
         .plane = [this] { return !in_space(); },
         .beam = [this] { return in_space(); },
         .cells = {},
         .load = [this] { return held(); },
         .space_load = [this] { return in_space(); },
         .panel = [this] { return !in_space(); }},
        {.youngs_modulus = 2e5, .load_y = -300, .height = 0.4, .width = 0.4, .cells_x = 6, .plane = Plane::strain}};
    Number density{*this, log_quantity("density", "ρ", "kg/m³", 1000, {10, 1e4}, {1e-9, 1e9},
                                       "of the body; a node carries an equal share of the mass of each of its elements")
                              .in(Group::material)
                              .rebuilds()};
    Number damping{
        *this, quantity("damping", "α", "1/s", 0, {0, 5}, {0, 1e6}, "damping −α m v of every node; 0: none").in(Group::material)};
    Number gravity{*this, quantity("gravity", "g", "m/s²", 0, {0, 20}, {0, 1e6}, "acceleration of gravity, downwards")
                              .in(Group::forces)
                              .when([this] { return held(); })};
    Number spin_rate{*this, quantity("spin", "Ω", "rad/s", 3, {0, 10}, {-1e4, 1e4}, "angular velocity at the start")
                                .in(Group::start)
                                .rebuilds()
                                .when([this] { return !held(); })};
    Choice<Scheme> scheme{*this, setting_of("integrator", "how forces become motion", 1).in(Group::method), scheme_options(3)};
    Number dt{*this, fixed_time_step(2e-3, {1e-5, 0.1})};
    Number pull_stiffness{*this, springs::pull_stiffness_from(500, {1, 1e5})};
    Number newton_tolerance{
        *this,
        newton_tolerance_from(1e-9, "Newton's method stops when its step is shorter than this fraction of a cell").when([this] {
            return implicit();
        })};
    Whole newton_cap{*this, newton_iterations().when([this] { return implicit(); })};
    Whole element_shown{
        *this, quantity("element_shown", "e", "", 15, {0, 60}, {0, 1e9}, "the element that is lit, with the forces on its faces")
                   .in(Group::view)
                   .looks()};
    Number shrink{*this, quantity("shrink", "", "", 0.12, {0, 0.6}, {0, 0.9}, "by which share elements are drawn smaller")
                             .in(Group::view)
                             .looks()};
    Switch all_faces{
        *this, setting_of("all_faces", "the force on every face, not on those of the lit element alone").in(Group::view).looks()};

    void declare_fields(), declare_stages(), declare_probes(), explain_probes(), declare_lines(), declare_checks(),
        declare_assumptions();

    // --- what the parameters mean ---
    bool held() const { return !is(Setting::free); }
    bool implicit() const { return is_implicit(scheme); }
    bool damped() const { return damping > 0; }
    bool turns() const { return Law(body.law) == Law::corotational; }
    bool flies_apart() const { return !held() && Law(body.law) == Law::linear; }
    bool pulled() const { return pull_ && pull_stiffness > 0; }
    Shape shape() const { return in_space() ? Shape::beam : Shape::panel; }
    Real weight_acceleration() const { return held() ? Real{gravity} : Real{0}; }
    Vec<3> load_force() const;  // N
    bool loaded() const { return weight_acceleration() > 0 || load_force().norm() > 0 || pulled(); }
    solid_mesh::SolidWhy why() const { return {solid_.get(), &body}; }
    Index lit() const { return std::min<Index>(Index(element_shown), solid_->element_count() - 1); }

    // --- faces: that of element e opposite its corner k is number (dim + 1) e + k ---
    int corners() const { return solid_->dim() + 1; }
    Index face(Index element, int opposite) const { return corners() * element + opposite; }
    // Its nodes, so that the area vector points outward.
    std::vector<Index> face_nodes(Index element, int opposite) const;
    Small taken(const MatX& tensors, Index element) const;
    void put(MatX& tensors, Index element, const Small& value) const;

    // --- the stages ---
    void measure_areas(), deform(), turn(), measure_strain(), evaluate_stress(), true_stress(), face_forces(), share(),
        fem_forces(), outer_forces(), begin_integration(), integrate(), end_integration();
    void begin_faces();
    solid_mesh::OuterLoad outer_load() const;
    MatX load_on_nodes() const;  // N
    const MatX& displacement() const;

    // --- readings ---
    Real tip(int component) const;
    Real largest_face_force() const;
    std::optional<Real> difference_from_fem() const, difference_of_forms() const;
    Real sum_of_faces() const;
    Real face_rounding() const;
    Real kinetic() const;
    Real elastic() const { return solid_->energy(displacement()); }
    Real outer_energy() const;
    Real total_energy() const { return kinetic() + elastic() + outer_energy(); }
    Real speed_scale() const;    // m/s
    Real motion_energy() const;  // J that motion can come to
    Real energy_tolerance() const;
    VecX momentum() const;
    Real spin() const;  // kg m²/s, magnitude about the centre of mass
    Real momentum_terms() const;
    Real smallest_volume_ratio() const;
    Real fastest() const;           // rad/s, of small vibrations
    Real stable_time_step() const;  // s
    std::optional<Fix> stable_fix() const;
    Vec<3> cut_force(Index cut, bool from_left) const;
    Real slender_deflection(Real x) const;

    // --- why a number is what it is ---
    std::optional<Explanation> why_element(const Question&q) const, why_face(const Question&q) const,
        why_shared(const Question&q) const, why_outer(const Question&q) const, why_integrated(const Question&q) const;
    Explanation why_rest_area(Index face, int component) const, why_deformed_area(Index face, int component) const,
        why_cauchy(Index element, int i, int j) const, why_true_force(Index face, int component) const;
    Explanation why_load(Index node, int component) const;
    Input node_mass(Index node) const;
    std::vector<Input> forces_on(Index node, int component) const, balanced_forces_on(Index node, int component) const;
    Input newton_start(Index node, int component) const;

    // --- the picture ---
    Drawn drawn() const { return {solid_.get(), &displacement()}; }
    void draw_elements(Scene&scene) const, draw_face_forces(Scene&scene) const, draw_nodal_forces(Scene&scene) const,
        write_notes(Scene&scene) const;
    Real arrow_scale() const;  // m/N
    Vec<3> apart(Index element, const Vec<3>&x) const, middle_of_face(Index element, int opposite) const;

    std::unique_ptr<Solid> solid_;
    // One of each pair is in use. The elements are those of solid_.
    const HyperelasticFem<2>* plane_elements_ = nullptr;
    const HyperelasticFem<3>* space_elements_ = nullptr;
    std::unique_ptr<FaceForceBody<2>> plane_;
    std::unique_ptr<FaceForceBody<3>> space_;
    std::unique_ptr<solid_mesh::SolidMotion> motion_;
    std::optional<Pull> pull_;
    Index first_of_pass_ = 0, next_element_ = 0;  // in the loop over the elements
    bool loop_runs_ = false;
    bool forces_meet_ = false;                 // both forces on the nodes belong to the same places
    Real start_kinetic_ = 0, start_spin_ = 0;  // J, kg m²/s
    bool interfered_ = false;

    // State, dim × nodes [m, m/s], and the time [s].
    MatX position_, velocity_;
    VecX clock_ = VecX::Zero(1);
    VecX start_position_, total_force_;  // of the step
    MatX force_, fem_force_, outer_force_, damping_force_;
    MatX deformation_, rotation_, strain_, stress_, cauchy_;
    MatX rest_area_, deformed_area_, face_force_, true_face_force_;
    VecX volume_, mass_;
    mutable MatX displacement_;
    mutable std::optional<Real> fastest_, compliance_;  // rad/s; J that the load does on its way to rest
};

}  // namespace pliant::fvm
