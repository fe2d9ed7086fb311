// Parameters and what they mean, and the start.
#include "bem.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::bem {
namespace {

struct CornerKeys {
    std::string_view x, y, x_symbol, y_symbol;
    Real at_x, at_y;
};
// An arm with a haunch: held at the wall on its left, loaded at its end.
constexpr std::array<CornerKeys, most_corners> corner_keys{{{"corner1_x", "corner1_y", "x₁", "y₁", 0, -1},
                                                            {"corner2_x", "corner2_y", "x₂", "y₂", 0.7, 0.2},
                                                            {"corner3_x", "corner3_y", "x₃", "y₃", 2.6, 0.5},
                                                            {"corner4_x", "corner4_y", "x₄", "y₄", 2.6, 1.2},
                                                            {"corner5_x", "corner5_y", "x₅", "y₅", 0, 1.2},
                                                            {"corner6_x", "corner6_y", "x₆", "y₆", -0.6, 0.6},
                                                            {"corner7_x", "corner7_y", "x₇", "y₇", -0.6, 0},
                                                            {"corner8_x", "corner8_y", "x₈", "y₈", -0.3, -0.6}}};

ParameterInfo corner_info(std::string_view key, std::string_view symbol, Real initial) {
    return quantity(key, symbol, "m", initial, {-3, 3}, {-1e6, 1e6}, "of a corner of the outline; drag it in the picture")
        .in(Group::shape)
        .rebuilds();
}

}  // namespace

OutlineCorner::OutlineCorner(Lesson& owner, std::size_t which, std::function<bool()> used)
    : x(owner, corner_info(corner_keys[which].x, corner_keys[which].x_symbol, corner_keys[which].at_x), used),
      y(owner, corner_info(corner_keys[which].y, corner_keys[which].y_symbol, corner_keys[which].at_y), used) {}

ParameterInfo BemLesson::length_of(std::string_view key, std::string_view symbol, Real initial, std::string_view help) {
    return log_quantity(key, symbol, "m", initial, {0.1, 10}, {1e-6, 1e6}, help).in(Group::shape).rebuilds();
}
ParameterInfo BemLesson::load_of(std::string_view key, std::string_view symbol, Real initial, std::string_view help) {
    return quantity(key, symbol, "Pa", initial, {-2, 2}, {-1e15, 1e15}, help).in(Group::forces).rebuilds();
}
ParameterInfo BemLesson::place_of(std::string_view key, std::string_view symbol, Real initial) {
    return quantity(key, symbol, "m", initial, {-4, 4}, {-1e7, 1e7},
                    "a point inside, whose stress is asked for; drag it in the picture")
        .in(Group::view)
        .looks();
}
ParameterInfo BemLesson::modulus_info() {
    ParameterInfo info = youngs_modulus_info("stress over strain of a pull", {10, 1e4});
    info.initial = 100;
    return info;
}

BemLesson::BemLesson() {
    for (std::size_t k = 0; k < most_corners; ++k)
        outline.emplace_back(*this, k, [this, k] { return is(Setting::outline) && static_cast<Index>(k) < Index(corners); });
    declare_fields(), declare_stages(), declare_probes(), declare_lines(), declare_checks();
}

BodyPlan BemLesson::plan() const {
    BodyPlan p{setting,
               order,
               static_cast<int>(Index(elements)),
               {hole_a, hole_b},
               {half_width, half_height},
               inner_radius,
               outer_radius,
               {},
               material(),
               inside};
    for (std::size_t k = 0; k < static_cast<std::size_t>(Index(corners)); ++k) p.corners.push_back(outline[k].place());
    return p;
}

Lame BemLesson::material() const {
    const auto m = IsotropicModuli::from_young_poisson(youngs_modulus, poisson_ratio);
    return !in_space() && plane == Plane::stress ? m.plane_stress_lame() : m.lame();
}

