// Boundary elements: only the outline of a body is cut up, every element feels every other, and the inside is found afterwards.
#pragma once
#include "comparison.h"
#include "kits/material/material_parameters.h"

#include <pliant/continuum/plane_moduli.h>
#include <pliant/continuum/strain.h>
#include <pliant/lesson/registry.h>

#include <array>
#include <deque>
#include <memory>
#include <optional>

namespace pliant::bem {

// A corner of the outline that a person draws.
struct OutlineCorner {
    OutlineCorner(Lesson& owner, std::size_t which, std::function<bool()> used);
    Vec<2> place() const { return {x, y}; }
    Number x, y;
};
inline constexpr std::size_t most_corners = 8;

// A static lesson: one step sets up and solves everything.
struct BemLesson final : Lesson {
    BemLesson();

    int dimension() const override { return in_space() ? 3 : 2; }
    void check() const override;
    void reset() override;
    void looked() override;
    Real time_step() const override { return 0; }
    bool at_rest() const override { return tally_[done] != 0; }
    void draw(Scene& scene) const override;
    std::optional<On> can_pull() const override { return On::handle; }
    std::vector<std::pair<std::string, Real>> dragged(const Pull& pull) const override;
    std::string blow_up_hint() const override;
    std::optional<UnstructuredGrid> unstructured_grid() const override;
    std::optional<Fix> fix(const Failure&) const override { return fix_by(poisson_ratio, 0.3); }
    std::vector<std::pair<std::string, std::string>> finer() const override;
    ColourBy first_colours() const override;
    std::vector<Group> first_groups() const override { return {Group::scene, Group::method, Group::forces}; }
    std::vector<std::string_view> first_plots() const override {
        return {"stress_along_x", "hoop_around", "stress_along_outline", "error_over_unknowns"};
    }
    std::vector<std::string_view> key_numbers() const override;
    std::string_view error_probe() const override;

    Choice<Setting> setting{*this,
                            setting_of("scene", "which body, and what acts on it").in(Group::scene).rebuilds(),
                            {{"hole", "hole in a plane without end"},
                             {"plate_with_hole", "plate with a hole"},
                             {"ring", "ring under pressure"},
                             {"outline", "outline drawn by hand"},
                             {"cavity_3d", "spherical cavity in space"}}};
    Choice<BoundaryOrder> order{
        *this,
        setting_of("element", "how displacement and traction go along an element; in space they are linear over curved triangles",
                   BoundaryOrder::quadratic)
            .in(Group::method)
            .rebuilds(),
        {{"constant", "constant, straight"}, {"linear", "linear, straight"}, {"quadratic", "quadratic, curved"}},
        [this] { return !in_space(); }};
    Whole elements{*this,
                   quantity("elements", "N", "", 24, {8, 64}, {3, 2000},
                            "on the hole, on each circle of the ring, on the whole outline; of a cavity about so many triangles")
                       .in(Group::method)
                       .rebuilds()};
    Number hole_a{*this, length_of("hole_a", "a", 1, "half axis of the hole along x"), [this] { return has_hole(); }};
    Number hole_b{*this, length_of("hole_b", "b", 1, "half axis of the hole along y"), [this] { return has_hole(); }};
    Number half_width{*this, length_of("half_width", "W", 3, "of the plate, along x"),
                      [this] { return is(Setting::plate_with_hole); }};
    Number half_height{*this, length_of("half_height", "H", 3, "of the plate, along y"),
                       [this] { return is(Setting::plate_with_hole); }};
    Number inner_radius{*this, length_of("inner_radius", "r_i", 1, "of the ring or the cavity"),
                        [this] { return is(Setting::ring) || in_space(); }};
    Number outer_radius{*this, length_of("outer_radius", "r_o", 2, "of the ring"), [this] { return is(Setting::ring); }};
    Number remote_stress{*this, load_of("remote_stress", "S", 1, "that pulls along y, from far away or at the plate's edges"),
                         [this] { return has_hole(); }};
    Number pressure{*this, load_of("pressure", "p", 0, "that presses on the wall of the hole, the ring or the cavity"),
                    [this] { return !is(Setting::outline); }};
    Number load_x{*this, load_of("load_x", "q_x", 0, "traction on the loaded side, along x"),
                  [this] { return is(Setting::outline); }};
    Number load_y{*this, load_of("load_y", "q_y", -0.2, "traction on the loaded side, along y"),
                  [this] { return is(Setting::outline); }};
    Choice<Plane> plane{
        *this,
        setting_of("plane", "nothing stretches across the plane, or nothing pulls across it").in(Group::material).rebuilds(),
        {{"strain", "plane strain: a long body"}, {"stress", "plane stress: a thin plate"}},
        [this] { return !in_space(); }};
    Number youngs_modulus{*this, modulus_info()};
    Number poisson_ratio{*this, poisson_ratio_info("narrowing over lengthening", {-0.9, 0.4999})};
    Whole corners{
        *this,
        quantity("corners", "", "", 5, {3, 8}, {3, 8}, "of the outline; drag them in the picture").in(Group::shape).rebuilds(),
        [this] { return is(Setting::outline); }};
    Whole held_side{
        *this,
        quantity("held_side", "", "", 5, {1, 8}, {1, 8}, "side that does not move; side 1 runs from corner 1 to corner 2")
            .in(Group::forces)
            .rebuilds(),
        [this] { return is(Setting::outline); }};
    Whole loaded_side{
        *this, quantity("loaded_side", "", "", 3, {1, 8}, {1, 8}, "side that the traction acts on").in(Group::forces).rebuilds(),
        [this] { return is(Setting::outline); }};
    Switch inside{*this,
                  setting_of("inside", "find displacement and stress at points inside as well", 1).in(Group::method).rebuilds()};
    Number point_x{*this, place_of("point_x", "x_P", 1.5)};
    Number point_y{*this, place_of("point_y", "y_P", 1)};
    std::deque<OutlineCorner> outline;

