#include "flow_readings.h"

namespace pliant::grid2d {

Field velocity_field(const FlowFields& flow, std::function<GridWhy()> why, std::string_view help) {
    return plane_vector_field(
               "velocity", "u", "m/s", On::cell, [&flow] { return as_span(flow.centre_velocity()); }, help)
        .follows({"u_on_faces", "v_on_faces"}, [why](const Question& q) { return why().cell_velocity(q.index, q.component); });
}

Field speed_field(const FlowFields& flow, std::function<GridWhy()> why) {
    return scalar_field(
               "speed", "|u|", "m/s", On::cell, [&flow] { return as_span(flow.speed()); }, "")
        .follows({"velocity"}, [why](const Question& q) { return why().speed(q.index); });
}

Field stored_velocity(int axis, std::function<const FaceField<2>&()> velocity, Real largest) {
    return scalar_field(
               face_field(axis), axis == 0 ? "u" : "v", "m/s", axis == 0 ? On::x_face : On::y_face,
               [velocity, axis] { return as_span(velocity()[axis]); },
               axis == 0 ? "x component of the velocity, where it is stored: on the upright faces of the cells"
                         : "y component of the velocity, where it is stored: on the level faces of the cells")
        .of_both_signs()
        .stops_at(largest);
}

Probe largest_probe(std::string_view name, std::string_view symbol, std::string_view unit, std::string_view help,
                    const VecX& values, std::string_view field) {
    return probe_of(
        name, symbol, unit, help, [&values] { return values.lpNorm<Eigen::Infinity>(); },
        [&values, symbol, field] { return largest(symbol, values, field); });
}

void sample_centres(Curve& curve, Index n, Real dx, const std::function<std::optional<Real>(Index)>& value) {
    curve = {};
    for (Index i = 0; i < n; ++i) {
        const auto here = value(i);
        if (!here) return;
        curve.position.push_back((static_cast<Real>(i) + Real(0.5)) * dx);
        curve.value.push_back(*here);
    }
}

}  // namespace pliant::grid2d
