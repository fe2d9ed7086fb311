// Probes and curves.
#include "fvm.h"

#include <pliant/solids/point_masses.h>
#include <pliant/text/format.h>
#include <pliant/time/vibration.h>

#include <fmt/format.h>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace pliant::fvm {
namespace {

constexpr Real rounding = 1e-15;  // of strains, and of what sums of a few numbers lose

}  // namespace

void FvmLesson::declare_probes() {
    const auto defined_where = [](std::function<bool()> there, std::function<Real()> number) {
        return [there, number] { return there() ? std::optional<Real>(number()) : std::nullopt; };
    };
    const auto tip_of = [this, defined_where](std::string_view name, int component, std::string_view symbol) {
        return probe_of(name, symbol, "m", "mean displacement of the nodes of the loaded face",
                        defined_where([this, component] { return held() && component < solid_->dim(); },
                                      [this, component] { return tip(component); }));
    };
    probes = {
        probe_of("difference_from_fem", "δ", "",
                 "largest difference of a nodal force from that of finite elements, in parts of the largest force on a face",
                 [this] { return difference_from_fem(); }),
        probe_of("difference_of_forms", "δ_σ", "",
                 "largest difference of P N at rest from σ a on the deformed face, in parts of the largest force on a face",
                 [this] { return difference_of_forms(); }),
        probe_of("sum_of_faces", "Σ", "N", "largest sum of the forces on all faces of one element: they cancel",
                 [this] { return sum_of_faces(); }),
        probe_of("largest_face_force", "f_max", "N", "of all faces", [this] { return largest_face_force(); }),
        tip_of("tip_x", 0, "ū_x"),
        tip_of("tip_y", 1, "ū_y"),
        tip_of("tip_z", 2, "ū_z"),
        probe_of("energy", "E", "J", "kinetic, elastic, and of the loads", [this] { return total_energy(); }),
        probe_of("kinetic_energy", "K", "J", "½ Σ m v²", [this] { return kinetic(); }),
        probe_of("elastic_energy", "U", "J", "Σ V ψ(F), which no stage needs", [this] { return elastic(); }),
        probe_of("load_energy", "V", "J", "of weight, load and hand: 0 at rest", [this] { return outer_energy(); }),
        probe_of("momentum", "p", "kg m/s", "magnitude of Σ m v", [this] { return momentum().norm(); })
            .exactly([this]() -> std::optional<Real> { return held() || interfered_ ? std::nullopt : std::optional<Real>(0); }),
        probe_of("angular_momentum", "L", "kg m²/s", "magnitude, about the centre of mass", [this] { return spin(); })
            .exactly([this]() -> std::optional<Real> {
                return held() || interfered_ || damped() ? std::nullopt : std::optional<Real>(start_spin_);
            }),
        probe_of("smallest_volume", "J", "", "smallest volume of an element over its volume at rest; below 0 it is inside out",
                 [this] { return smallest_volume_ratio(); }),
        probe_of("stable_time_step", "Δt*", "s", "largest stable time step of an explicit scheme, for small vibrations",
                 defined_where([this] { return !implicit(); }, [this] { return stable_time_step(); })),
        probe_of("newton_iterations_used", "", "", "of the latest time step",
                 defined_where([this] { return implicit() && clock_[0] > 0 && motion_->integrator().scheme() == Scheme(scheme); },
                               [this] { return static_cast<Real>(motion_->integrator().solver().iterations()); })),
    };
}

Real FvmLesson::tip(int component) const {
    Real sum = 0;
    for (const Index n : solid_->loaded_nodes()) sum += displacement()(component, n);
    return sum / static_cast<Real>(solid_->loaded_nodes().size());
}

Real FvmLesson::largest_face_force() const { return face_force_.colwise().norm().maxCoeff(); }

