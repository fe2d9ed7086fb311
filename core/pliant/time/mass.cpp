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

}  // namespace pliant
