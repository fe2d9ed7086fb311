#include "fem_motion.h"

#include <pliant/solids/elastic_system.h>

#include <optional>

namespace pliant::fem {
namespace {

template <int Dim>
class MotionOf final : public Motion {
public:
    MotionOf(const solid_mesh::Solid& solid, const ElasticBody<Dim>& body, std::unique_ptr<Mass> mass)
        : rest_(solid.rest()), mass_(std::move(mass)), system_(body, rest_, *mass_) {}

    void follow(const Acting& acting) override {
        acting_ = acting;
        system_.mass_damping = acting.mass_damping, system_.stiffness_damping = acting.stiffness_damping;
        system_.load.gravity.setZero();
        system_.load.gravity[1] = -acting.gravity;
        system_.load.pull.node = acting.pulled;
        system_.load.pull.target = acting.target.template head<Dim>();
        system_.load.pull.stiffness = acting.pull_stiffness;
        system_.terms.force = acting.load;
    }
    MatX force(const MatX& x, const MatX& v) override {
        MatX f = MatX::Zero(Dim, x.cols());
        system_.begin_step(flat(x));
        system_.force(flat(x), flat(v), flat(f));
        return f;
    }
    Real potential(const MatX& x) override { return system_.potential(flat(x)); }

    void begin(Scheme scheme, Real dt, const MatX& x, const MatX& v, const MatX& force, const NewtonOptions& options) override {
        if (!integrator_) integrator_.emplace(system_, *mass_, scheme, options);
        integrator_->set_scheme(scheme);
        integrator_->set_options(options);
        if (acting_.ground)
            set_ground_bounds<Dim>(ground(), Points<Dim>(x), integrator_->lower_bound());
        else
            integrator_->lower_bound().resize(0);
        contact_.begin(dt, Points<Dim>(x), Points<Dim>(v));
        start_force_ = flat(force);
        integrator_->begin(dt, flat(x), flat(v), &start_force_);
    }
    bool again() const override { return integrator_->again(); }
    void pass(MatX& x, MatX& v) override {
        integrator_->pass();
        flat(x) = integrator_->position(), flat(v) = integrator_->velocity();
        for (Index d = 0; d < v.size(); ++d)
            if (mass_->fixed(d)) v.data()[d] = 0;
    }
    void finish(MatX& x, MatX& v) override { integrator_->finish(flat(x), flat(v)); }
    Index meet_ground(MatX& x, MatX& v) override {
        const auto& mass = dynamic_cast<const DiagonalMass&>(*mass_);
        contact_.arrest(*integrator_, mass);
        const auto force = [this](ConstDofs at, ConstDofs velocity, Dofs f) {
            system_.begin_step(at);
            system_.force(at, velocity, f);
        };
        Points<Dim> places = x, velocities = v;
        const Index touching = contact_.resolve(ground(), mass, integrator_->scheme(), force, places, velocities);
        x = places, v = velocities;
        return touching;
    }
    Touch touch(Index node) const override { return contact_.touch(node); }
    const TimeIntegrator& integrator() const override { return *integrator_; }
    const Mass& mass() const override { return *mass_; }
    const VecX& node_mass() const override { return system_.node_mass(); }

private:
    Ground ground() const { return {0, 0, acting_.friction}; }

    Points<Dim> rest_;
    std::unique_ptr<Mass> mass_;
    VecX start_force_;
    ElasticSystem<Dim> system_;
    std::optional<TimeIntegrator> integrator_;
    GroundContact<Dim> contact_;
    Acting acting_;
};

}  // namespace

std::unique_ptr<Motion> make_motion(const solid_mesh::Solid& solid, std::unique_ptr<Mass> mass) {
    if (const auto* plane = solid.plane_body()) return std::make_unique<MotionOf<2>>(solid, *plane, std::move(mass));
    return std::make_unique<MotionOf<3>>(solid, *solid.space_body(), std::move(mass));
}

}  // namespace pliant::fem
