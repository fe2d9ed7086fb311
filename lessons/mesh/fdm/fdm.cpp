#include "fdm.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::fdm {
namespace {

// Of samples in a plane, row by row.
Field plane_tensor_field(std::string_view name, std::string_view symbol, std::string_view unit,
                         const ElasticGrid<2>::Tensors& numbers, std::string_view help) {
    Field f = tensor_field(name, symbol, unit, On::element, numbers, help);
    f.components = 4;
    return f;
}

}  // namespace

// ------------------------------------------------------------------------------------------------- what the parameters mean

GridBody FdmLesson::body_at(Index cells) const {
    return {.shape = setting,
            .energy = linear() ? Energy::linear : Energy::stvk,
            .youngs_modulus = youngs_modulus,
            .poisson_ratio = is(GridShape::rod) ? Real{0} : Real{poisson_ratio},
            .length = length,
            .body_force = is(GridShape::block) || is(GridShape::disc) ? Real{body_force} : Real{0},
            .resolution = static_cast<int>(cells),
            .amplitude = is(GridShape::manufactured) ? Real{amplitude} : Real{0}};
}

Real FdmLesson::pressure_wave_speed() const {
    const Lame m = material();
    return std::sqrt((m.lambda + 2 * m.mu) / density);
}

// Of a body that is no box, the node that is there and lies nearest.
Index FdmLesson::nearest_node(Real across, Real up) const {
    const Points<2>& at = grid().positions();
    const Vec<2> low = at.rowwise().minCoeff(), high = at.rowwise().maxCoeff();
    const Vec<2> wanted = low + Vec<2>(across, up).cwiseProduct(high - low);
    Index nearest = 0;
    (at.colwise() - wanted).colwise().squaredNorm().minCoeff(&nearest);
    return nearest;
}

Index FdmLesson::point() const { return nearest_node(point_x, is(GridShape::rod) ? Real{0} : Real{point_y}); }

std::vector<Index> FdmLesson::samples_of(Index node) const {
    std::vector<Index> samples;
    for (Index s = 0; s < grid().sample_count(); ++s)
        if (grid().node_of(s) == node) samples.push_back(s);
    return samples;
}

// ------------------------------------------------------------------------------------------------------------- the start

void FdmLesson::reset() {
    integrator_.reset();
    system_.reset();
    newton_.reset();
    tangent_.forget();
    problem_ = std::make_unique<GridProblem>(body());
    const Index nodes = grid().node_count(), samples = grid().sample_count();
    clock_.setZero();
    rhythm_.reset();
    for (Points<2>* of_nodes : {&displacement_, &force_, &unbalanced_, &reaction_, &rest_, &before_newton_})
        of_nodes->setZero(2, nodes);
    load_.setZero(2, loaded() ? nodes : 0);
    stencil_force_.setZero(2, linear() ? nodes : 0);
    for (Points<2>* of_motion : {&velocity_, &acceleration_}) of_motion->setZero(2, moves() ? nodes : 0);
    step_.setZero(2, moves() ? 0 : nodes);
    for (ElasticGrid<2>::Tensors* of_samples : {&gradient_, &strain_, &stress_}) of_samples->setZero(4, samples);
    metric_.setZero(4, linear() ? 0 : samples);
    metric_.row(0).setOnes(), metric_.row(3).setOnes();
    if (is(GridShape::rod)) displacement_.row(0) = start_strain * grid().positions().row(0);
    error_.setZero(2, has_exact() ? nodes : 0);
    divergence_passes_ = stencil_passes_ = 0;
    if (moves()) {
        inertia_ = DiagonalMass::with_held(density * grid().volumes(), 2, problem_->supports().flags());
        system_ = std::make_unique<ElasticSystem<2>>(grid(), rest_, inertia_);
        system_->terms.force = problem_->nodal_force();
        integrator_ = std::make_unique<TimeIntegrator>(*system_, inertia_, scheme());
    } else {
        newton_ = std::make_unique<NewtonEquilibrium<2>>(grid(), problem_->supports(), NewtonEquilibrium<2>::Settings{});
    }
    start_energy_ = total_energy();
    start_motion_ = start_motion();
}

// Towards a place in the picture, in which displacements may be drawn larger than they are.
void FdmLesson::pull(const std::optional<Pull>& hand) {
    hand_.node = -1;
    if (!hand || hand->index < 0) return;
    if (hand->index >= grid().node_count())
        throw Refused(fmt::format("pull: node {} does not exist, there are {} nodes", hand->index, grid().node_count()));
    if (!hand->to.allFinite()) throw Refused("pull: give a finite place in m");
    hand_.node = hand->index;
    hand_.target = (hand->to.head<2>() - grid().positions().col(hand->index)) / magnification();
}

