// Curves: how a beam bends, how fast the error falls, how triangles lock.
#include "fem.h"

#include <pliant/solids/cooks_membrane_table.h>
#include <pliant/solids/elastica.h>
#include <pliant/solids/manufactured_solution.h>

#include <algorithm>

namespace pliant::fem {
namespace {

// A body of its own beside the lesson's, solved at once.
MatX solved(Solid& solid, const MatX& load) {
    const MatX nothing = MatX::Zero(solid.dim(), solid.node_count());
    solid.hold(solid.fixed_nodes());
    solid.begin(nothing, load, nothing);
    while (solid.running()) solid.iterate();
    return solid.displacement();
}

void add_points(const std::vector<std::pair<Real, Real>>& points, Curve& curve) {
    for (const auto& [x, y] : points) curve.add(x, y);
}

}  // namespace

FemLesson::Table FemLesson::measure_convergence() const {
    Table table;
    for (const int of_order : {1, 2})
        for (const int n : {2, 4, 8, 16}) {
            solid_mesh::BodySettings s = settings();
            s.order = of_order, s.cells = {n, n, 1};
            const auto solid = solid_mesh::make_solid(s);
            const MatX load = solid->lame().lambda * solid->plane_load(manufactured::force_of_lambda) +
                              solid->lame().mu * solid->plane_load(manufactured::force_of_mu);
            const auto errors = solid->plane_errors(solved(*solid, load), manufactured::displacement, manufactured::gradient);
            table[static_cast<std::size_t>(of_order - 1)].emplace_back(Real{1} / n, errors.l2);
        }
    return table;
}

FemLesson::Table FemLesson::measure_locking(int cells) const {
    Table table;
    for (const int of_order : {1, 2})
        for (const auto& [nu, converged] : converged_membrane) {
            solid_mesh::BodySettings s;
            s.shape = Shape::cook, s.plane = Plane::strain, s.order = of_order, s.poisson_ratio = nu, s.cells = {cells, cells, 1};
            const auto solid = solid_mesh::make_solid(s);
            MatX load = MatX::Zero(2, solid->node_count());
            load.row(1) = solid->loaded_area().transpose() / solid->loaded_area().sum();
            const MatX u = solved(*solid, load);
            Index middle = 0;
            (solid->rest().colwise() - Vec<2>(48, 52)).colwise().squaredNorm().minCoeff(&middle);
            table[static_cast<std::size_t>(of_order - 1)].emplace_back(nu, u(1, middle));
        }
    return table;
}

const FemLesson::Table& FemLesson::convergence() const {
    return convergence_.of({body.youngs_modulus, body.poisson_ratio, body.plane}, [this] { return measure_convergence(); });
}

// On even numbers of cells, few enough for a curve beside a run.
const FemLesson::Table& FemLesson::locking() const {
    const int cells = std::clamp<int>(2 * static_cast<int>(Index(body.cells_x) / 2), 2, 8);
    return locking_.of(cells, [this, cells] { return measure_locking(cells); });
}

void FemLesson::declare_lines() {
    add_bending_lines(), add_error_lines(), add_locking_lines();
    lines.push_back(
        line_of("course", "m", "share of the load", "",
                "displacement of the loaded face, step by step of the load; it is a straight line where the body is linear",
                [this](Curve& curve) {
                    for (Index k = 0; k < course_length_; ++k)
                        curve.add(course_(0, k), course_.col(k).segment(1, solid_->dim()).norm());
                })
            .measures("|ū|")
            .when([this] { return !is(Setting::manufactured) && levels() > 1; }));
}

// Over the load number, since a slender beam depends on it alone.
void FemLesson::add_bending_lines() {
    const auto end = [this] { return std::clamp<Real>(1.2 * bending_number().value_or(1), 1, 12); };
    lines.push_back(
        line_of("bending", "", "F L²/(Y I)", "",
                "deflection of the tip over the length: this beam, and a slender one of any load",
                [this](Curve& curve) {
                    for (Index k = 0; k < course_length_; ++k)
                        curve.add(course_(0, k) * bending_number().value_or(0), std::abs(course_(2, k)) / body.length);
                })
            .against("slender beam, bent as far as it likes",
                     [end](Curve& curve) { curve.add_range(0, end(), 41, [](Real a) { return elastica(a).deflection; }); })
            .beside({{.name = "small deflections, a/3",
                      .sample = [](Curve& curve) { curve.add_range(0, 3, 2, [](Real a) { return a / 3; }); }}})
            .measures("|ū_y|/L")
            .when([this] { return loaded_down(); }));
}

void FemLesson::add_error_lines() {
    lines.push_back(
        line_of("convergence", "m²", "edge of a cell h", "m",
                "error of the displacement on 2, 4, 8 and 16 cells along each side: with quadratic elements one order better",
                [this](Curve& curve) { add_points(convergence()[0], curve); })
            .beside({{.name = "quadratic elements", .sample = [this](Curve& curve) { add_points(convergence()[1], curve); }},
                     {.name = "this run",
                      .sample =
                          [this](Curve& curve) {
                              if (done_[0] != 0) curve.add(Real{1} / static_cast<Real>(Index(body.cells_x)), errors().l2);
                          },
                      .points = true}})
            .measures("linear elements")
            .on_log_axes()
            .when([this] { return is(Setting::manufactured); }));
}

void FemLesson::add_locking_lines() {
    lines.push_back(
        line_of("locking", "m", "Poisson's ratio ν", "",
                "deflection of the panel in plane strain, Y = 1 Pa and F = 1 N, on at most 8 cells along each edge: linear "
                "triangles collapse near ½, quadratic ones do not",
                [this](Curve& curve) { add_points(locking()[0], curve); })
            .against(
                "cubic triangles, converged",
                [](Curve& curve) {
                    for (const auto& [nu, deflection] : converged_membrane) curve.add(nu, deflection);
                },
                true)
            .beside({{.name = "quadratic triangles", .sample = [this](Curve& curve) { add_points(locking()[1], curve); }}})
            .measures("linear triangles")
            .when([this] { return is(Setting::cook); }));
}

}  // namespace pliant::fem
