// M6: what the lectures say of boundary elements, measured beside finite elements on a ring.
#include "bem.h"

#include <pliant/study/claims.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <cmath>

namespace pliant::bem {
namespace {

RingProblem linear_ring() {
    return {{1, 2, 1e6, IsotropicModuli::from_young_poisson(2e11, 0.3).lame()}, BoundaryOrder::linear, 32};
}

// Linear elements on both sides, so that both errors fall with the square of the size of an element.
Finding only_the_boundary() {
    const RingProblem problem = linear_ring();
    const Effort coarse = boundary_effort(problem, 16), own = boundary_effort(problem, 32);
    const Comparison c = compare_efforts(problem, own);
    const Real order = std::log2(coarse.error / own.error);
    const Real fewer = c.equal.unknowns / own.unknowns, entries = c.equal.entries / own.entries,
               operations = c.equal.operations / own.operations;
    const auto round = [](Real x) { return format_quantity(x, "", 2); };
    return {.figure = fewer,
            .verdict = fewer > 2 && order > 1.5 ? Verdict::qualified : Verdict::refuted,
            .text = fmt::format(
                "A ring with {:.0f} unknowns on its two circles is as good as linear triangles with {} times as many. Their "
                "sparse matrix has {} times as many entries, and takes {} times as many operations to factorise.",
                own.unknowns, round(fewer), round(entries), round(operations)),
            .condition =
                "the body is of one material, whose Kelvin solution is known; the matrix is full, so that its entries grow with "
                "the square of the unknowns, and the operations with the cube"};
}

const ClaimRegistration m6{"M6", only_the_boundary};

}  // namespace
}  // namespace pliant::bem
