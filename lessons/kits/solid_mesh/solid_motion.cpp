#include "solid_motion.h"

namespace pliant::solid_mesh {
namespace {

template <int Dim>
class MotionOf final : public SolidMotion {
public:
    MotionOf(const ElasticBody<Dim>& body, const MatX& rest, const VecX& node_mass, const std::vector<Index>& held)
        : SolidMotion(DiagonalMass(node_mass, Dim, held)), rest_(rest), system_(body, rest_, mass_) {
        integrator_ = std::make_unique<TimeIntegrator>(system_, mass_);
    }
    void set_load(const OuterLoad& load) override {
        system_.load.gravity = -load.gravity * Vec<Dim>::Unit(1);
        system_.load.pull = {load.pull.node, load.pull.target.head<Dim>(), load.pull.stiffness};
        system_.terms.force = load.force;
        system_.mass_damping = load.mass_damping;
    }

private:
    Points<Dim> rest_;
    ElasticSystem<Dim> system_;
};

}  // namespace

template <int Dim>
std::unique_ptr<SolidMotion> SolidMotion::of(const ElasticBody<Dim>& body, const MatX& rest, const VecX& node_mass,
                                             const std::vector<Index>& held) {
    return std::make_unique<MotionOf<Dim>>(body, rest, node_mass, held);
}

template std::unique_ptr<SolidMotion> SolidMotion::of<2>(const ElasticBody<2>&, const MatX&, const VecX&,
                                                         const std::vector<Index>&);
template std::unique_ptr<SolidMotion> SolidMotion::of<3>(const ElasticBody<3>&, const MatX&, const VecX&,
                                                         const std::vector<Index>&);

VecX lumped_mass(const Solid& solid, Real density) {
    VecX mass = VecX::Zero(solid.node_count());
    for (Index e = 0; e < solid.element_count(); ++e)
        for (int a = 0; a < solid.nodes_of_element(); ++a)
            mass[solid.node(e, a)] += density * solid.volumes()[e] / solid.nodes_of_element();
    return mass;
}

}  // namespace pliant::solid_mesh
