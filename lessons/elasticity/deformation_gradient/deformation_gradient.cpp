#include "deformation_gradient.h"

#include <cmath>

namespace pliant::deformation {
namespace {

const Vec<3> body_size(1, 0.6, 0.4);  // m
constexpr std::array<int, 3> body_cells{15, 6, 4};

constexpr std::array<std::string_view, 3> P_keys{"P_x", "P_y", "P_z"}, P_symbols{"P₁", "P₂", "P₃"}, Q_keys{"Q_x", "Q_y", "Q_z"},
    Q_symbols{"Q₁", "Q₂", "Q₃"};
constexpr std::array<Real, 3> P_initial{-0.25, -0.1, 0.2}, Q_initial{0.1, 0.1, 0.2};

void declare_point(Lesson& owner, std::deque<Number>& point, const std::array<std::string_view, 3>& keys,
                   const std::array<std::string_view, 3>& symbols, const std::array<Real, 3>& initial, std::string_view help) {
    for (std::size_t k = 0; k < 3; ++k) {
        const Real half = body_size[static_cast<Index>(k)] / 2;
        point.emplace_back(
            owner, quantity(keys[k], symbols[k], "m", initial[k], {-half, half}, {-100, 100}, help).in(Group::view).rebuilds());
    }
}

}  // namespace

DeformationGradientLesson::DeformationGradientLesson()
    : controls(*this, MapControls::Offer::all, MapKind::bend, Vec<3>(1.3, 0.1, 0)), body_(body_size, body_cells) {
    declare_point(*this, P, P_keys, P_symbols, P_initial, "of the material point P at rest; drag P in the picture");
    declare_point(*this, Q, Q_keys, Q_symbols, Q_initial, "of its neighbour Q at rest; drag Q in the picture");
    controls.add_entries(*this);
    declare_fields(), declare_stages(), declare_probes(), explain_probes(), declare_lines(), declare_checks();
}

Vec<3> DeformationGradientLesson::material(Index point) const {
    const auto& of = point == 0 ? P : Q;
    return {of[0], of[1], of[2]};
}

// Everything as at rest.
void DeformationGradientLesson::reset() {
    map_ = controls.map();
    const Vec<9> identity = Mat<3>::Identity().reshaped();
    const Index nodes = body_.points().cols();
    position_ = body_.points();
    displacement_.setZero(3, nodes);
    slope_.setZero(9, nodes);
    strain_.setZero(9, nodes);
    deformation_ = identity.replicate(1, nodes);
    volume_ratio_.setOnes(nodes);

    point_position_.resize(3, 2);
    point_position_ << material(0), material(1);
    point_displacement_.setZero(3, 2);
    point_slope_.setZero(9, 2);
    for (Nine* tensors : {&point_deformation_, &point_rotation_, &point_stretch_}) *tensors = identity.replicate(1, 2);
    for (Vectors* vector : {&rest_vector_, &deformed_vector_, &mapped_vector_}) *vector = rest_vector();
    for (Vectors* vector : {&relative_displacement_, &gap_}) vector->setZero(3, 1);
    done_.setZero();
}

// ------------------------------------------------------------------------------------------------------------ stages

void DeformationGradientLesson::declare_stages() {
    formula_symbols = {{"φ", "m"}, {"X", "m"}, {"P", "m"}, {"Q", "m"}, {"dV", "m³"}, {"dv", "m³"}};
    stages = {
        stage_of("map_points", "x = φ(X),  dX = Q − P", "lecture: continuum mechanics, material coordinates P and Q",
                 [this] { map_points(); })
            .done_in("core/pliant/continuum/deformation_map.cpp: position")
            .maps({}, {"position", "point_position", "rest_vector"})
            .because([this](const Question& q) { return why_map(q); }),
        stage_of("displacement", "u = x − X,  du = u(Q) − u(P),  dx = dX + du",
                 "lecture: continuum mechanics, displacement field", [this] { displace(); })
            .done_in("lessons/elasticity/deformation_gradient/deformation_gradient.cpp: displace")
            .maps({"position", "point_position", "rest_vector"},
                  {"displacement", "point_displacement", "relative_displacement", "deformed_vector"})
            .because([this](const Question& q) { return why_displaced(q); }),
        stage_of("gradient_of_u", "∇u: row by row the slopes of u, v and w along X, Y and Z",
                 "lecture: continuum mechanics, gradient of the displacement field", [this] { differentiate(); })
            .done_in("core/pliant/continuum/deformation_map.cpp: displacement_gradient")
            .maps({}, {"displacement_gradient", "point_gradient"})
            .because([this](const Question& q) { return why_slope(q); }),
        stage_of("deformation_gradient", "F = I + ∇u,  det F = dv/dV, volume now over volume at rest",
                 "lecture: material deformation gradient tensor [Bonet2008 §4.4]", [this] { make_gradient(); })
            .done_in("core/pliant/continuum/deformation.h: deformation_gradient, volume_ratio")
            .maps({"displacement_gradient", "point_gradient"}, {"deformation_gradient", "point_deformation", "volume_ratio"})
            .because([this](const Question& q) { return why_deformation(q); }),
        stage_of("compare", "dx ≈ F dX,  error |dx − F dX| ~ |dX|²", "lecture: u(X + dX) ≈ u(X) + ∇u dX, Q very close to P",
                 [this] { compare(); })
            .done_in("lessons/elasticity/deformation_gradient/deformation_gradient.cpp: compare")
            .maps({"point_deformation", "rest_vector", "deformed_vector"}, {"mapped_vector", "taylor_gap"})
            .because([this](const Question& q) { return why_compared(q); }),
        stage_of("polar_decomposition", "F = R S,  RᵀR = I,  det R = 1,  S = Sᵀ",
                 "rotation and stretch [Bonet2008 §4.6, Lin2022]", [this] { decompose(); })
            .done_in("core/pliant/continuum/deformation.cpp: polar_decomposition, nearest_rotation")
            .maps({"point_deformation"}, {"point_rotation", "point_stretch"})
            .because([this](const Question& q) { return why_polar(q); }),
        stage_of("strain", "E = ½ (∇u + ∇uᵀ + ∇uᵀ∇u)", "lecture: Green's strain tensor", [this] { strain(); })
            .done_in("core/pliant/continuum/strain.h: green_strain")
            .maps({"displacement_gradient"}, {"green_strain"})
            .because([this](const Question& q) { return why_strain(q); })};
}

void DeformationGradientLesson::map_points() {
    for (Index n = 0; n < position_.cols(); ++n) position_.col(n) = map_.position(body_.points().col(n));
    for (Index p = 0; p < 2; ++p) point_position_.col(p) = map_.position(material(p));
    rest_vector_ = rest_vector();
}

void DeformationGradientLesson::displace() {
    displacement_ = position_ - body_.points();
    for (Index p = 0; p < 2; ++p) point_displacement_.col(p) = point_position_.col(p) - material(p);
    relative_displacement_ = point_displacement_.col(1) - point_displacement_.col(0);
    deformed_vector_ = rest_vector_ + relative_displacement_;
}

void DeformationGradientLesson::differentiate() {
    const auto write = [](Nine& tensors, Index i, const Mat<3>& m) { Eigen::Map<RowMajor>(tensors.col(i).data()) = m; };
    for (Index n = 0; n < slope_.cols(); ++n) write(slope_, n, map_.displacement_gradient(body_.points().col(n)));
    for (Index p = 0; p < 2; ++p) write(point_slope_, p, map_.displacement_gradient(material(p)));
}

void DeformationGradientLesson::make_gradient() {
    const Vec<9> identity = Mat<3>::Identity().reshaped();
    deformation_ = slope_.colwise() + identity;
    point_deformation_ = point_slope_.colwise() + identity;
    for (Index n = 0; n < deformation_.cols(); ++n)
        volume_ratio_[n] = pliant::volume_ratio<3>(Eigen::Map<const RowMajor>(deformation_.col(n).data()));
}

void DeformationGradientLesson::compare() {
    mapped_vector_ = at_P(point_deformation_) * rest_vector_;
    gap_ = deformed_vector_ - mapped_vector_;
}

void DeformationGradientLesson::decompose() {
    for (Index p = 0; p < 2; ++p) {
        const auto polar = polar_decomposition<3>(Eigen::Map<const RowMajor>(point_deformation_.col(p).data()));
        Eigen::Map<RowMajor>(point_rotation_.col(p).data()) = polar.R;
        Eigen::Map<RowMajor>(point_stretch_.col(p).data()) = polar.S;
    }
}

void DeformationGradientLesson::strain() {
    for (Index n = 0; n < strain_.cols(); ++n)
        Eigen::Map<RowMajor>(strain_.col(n).data()) = green_strain<3>(Eigen::Map<const RowMajor>(slope_.col(n).data()));
    done_[0] = 1;
}

// ---------------------------------------------------------------------------------------------------------- readings

Real DeformationGradientLesson::taylor_error(Real length) const {
    const Vec<3> along = rest_vector().norm() > 0 ? rest_vector().normalized() : Vec<3>::UnitX();
    const Vec<3> dX = length * along, from = material(0);
    const Vec<3> du = map_.displacement(from + dX) - map_.displacement(from);
    return (du - map_.displacement_gradient(from) * dX).norm();
}

Real DeformationGradientLesson::rotation_angle() const {
    const Mat<3> R = at_P(point_rotation_);
    const Vec<3> axial(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
    return std::atan2(axial.norm(), R.trace() - 1);
}

// A handle goes where the hand goes.
std::vector<std::pair<std::string, Real>> DeformationGradientLesson::dragged(const Pull& pull) const {
    if (pull.index != 0 && pull.index != 1) return {};
    std::vector<std::pair<std::string, Real>> values;
    for (std::size_t k = 0; k < 3; ++k)
        values.emplace_back(pull.index == 0 ? P_keys[k] : Q_keys[k], pull.to[static_cast<Index>(k)]);
    return values;
}

const Registration<DeformationGradientLesson> registration{
    {.id = "elasticity/deformation_gradient",
     .title = "Deformation gradient",
     .summary = "Follow a point and its neighbour through a map: u, ∇u, F, the error of dx ≈ F dX, and F = R S.",
     .demo_steps = 1}};

}  // namespace pliant::deformation
