#include <pliant/math/error.h>
#include <pliant/time/mass.h>

#include <fmt/format.h>

#include <cmath>

namespace pliant {

DiagonalMass::DiagonalMass(const VecX& node_mass, int dimension, const std::vector<Index>& fixed)
    : mass_(node_mass.size() * dimension) {
    for (Index n = 0; n < node_mass.size(); ++n) {
        if (!(node_mass[n] > 0) || !std::isfinite(node_mass[n]))
            throw Refused(fmt::format("mass[{}]", n), node_mass[n], "kg", "a finite mass > 0");
        mass_.segment(n * dimension, dimension).setConstant(node_mass[n]);
    }
    inverse_ = mass_.cwiseInverse();
    for (const Index n : fixed) {
        if (n < 0 || n >= node_mass.size())
            throw Refused(fmt::format("fixed node {} does not exist: there are {} nodes", n, node_mass.size()));
        inverse_.segment(n * dimension, dimension).setZero();
    }
}

DiagonalMass DiagonalMass::with_held(const VecX& node_mass, int dimension, const std::vector<char>& held) {
    DiagonalMass mass(node_mass, dimension);
    if (static_cast<Index>(held.size()) != mass.size())
        throw Refused(fmt::format("{} flags of held degrees of freedom: there are {}", held.size(), mass.size()));
    for (Index d = 0; d < mass.size(); ++d)
        if (held[static_cast<std::size_t>(d)]) mass.inverse_[d] = 0;
    return mass;
}

}  // namespace pliant
