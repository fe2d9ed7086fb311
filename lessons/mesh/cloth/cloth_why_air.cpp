// Why the air pushes as it does: the triangles of a node.
#include "cloth.h"

#include <fmt/format.h>

#include <algorithm>

namespace pliant::cloth {
namespace {}  // namespace

Explanation ClothLesson::why_wind_stage(const Question& q) const {
    return q.field == "wind_drag" ? why_drag(q.index, q.component / 3, q.component % 3) : why_wind_force(q.index, q.component);
}

Input ClothLesson::wind_component(int component) const {
    const std::string symbol = fmt::format("w_{}", axis_name(component));
    const int along = setting == Setting::flag ? 0 : 2;
    if (component == along)
        return Input::part(
            symbol, "m/s",
            {.formula = symbol + " = W", .inputs = {Input::of(wind)}, .evaluate = [](std::span<const Real> x) { return x[0]; }});
    if (component == 1)
        return Input::part(symbol, "m/s",
                           {.formula = symbol + " = 0: the wind is level", .inputs = {}, .evaluate = [](std::span<const Real>) {
                                return Real{0};
                            }});
    return Input::part(symbol, "m/s",
                       {.formula = symbol + " = W γ sin(2π f t)",
                        .inputs = {Input::of(wind), Input::of(gust), Input::constant("f", 1, "1/s", "how often the gust comes"),
                                   Input::constant("t", gust_at_, "s", "since the wind began, at the start of the step")}});
}

// One triangle at a time: its area vector, and how fast the air meets it.
Explanation ClothLesson::why_drag(Index node, int row, int column) const {
    std::vector<Input> terms;
    for (std::size_t t = 0; t < sheet_->triangles().size(); ++t) {
        const NodeTriple& corners = sheet_->triangles()[t];
        if (std::ranges::find(corners, node) == corners.end()) continue;
        Explanation e{
            .formula = fmt::format("C_{} = ρ c |u · A| A_{} A_{} / (6 |A|²), A = ½ (b − a) × (c − a), u = w − (vᵃ + vᵇ + vᶜ) / 3",
                                   t, axis_name(row), axis_name(column)),
            .inputs = {Input::constant("ρ", Air{}.density, "kg/m³", "density of the air"), Input::of(air_drag)},
            .evaluate = {}};
        for (int c = 0; c < 3; ++c) e.inputs.push_back(wind_component(c));
        for (const char* field : {"position", "velocity"})
            for (const Index corner : corners)
                for (int c = 0; c < 3; ++c)
                    e.inputs.push_back(
                        Input::now(fmt::format("{}{}_{}", field[0] == 'v' ? "v" : "", axis_name(c), corner), field, corner, c));
        const auto share = [row, column](std::span<const Real> x) {
            const Air air{.velocity = {x[2], x[3], x[4]}, .density = x[0], .drag = x[1]};
            return triangle_drag(air, Eigen::Map<const Mat<3>>(x.data() + 5), Eigen::Map<const Mat<3>>(x.data() + 14))(row,
                                                                                                                       column);
        };
        e.evaluate = share;
        e.substitute = [share](std::span<const Real> x) {
            const auto a = Eigen::Map<const Mat<3>>(x.data() + 5);
            return fmt::format("{}, for a = ({:.4g}, {:.4g}, {:.4g}) m and the other corners", share(x), a(0, 0), a(1, 0),
                               a(2, 0));
        };
        terms.push_back(Input::part(fmt::format("C_{}", t), "N s/m", std::move(e)));
    }
    return sum_of("C = Σ C_t over the triangles of the node", std::move(terms));
}

// A row of C (w − v).
Explanation ClothLesson::why_wind_force(Index node, int component) const {
    Explanation e{.formula = "fʷ = ", .inputs = {}, .evaluate = {}};
    for (int c = 0; c < 3; ++c) {
        const char* letter = axis_name(c);
        e.formula += fmt::format("{0}C_{1} (w_{1} − v_{1})", c ? " + " : "", letter);
        e.inputs.push_back(Input::now(fmt::format("C_{}", letter), "wind_drag", node, 3 * component + c));
        e.inputs.push_back(wind_component(c));
        e.inputs.push_back(Input::now(fmt::format("v_{}", letter), "velocity", node, c));
    }
    e.evaluate = [](std::span<const Real> x) { return x[0] * (x[1] - x[2]) + x[3] * (x[4] - x[5]) + x[6] * (x[7] - x[8]); };
    return e;
}

}  // namespace pliant::cloth
