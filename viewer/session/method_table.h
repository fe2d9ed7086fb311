// All methods of the open lesson in its present scene, run beside the lab in a thread of their own. It draws nothing.
#pragma once
#include <pliant/math/background.h>
#include <pliant/math/watch.h>
#include <pliant/study/method_comparison.h>

#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pliant::viewer {

class Session;

class MethodTable {
public:
    MethodTable() = default;
    MethodTable(const MethodTable&) = delete;
    MethodTable& operator=(const MethodTable&) = delete;
    // What is being run is called off and waited for.
    ~MethodTable() { cancel(); }

    std::string over{};  // key of the choice whose options are compared

    // Another lesson forgets the table; takes up what is done. Call in every frame.
    void follow(const Session& session);
    // From the start of the scene to the time where it stands; as far as its demo goes where it has not begun. What goes wrong is
    // told by trouble().
    // The first steps of each run are measured before; with asks, what then takes too long is not run but told by work().
    void start(const Session& session, bool asks = false);
    void make_now(const Session& session);  // in this thread
    void cancel();
    bool busy() const { return under_way_ != nullptr; }
    Watch::Progress progress() const { return under_way_ ? under_way_->watch.progress() : Watch::Progress{}; }

    const MethodComparison* result() const { return result_ ? &*result_ : nullptr; }
    // While it is busy: the runs that are done; null before the first.
    std::shared_ptr<const MethodComparison> so_far() const;
    // What start() runs, and how long that takes, as far as it was measured; of a static lesson at the pace of the present
    // run, which has to have made a step.
    struct Work {
        Index runs = 0, steps = 0;  // steps: of each; 0 where they end by themselves
        std::optional<Real> seconds{};
        bool long_one() const { return seconds && *seconds > 20; }
    };
    Work work(const Session& session) const;

    // Has something beside the choice changed since?
    bool outdated(const Session& session) const;
    const std::string& trouble() const { return trouble_; }

private:
    struct Job {
        Job(SceneFile wanted, std::string choice, Until far) : scene(std::move(wanted)), over(std::move(choice)), until(far) {}
        SceneFile scene;
        std::string over;
        Until until;
        Watch watch{};
        Index steps = 0;
        std::mutex telling{};
        std::shared_ptr<const MethodComparison> so_far{};
        std::optional<Real> seconds{};                                      // that it takes, measured
        std::optional<Background<std::optional<MethodComparison>>> work{};  // last: it is waited for before the others go
    };
    struct Measured {
        SceneFile scene;
        std::string over;
        Index steps = 0;
        Real seconds = 0;
    };
    std::unique_ptr<Job> job_of(const Session& session) const;
    Index steps_of(const Session& session) const;
    std::optional<Real> measured_seconds(const Session& session) const;
    void take(const std::function<std::optional<MethodComparison>()>& made, const Job& job);

    std::string_view lesson_{};
    std::optional<MethodComparison> result_;
    std::optional<Measured> measured_;  // last
    Runner::Assignments settings_;      // of the scene that was compared, without the choice
    std::string trouble_;
    std::unique_ptr<Job> under_way_;
    std::list<std::unique_ptr<Job>> cancelled_;  // until their threads are done
};

// The option beside the present run, as run B.
void open_method_beside(Session& session, const MethodComparison& comparison, std::size_t row);

// --- what if ---
// A press compares the run with one in which a single parameter is different.
struct WhatIf {
    std::string words;  // "twice Δt: 4 ms"
    std::string text;   // of the value
};
// Half and twice a number, as far as they are accepted; the other options of a choice; a switch turned.
std::vector<WhatIf> what_if(const Session& session, const Parameter& parameter);
// Run B differs from A in that alone, and both go to the time where A stands.
void compare_what_if(Session& session, const Parameter& parameter, const WhatIf& what);
// What the single difference of B does to the key numbers, in sentences; "" without B, or where it differs in more.
std::string what_if_words(const Session& session);

}  // namespace pliant::viewer
