// Finite elements from one element up: shape functions, F, strain, stress, the element's stiffness, assembly, and the solution of
// what follows, static or moving.
#pragma once
#include "fem_motion.h"
#include "kits/schemes/scheme_options.h"
#include "kits/solid_mesh/solid_parameters.h"
#include "kits/solid_mesh/solid_picture.h"
#include "kits/solid_mesh/solid_why.h"

#include <pliant/lesson/registry.h>
#include <pliant/math/remembered.h>

#include <memory>
#include <optional>
#include <string>
#include <tuple>

namespace pliant::fem {

using solid_mesh::Drawn, solid_mesh::Law, solid_mesh::Plane, solid_mesh::Shape, solid_mesh::Small, solid_mesh::Solid;

enum class Setting { beam, cook, manufactured, twist, spin, drop, own };
enum class Order { linear, quadratic };
enum class Turned { end, support };
enum class Course { at_once, in_motion };
enum class MassKind { consistent, lumped };

// One step is one solve, or a step in time.
struct FemLesson final : Lesson {
    FemLesson();

    int dimension() const override { return in_plane() ? 2 : 3; }
    void check() const override;
    void reset() override;
    void looked() override {}
    Real time_step() const override { return moving() ? Real{dt} : Real{0}; }
    bool at_rest() const override;
    std::string unrest() const override;
    void draw(Scene& scene) const override;
    std::optional<On> can_pull() const override { return bent() || moving() ? std::optional(On::node) : std::nullopt; }
    void pull(const std::optional<Pull>& hand) override;
    std::optional<UnstructuredGrid> unstructured_grid() const override { return solid_->grid(displacement_); }
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure& failure) const override;
    std::vector<Fix> other_fixes(const Failure& failure) const override;
    std::vector<std::pair<std::string, std::string>> finer() const override;
    std::string_view error_probe() const override;
    ColourBy first_colours() const override { return {"von_mises", -1}; }
    std::vector<std::string_view> first_plots() const override;
    std::vector<std::string_view> key_numbers() const override;
    std::vector<Group> first_groups() const override { return {Group::scene, Group::method, Group::material, Group::forces}; }

    bool is(Setting wanted) const { return Setting(setting) == wanted; }
    const std::function<bool()> in_beam = [this] { return shape() == Shape::beam; },
                                bent = [this] { return is(Setting::beam) || is(Setting::cook) || is(Setting::own); },
                                has_law = [this] { return !is(Setting::manufactured); };

