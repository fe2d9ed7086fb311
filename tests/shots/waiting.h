// Waiting for what goes on in another thread.
#pragma once
#include <chrono>
#include <functional>
#include <thread>

namespace pliant::test {

// Looks again and again until it is so. Only what hangs is given up, after minutes: a busy machine may take its time.
inline bool comes_true(const std::function<bool()>& condition) {
    using namespace std::chrono_literals;
    const auto deadline = std::chrono::steady_clock::now() + 20min;
    while (std::chrono::steady_clock::now() < deadline) {
        if (condition()) return true;
        std::this_thread::sleep_for(1ms);
    }
    return condition();
}

}  // namespace pliant::test
