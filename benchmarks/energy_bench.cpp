// What one evaluation costs: polar decomposition, energy density, its stress and its tangent. Over many different deformation
// gradients, so that no branch is learnt by heart.
#include <pliant/continuum/deformation.h>
#include <pliant/continuum/energy_density.h>

#include <benchmark/benchmark.h>

#include <random>
#include <vector>

namespace pliant {
namespace {

enum class Kind { near_rest, large, inverted };

// Random entries about the identity; det F has the sign that the kind asks for.
template <int Dim>
std::vector<Mat<Dim>> gradients(Kind kind) {
    std::mt19937 random(7);
    std::uniform_real_distribution<Real> entry(-1, 1);
    const Real size = kind == Kind::near_rest ? 0.1 : 0.6;
    std::vector<Mat<Dim>> all;
    while (all.size() < 1024) {
        const Mat<Dim> F = Mat<Dim>::Identity() + size * Mat<Dim>::NullaryExpr([&] { return entry(random); });
        const Mat<Dim> candidate = kind == Kind::inverted ? Mat<Dim>(-F) : F;
        if (std::abs(volume_ratio<Dim>(F)) > 0.05 && (kind == Kind::inverted) == (volume_ratio<Dim>(candidate) < 0))
            all.push_back(candidate);
    }
    return all;
}

template <int Dim, class Evaluate>
void over_gradients(benchmark::State& state, Kind kind, Evaluate evaluate) {
    const auto all = gradients<Dim>(kind);
    for (auto _ : state)
        for (const Mat<Dim>& F : all) benchmark::DoNotOptimize(evaluate(F));
    const auto count = static_cast<double>(all.size());
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(all.size()));
    state.counters["ns"] =
        benchmark::Counter(count * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

const EnergyDensity<3> density(Energy energy) { return {energy, IsotropicModuli::from_young_poisson(1e6, 0.3).lame()}; }

void register_all() {
    struct Named {
        const char* name;
        Kind kind;
    };
    for (const Named n : {Named{"near_rest", Kind::near_rest}, Named{"large", Kind::large}, Named{"inverted", Kind::inverted}})
        benchmark::RegisterBenchmark((std::string("polar/3d/") + n.name).c_str(), [n](benchmark::State& state) {
            over_gradients<3>(state, n.kind, [](const Mat<3>& F) { return nearest_rotation<3>(F); });
        });
    benchmark::RegisterBenchmark("polar/2d/large", [](benchmark::State& state) {
        over_gradients<2>(state, Kind::large, [](const Mat<2>& F) { return nearest_rotation<2>(F); });
    });
    struct NamedEnergy {
        const char* name;
        Energy energy;
    };
    for (const NamedEnergy n : {NamedEnergy{"linear", Energy::linear}, NamedEnergy{"stvk", Energy::stvk},
                                NamedEnergy{"corotated", Energy::corotated}, NamedEnergy{"neo_hookean", Energy::neo_hookean}}) {
        const std::string name(n.name);
        benchmark::RegisterBenchmark(("energy/psi/" + name).c_str(), [n](benchmark::State& state) {
            over_gradients<3>(state, Kind::large, [d = density(n.energy)](const Mat<3>& F) { return d.psi(F); });
        });
        benchmark::RegisterBenchmark(("energy/P/" + name).c_str(), [n](benchmark::State& state) {
            over_gradients<3>(state, Kind::large, [d = density(n.energy)](const Mat<3>& F) { return d.P(F); });
        });
        benchmark::RegisterBenchmark(("energy/tangent/" + name).c_str(), [n](benchmark::State& state) {
            over_gradients<3>(state, Kind::large, [d = density(n.energy)](const Mat<3>& F) { return d.tangent(F); });
        });
    }
}

[[maybe_unused]] const bool registered = (register_all(), true);

}  // namespace
}  // namespace pliant