    Choice<Setting> setting{*this,
                            setting_of("scene", "what is computed").in(Group::scene).rebuilds(),
                            {{"beam", "a beam, held at one end"},
                             {"cook", "Cook's membrane: a panel in the plane"},
                             {"manufactured", "a solution that is known: how large is the error?"},
                             {"twist", "a beam whose end is turned"},
                             {"spin", "a beam that spins freely"},
                             {"drop", "a beam that falls on the ground"},
                             {"own", "a body of one's own"}}};
    Choice<Course> course{*this,
                          setting_of("motion", "the equilibrium at once, or the way to it in time").in(Group::scene).rebuilds(),
                          {{"static", "equilibrium"}, {"dynamic", "in motion"}},
                          bent};
    File mesh_file{
        *this,
        file_of("mesh_file", "triangles or tetrahedra, with the groups \"fixed\" and \"loaded\" of boundary faces; none: a gear",
                {".msh", ".vtu", ".vtk"})
            .in(Group::scene)
            .with("scene", "own")
            .when([this] { return is(Setting::own); })};
    solid_mesh::SolidParameters body{*this,
                                     {.law = has_law,
                                      .plane = [this] { return in_plane(); },
                                      .beam = in_beam,
                                      .cells = [this] { return !is(Setting::own); },
                                      .load = bent,
                                      .space_load = [this] { return bent() && !in_plane(); }}};
    Choice<Order> element_kind{*this,
                               setting_of("element", "corners alone, or the middles of edges too").in(Group::method).rebuilds(),
                               {{"linear", "linear"}, {"quadratic", "quadratic"}}};
    Number twist_angle{*this,
                       quantity("twist_angle", "φ", "°", 60, {0, 180}, {-3600, 3600}, "by which a face is turned about the beam")
                           .in(Group::scene)
                           .rebuilds(),
                       [this] { return is(Setting::twist); }};
    Choice<Turned> turned{*this,
                          setting_of("turned", "the far end against the held one, or the support with all that hangs on it")
                              .in(Group::scene)
                              .rebuilds(),
                          {{"end", "the far end"}, {"support", "the support: a rotation of the whole"}},
                          [this] { return is(Setting::twist); }};
    Whole load_steps{*this, quantity("load_steps", "m", "", 1, {1, 20}, {1, 1000},
                                     "parts in which load or turning is applied, each solved from the one before")
                                .in(Group::method)
                                .rebuilds()
                                .when([this] { return has_law() && !moving(); })};
    Choice<Scheme> integrator{
        *this, setting_of("integrator", "how forces become motion", Scheme::implicit_euler).in(Group::method).when([this] {
            return moving() && !is(Setting::drop);
        }),
        scheme_options(3)};
    Number dt{*this, fixed_time_step(0.01, {1e-5, 0.1}).when([this] { return moving(); })};
    Choice<MassKind> mass_kind{*this,
                               setting_of("mass", "as the shape functions spread it, or all of it on the nodes", MassKind::lumped)
                                   .in(Group::method)
                                   .rebuilds()
                                   .when([this] { return !is(Setting::drop); }),
                               {{"consistent", "consistent"}, {"lumped", "lumped"}}};
    Number density{*this, log_quantity("density", "ρ", "kg/m³", 1000, {10, 2e4}, {1e-9, 1e12}, "mass per volume; water has 1000")
                              .in(Group::material)
                              .rebuilds()};
    Number mass_damping{*this, quantity("mass_damping", "α", "1/s", 0.2, {0, 10}, {0, 1e12},
                                        "damping by the mass: brakes every motion, also that of the whole")
                                   .in(Group::material)
                                   .when([this] { return moving() && !is(Setting::spin); })};
    Number stiffness_damping{*this, quantity("stiffness_damping", "β", "s", 0, {0, 0.1}, {0, 1e6},
                                             "damping by the stiffness: brakes fast vibrations most, and no motion of the whole")
                                        .in(Group::material)
                                        .when([this] { return moving(); })};
    Number gravity{*this, quantity("gravity", "g", "m/s²", 9.81, {0, 20}, {0, 1e6}, "acceleration of gravity, downwards")
                              .in(Group::forces)
                              .when([this] { return moving() && !is(Setting::spin); })};
    Number spin_rate{*this,
                     quantity("spin", "Ω", "rad/s", 3, {0, 10}, {-1e6, 1e6}, "angular velocity at the start, about the z axis")
                         .in(Group::start)
                         .rebuilds()
                         .when([this] { return is(Setting::spin); })};
    Number drop_height{
        *this, quantity("drop_height", "h₀", "m", 0.3, {0, 2}, {0, 1e6}, "of the lowest point above the ground at the start")
                   .in(Group::start)
                   .rebuilds()
                   .when([this] { return is(Setting::drop); })};
    Number tilt{*this, quantity("tilt", "ψ", "°", 30, {-90, 90}, {-360, 360}, "of the beam about the z axis at the start")
                           .in(Group::start)
                           .rebuilds()
                           .when([this] { return is(Setting::drop); })};
    Number friction{*this, quantity("friction", "μ_g", "", 0.5, {0, 1.5}, {0, 1e6}, "Coulomb's coefficient of the ground")
                               .in(Group::forces)
                               .when([this] { return is(Setting::drop); })};
    Number pull_stiffness{*this, log_quantity("pull_stiffness", "kₕ", "N/m", 500, {1, 1e6}, {0, 1e12},
                                              "force per distance by which the hand has drawn a node")
                                     .in(Group::view)
                                     .when([this] { return bent() || moving(); })};
    Whole element_shown{*this,
                        quantity("element_shown", "e", "", 0, {0, 100}, {0, 1e9}, "the element that is lit, counted from 0")
                            .in(Group::view)
                            .looks()};
    Switch show_matrix{*this, setting_of("show_matrix", "the pattern of K beside the body", 1).in(Group::view).looks()};
    Switch show_numbers{
        *this, setting_of("show_numbers", "F, P and Kₑ of the element that is lit, beside the body", 1).in(Group::view).looks()};
    Number magnification{*this, quantity("magnification", "", "", 0, {0, 100}, {0, 1e12},
                                         "of the drawn deformation, the numbers are not touched; 0 chooses one")
                                    .in(Group::view)
                                    .looks()};

