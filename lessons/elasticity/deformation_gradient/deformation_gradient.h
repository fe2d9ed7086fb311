// The local deformation of a body under a chosen map: from the displacement of two neighbouring points to F, its Taylor error and
// its polar decomposition.
#pragma once
#include "kits/deformation_maps/map_controls.h"

#include <pliant/continuum/deformation.h>
#include <pliant/lesson/registry.h>
#include <pliant/mesh/body_grid.h>

#include <deque>

namespace pliant::deformation {

// Relative error at which F dX is no longer a good stand-in for dx.
inline constexpr Real near_enough = 0.05;

// A static lesson: one step goes through all stages of the lecture.
struct DeformationGradientLesson final : Lesson {
    DeformationGradientLesson();

    int dimension() const override { return 3; }
    void reset() override;
    Real time_step() const override { return 0; }
    bool at_rest() const override { return done_[0] != 0; }
    void draw(Scene& scene) const override;
    std::optional<UnstructuredGrid> unstructured_grid() const override;
    std::optional<On> can_pull() const override { return On::particle; }
    std::vector<std::pair<std::string, Real>> dragged(const Pull& pull) const override;
    std::string blow_up_hint() const override;
    std::optional<Fix> fix(const Failure&) const override { return Fix{"bend", {{"map", "bend"}}}; }
    ColourBy first_colours() const override { return {"volume_ratio", -1}; }
    std::vector<std::string_view> first_plots() const override { return {"taylor_error_over_distance"}; }
    std::vector<std::string_view> key_numbers() const override { return {"det_F", "taylor_error", "rotation_angle"}; }

    // Numbers per row: of a tensor row by row.
    using Vectors = Points<3>;
    using Nine = Eigen::Matrix<Real, 9, Eigen::Dynamic>;
    using RowMajor = Eigen::Matrix<Real, 3, 3, Eigen::RowMajor>;
    using One = Eigen::Matrix<Real, 1, 1>;

    MapControls controls;
    std::deque<Number> P, Q;  // coordinates at rest

    void declare_fields(), declare_stages(), declare_probes(), declare_lines(), declare_checks(), explain_probes();

    // --- the stages ---
    void map_points(), displace(), differentiate(), make_gradient(), compare(), decompose(), strain();

    Vec<3> material(Index point) const;  // P or Q at rest
    Vec<3> rest_vector() const { return material(1) - material(0); }
    Mat<3> at_P(const Nine& tensors) const { return Eigen::Map<const RowMajor>(tensors.data()); }
    // |dx - F dX| for dX of this length along the present one.
    Real taylor_error(Real length) const;
    Real rotation_angle() const;  // rad

    // --- why a number is what it is ---
    std::array<Input, 3> coordinates(bool of_node, Index index) const;
    Explanation why_map(const Question& q) const;
    Explanation why_displaced(const Question& q) const;
    Explanation why_slope(const Question& q) const;
    Explanation why_deformation(const Question& q) const;
    Explanation why_compared(const Question& q) const;
    Explanation why_polar(const Question& q) const;
    Explanation why_strain(const Question& q) const;

    // --- what would mend a run ---
    std::optional<Fix> nearer() const, not_inverted() const;

    // --- the picture ---
    void draw_body(Scene& scene) const;
    void draw_points(Scene& scene) const;
    void draw_vectors(Scene& scene) const;
    void draw_ellipsoid(Scene& scene) const;
    void write_numbers(Scene& scene) const;
    void frame(Scene& scene) const;

    DeformationMap map_;
    BodyGrid body_;

    // Of the body's points.
    Vectors position_, displacement_;
    Nine slope_, deformation_, strain_;
    VecX volume_ratio_;
    // Of P and Q.
    Vectors point_position_, point_displacement_;
    Nine point_slope_, point_deformation_, point_rotation_, point_stretch_;
    // From P to Q.
    Vectors rest_vector_, relative_displacement_, deformed_vector_, mapped_vector_, gap_;
    One done_;
};

}  // namespace pliant::deformation
