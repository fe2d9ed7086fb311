// Cost of the measures of strain and of Hooke's law, per 3 × 3 matrix.
#include <pliant/continuum/moduli.h>
#include <pliant/continuum/strain.h>

#include <benchmark/benchmark.h>

#include <random>
#include <vector>

namespace {
using namespace pliant;

// As many as fit into the first cache.
std::vector<Mat<3>> gradients() {
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<Real> spread(-0.3, 0.3);
    std::vector<Mat<3>> all(64);
    for (Mat<3>& H : all) H = Mat<3>::NullaryExpr([&] { return spread(engine); });
    return all;
}

template <class Measure>
void each(benchmark::State& state, Measure measure) {
    const std::vector<Mat<3>> given = gradients();
    std::vector<Mat<3>> results(given.size());
    for (auto _ : state) {
        for (std::size_t k = 0; k < given.size(); ++k) results[k] = measure(given[k]);
        benchmark::DoNotOptimize(results.data());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(given.size()));
    state.counters["ns_per_matrix"] = benchmark::Counter(
        static_cast<double>(given.size()) * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void strain_cauchy(benchmark::State& state) {
    each(state, [](const Mat<3>& H) { return cauchy_strain<3>(H); });
}
void strain_green(benchmark::State& state) {
    each(state, [](const Mat<3>& H) { return green_strain<3>(H); });
}
void strain_right_cauchy_green(benchmark::State& state) {
    each(state, [](const Mat<3>& H) { return right_cauchy_green<3>(Mat<3>::Identity() + H); });
}
void hooke_tensor(benchmark::State& state) {
    const Lame material = IsotropicModuli::from_young_poisson(1e6, 0.3).lame();
    each(state, [&](const Mat<3>& strain) { return hooke_stress<3>(material, strain); });
}
void hooke_matrix(benchmark::State& state) {
    const Mat<6> D = elasticity_matrix(IsotropicModuli::from_young_poisson(1e6, 0.3));
    each(state, [&](const Mat<3>& strain) { return tensor_from_voigt_stress<3>(D * voigt_strain<3>(strain)); });
}

BENCHMARK(strain_cauchy)->Name("strain/cauchy");
BENCHMARK(strain_green)->Name("strain/green");
BENCHMARK(strain_right_cauchy_green)->Name("strain/right_cauchy_green");
BENCHMARK(hooke_tensor)->Name("hooke/tensor");
BENCHMARK(hooke_matrix)->Name("hooke/matrix_6x6");

}  // namespace