    void add_moving_probes(), declare_fields(), declare_stages(), add_moving_stages(), declare_probes(), explain_probes(),
        declare_lines(), declare_checks();

    // --- what the parameters mean ---
    bool in_plane() const {
        return is(Setting::cook) || is(Setting::manufactured) || (is(Setting::own) && dimension_of_file() == 2);
    }
    Shape shape() const {
        if (is(Setting::own)) return Shape::file;
        return is(Setting::cook) ? Shape::cook : is(Setting::manufactured) ? Shape::square : Shape::beam;
    }
    int order() const { return Order(element_kind) == Order::quadratic ? 2 : 1; }
    bool moving() const { return is(Setting::spin) || is(Setting::drop) || (bent() && course == Course::in_motion); }
    Scheme scheme() const { return is(Setting::drop) ? Scheme::implicit_euler : Scheme(integrator); }
    bool implicit() const { return scheme() == Scheme::implicit_euler; }
    bool damped() const { return alpha() > 0 || stiffness_damping > 0; }
    Real alpha() const { return is(Setting::spin) ? Real{0} : Real{mass_damping}; }
    Real weight_acceleration() const { return is(Setting::spin) ? Real{0} : Real{gravity}; }
    bool lumped() const { return is(Setting::drop) || mass_kind == MassKind::lumped; }
    Law law() const { return is(Setting::manufactured) ? Law::linear : Law(body.law); }
    bool turns() const { return law() == Law::corotational; }
    Index levels() const { return has_law() && !moving() ? Index(load_steps) : Index{1}; }
    solid_mesh::BodySettings settings() const;
    // What the file holds; the gear that comes with Pliant where none is given. Throws Refused for one that cannot be read.
    const std::shared_ptr<const MeshFile>& file() const;
    std::string file_name() const;
    Index file_number() const;
    int dimension_of_file() const;  // 3 for one that cannot be read
    Vec<3> force() const {          // N
        Vec<3> whole = bent() ? body.load() : Vec<3>(Vec<3>::Zero());
        if (in_plane()) whole[2] = 0;
        return whole;
    }
    std::optional<Real> bending_number() const;  // P L²/(E I), of a beam that its load bends down
    solid_mesh::SolidWhy why() const { return {solid_.get(), &body}; }
    Index lit() const { return std::min<Index>(Index(element_shown), solid_->element_count() - 1); }

    // --- the stages ---
    void shape_functions(), deform(), turn(), measure_strain(), evaluate_stress(), internal_forces();
    void begin_assembly(), assemble(), apply_load(), support(), solve(), react();
    void clear(), note_course();
    void put(MatX& tensors, Index element, const Small& value) const;
    Small taken(const MatX& tensors, Index element) const;
    void full_load(MatX& load) const;
    Small turning(Real share) const;  // rotation of a face
    Real share() const { return level_ / static_cast<Real>(levels()); }
    void raise_level();
    void start_moving(), damp(), act_from_outside(), begin_integration(), integrate(), end_integration(), meet_ground();
    void follow_positions() { displacement_ = position_ - solid_->rest(); }

