// Work that goes on beside its owner, such as a map that the lab makes while a run is shown.
#pragma once
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>

namespace pliant {

template <class Result>
class Background {
public:
    // Begins with work(stop) in a thread of its own; where the system has none to give, it is done here and now. The work looks
    // at the token from time to time, and may then end early with any result.
    explicit Background(std::function<Result(const std::stop_token&)> work) {
        const auto task = std::make_shared<std::packaged_task<Result(const std::stop_token&)>>(std::move(work));
        result_ = task->get_future();
        try {
            thread_ = std::jthread([task](const std::stop_token& stop) { (*task)(stop); });
        } catch (const std::system_error&) {
            (*task)(std::stop_token());
        }
    }
    // Asks it to stop, and waits until it has.
    ~Background() = default;
    Background(Background&&) noexcept = default;
    Background& operator=(Background&&) noexcept = default;

    bool done() const { return result_.valid() && result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }
    void ask_to_stop() { thread_.request_stop(); }
    // Once: waits until it is done, and gives its result or throws what it threw.
    Result take() { return result_.get(); }

private:
    std::future<Result> result_;
    std::jthread thread_;  // last: it is waited for before the result goes
};

}  // namespace pliant
