#include <pliant/fluids/interpolation_stencil.h>

namespace pliant {
namespace {

// Weights along one axis after the other, as PaddedField::cubic_at interpolates.
template <int Dim>
class CubicWeights {
public:
    CubicWeights(const PaddedField<Dim>& field, InterpolationStencil<Dim>& stencil) : field_(field), stencil_(stencil) {}

    void add() { add_along(0, stencil_.corner, 1); }

private:
    // Along axis 1 first, then along axis 2 where there is one, then along axis 0: level 0 is the last of them.
    static constexpr int axis_of(int level) { return level == 0 ? 0 : Dim - level; }

    std::array<Real, 4> values_along(int level, const Counts<Dim>& at) const {
        std::array<Real, 4> q;
        const int axis = axis_of(level);
        for (Index k = 0; k < 4; ++k) {
            Counts<Dim> beside = at;
            beside[axis] += k - 1;
            q[static_cast<std::size_t>(k)] = value_along(level + 1, beside);
        }
        return q;
    }
    Real value_along(int level, const Counts<Dim>& at) const {
        if (level == Dim) return field_.sample(at);
        return monotone_cubic(values_along(level, at), stencil_.fraction[axis_of(level)]);
    }
    void add_along(int level, const Counts<Dim>& at, Real factor) {
        if (level == Dim) {
            stencil_.samples.push_back({at, factor});
            return;
        }
        const int axis = axis_of(level);
        const std::array<Real, 4> w = monotone_cubic_weights(values_along(level, at), stencil_.fraction[axis]);
        for (Index k = 0; k < 4; ++k) {
            Counts<Dim> beside = at;
            beside[axis] += k - 1;
            add_along(level + 1, beside, factor * w[static_cast<std::size_t>(k)]);
        }
    }

    const PaddedField<Dim>& field_;
    InterpolationStencil<Dim>& stencil_;
};

}  // namespace

template <int Dim>
InterpolationStencil<Dim> interpolation_stencil(const PaddedField<Dim>& field, const GridPlace<Dim>& at) {
    const auto inside = field.locate(at);
    InterpolationStencil<Dim> stencil{field.coordinates(inside.position), inside.fraction, {}};
    if (field.interpolation() == Interpolation::monotone_cubic) {
        CubicWeights<Dim>(field, stencil).add();
        return stencil;
    }
    for (int k = 0; k < 1 << Dim; ++k) {
        WeightedSample<Dim> sample{stencil.corner, 1};
        for (int a = 0; a < Dim; ++a) {
            const bool upper = k >> a & 1;
            sample.at[a] += upper;
            sample.weight *= upper ? stencil.fraction[a] : 1 - stencil.fraction[a];
        }
        stencil.samples.push_back(sample);
    }
    return stencil;
}

template InterpolationStencil<2> interpolation_stencil<2>(const PaddedField<2>&, const GridPlace<2>&);
template InterpolationStencil<3> interpolation_stencil<3>(const PaddedField<3>&, const GridPlace<3>&);

}  // namespace pliant
