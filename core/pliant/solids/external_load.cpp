#include <pliant/solids/external_load.h>
#include <pliant/solids/point_masses.h>

namespace pliant {

template <int Dim>
void add_external_forces(const ExternalLoad<Dim>& load, const VecX& mass, PointsIn<Dim> x, PointsOut<Dim> f) {
    for (Index n = 0; n < f.cols(); ++n) f.col(n) += mass[n] * load.gravity;
    if (load.pull.active()) f.col(load.pull.node) += load.pull.force(x.col(load.pull.node));
}

template <int Dim>
Real external_energy(const ExternalLoad<Dim>& load, const VecX& mass, PointsIn<Dim> x) {
    const Real pull = load.pull.active() ? load.pull.energy(x.col(load.pull.node)) : 0;
    return gravitational_energy<Dim>(mass, load.gravity, x) + pull;
}

#define PLIANT_INSTANTIATE(Dim)                                                                                   \
    template void add_external_forces<Dim>(const ExternalLoad<Dim>&, const VecX&, PointsIn<Dim>, PointsOut<Dim>); \
    template Real external_energy<Dim>(const ExternalLoad<Dim>&, const VecX&, PointsIn<Dim>);

PLIANT_INSTANTIATE(2)
PLIANT_INSTANTIATE(3)
#undef PLIANT_INSTANTIATE

}  // namespace pliant
