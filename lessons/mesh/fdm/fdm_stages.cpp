// The stages of a step in the order of the lecture: differences, strain, stress, differences again, motion.
#include "fdm.h"

#include <algorithm>
#include <cmath>

namespace pliant::fdm {
namespace {

Mat<2> matrix_of(const ElasticGrid<2>::Tensors& tensors, Index sample) {
    Mat<2> m;
    m << tensors(0, sample), tensors(1, sample), tensors(2, sample), tensors(3, sample);
    return m;
}

void store(const Mat<2>& m, ElasticGrid<2>::Tensors& tensors, Index sample) {
    tensors.col(sample) << m(0, 0), m(0, 1), m(1, 0), m(1, 1);
}

}  // namespace

void FdmLesson::declare_stages() {
    const auto reason = [this](const Question& q) { return why(q); };
    const auto in_motion = [this] { return moves(); };
    formula_symbols = {{"X", "m"},  {"x", "m"}, {"y", "m"},  {"Δx", "m"},  {"F"}, {"E"},      {"λ", "Pa"},
                       {"μ", "Pa"}, {"u", "m"}, {"V", "m²"}, {"K", "N/m"}, {"s"}, {"h", "m"}, {"m", "kg/m"}};
    stages = {
        stage_of("differences", "∂u/∂X ≈ (uⱼ − uᵢ)/Δx", "lecture: finite differences method, a regular spatial grid",
                 [this] { difference_stage(); })
            .maps({"displacement"}, {"gradient"})
            .because(reason)
            .done_in("core/pliant/solids/elastic_grid.cpp: gradient"),
        stage_of("metric", "G = FᵀF,  F = I + ∂u/∂X",
                 "lecture: metric tensors of the deformed and original shapes; [Terzopoulos1987 §3]", [this] { metric_stage(); })
            .maps({"gradient"}, {"metric"})
            .because(reason)
            .when([this] { return !linear(); })
            .done_in("lessons/mesh/fdm/fdm_stages.cpp: metric_stage"),
        stage_of("strain", "Navier–Lamé: ε = ½ (∂u/∂X + (∂u/∂X)ᵀ);  metric tensors: E = ½ (G − I)",
                 "lecture: Cauchy's strain; the difference between metric tensors [Terzopoulos1987 §3]",
                 [this] { strain_stage(); })
            .maps({"gradient", "metric"}, {"strain"})
            .shows([this] { return std::string_view(linear() ? "ε = ½ (∂u/∂X + (∂u/∂X)ᵀ)" : "E = ½ (G − I)"); })
            .because(reason)
            .done_in("core/pliant/continuum/strain.h: cauchy_strain, green_strain"),
        stage_of("stress", "Navier–Lamé: P = λ tr(ε) I + 2 μ ε;  metric tensors: P = F (λ tr(E) I + 2 μ E)",
                 "lecture: Hooke's law; [Terzopoulos1987 §4]", [this] { stress_stage(); })
            .maps({"gradient", "strain"}, {"stress"})
            .shows([this] { return std::string_view(linear() ? "P = λ tr(ε) I + 2 μ ε" : "P = F (λ tr(E) I + 2 μ E)"); })
            .because(reason)
            .done_in("core/pliant/continuum/energy_density.cpp: P"),
        stage_of("divergence", "f = ∂P_x/∂x + ∂P_y/∂y", "lecture: ρ a = ∇·σ + F, the derivative discretised by differences",
                 [this] { divergence_pass(); })
            .maps({"stress"}, {"force_density"})
            .repeats([this] { return divergence_passes_ < 2; }, [this] { force_.setZero(), divergence_passes_ = 0; })
            .because(reason)
            .done_in("core/pliant/solids/elastic_grid.cpp: add_divergence"),
        stage_of("stencil", "fˢ = μ ∇²u + (λ + μ) ∇(∇·u):  along x, along y, across by (u₊₊ − u₊₋ − u₋₊ + u₋₋)/(4 Δx²)",
                 "lecture: Lamé's linear equation, discretised directly", [this] { stencil_pass(); })
            .maps({"displacement", "force_density"}, {"stencil_force"})
            .repeats([this] { return stencil_passes_ < stencil_passes(); }, [this] { stencil_passes_ = 0; })
            .shows([this] {
                return std::string_view(is(GridShape::rod) ? "fˢ = Y (uⱼ − 2 uᵢ + uₖ)/Δx²" : "fˢ = μ ∇²u + (λ + μ) ∇(∇·u)");
            })
            .because(reason)
            .when([this] { return linear(); })
            .done_in("core/pliant/solids/grid_problem.cpp: second_difference, cross_difference"),
        stage_of("loads", "b = ρ g of a weight;  b = ρ ω² X of a disc that spins;  b = −∇·P of a known field",
                 "lecture: external forces F", [this] { load_stage(); })
            .maps({}, {"load"})
            .where({{"g", "m/s²"}, {"ω", "rad/s"}, {"∇", "1/m"}})
            .because(reason)
            .when([this] { return loaded(); })
            .done_in(
                "core/pliant/solids/grid_problem.cpp: force_density; core/pliant/solids/elastic_solutions.cpp: force_density"),
        stage_of("balance", "r = f + b", "lecture: ρ a = ∇·σ + F", [this] { balance_stage(); })
            .maps({"force_density", "load"}, {"unbalanced"})
            .because(reason)
            .done_in("lessons/mesh/fdm/fdm_stages.cpp: balance_stage"),
        stage_of("boundary", "held: R = −V r, r ← 0;  free: no traction, the differences end there", "boundary conditions",
                 [this] { support_stage(); })
            .maps({"unbalanced"}, {"unbalanced", "reaction"})
            .because(reason)
            .done_in("lessons/mesh/fdm/fdm_stages.cpp: support_stage"),
        stage_of("acceleration", "a = r/ρ − α v;  at a pulled node + kₕ (h − u)/m", "lecture: ρ a = ∇·σ + F",
                 [this] { acceleration_stage(); })
            .maps({"unbalanced", "velocity", "displacement"}, {"acceleration"})
            .because(reason)
            .when(in_motion)
            .done_in("lessons/mesh/fdm/fdm_stages.cpp: acceleration_stage"),
        stage_of("integrate", "a step of Δt by the chosen integrator",
                 "lecture: semi-implicit integration moves forward through time", [this] { integrate(); })
            .maps({"displacement", "velocity", "acceleration"}, {"displacement", "velocity"})
            .repeats([this] { return integrator_->again(); }, [this] { begin_integration(); }, [this] { end_integration(); })
            .shows([this] { return info_of(scheme()).formula; })
            .where({{"x", "m"}, {"f", "N"}, {"m", "kg"}})
            .because(reason)
            .when(in_motion)
            .done_in("core/pliant/time/time_integrator.cpp: explicit_pass"),
        stage_of("solve", "K d = V r,  u ← u + s d, until r = 0", "equilibrium by Newton's method [Nocedal2006 §3]",
                 [this] { solve_stage(); })
            .maps({"displacement", "unbalanced"}, {"newton_step", "displacement"})
            .where({{"V", "m³"}})
            .because(reason)
            .when([this] { return !moves(); })
            .loops_from("differences", [this] { return !solved(); })
            .done_in("core/pliant/solids/newton_equilibrium.cpp: iterate"),
    };
}

// ------------------------------------------------------------------------------------------------------- from u to stress

void FdmLesson::difference_stage() {
    for (Index s = 0; s < gradient_.cols(); ++s) store(grid().gradient(s, displacement_), gradient_, s);
}

void FdmLesson::metric_stage() {
    for (Index s = 0; s < metric_.cols(); ++s) {
        const Mat<2> F = Mat<2>::Identity() + matrix_of(gradient_, s);
        store(F.transpose() * F, metric_, s);
    }
}

void FdmLesson::strain_stage() {
    for (Index s = 0; s < strain_.cols(); ++s) {
        const Mat<2> H = matrix_of(gradient_, s);
        const Mat<2> strain =
            linear() ? Mat<2>(0.5 * (H + H.transpose())) : Mat<2>(0.5 * (matrix_of(metric_, s) - Mat<2>::Identity()));
        store(strain, strain_, s);
    }
}

// Of a rod only the stress along it counts: no node moves across.
void FdmLesson::stress_stage() {
    const Lame m = material();
    for (Index s = 0; s < stress_.cols(); ++s) {
        const Mat<2> strain = matrix_of(strain_, s);
        Mat<2> stress = m.lambda * strain.trace() * Mat<2>::Identity() + 2 * m.mu * strain;
        if (is(GridShape::rod)) stress << youngs_modulus * strain(0, 0), 0, 0, 0;
        if (!linear()) stress = (Mat<2>::Identity() + matrix_of(gradient_, s)) * stress;
        store(stress, stress_, s);
    }
}

// ------------------------------------------------------------------------------------------------------- from stress to force

void FdmLesson::divergence_pass() { grid().add_divergence(static_cast<int>(divergence_passes_++), stress_, force_); }

void FdmLesson::stencil_pass() {
    const Lame m = material();
    const Index pass = stencil_passes_++;
    for (Index k = 0; k < stencil_force_.cols(); ++k) {
        if (!problem_->has_stencil(k)) {
            stencil_force_.col(k) = force_.col(k);
        } else if (is(GridShape::rod)) {
            stencil_force_.col(k) << youngs_modulus * second_difference(grid(), displacement_, k, 0).x(), force_(1, k);
        } else if (pass < 2) {
            const int axis = static_cast<int>(pass);
            Vec<2> stiff = Vec<2>::Constant(m.mu);
            stiff[axis] += m.lambda + m.mu;
            const Vec<2> part = stiff.cwiseProduct(second_difference(grid(), displacement_, k, axis));
            stencil_force_.col(k) = pass == 0 ? part : Vec<2>(stencil_force_.col(k) + part);
        } else {
            const Vec<2> across = cross_difference(grid(), displacement_, k);
            stencil_force_.col(k) += (m.lambda + m.mu) * Vec<2>(across.y(), across.x());
        }
    }
}

void FdmLesson::load_stage() { load_ = problem_->force_density(); }

void FdmLesson::balance_stage() {
    unbalanced_ = force_;
    if (loaded()) unbalanced_ += load_;
}

void FdmLesson::support_stage() {
    for (Index k = 0; k < unbalanced_.cols(); ++k)
        for (int c = 0; c < 2; ++c) {
            const bool held = problem_->supports().prescribed(k, c);
            reaction_(c, k) = held ? -grid().volumes()[k] * unbalanced_(c, k) : 0;
            if (held) unbalanced_(c, k) = 0;
        }
}

// -------------------------------------------------------------------------------------------------------------- motion

void FdmLesson::follow_hand() { hand_.stiffness = pull_stiffness; }

void FdmLesson::acceleration_stage() {
    follow_hand();
    acceleration_ = unbalanced_ / density;
    if (damped()) acceleration_ -= damping * velocity_;
    if (pulled())
        acceleration_.col(hand_.node) += hand_.force(displacement_.col(hand_.node)) / (density * grid().volumes()[hand_.node]);
    for (Index d = 0; d < acceleration_.size(); ++d)
        if (inertia_.fixed(d)) acceleration_.data()[d] = 0;
}

void FdmLesson::begin_integration() {
    system_->mass_damping = damped() ? Real{damping} : Real{0};
    system_->load.pull = hand_;
    integrator_->set_scheme(scheme());
    const VecX force = inertia_.mass().cwiseProduct(flat(acceleration_));
    integrator_->begin(dt, flat(displacement_), flat(velocity_), &force);
}

// Behind each pass the nodes are where the next force is evaluated.
void FdmLesson::integrate() {
    integrator_->pass();
    flat(displacement_) = integrator_->position();
    flat(velocity_) = integrator_->velocity();
}

void FdmLesson::end_integration() {
    integrator_->finish(flat(displacement_), flat(velocity_));
    clock_[elapsed] += dt;
    note_swing();
}

// --------------------------------------------------------------------------------------------------------- equilibrium

// One Newton iteration; the round behind the last one finds that nothing is left to do, with all fields at the solution.
void FdmLesson::solve_stage() {
    if (solved()) return;
    if (clock_[iterations] == 0) newton_->begin(displacement_, problem_->nodal_force(), problem_->supports());
    if (newton_->converged()) {
        clock_[is_solved] = 1;
        return;
    }
    before_newton_ = displacement_;
    newton_->iterate();
    if (!newton_->running()) newton_->require_convergence();
    displacement_ = newton_->displacement();
    step_ = newton_->step();
    clock_[iterations] += 1;
    tangent_.forget();
}

}  // namespace pliant::fdm