    // --- why a number is what it is ---
    std::optional<Explanation> why_element(const Question&q) const, why_node(const Question&q) const,
        why_solved(const Question&q) const, why_outer(const Question&q) const, why_integrated(const Question&q) const,
        why_contact(const Question&q) const;
    Input node_mass(Index node) const, share_of_load(Index node, int component) const;
    std::vector<Input> forces_at_start(Index node, int component) const;
    Explanation why_damping(Index node, int component) const, why_external(Index node, int component) const,
        why_newton(Index node, int component) const;
    struct RowWords {
        std::string letter, unit, entries, speeds;
    };
    void add_row(std::vector<Input>& inputs, const SparseMatrix& matrix, Index row, const RowWords& words) const;
    Explanation why_coupled(Index node, int component, const Input& v) const;
    Input place_at_rest(Index node, int component) const {
        Input place = why().place_at_rest(node, component);
        place.symbol = "X";
        return place;
    }
    SparseMatrix damping_stiffness() const;
    Explanation why_load(Index node, int component) const, why_prescribed(Index node, int component) const,
        why_assembled(Index node, int component) const;
    Input share_so_far() const;
    template <int Dim>
    Explanation why_direction(Index node, int component) const;

    // --- readings ---
    Real tip(int component) const;
    std::optional<Real> middle_exact() const;
    std::optional<Real> middle_deflection() const;
    Real largest_rotation() const, smallest_volume() const, force_imbalance() const;
    Index unknowns() const;
    bool loaded_down() const { return is(Setting::beam) && body.load_x == 0 && body.load_z == 0 && body.load_y != 0; }
    bool hand_off() const { return !solved_pull_; }
    const solid_mesh::Solid::ErrorNorms& errors() const;
    void add_bending_lines(), add_error_lines(), add_locking_lines();
    // Points of a curve, of linear elements and of quadratic ones.
    using Table = std::array<std::vector<std::pair<Real, Real>>, 2>;
    Table measure_convergence() const, measure_locking(int cells) const;
    const Table& convergence() const;
    const Table& locking() const;

    Real frequency() const;
    Real stable_time_step() const;
    Vec<3> centre() const, momentum() const, angular_momentum() const;
    Real kinetic_energy() const, total_energy() const;

    // --- the picture ---
    Drawn drawn() const;
    void set_frame(Scene&scene) const, draw_pattern(Scene&scene) const;
    void write_matrices(Scene& scene) const;
    void write_notes(Scene& scene) const;

    std::unique_ptr<Solid> solid_;
    mutable Remembered<Index, std::shared_ptr<const MeshFile>> file_;
    std::unique_ptr<Motion> motion_;
    std::optional<Pull> pull_, solved_pull_;
    bool advancing_ = false;  // does Newton's loop go on?
    bool assembled_once_ = false;
    Real level_ = 0;  // load steps that are begun
    Index next_element_ = 0, first_of_pass_ = 0;
    MatX before_;  // displacement before the latest iteration
    // Balanced load steps: share of the load and mean displacement of the loaded nodes, a column each.
    Eigen::Matrix<Real, 4, Eigen::Dynamic> course_;
    Index course_length_ = 0;

    // A solve begins anew from the parameters: done, iterations, what is left of the forces.
    Eigen::Matrix<Real, 3, 1> done_;
    // Fields: dim × nodes or dim² × elements.
    MatX displacement_, load_, prescribed_, internal_, residual_, newton_step_, reaction_, assembled_;
    MatX deformation_, rotation_, strain_, stress_, block_;
    // In motion [m, m/s, N]: state, forces at the start of a step, and the sum of all of them.
    MatX position_, velocity_, damping_force_, external_force_, total_force_, start_position_;
    VecX clock_ = VecX::Zero(1);
    bool pulled_ever_ = false;
    VecX volume_, mises_;
    mutable std::optional<solid_mesh::Solid::ErrorNorms> errors_;
    mutable Remembered<std::tuple<Real, Real, Plane>, Table> convergence_;
    mutable Remembered<int, Table> locking_;
    mutable Remembered<Real, Real> frequency_;
};

}  // namespace pliant::fem