void BemLesson::check() const {
    const auto text = [](const Parameter& p) {
        return fmt::format("{} = {}", p.info.key, format_quantity(p.value(), p.info.unit));
    };
    if (is(Setting::ring) && !(outer_radius > 1.001 * inner_radius))
        throw Refused(fmt::format("{} is not above {}: a ring needs a wall; give a larger outer_radius", text(outer_radius),
                                  text(inner_radius)));
    if (is(Setting::plate_with_hole) && !(half_width > 1.001 * hole_a && half_height > 1.001 * hole_b))
        throw Refused(fmt::format("the hole, {} by {}, does not fit into the plate, {} by {}: give a smaller hole", text(hole_a),
                                  text(hole_b), text(half_width), text(half_height)));
    if (is(Setting::outline))
        for (const Parameter* side : {static_cast<const Parameter*>(&held_side), static_cast<const Parameter*>(&loaded_side)})
            if (side->value() > corners.value())
                throw Refused(
                    fmt::format("{} = {}, but the outline has {} sides", side->info.key, Index(side->value()), Index(corners)));
    if (is(Setting::outline) && Index(held_side) == Index(loaded_side))
        throw Refused(fmt::format("held_side and loaded_side are both {}: a side is held or loaded, not both", Index(held_side)));
    const Index unknowns = unknowns_of(plan());
    if (unknowns > most_unknowns)
        throw Refused(
            fmt::format("elements = {} make {} unknowns, every one of which is tied to every other; at most {} are solved for: "
                        "give fewer elements, or simpler ones",
                        Index(elements), unknowns, most_unknowns));
}

void BemLesson::reset() {
    body_ = std::make_unique<Body>(plan());
    comparison_.reset();
    lay_out();
    tally_.fill(0);
}

// The kernel from the present source, and the stress where the person looks.
void BemLesson::looked() {
    body_->set_point(point());
    if (tally_[found_inside] != 0) find_at(body_->point());
}

std::vector<std::pair<std::string, Real>> BemLesson::dragged(const Pull& pull) const {
    if (pull.index == point_handle) return {{"point_x", pull.to[0]}, {"point_y", pull.to[1]}};
    if (pull.index == a_handle && has_hole()) return {{"hole_a", std::abs(pull.to[0])}};
    if (pull.index == b_handle && has_hole()) return {{"hole_b", std::abs(pull.to[1])}};
    const Index k = pull.index - corner_handle;
    if (!is(Setting::outline) || k < 0 || k >= Index(corners)) return {};
    const CornerKeys& keys = corner_keys[static_cast<std::size_t>(k)];
    return {{std::string(keys.x), pull.to[0]}, {std::string(keys.y), pull.to[1]}};
}

ColourBy BemLesson::first_colours() const {
    if (in_space()) return {"displacement", -1};
    return {"inside_stress", is(Setting::outline) ? -1 : 4};
}

std::vector<std::string_view> BemLesson::key_numbers() const {
    if (has_hole()) return {"stress_at_a", "u_y_at_b", "unknowns"};
    if (is(Setting::outline)) return {"largest_displacement", "unbalanced", "unknowns"};
    return {"hoop_inner", "u_inner", "unknowns"};
}

std::string_view BemLesson::error_probe() const {
    return has_hole() ? "stress_at_a" : is(Setting::outline) ? "largest_displacement" : "u_inner";
}

std::vector<std::pair<std::string, std::string>> BemLesson::finer() const {
    const Index more = in_space() ? 4 * elements : 2 * elements;
    BodyPlan finer_plan = plan();
    finer_plan.elements = static_cast<int>(more);
    if (unknowns_of(finer_plan) > most_unknowns) return {};
    return {{"elements", std::to_string(more)}};
}

std::string BemLesson::blow_up_hint() const {
    return fmt::format("The system is linear and cannot blow up by itself; {}",
                       poisson_ratio > 0.45 ? fmt::format("ν = {} is close to ½, where Kelvin's constants fail: lower it",
                                                          format_quantity(poisson_ratio, ""))
                                            : "the load is too large for the stiffness: lower it");
}

namespace {

const Registration<BemLesson> registration{
    {.id = "mesh/bem",
     .title = "Boundary elements",
     .summary =
         "Only the outline of a body is cut up: every element feels every other, a small full matrix is filled row by row, "
         "and the inside is found afterwards.",
     .demo_steps = 1}};

}  // namespace

}  // namespace pliant::bem
