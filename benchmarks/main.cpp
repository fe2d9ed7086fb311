#include <benchmark/benchmark.h>

#include "late.h"

int main(int argc, char** argv) {
    for (const auto& add : late_benchmarks()) add();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
