// Static equilibrium of a body of any elastic energy: Newton's method with a line search [Nocedal2006 §3], one iteration at a
// time.
//
// Prescribed displacements are part of each step: the first one carries the supports to where they shall be as far as the energy
// stays finite, and what is left follows in the next iterations. No step carries an element through the state in which its
// energy is infinite.
#pragma once
#include <pliant/math/constrained_system.h>
#include <pliant/math/sparse_cholesky.h>
#include <pliant/solids/displacement_constraints.h>
#include <pliant/solids/elastic_body.h>

namespace pliant {

enum class LinearSolver { direct, conjugate_gradients };

template <int Dim>
class NewtonEquilibrium {
public:
    struct Settings {
        Real tolerance = 1e-10;  // of the residual force, relative to the largest force in the body
        Index max_iterations = 50;
        LinearSolver solver = LinearSolver::direct;
    };
    enum class Status {
        running,
        converged,
        capped,     // the cap on iterations is reached first
        stagnated,  // no step, however short, leads on
    };

    // The body outlives this. Throws Refused as require_support does, or for a tolerance outside (0, 1).
    NewtonEquilibrium(const ElasticBody<Dim>& body, const DisplacementConstraints<Dim>& constraints, Settings settings);

    // Starts from displacements u0 [m] under forces on the nodes [N]; both Dim × nodes. `constraints` hold the same components as
    // those of the constructor, at other values perhaps. Throws Diverged when the energy is infinite at u0.
    void begin(const Points<Dim>& u0, const Points<Dim>& force, const DisplacementConstraints<Dim>& constraints);
    // One iteration; nothing is done unless running().
    void iterate();
    void solve();  // iterates while running()

    bool running() const { return status_ == Status::running; }
    bool converged() const { return status_ == Status::converged; }
    Status status() const { return status_; }
    // Throws Diverged, with the residual that was reached and its limit, unless converged().
    void require_convergence() const;

    const ElasticBody<Dim>& body() const { return *body_; }
    const Points<Dim>& displacement() const { return u_; }
    const Points<Dim>& step() const { return step_; }                // Newton's direction of the latest iteration [m]
    const Points<Dim>& internal_force() const { return internal_; }  // [N]
    // Load less internal force where the displacement is free, 0 elsewhere [N].
    const Points<Dim>& residual_force() const { return residual_force_; }
    // What the supports do: internal force less load where a displacement is prescribed, 0 elsewhere [N].
    void reaction(Points<Dim>& reaction) const;

    Real residual() const { return residual_; }        // largest residual force over the largest internal force or load
    Real step_length() const { return step_length_; }  // share of Newton's step that the line search took
    bool tangent_was_definite() const { return !made_definite_; }  // of the latest iteration, as it was
    // Added to the diagonal of a tangent that was singular even so [N/m]; else 0.
    Real diagonal_shift() const { return diagonal_shift_; }
    Index iterations() const { return iterations_; }
    // Energy of the body less the work of the loads [J].
    Real potential_energy() const { return potential_; }

private:
    void measure();
    void find_direction();
    bool solve_tangent(bool definite);
    bool try_step(Real length, Real slope);
    Real slope() const;

    const ElasticBody<Dim>* body_;
    Settings settings_;
    DisplacementConstraints<Dim> constraints_;
    SparseMatrix stiffness_;
    ConstrainedSystem system_;
    SparseCholesky cholesky_;
    Points<Dim> u_, force_, step_, internal_, residual_force_, trial_;
    VecX full_, right_side_, direction_;
    Real residual_ = 0, residual_size_ = 0, step_length_ = 0, potential_ = 0, diagonal_shift_ = 0;
    Index iterations_ = 0;
    bool made_definite_ = false;
    Status status_ = Status::converged;
};

}  // namespace pliant