// ------------------------------------------------------------------------------------------------------------- fields

void FdmLesson::declare_fields() {
    state = {state_array("displacement", "m", displacement_),
             state_array("velocity", "m/s", velocity_),
             state_array("clock", "s", clock_),
             state_array("rhythm", "s, m", rhythm_.memory()),
             {"integrator", "", [this] {
                  if (!integrator_) return std::span<Real>();
                  integrator_->set_scheme(scheme());  // each remembers as much as it needs
                  VecX& memory = integrator_->memory();
                  return std::span<Real>(memory.data(), static_cast<std::size_t>(memory.size()));
              }}};
    const auto in_motion = [this] { return moves(); };
    const auto is_linear = [this] { return linear(); };
    const auto displaced = [this] { return reach(); };
    // What one-sided differences of such displacements come to.
    const auto strained = [this] {
        const Real slope = 4 * reach() / spacing();
        return linear() ? slope : 1 + slope * (1 + slope);
    };
    fields = {
        plane_vector_field("displacement", "u", "m", On::node, displacement_, "of the nodes from where they are at rest")
            .stops_at(displaced),
        plane_vector_field("velocity", "v", "m/s", On::node, velocity_, "of the nodes")
            .stops_at([this] { return reach() * (2 / dt + 2 * fastest()); })
            .when(in_motion),
        plane_tensor_field("gradient", "∂u/∂X", "", gradient_,
                           "one-sided differences at a corner of a cell, shown on the quarter of the cell there")
            .stops_at(strained),
        plane_tensor_field("metric", "G", "", metric_, "metric tensor of the deformed shape, FᵀF; I at rest")
            .stops_at([strained] { return 4 * strained(); })
            .when([this] { return !linear(); }),
        plane_tensor_field("strain", "ε", "", strain_, "small strain, or Green's strain ½ (G − I), of the quarters of cells")
            .stops_at([strained] { return 4 * strained(); }),
        plane_tensor_field("stress", "P", "Pa", stress_, "force per area of the undeformed shape, of the quarters of cells"),
        plane_vector_field("force_density", "f", "N/m³", On::node, force_,
                           "of the stress around a node, per volume: differences of P, without a traction from outside"),
        plane_vector_field(
            "stencil_force", "fˢ", "N/m³", On::node, stencil_force_,
            "the same from displacements in one go, by second differences and the 4-point cross derivative; at the "
            "boundary, where neighbours are missing, that of the stress")
            .when(is_linear),
        plane_vector_field("load", "b", "N/m³", On::node, load_, "force per volume from outside").when([this] {
            return loaded();
        }),
        plane_vector_field("unbalanced", "r", "N/m³", On::node, unbalanced_,
                           "f + b: what moves a node; 0 where a support holds it"),
        plane_vector_field("reaction", "R", "N/m", On::node, reaction_, "of the support, for 1 m of depth"),
        plane_vector_field("acceleration", "a", "m/s²", On::node, acceleration_, "of the nodes").when(in_motion),
        plane_vector_field("newton_step", "d", "m", On::node, step_, "direction of the latest Newton iteration")
            .stops_at(displaced)
            .when([this] { return !moves(); }),
        plane_vector_field("error", "u − u_exact", "m", On::node, error_, "of the displacement, against the exact one")
            .when([this] { return has_exact(); }),
    };
    Field& error = fields.back();
    error.defined_by = {"displacement"};
    error.view = [this] {
        for (Index k = 0; k < error_.cols(); ++k) error_.col(k) = displacement_.col(k) - exact_at(k);
        return view_of(error_)();
    };
    error.explain = [this](const Question& q) {
        return Explanation{"e = u − u_exact",
                           {Input::now("u", "displacement", q.index, q.component),
                            Input::constant("u_exact", exact_at(q.index)[q.component], "m", "in closed form, there and now")}};
    };
}

const Registration<FdmLesson> registration{{.id = "mesh/fdm",
                                            .title = "Finite differences",
                                            .summary = "Derivatives become differences on a regular grid: a rod swings, a block "
                                                       "sinks, and a disc shows what a boundary in stairs costs.",
                                            .demo_steps = 300}};

}  // namespace pliant::fdm
