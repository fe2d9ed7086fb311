// Curves: profiles beside what is exact or beside finite elements, frequencies, and errors by spacing.
#include "fdm.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace pliant::fdm {
namespace {

constexpr std::array<Index, 6> tried{4, 6, 8, 12, 16, 24};

}  // namespace

void FdmLesson::declare_lines() {
    const auto in_rod = [this] { return is(GridShape::rod); };
    // u_x along the row of nodes through the middle; of a rod along it.
    const auto along = [this](Curve& curve, bool exact) {
        const int row = is(GridShape::rod) ? 0 : grid().cells()[1] / 2;
        for (int i = 0; i <= grid().cells()[0]; ++i) {
            const Index k = grid().node_at({i, row});
            if (k >= 0) curve.add(grid().positions()(0, k), exact ? exact_at(k).x() : displacement_(0, k));
        }
    };
    const auto f_of_grid = [this](Index j) {
        const auto n = static_cast<Real>(Index(resolution));
        return pressure_wave_speed() / (std::numbers::pi * spacing()) *
               std::sin(static_cast<Real>(2 * j - 1) * std::numbers::pi / (4 * n));
    };
    lines = {
        line_of("displacement_profile", "m", "place along the body x", "m", "displacement along x, of the nodes along the middle",
                [along](Curve& curve) { along(curve, false); })
            .against("exact",
                     [this, along](Curve& curve) {
                         if (has_exact()) along(curve, true);
                     })
            .measures("displacement u_x")
            .when([this] { return !is(GridShape::block); }),
        line_of("frequencies", "Hz", "number of the mode j", "",
                "of the modes of a rod on this grid, beside those of the continuum",
                [this, f_of_grid](Curve& curve) {
                    for (Index j = 1; j <= resolution; ++j) curve.add(static_cast<Real>(j), f_of_grid(j));
                })
            .against("(2j − 1)c/(4L)",
                     [this](Curve& curve) {
                         for (Index j = 1; j <= resolution; ++j) curve.add(static_cast<Real>(j), released().frequency(j));
                     })
            .measures("frequency f")
            .when([this, in_rod] { return in_rod() && linear(); }),
        line_of("side_profile", "m", "height y", "m",
                "how far the right side of the block bulges, beside quadratic finite elements",
                [this](Curve& curve) {
                    const int n = static_cast<int>(Index(resolution));
                    for (int j = 0; j <= n; ++j) {
                        const Index k = grid().node_at({n, j});
                        curve.add(grid().positions()(1, k), displacement_(0, k));
                    }
                })
            .against("finite elements, at rest",
                     [this](Curve& curve) {
                         const FemBeside* elements = beside();
                         if (!elements) return;
                         std::map<Real, Real> by_height;
                         const Real right = elements->positions.row(0).maxCoeff();
                         for (Index k = 0; k < elements->nodes; ++k)
                             if (elements->positions(0, k) == right)
                                 by_height[elements->positions(1, k)] = elements->displacement(0, k);
                         for (const auto& [y, u] : by_height) curve.add(y, u);
                     })
            .measures("displacement u_x")
            .when([this] { return is(GridShape::block); }),
        line_of("error_by_spacing", "", "spacing of the grid Δx/L", "",
                "largest error at a node over the largest displacement, of this body on grids from 4 to 24 cells",
                [this](Curve& curve) { sample_errors(curve, false); })
            .beside({{"linear finite elements", [this](Curve& curve) { sample_errors(curve, true); }},
                     {"this grid",
                      [this](Curve& curve) {
                          if (solved() && largest_exact() > 0)
                              curve.add(1 / static_cast<Real>(Index(resolution)), nodal_error() / largest_exact());
                      },
                      true}})
            .measures("relative error")
            .on_log_axes()
            .when([this] { return !moves() && has_exact(); }),
    };
}

// They depend on the shape, the form, Poisson's ratio and the amplitude alone.
void FdmLesson::sample_errors(Curve& curve, bool by_elements) const {
    curve = errors_.of({setting, form, poisson_ratio, body().amplitude}, [this] {
        std::array<Curve, 2> both;
        for (const Index n : tried) {
            GridBody unit = body_at(n);
            unit.youngs_modulus = unit.length = unit.body_force = 1;
            try {
                const GridProblem problem(unit);
                Real size = 0;
                for (Index k = 0; k < problem.grid().node_count(); ++k)
                    size = std::max(size, unit.exact(problem.grid().positions().col(k)).cwiseAbs().maxCoeff());
                const Real spacing = 1 / static_cast<Real>(n);
                both[0].add(spacing, problem.error(problem.equilibrium()) / size);
                both[1].add(spacing, finite_elements_beside(unit).error / size);
            } catch (const Diverged&) {  // without this point
            }
        }
        return both;
    })[by_elements ? 1 : 0];
}

}  // namespace pliant::fdm