// What rounding of F makes of a force on a face, N.
Real FvmLesson::face_rounding() const {
    const Real stiff = std::abs(solid_->lame().lambda) + 2 * solid_->lame().mu;
    return rounding * stiff * rest_area_.colwise().norm().maxCoeff() * std::max<Real>(1, deformation_.cwiseAbs().maxCoeff());
}

std::optional<Real> FvmLesson::difference_from_fem() const {
    const Real largest = largest_face_force();
    if (!forces_meet_ || !(largest > 0)) return std::nullopt;
    return (force_ - fem_force_).cwiseAbs().maxCoeff() / largest;
}

std::optional<Real> FvmLesson::difference_of_forms() const {
    const Real largest = largest_face_force();
    if (!(largest > 0) || (cauchy_.colwise().norm().array() == 0).any()) return std::nullopt;
    return (face_force_ - true_face_force_).cwiseAbs().maxCoeff() / largest;
}

Real FvmLesson::sum_of_faces() const {
    Real largest = 0;
    for (Index e = 0; e < solid_->element_count(); ++e)
        largest = std::max(largest, face_force_.middleCols(face(e, 0), corners()).rowwise().sum().norm());
    return largest;
}

Real FvmLesson::kinetic() const { return 0.5 * mass_.dot(velocity_.colwise().squaredNorm()); }

Real FvmLesson::outer_energy() const {
    const MatX& u = displacement();
    Real energy = weight_acceleration() * u.row(1).dot(mass_) - load_on_nodes().cwiseProduct(u).sum();
    if (pulled()) energy += 0.5 * pull_stiffness * (pull_->to.head(solid_->dim()) - position_.col(pull_->index)).squaredNorm();
    return energy;
}

VecX FvmLesson::momentum() const { return velocity_ * mass_; }

Real FvmLesson::spin() const {
    const VecX centre = position_ * mass_ / mass_.sum(), mean = momentum() / mass_.sum();
    Vec<3> sum = Vec<3>::Zero();
    for (Index n = 0; n < mass_.size(); ++n) {
        Vec<3> arm = Vec<3>::Zero(), v = Vec<3>::Zero();
        arm.head(solid_->dim()) = position_.col(n) - centre, v.head(solid_->dim()) = velocity_.col(n) - mean;
        sum += mass_[n] * arm.cross(v);
    }
    return sum.norm();
}

Real FvmLesson::momentum_terms() const { return mass_.dot(velocity_.colwise().norm()); }

Real FvmLesson::smallest_volume_ratio() const {
    Real least = 1e300;
    const MatX& u = displacement();
    for (Index e = 0; e < solid_->element_count(); ++e) least = std::min(least, solid_->deformation(e, u).determinant());
    return least;
}

// Of the linear body under its load: the first step of Newton's method from rest.
Real FvmLesson::motion_energy() const {
    if (!compliance_) {
        compliance_ = 0;
        MatX load = load_on_nodes();
        load.row(1) -= weight_acceleration() * mass_.transpose();
        if (held() && load.norm() > 0) {
            solid_->hold(solid_->fixed_nodes());
            solid_->begin(MatX::Zero(load.rows(), load.cols()), load, MatX::Zero(load.rows(), load.cols()));
            solid_->iterate();
            compliance_ = load.cwiseProduct(solid_->newton_step()).sum();
        }
    }
    return kinetic() + elastic() + *compliance_;
}

Real FvmLesson::energy_tolerance() const {
    const Real solved = implicit() ? 1e-6 : 1e-9;
    const Real excess = dt <= stable_time_step() ? energy_excess(scheme, fastest() * dt, false, damped()) : Real{0};
    return (solved + excess) * motion_energy();
}

Real FvmLesson::fastest() const {
    if (!fastest_) {
        const MatX at_rest = MatX::Zero(solid_->dim(), solid_->node_count());
        fastest_ = fastest_mode(solid_->stiffness(at_rest, true), motion_->mass()).omega;
    }
    return *fastest_;
}

