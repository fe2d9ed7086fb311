#include <pliant/math/element_assembly.h>
#include <pliant/math/error.h>
#include <pliant/mesh/element_mass.h>

#include <cmath>

namespace pliant {
namespace {

void require_density(Real density) {
    if (!(density > 0) || !std::isfinite(density)) throw Refused("density", density, "kg/m³", "a finite density > 0");
}

}  // namespace

template <int Dim, int Order>
VecX lumped_mass(const SimplexElements<Dim, Order>& elements, Real density) {
    require_density(density);
    VecX mass = VecX::Zero(elements.node_count());
    const auto shares = SimplexElements<Dim, Order>::lumped_shares();
    for (Index e = 0; e < elements.element_count(); ++e)
        for (int a = 0; a < shares.size(); ++a)
            mass[elements.elements()(a, e)] += density * elements.mesh().volumes()[e] * shares[a];
    return mass;
}

template <int Dim, int Order>
SparseMatrix consistent_mass(const SimplexElements<Dim, Order>& elements, Real density) {
    require_density(density);
    constexpr int nodes = SimplexElements<Dim, Order>::nodes;
    const ElementAssembly<Dim, nodes> assembly(elements.elements(), elements.node_count());
    SparseMatrix mass = assembly.pattern();
    const auto& unit = SimplexElements<Dim, Order>::unit_mass();
    Mat<Dim* nodes> local = Mat<Dim * nodes>::Zero();
    for (Index e = 0; e < elements.element_count(); ++e) {
        for (int a = 0; a < nodes; ++a)
            for (int b = 0; b < nodes; ++b)
                for (int k = 0; k < Dim; ++k)
                    local(Dim * a + k, Dim * b + k) = density * elements.mesh().volumes()[e] * unit(a, b);
        assembly.add(e, local, mass);
    }
    return mass;
}

#define PLIANT_INSTANTIATE(Dim, Order)                                   \
    template VecX lumped_mass(const SimplexElements<Dim, Order>&, Real); \
    template SparseMatrix consistent_mass(const SimplexElements<Dim, Order>&, Real)
PLIANT_INSTANTIATE(2, 1);
PLIANT_INSTANTIATE(2, 2);
PLIANT_INSTANTIATE(3, 1);
PLIANT_INSTANTIATE(3, 2);
#undef PLIANT_INSTANTIATE

}  // namespace pliant
