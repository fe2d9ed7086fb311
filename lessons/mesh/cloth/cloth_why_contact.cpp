// Why the sphere and the limit on strain move the nodes as they do.
#include "cloth.h"

#include <fmt/format.h>

#include <algorithm>

namespace pliant::cloth {
namespace {

std::string of_axis(const char* symbol, int c) { return fmt::format("{}_{}", symbol, axis_name(c)); }

Vec<3> vec(std::span<const Real> x, std::size_t first) { return {x[first], x[first + 1], x[first + 2]}; }

// The three numbers of a node's vector.
void append(std::vector<Input>& inputs, Input (*at)(std::string, std::string_view, Index, int), const char* symbol,
            std::string_view field, Index node) {
    for (int c = 0; c < 3; ++c) inputs.push_back(at(of_axis(symbol, c), field, node, c));
}

void append_constants(std::vector<Input>& inputs, const char* symbol, const Vec<3>& v, const char* unit, const char* meaning) {
    for (int c = 0; c < 3; ++c) inputs.push_back(Input::constant(of_axis(symbol, c), v[c], unit, meaning));
}

constexpr const char* frozen_normal = "from the middle of the sphere to the node, at the start of the step";

const NodePlane<3>* plane_of(const ClothLesson& l, Index node) {
    if (!l.system_) return nullptr;
    const auto found = std::ranges::find(l.system_->terms.planes, node, &NodePlane<3>::node);
    return found == l.system_->terms.planes.end() ? nullptr : &*found;
}

Explanation why_plane_force(const NodePlane<3>& plane, int component) {
    Explanation e{fmt::format("fⁿ = k (o − n_x x − n_y y − n_z z) n_{}", axis_name(component)),
                  {Input::constant("k", plane.stiffness, "N/m", "of the plane that the node rests on"),
                   Input::constant("o", plane.offset, "m", "of the plane from the origin")}};
    append_constants(e.inputs, "n", plane.normal, "", frozen_normal);
    for (int c = 0; c < 3; ++c) e.inputs.push_back(Input::now(axis_name(c), "position", plane.node, c));
    return e;
}

// Coulomb's friction with the force and the speed of the start.
Explanation why_friction(const ClothLesson& l, const NodePlane<3>& plane, int component) {
    Explanation drag{"b = μ N / max(|v_t|, v₀), |v_t|² = |v|² − (n · v)²",
                     {l.friction, Input::before("N", "contact_force", plane.node),
                      Input::constant("v₀", creep_speed, "m/s", "speed below which friction is drag")},
                     [](std::span<const Real> x) {
                         const Vec<3> n = vec(x, 3), v = vec(x, 6);
                         return x[0] * x[1] / std::max((v - n.dot(v) * n).norm(), x[2]);
                     }};
    append_constants(drag.inputs, "n", plane.normal, "", frozen_normal);
    append(drag.inputs, Input::before, "v", "velocity", plane.node);
    drag.substitute = [](std::span<const Real> x) {
        const Vec<3> n = vec(x, 3), v = vec(x, 6);
        return fmt::format("{} · {} / max({:.6g}, {})", as_factor(x[0]), as_factor(x[1]), (v - n.dot(v) * n).norm(), x[2]);
    };
    const char* letter = axis_name(component);
    Explanation e{fmt::format("fᵗ = − b (v_{0} − n_{0} (n_x v_x + n_y v_y + n_z v_z))", letter),
                  {Input::part("b", "N s/m", std::move(drag))}};
    append_constants(e.inputs, "n", plane.normal, "", frozen_normal);
    append(e.inputs, Input::now, "v", "velocity", plane.node);
    return e;
}

Explanation why_pressed(const ClothLesson& l, Index node) {
    const SphereTouch touch = l.touches_[static_cast<std::size_t>(node)];
    if (touch.held) {
        const NodePlane<3>& plane = *plane_of(l, node);
        Explanation e{"N = k (o − n_x x − n_y y − n_z z)",
                      {Input::constant("k", plane.stiffness, "N/m", "of the plane that the node rests on"),
                       Input::constant("o", plane.offset, "m", "of the plane from the origin")}};
        append_constants(e.inputs, "n", plane.normal, "", frozen_normal);
        for (int c = 0; c < 3; ++c)
            e.inputs.push_back(Input::constant(axis_name(c), l.solver()->position()[3 * node + c], "m",
                                               "where the integration has left the node"));
        return e;
    }
    if (!touch.inside || l.contact_force_[node] == 0) return fixed_value("N = 0: the sphere does not press the node", 0);
    Explanation e{"N = m w / Δt, w = − n · v, n = (x − c) / |x − c|", {l.node_mass(), l.dt}};
    append(e.inputs, Input::before, "x", "position", node);
    append_constants(e.inputs, "c", l.sphere().centre, "m", "middle of the sphere");
    append(e.inputs, Input::before, "v", "velocity", node);
    e.evaluate = [](std::span<const Real> x) {
        const Vec<3> from = vec(x, 2) - vec(x, 5);
        const Vec<3> n = from.norm() > 0 ? Vec<3>(from / from.norm()) : Vec<3>::UnitY();
        return x[0] * std::max(-n.dot(vec(x, 8)), Real{0}) / x[1];
    };
    e.substitute = [evaluate = e.evaluate](std::span<const Real> x) {
        return fmt::format("{} · {:.6g} / {}", as_factor(x[0]), evaluate(x) * x[1] / x[0], x[1]);
    };
    return e;
}

}  // namespace

std::vector<Input> ClothLesson::plane_forces_on(Index node, int component) const {
    const NodePlane<3>* plane = plane_of(*this, node);
    if (!plane) return {};
    return {Input::part("fⁿ(x′)", "N", why_plane_force(*plane, component)),
            Input::part("fᵗ(v′)", "N", why_friction(*this, *plane, component))};
}

// Of one pass of strain limiting: what each spring of the node has moved it by.
Explanation ClothLesson::why_limited(const Question& q) const {
    const auto reading = limiter_->passes() == 1 ? Input::before : Input::earlier;
    if (q.field == "velocity")
        return {"v′ = v + (x′ − x) / Δt",
                {reading("v", "velocity", q.index, q.component), Input::now("x′", "position", q.index, q.component),
                 reading("x", "position", q.index, q.component), dt}};
    Explanation e{"x′ = x", {reading("x", "position", q.index, q.component)}};
    if (sheet_->inertia().fixed(3 * q.index)) {
        e.formula += ": the node is held";
        return e;
    }
    e.inputs.push_back(node_mass());
    std::string sum;
    for (const Index s : sheet_->springs_of(q.index)) {
        if (s >= sheet_->last(shear) || limiter_->corrections().col(s).isZero(0)) continue;
        const bool first = sheet_->springs().i(s) == q.index;
        const std::string symbol = fmt::format("p_{}", s);
        sum += (sum.empty() ? "" : " + ") + symbol;
        e.inputs.push_back(Input::constant(symbol, (first ? 1 : -1) * limiter_->corrections()(q.component, s), "kg m",
                                           fmt::format("spring {} was overlong, and drew its ends together", s)));
    }
    if (sum.empty()) {
        e.inputs.pop_back();
        e.formula += ": no spring of the node is overlong";
        return e;
    }
    e.formula = fmt::format("x′ = x + ({}) / m", sum);
    return e;
}

// Nothing, where the stage has left the number as it was.
std::optional<Explanation> ClothLesson::why_contact(const Question& q) const {
    if (q.field == "contact_force") return why_pressed(*this, q.index);
    const SphereTouch touch = touches_[static_cast<std::size_t>(q.index)];
    if (!touch.any()) return std::nullopt;
    const Vec<3> centre = sphere().centre;
    const auto of_centre = [&](Explanation& e) {
        append(e.inputs, Input::before, "x", "position", q.index);
        append_constants(e.inputs, "c", centre, "m", "middle of the sphere");
    };
    const auto component = static_cast<Index>(q.component);
    if (q.field == "position") {
        if (!touch.inside) return std::nullopt;
        const char* letter = axis_name(q.component);
        Explanation e{fmt::format("x′ = c_{0} + R (x_{0} − c_{0}) / |x − c|: onto the surface", letter),
                      {sphere_radius},
                      [component](std::span<const Real> x) {
                          const Vec<3> from = vec(x, 1) - vec(x, 4);
                          const Vec<3> n = from.norm() > 0 ? Vec<3>(from / from.norm()) : Vec<3>::UnitY();
                          return x[4 + static_cast<std::size_t>(component)] + x[0] * n[component];
                      }};
        of_centre(e);
        e.substitute = [component](std::span<const Real> x) {
            const auto at = static_cast<std::size_t>(component);
            return fmt::format("{} + {} · ({} − {}) / {}", x[4 + at], x[0], x[1 + at], x[4 + at], (vec(x, 1) - vec(x, 4)).norm());
        };
        return e;
    }
    Explanation e{touch.held ? "v′ = v + w n, w = max(− n · v, 0), n = (x − c) / |x − c|"
                             : "v′ = u − min(1, μ w / |u|) u, u = v + w n, w = max(− n · v, 0), n = (x − c) / |x − c|",
                  {friction}};
    of_centre(e);
    append(e.inputs, Input::before, "v", "velocity", q.index);
    e.evaluate = [component, held = touch.held](std::span<const Real> x) {
        const Vec<3> from = vec(x, 1) - vec(x, 4), v = vec(x, 7);
        const Vec<3> n = from.norm() > 0 ? Vec<3>(from / from.norm()) : Vec<3>::UnitY();
        const Real w = std::max(-n.dot(v), Real{0});
        const Vec<3> u = v + w * n, along = u - n.dot(u) * n;
        if (held || w == 0 || along.norm() == 0) return u[component];
        return u[component] - std::min(Real{1}, x[0] * w / along.norm()) * along[component];
    };
    e.substitute = [evaluate = e.evaluate](std::span<const Real> x) {
        return fmt::format("{:.8g}, with v = ({:.4g}, {:.4g}, {:.4g})", evaluate(x), x[7], x[8], x[9]);
    };
    return e;
}

}  // namespace pliant::cloth