    enum Tally : Index { done, source, solved, found_inside, tally_count };
    enum Handle : Index { point_handle, a_handle, b_handle, corner_handle };

    static ParameterInfo length_of(std::string_view key, std::string_view symbol, Real initial, std::string_view help);
    static ParameterInfo load_of(std::string_view key, std::string_view symbol, Real initial, std::string_view help);
    static ParameterInfo place_of(std::string_view key, std::string_view symbol, Real initial);
    static ParameterInfo modulus_info();

    void declare_fields(), declare_stages(), declare_probes(), declare_lines(), declare_checks();

    // --- what the parameters mean ---
    bool is(Setting which) const { return setting == which; }
    bool in_space() const { return is(Setting::cavity_3d); }
    bool has_hole() const { return is(Setting::hole) || is(Setting::plate_with_hole); }
    bool has_exact() const { return is(Setting::hole) || is(Setting::ring) || in_space(); }
    BodyPlan plan() const;
    Lame material() const;
    EllipticHole exact_hole() const { return {{hole_a, hole_b}, remote_stress, pressure, material()}; }
    PressedRing exact_ring() const { return {inner_radius, outer_radius, pressure, material()}; }
    PressedCavity exact_cavity() const { return {inner_radius, pressure, material().mu}; }
    Vec<3> exact_displacement(const Vec<3>& X) const;  // of the boundary, where it is known
    Vec<3> point() const { return {point_x, point_y, 0}; }

    // --- the stages (bem_stages.cpp) ---
    void lay_out(), place_source(), fill_rows(), close_rows(), condition(), exchange(), solve(), read_boundary(), find_inside();
    void find_at(Index particle);
    VecX remote_displacements() const;  // of the nodes, m
    Index rows_per_pass() const;
    bool at_source(Index element) const, pulled_edge(Index element) const;
    bool held(Index element) const { return is(Setting::outline) && body_->arc(element) == Index(held_side) - 1; }
    bool shows_matrices() const { return body_ && body_->unknowns() <= most_shown; }

    // --- what is measured (bem_readings.cpp) ---
    Real size() const;  // of the body, m
    std::optional<Real> worst_error() const;
    Real largest_displacement() const, unbalanced() const;
    void compare();
    Real hoop_at(Index element) const;
    Real mean_hoop(int loop) const, mean_outward(int loop) const;
    std::optional<Real> point_stress(int i, int j) const;

    // --- why a number is what it is (bem_why.cpp) ---
    std::optional<Explanation> why_kernel(const Question& q) const;
    Input why_end(const char* symbol, Index element, int which, int axis) const;
    Explanation why_geometry(const Question&q) const, why_entry(const Question&q) const;
    Explanation why_own_block(const Question& q) const;
    Input entry_of(std::string symbol, std::string_view matrix, Index row, Index column) const;
    Explanation why_right_side(const Question&q) const, why_unknown(const Question&q) const;
    Explanation why_traction(const Question& q) const;
    std::optional<Explanation> why_effort(const Question& q) const;
    Explanation why_boundary_stress(const Question&q) const, why_inside(const Question&q) const;

    // --- the picture (bem_picture.cpp, bem_picture_matrix.cpp) ---
    struct View {
        Vec<3> lower, upper;  // m, what is drawn of the body
    };
    View view() const;
    Real magnification() const, matrix_room() const;
    Vec<3> drawn(const OnBoundary& at) const;
    void draw_outline(Scene&) const, draw_inside(Scene&) const, draw_wall(Scene&) const, draw_loads(Scene&) const;
    void draw_source(Scene&) const, draw_matrices(Scene&) const, draw_handles(Scene&) const, write_notes(Scene&) const;

    static constexpr Index most_shown = 420;      // unknowns whose matrices are kept as fields and drawn
    static constexpr Index most_unknowns = 2500;  // that are solved for

    std::unique_ptr<Body> body_;
    std::optional<Comparison> comparison_;
    Points<3> normal_;
    VecX size_;
    Points<3> kernel_displacement_, kernel_traction_;
    VecX H_, G_;
    Points<3> given_traction_, right_side_, displacement_, traction_;
    Tensors<3> boundary_stress_, inside_stress_;
    Points<3> inside_displacement_;
    std::array<Real, tally_count> tally_{};
};

}  // namespace pliant::bem
