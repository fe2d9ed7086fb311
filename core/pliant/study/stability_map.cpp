#include <pliant/math/parallel.h>
#include <pliant/study/stability_map.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <numbers>

namespace pliant {
namespace {

// Until the motion has turned so far it has not shown a whole period of its energy, rad.
constexpr Real whole_turn = 3 * std::numbers::pi;

const Probe* find_probe(const Lesson& lesson, std::string_view name) {
    const auto found = std::ranges::find(lesson.probes, name, &Probe::name);
    return found == lesson.probes.end() ? nullptr : &*found;
}

const Probe* watched(const Lesson& lesson, const std::string& wanted) {
    if (!wanted.empty()) return &lesson.probe(wanted);
    const Probe* energy = find_probe(lesson, "energy");
    return energy ? energy : find_probe(lesson, "kinetic_energy");
}

// One thread's part of the work: its runner is used again for every cell.
class CellRunner {
public:
    CellRunner(const MapOrder& order, const std::stop_token& stop)
        : order_(order), stop_(stop), runner_(*order.lesson, order.settings, 0), probe_(watched(runner_.lesson(), order.probe)) {
        for (const Assumption& a : runner_.lesson().assumptions)
            if (a.name == "stability") theory_ = &a;
    }

    MapCell run(Index i, Index j) {
        MapCell cell;
        watch_.clear();
        bool began = false;
        try {
            runner_.load(cell_assignments(order_, runner_.lesson(), i, j));
            began = true;
            cell.theory = theory();
            cell.verdict = step();
        } catch (const Refused& e) {
            cell.verdict = {.kind = Stability::refused, .reason = e.what()};
        } catch (const Diverged& e) {
            const bool gave_up = e.failure.kind == FailureKind::not_converged;
            cell.verdict = {.kind = gave_up ? Stability::not_converged : Stability::diverged,
                            .growth = watch_.overall_growth(),
                            .reason = e.what()};
        }
        if (!began) return cell;
        cell.steps = runner_.place().step;
        for (const Stage& stage : runner_.lesson().stages) cell.passes += runner_.cost(stage).passes;
        return cell;
    }

private:
    std::optional<Real> theory() const {
        if (!theory_) return std::nullopt;
        if (!theory_->in_use()) return 0;
        const Real value = theory_->value(), limit = theory_->limit();
        if (std::isnan(value) || std::isnan(limit)) return std::nullopt;
        return limit > 0 ? value / limit : std::numeric_limits<Real>::infinity();
    }

    Index wanted_steps() const {
        if (!order_.time) return order_.steps;
        const Real steps = std::round(*order_.time / runner_.time_step());
        return std::max(least_map_steps, static_cast<Index>(std::min(steps, Real{1e9})));
    }

    void observe() {
        if (probe_) watch_.add(runner_.value(*probe_), runner_.exact(*probe_));
        const auto& state = runner_.lesson().state;
        // What has no unit counts something, and what has several is a memory of a method; neither is the motion.
        for (std::size_t a = 0; a < state.size(); ++a)
            if (!state[a].unit.empty() && state[a].unit.find(',') == std::string_view::npos) turn_.add(a, state[a].view());
    }

    StabilityVerdict step() {
        turn_.clear(runner_.lesson().state.size());
        observe();
        const Index wanted = wanted_steps();
        for (Index until = wanted;; until *= 2) {
            while (runner_.place().step < until && !watch_.exploded() && !stop_.stop_requested()) {
                runner_.step();
                observe();
            }
            const bool last = until >= most_extension * wanted || stop_.stop_requested();
            const StabilityVerdict verdict = watch_.verdict(turn_.turned() >= whole_turn, last);
            if (verdict.settled) return verdict;
        }
    }

    const MapOrder& order_;
    const std::stop_token& stop_;
    Runner runner_;
    const Probe* probe_;
    const Assumption* theory_ = nullptr;
    StabilityWatch watch_;
    TurnMeter turn_;
};

// What the threads share.
class Work {
public:
    Work(StabilityMap& map, const MapProgress& progress, const std::stop_token& stop)
        : map_(map), progress_(progress), stop_(stop), total_(static_cast<Index>(map.cells.size())) {}

    void take_part() {
        if (next_ >= total_) return;
        try {
            CellRunner runner(map_.order, stop_);
            for (Index k = next_++; k < total_ && !stop_.stop_requested(); k = next_++) {
                map_.cells[static_cast<std::size_t>(k)] = runner.run(k % map_.columns(), k / map_.columns());
                tell();
            }
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!error_) error_ = std::current_exception();
            next_ = total_;
        }
    }
    bool finish() const {
        if (error_) std::rethrow_exception(error_);
        return !stop_.stop_requested();
    }

private:
    void tell() {
        const std::lock_guard lock(mutex_);
        ++done_;
        if (progress_) progress_(done_, total_);
    }

    StabilityMap& map_;
    const MapProgress& progress_;
    const std::stop_token& stop_;
    const Index total_;
    std::atomic<Index> next_ = 0;
    std::mutex mutex_;
    Index done_ = 0;
    std::exception_ptr error_;
};

}  // namespace

Index StabilityMap::count(Stability kind) const {
    return std::ranges::count_if(cells, [&](const MapCell& c) { return c.verdict.kind == kind; });
}

Runner::Assignments cell_assignments(const MapOrder& order, const Lesson& lesson, Index i, Index j) {
    Runner::Assignments all = order.settings;
    const auto assign = [&](const Knob& knob, Index k) {
        all.emplace_back(knob.key, lesson.parameter(knob.key).text(knob.values[static_cast<std::size_t>(k)]));
    };
    assign(order.across, i), assign(order.up, j);
    return all;
}

void check_order(const MapOrder& order) {
    const Runner runner(*order.lesson, order.settings, 0);
    const Lesson& lesson = runner.lesson();
    if (order.across.key == order.up.key)
        throw Refused(fmt::format("--map {} is given twice: a map needs two different knobs", order.up.key));
    for (const Knob* knob : {&order.across, &order.up}) {
        lesson.parameter(knob->key);
        for (const auto& [key, value] : order.settings)
            if (key == knob->key) throw Refused(fmt::format("{} is a knob of the map: leave out --set {}={}", key, key, value));
    }
    if (runner.is_static())
        throw Refused(fmt::format("{} is solved at once: it takes no time steps that could be stable or not", runner.info().id));
    if (order.time ? !(std::isfinite(*order.time) && *order.time > 0) : false)
        throw Refused("--time", *order.time, "s", "a finite time above 0");
    if (!order.time && order.steps < least_map_steps)
        throw Refused("--steps", static_cast<Real>(order.steps), "", fmt::format("a whole number from {} on", least_map_steps));
    watched(lesson, order.probe);
}

StabilityMap make_stability_map(const MapOrder& order, int jobs, const MapProgress& progress, std::stop_token stop) {
    if (jobs < 1) throw Refused("--jobs", jobs, "", "a whole number from 1 on");
    check_order(order);
    StabilityMap map{.order = order, .probe = {}, .cells = {}};
    {
        const auto lesson = order.lesson->make();
        const Probe* probe = watched(*lesson, order.probe);
        map.probe = probe ? probe->name : "";
    }
    map.cells.resize(order.across.values.size() * order.up.values.size());
    Work work(map, progress, stop);
    const auto most = static_cast<int>(std::min<std::size_t>(map.cells.size(), 256));
    parallel_jobs(std::min(jobs, most), [&work](int) { work.take_part(); });
    map.complete = work.finish();
    if (!map.complete) map.cells.clear();
    return map;
}

}  // namespace pliant