// A pull adds at most its own stiffness.
Real FvmLesson::stable_time_step() const {
    const Real omega = pulled() ? std::hypot(fastest(), std::sqrt(pull_stiffness / mass_[pull_->index])) : fastest();
    return stability_limit(scheme, omega, rayleigh_damping_ratio(omega, damping, 0));
}

// --------------------------------------------------------------------------------------------------------------- curves

// The force [N] with which what lies right of a cut between two columns of cells pulls at what lies left of it, by the faces of
// the elements on one side.
Vec<3> FvmLesson::cut_force(Index cut, bool from_left) const {
    const Real at = body.length * static_cast<Real>(cut) / static_cast<Real>(Index(body.cells_x)), near = 1e-6 * body.length;
    Vec<3> sum = Vec<3>::Zero();
    for (Index e = 0; e < solid_->element_count(); ++e)
        for (int k = 0; k < corners(); ++k) {
            if ((rest_area_(0, face(e, k)) > 0) != from_left) continue;
            const std::vector<Index> nodes = face_nodes(e, k);
            if (std::ranges::all_of(nodes, [&](Index n) { return std::abs(solid_->rest()(0, n) - at) < near; }))
                sum.head(solid_->dim()) += (from_left ? 1 : -1) * face_force_.col(face(e, k));
        }
    return sum;
}

// At rest, of a slender beam under the load at its end and its weight.
Real FvmLesson::slender_deflection(Real x) const {
    const Real L = body.length, h = body.height, b = in_space() ? Real{body.width} : Real{1};
    const Real nu = body.poisson_ratio, Y = body.youngs_modulus;
    const Real stiff = (!in_space() && Plane(body.plane) == Plane::strain ? Y / (1 - nu * nu) : Y) * b * h * h * h / 12;
    const Real weight = density * weight_acceleration() * b * h;  // N/m
    return body.load_y * x * x * (3 * L - x) / (6 * stiff) - weight * x * x * (6 * L * L - 4 * L * x + x * x) / (24 * stiff);
}

void FvmLesson::declare_lines() {
    const auto at = [this](Index cut) { return body.length * static_cast<Real>(cut) / static_cast<Real>(Index(body.cells_x)); };
    const auto by_faces = [this, at](bool from_left) {
        return [this, at, from_left](Curve& c) {
            for (Index cut = 1; cut < body.cells_x; ++cut) c.add(at(cut), cut_force(cut, from_left)[1]);
        };
    };
    const auto is_held = [this] { return held(); };
    lines = {line_of("cut_force", "N", "place of the cut x", "m",
                     "force across each cut between two columns of cells: the sum over the faces in it, as the elements at its "
                     "left have them and as those at its right do. At rest the load beyond the cut; their stresses differ, and "
                     "only nodes are in balance",
                     by_faces(true))
                 .against("load beyond the cut",
                          [this, at](Curve& c) {
                              for (Index cut = 1; cut < body.cells_x; ++cut)
                                  c.add(at(cut),
                                        load_force()[1] - weight_acceleration() * mass_.sum() * (1 - at(cut) / body.length));
                          })
                 .beside({{.name = "from the right", .sample = by_faces(false)}})
                 .measures("from the left")
                 .when(is_held),
             line_of("deflection", "m", "place at rest X", "m", "of the lower edge, beside that of a slender beam at rest",
                     [this](Curve& c) {
                         for (Index n = 0; n < solid_->node_count(); ++n)
                             if (solid_->rest(n)[1] == 0 && solid_->rest(n)[2] == 0)
                                 c.add(solid_->rest(n)[0], displacement()(1, n));
                     })
                 .against("slender beam at rest",
                          [this](Curve& c) { c.add_range(0, body.length, 41, [this](Real x) { return slender_deflection(x); }); })
                 .measures("u_y")
                 .when(is_held)};
}

}  // namespace pliant::fvm
