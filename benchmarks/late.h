// Benchmarks that are registered once all lessons are known.
#pragma once
#include <functional>
#include <vector>

inline std::vector<std::function<void()>>& late_benchmarks() {
    static std::vector<std::function<void()>> all;
    return all;
}

struct LateBenchmarks {
    explicit LateBenchmarks(std::function<void()> add) { late_benchmarks().push_back(std::move(add)); }
};
