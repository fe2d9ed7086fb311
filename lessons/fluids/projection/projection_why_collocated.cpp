// How the numbers on the collocated grid came about: central differences over two cells.
#include "projection.h"

#include <fmt/format.h>

namespace pliant::projection {
namespace {

using From = Input::From;
using Values = std::span<const Real>;

constexpr std::array<std::string_view, 2> stored{"u_in_cells", "v_in_cells"};
constexpr std::array<const char*, 4> way{"left", "right", "below", "above"};

// The cell one step along an axis; beyond a wall the cell itself, and `inside` says so.
struct CellBeside {
    Index cell;
    bool inside;
};
CellBeside beside(const Lattice<2>& cells, Index cell, int axis, int side) {
    const Index n = cells.neighbour(cells.coordinates(cell), axis, side == 0 ? -1 : 1);
    return n >= 0 ? CellBeside{n, true} : CellBeside{cell, false};
}

}  // namespace

Explanation Projection::why_central_divergence(Index cell, From from) const {
    Explanation why{"∇·u = (u_right − u_left + v_above − v_below) / (2 Δx)", {}, {}};
    if (from == From::before) why.formula.replace(0, std::string("∇·u").size(), "∇·ũ");
    for (int k = 0; k < 4; ++k) {
        const int axis = k / 2;
        const CellBeside b = beside(grid_->cells(), cell, axis, k % 2);
        const std::string symbol = fmt::format("{}_{}", axis == 0 ? "u" : "v", way[static_cast<std::size_t>(k)]);
        const std::string_view field = stored[static_cast<std::size_t>(axis)];
        Input there = flow::sample(b.inside ? symbol : "q", from, field, b.cell);
        if (!b.inside)
            there = Input::part(
                symbol, "m/s",
                {symbol + " = −q   (mirrored, so that nothing crosses the wall)", {there}, [](Values x) { return -x[0]; }});
        why.inputs.push_back(std::move(there));
    }
    why.inputs.push_back(grid_why().dx());
    why.evaluate = [](Values x) { return (x[1] - x[0] + x[3] - x[2]) / (2 * x[4]); };
    return why;
}

// The cells that 4Δx² ∇·∇p takes its values from, with their weights: those two steps away, and the cell itself.
std::map<Index, Real> Projection::wide_row(Index cell) const {
    std::map<Index, Real> row;
    for (int k = 0; k < 4; ++k) {
        const int axis = k / 2, side = k % 2;
        const CellBeside b = beside(grid_->cells(), cell, axis, side);
        // The divergence adds the cell on the high side and subtracts the low one; beyond a wall the gradient is mirrored.
        const Real sign = (side == 1 ? 1 : -1) * (b.inside ? 1 : -1);
        row[beside(grid_->cells(), b.cell, axis, 1).cell] += sign;
        row[beside(grid_->cells(), b.cell, axis, 0).cell] -= sign;
    }
    std::erase_if(row, [](const auto& entry) { return entry.second == 0; });
    return row;
}

Explanation Projection::why_central_pressure(Index cell) const {
    std::map<Index, Real> row = wide_row(cell);
    const Real own = row.contains(cell) ? row[cell] : 0;
    if (own == 0) return fixed_value("p = 0   (the grid sees no pressure here)", 0);
    row.erase(cell);
    std::vector<Input> inputs{Input::now("d̃", "divergence_before", cell), Input::now("d", "divergence_after", cell),
                              grid_why().dx(), Input::of(dt)};
    std::vector<Real> weights;
    std::string sum;
    for (const auto& [other, weight] : row) {
        const std::string symbol = fmt::format("p{}", weights.size() + 1);
        sum += fmt::format("{}{:g} {}", sum.empty() ? "" : " + ", weight, symbol);
        inputs.push_back(Input::now(symbol, "pressure", other));
        weights.push_back(weight);
    }
    return {fmt::format("p = ({} − 4 Δx² (d̃ − d) / Δt) / {:g}", sum.empty() ? "0" : sum, -own), std::move(inputs)};
}

Explanation Projection::why_central_remaining(Index cell) const {
    std::vector<Input> inputs{Input::now("d̃", "divergence_before", cell), grid_why().dx(), Input::of(dt)};
    std::vector<Real> weights;
    std::string sum;
    for (const auto& [other, weight] : wide_row(cell)) {
        const std::string symbol = fmt::format("p{}", weights.size() + 1);
        sum += fmt::format("{}{:g} {}", sum.empty() ? "" : " + ", weight, symbol);
        inputs.push_back(Input::now(symbol, "pressure", other));
        weights.push_back(weight);
    }
    return {fmt::format("∇·u = d̃ − Δt ({}) / (4 Δx²)", sum.empty() ? "0" : sum), std::move(inputs), [weights](Values x) {
                Real total = 0;
                for (std::size_t k = 0; k < weights.size(); ++k) total += weights[k] * x[3 + k];
                return x[0] - x[2] * total / (4 * x[1] * x[1]);
            }};
}

Explanation Projection::why_central_gradient(int axis, Index cell) const {
    return {"g = Δt (p_next − p_before) / (2 Δx)",
            {Input::of(dt), Input::now("p_next", "pressure", beside(grid_->cells(), cell, axis, 1).cell),
             Input::now("p_before", "pressure", beside(grid_->cells(), cell, axis, 0).cell), grid_why().dx()}};
}

Explanation Projection::why_central_projected(int axis, Index cell) const {
    Explanation why = why_central_gradient(axis, cell);
    why.formula = "u′ = ũ − Δt (p_next − p_before) / (2 Δx)";
    why.inputs.insert(why.inputs.begin(), flow::sample("ũ", From::before, stored[static_cast<std::size_t>(axis)], cell));
    why.evaluate = [](Values x) { return x[0] - x[1] * (x[2] - x[3]) / (2 * x[4]); };
    return why;
}

}  // namespace pliant::projection
