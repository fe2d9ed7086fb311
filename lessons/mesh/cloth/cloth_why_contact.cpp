// Why the sphere and the limit on strain move the nodes as they do.
#include "cloth.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pliant::cloth {
namespace {

std::string of_axis(const char* symbol, int c) { return fmt::format("{}_{}", symbol, axis_name(c)); }

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
    std::vector<Input> motion;
    append_constants(motion, "n", plane.normal, "", frozen_normal);
    append(motion, Input::before, "v", "velocity", plane.node);
    std::vector<Input> along = motion;
    along.push_back(part("s = n_x v_x + n_y v_y + n_z v_z", motion));
    const Input slip = part("|v_t| = √((v_x − s n_x)² + (v_y − s n_y)² + (v_z − s n_z)²)", std::move(along));
    const char* letter = axis_name(component);
    Explanation e{
        fmt::format("fᵗ = − b (v_{0} − n_{0} (n_x v_x + n_y v_y + n_z v_z))", letter),
        {part("b = μ N / max(|v_t|, v₀)", {l.friction, Input::before("N", "contact_force", plane.node), slip,
                                           Input::constant("v₀", creep_speed, "m/s", "speed below which friction is drag")})}};
    append_constants(e.inputs, "n", plane.normal, "", frozen_normal);
    append(e.inputs, Input::now, "v", "velocity", plane.node);
    return e;
}

// How far the node was from the middle of the sphere; the direction from there; how fast it moved towards the sphere.
Input from_middle(const ClothLesson& l, Index node) {
    std::vector<Input> ends;
    append(ends, Input::before, "x", "position", node);
    append_constants(ends, "c", l.sphere().centre, "m", "middle of the sphere");
    return part("r = √((x_x − c_x)² + (x_y − c_y)² + (x_z − c_z)²)", std::move(ends));
}
std::array<Input, 3> directions(const ClothLesson& l, Index node) {
    if (l.touches_[static_cast<std::size_t>(node)].centred) {
        const auto upwards = [](int c) {
            return Input::constant(of_axis("n", c), c == 1 ? 1 : 0, "", "a node in the very centre leaves it upwards");
        };
        return {upwards(0), upwards(1), upwards(2)};
    }
    const Input r = from_middle(l, node);
    const auto along = [&](int c) {
        return part(fmt::format("n_{0} = (x_{0} − c_{0}) / r", axis_name(c)),
                    {Input::before(of_axis("x", c), "position", node, c),
                     Input::constant(of_axis("c", c), l.sphere().centre[c], "m", "middle of the sphere"), r});
    };
    return {along(0), along(1), along(2)};
}
Input meeting_speed(const ClothLesson& l, Index node) {
    std::vector<Input> inputs;
    for (Input& n : directions(l, node)) inputs.push_back(std::move(n));
    append(inputs, Input::before, "v", "velocity", node);
    return part("w = max(− n_x v_x − n_y v_y − n_z v_z, 0)", std::move(inputs));
}

// What is left of the velocity when its part towards the sphere is gone, along the surface, in all.
Explanation why_rubbed(const ClothLesson& l, Index node, int component) {
    const std::array<Input, 3> n = directions(l, node);
    const Input w = meeting_speed(l, node);
    std::vector<Input> slid, inputs;
    for (int c = 0; c < 3; ++c) {
        slid.push_back(part(fmt::format("u_{0} = v_{0} + w n_{0}", axis_name(c)),
                            {Input::before(of_axis("v", c), "velocity", node, c), w, n[static_cast<std::size_t>(c)]}));
        inputs.push_back(slid.back()), inputs.push_back(n[static_cast<std::size_t>(c)]);
    }
    const Input away = part("s = n_x u_x + n_y u_y + n_z u_z", inputs);
    inputs.push_back(away);
    const Input slip = part("|u_t| = √((u_x − s n_x)² + (u_y − s n_y)² + (u_z − s n_z)²)", std::move(inputs));
    return {fmt::format("v′ = u_{0} − min(1, μ w / |u_t|) (u_{0} − s n_{0})", axis_name(component)),
            {slid[static_cast<std::size_t>(component)], n[static_cast<std::size_t>(component)], l.friction, w, slip, away}};
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
    if (!touch.inside || l.contact_force_[node] == 0) return fixed_value("N = 0: the sphere does not press the node");
    return {"N = m w / Δt", {l.node_mass(), meeting_speed(l, node), l.dt}};
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
    const auto component = static_cast<std::size_t>(q.component);
    if (q.field == "position") {
        if (!touch.inside) return std::nullopt;
        const char* letter = axis_name(q.component);
        return Explanation{
            fmt::format("x′ = c_{0} + R n_{0}: onto the surface", letter),
            {sphere_radius, directions(*this, q.index)[component],
             Input::constant(of_axis("c", q.component), sphere().centre[q.component], "m", "middle of the sphere")}};
    }
    if (touch.rubbed) return why_rubbed(*this, q.index, q.component);
    return Explanation{fmt::format("v′ = v_{0} + w n_{0}", axis_name(q.component)),
                       {Input::before(of_axis("v", q.component), "velocity", q.index, q.component), meeting_speed(*this, q.index),
                        directions(*this, q.index)[component]}};
}

}  // namespace pliant::cloth
