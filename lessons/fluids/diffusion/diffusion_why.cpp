// How each number came about.
#include "diffusion.h"
#include "kits/grid2d/grid_why.h"

#include <fmt/format.h>

#include <cmath>

namespace pliant::diffusion {
namespace {

using From = Input::From;

std::string joined(const std::vector<Input>& inputs) {
    std::string sum;
    for (const Input& in : inputs) sum += (sum.empty() ? "" : " + ") + in.symbol;
    return sum;
}

}  // namespace

// What the stencil takes from around a cell; beyond a wall what continues u there.
std::vector<Input> DiffusionLesson::why_neighbours(Index cell, Input::From from, const char* mark) const {
    std::vector<Input> beside;
    for (const Neighbour& n : neighbours()) {
        Counts<2> at = lattice_.coordinates(cell);
        at[n.axis] += n.step;
        beside.push_back(grid2d::sample(fmt::format("u{}_{}", mark, n.name), from, "u", sample_beyond(lattice_, at)));
    }
    return beside;
}

std::optional<Explanation> DiffusionLesson::why_neighbourhood(const Question& q) const {
    if (q.field == "u_before") return Explanation{"u_b = u   (kept to compare)", {Input::before("u", "u", q.index)}};
    if (q.field == "laplacian") return Explanation{"∇²u = s / Δx²", {Input::now("s", "stencil", q.index), why_dx()}};
    std::vector<Input> inputs = why_neighbours(q.index, From::before, "");
    std::string formula = fmt::format("s = {} − {} u", joined(inputs), inputs.size());
    inputs.push_back(Input::before("u", "u", q.index));
    return Explanation{std::move(formula), std::move(inputs)};
}

Explanation DiffusionLesson::why_updated(Index cell) const {
    const Input s = Input::now("s", "stencil", cell);
    if (literal())
        return {.formula = "u′ = ν Δt s   (as on the slide: the number of ν Δt in m²)",
                .inputs = {viscosity, Input::part("Δt", "s", why_time_step()), s},
                .wrong_unit = true};
    return {"u′ = u + r s", {Input::before("u", "u", cell), why_rate(), s}};
}

// The equation of this cell solved for its own u, with what the iterations have left of it.
std::optional<Explanation> DiffusionLesson::why_solved(const Question& q) const {
    if (q.field == "u_before") return why_neighbourhood(q);
    const bool residual = q.field == "residual";
    std::vector<Input> beside = why_neighbours(q.index, From::now, "′");
    const std::size_t n = beside.size();
    const std::string sum = joined(beside);
    std::vector<Input> inputs{Input::before("u", "u", q.index), why_rate()};
    inputs.insert(inputs.end(), beside.begin(), beside.end());
    inputs.push_back(residual ? Input::now("u′", "u", q.index) : Input::now("ρ", "residual", q.index));
    if (residual) return Explanation{fmt::format("ρ = u − u′ + r ({} − {} u′)", sum, n), std::move(inputs)};
    return Explanation{fmt::format("u′ = (u + r ({}) − ρ) / (1 + {} r)", sum, n), std::move(inputs)};
}

// -------------------------------------------------------------------------------------------------------------- probes

Explanation DiffusionLesson::why_amplitude(std::string_view field) const {
    const VecX wave = modes_.on_cells(mode);
    const Real square = wave.squaredNorm();
    std::vector<std::pair<Input, Input>> terms;
    if (square < 1e-20) return fixed_value("A = 0   (the mode vanishes on every cell)");
    for (Index c = 0; c < wave.size(); ++c)
        if (wave[c] != 0)
            terms.emplace_back(Input::constant(fmt::format("w{}", c), wave[c] / square, "", "φ/Σφ² of this cell"),
                               Input::now(fmt::format("u{}", c), field, c));
    if (couette()) {
        const VecX base = deviation(VecX::Zero(wave.size()));
        terms.emplace_back(
            Input::constant("w_s", 1, "", "of the steady part"),
            Input::constant("u_s", modes_.amplitude(base, mode), "m/s", "less the amplitude of the steady profile"));
    }
    return weighted_sum("A = Σ_c w_c u_c, w = φ/Σφ² of the cells", "w_c", "u_c", terms);
}

Explanation DiffusionLesson::why_theory() const {
    Input Lambda =
        part(fmt::format("Λ = {} sin(κ / 2)²", 4 * dims()),
             {Input::constant("κ", modes_.phase(mode), "rad", "phase from one cell to the next: 2πm/n, or πm/n between walls")});
    if (literal())
        return {.formula = "G_r = −ν Δt Λ",
                .inputs = {viscosity, Input::part("Δt", "s", why_time_step()), std::move(Lambda)},
                .wrong_unit = true};
    if (is_explicit()) return {"G_r = 1 − r Λ", {why_rate(), std::move(Lambda)}};
    return {"G_r = 1 / (1 + r Λ)", {why_rate(), std::move(Lambda)}};
}

}  // namespace pliant::diffusion
