#include <pliant/math/error.h>
#include <pliant/solids/element_materials.h>

#include <fmt/format.h>

#include <cmath>

namespace pliant {

template <int Dim>
void check_materials(const std::vector<Lame>& materials, Index elements) {
    if (static_cast<Index>(materials.size()) != elements)
        throw Refused(fmt::format("{} materials do not fit {} elements", materials.size(), elements));
    for (std::size_t e = 0; e < materials.size(); ++e) {
        const auto [lambda, mu] = materials[e];
        if (!(mu > 0) || !(Dim * lambda + 2 * mu > 0) || !std::isfinite(lambda) || !std::isfinite(mu))
            throw Refused(fmt::format(
                "element {} has lambda = {} Pa and mu = {} Pa: give finite values with mu > 0 and {} lambda + 2 mu > 0", e,
                lambda, mu, Dim));
    }
}

template void check_materials<2>(const std::vector<Lame>&, Index);
template void check_materials<3>(const std::vector<Lame>&, Index);

}  // namespace pliant
