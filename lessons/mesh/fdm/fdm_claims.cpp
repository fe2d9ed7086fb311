// What the lecture says of finite differences, measured.
#include <pliant/math/line_fit.h>
#include <pliant/solids/grid_problem.h>
#include <pliant/study/claims_report.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

namespace pliant::fdm {
namespace {

constexpr std::array<int, 5> resolutions{8, 12, 16, 24, 32};

struct ErrorsOfBoth {
    std::vector<Real> grid, elements;  // m
};

ErrorsOfBoth errors_on(GridShape shape) {
    ErrorsOfBoth errors;
    for (const int n : resolutions) {
        const GridProblem problem({.shape = shape,
                                   .energy = Energy::linear,
                                   .youngs_modulus = 1e4,
                                   .poisson_ratio = 0.3,
                                   .length = 1,
                                   .body_force = 1000,
                                   .resolution = n});
        errors.grid.push_back(problem.error(problem.equilibrium()));
        errors.elements.push_back(finite_elements_beside(problem.body()).error);
    }
    return errors;
}

// -d log error/d log n.
Real order_of(const std::vector<Real>& errors) {
    std::vector<Real> log_spacing, log_error;
    for (std::size_t k = 0; k < errors.size(); ++k) {
        log_spacing.push_back(-std::log(static_cast<Real>(resolutions[k])));
        log_error.push_back(std::log(errors[k]));
    }
    return fit_line(log_spacing, log_error)->slope;
}

Finding stairs_on_a_disc() {
    const ErrorsOfBoth disc = errors_on(GridShape::disc), square = errors_on(GridShape::manufactured);
    const Real stairs = order_of(disc.grid), triangles = order_of(disc.elements), along = order_of(square.grid);
    const bool holds = std::abs(stairs - 1) <= 0.3 && triangles > 1.5 && std::abs(along - 2) <= 0.2;
    const auto text = [](Real x, const char* unit = "") { return format_quantity(x, unit, 3); };
    return {
        .figure = stairs,
        .verdict = holds ? Verdict::reproduced : Verdict::refuted,
        .text = fmt::format("With 32 cells along the radius the largest error is {} on the grid and {} by finite elements of as "
                            "many rings, {} times less; from 8 cells on it falls with the order {} and {}. On a square, whose "
                            "boundary lies along the grid, the same formula has the order {}.",
                            text(disc.grid.back(), "m"), text(disc.elements.back(), "m"),
                            text(disc.grid.back() / disc.elements.back()), text(stairs), text(triangles), text(along))};
}

const ClaimRegistration m4{"M4", stairs_on_a_disc};

}  // namespace
}  // namespace pliant::fdm
