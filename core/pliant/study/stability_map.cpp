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

// Cells from one that comes first to the next: three of them at least in each direction, where there are so many.
Index coarsest(Index columns, Index rows) {
    Index width = 8;
    while (width > 1 && std::min(columns, rows) < 3 * width) width /= 2;
    return width;
}

// The coarsest cells of which this one is the corner are so many wide.
Index width_of(Index i, Index j, Index most) {
    while (i % most != 0 || j % most != 0) most /= 2;
    return most;
}

// The numbers of the cells, the coarse ones first.
std::vector<Index> coarse_to_fine(Index columns, Index rows) {
    std::vector<Index> order;
    const Index most = coarsest(columns, rows);
    for (Index width = most; width >= 1; width /= 2)
        for (Index j = 0; j < rows; ++j)
            for (Index i = 0; i < columns; ++i)
                if (width_of(i, j, most) == width) order.push_back(i + columns * j);
    return order;
}

// What the threads share.
class Work {
public:
    Work(StabilityMap& map, const MapProgress& progress, const std::stop_token& stop, MapSoFar* so_far)
        : map_(map),
          progress_(progress),
          stop_(stop),
          so_far_(so_far),
          order_(coarse_to_fine(map.columns(), map.rows())),
          total_(static_cast<Index>(map.cells.size())) {
        if (so_far_) so_far_->begin(map.columns(), map.rows());
    }

    void take_part() {
        if (next_ >= total_) return;
        try {
            CellRunner runner(map_.order, stop_);
            for (Index n = next_++; n < total_ && !stop_.stop_requested(); n = next_++) {
                const Index k = order_[static_cast<std::size_t>(n)], i = k % map_.columns(), j = k / map_.columns();
                MapCell& cell = map_.cells[static_cast<std::size_t>(k)];
                cell = runner.run(i, j);
                if (so_far_ && !stop_.stop_requested()) so_far_->add(i, j, cell);
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
    MapSoFar* const so_far_;
    const std::vector<Index> order_;
    const Index total_;
    std::atomic<Index> next_ = 0;
    std::mutex mutex_;
    Index done_ = 0;
    std::exception_ptr error_;
};

}  // namespace

void MapSoFar::begin(Index columns, Index rows) {
    const std::scoped_lock lock(mutex_);
    columns_ = columns, rows_ = rows, done_ = 0;
    coarsest_ = coarsest(columns, rows);
    coarse_left_ = ((columns + coarsest_ - 1) / coarsest_) * ((rows + coarsest_ - 1) / coarsest_);
    cells_.assign(static_cast<std::size_t>(columns * rows), std::nullopt);
}

void MapSoFar::add(Index i, Index j, const MapCell& cell) {
    const std::scoped_lock lock(mutex_);
    cells_[static_cast<std::size_t>(i + columns_ * j)] = cell;
    ++done_;
    if (i % coarsest_ == 0 && j % coarsest_ == 0) --coarse_left_;
}

Index MapSoFar::done() const {
    const std::scoped_lock lock(mutex_);
    return done_;
}

std::optional<StabilityMap> MapSoFar::map(const MapOrder& order) const {
    const std::scoped_lock lock(mutex_);
    if (cells_.empty() || coarse_left_ > 0) return std::nullopt;
    StabilityMap map{.order = order, .probe = {}, .cells = {}};
    for (Index j = 0; j < rows_; ++j)
        for (Index i = 0; i < columns_; ++i) {
            Index width = 1;
            const auto covering = [&] {
                return cells_[static_cast<std::size_t>(i / width * width + columns_ * (j / width * width))];
            };
            while (!covering()) width *= 2;
            map.cells.push_back(*covering());
        }
    return map;
}

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

StabilityMap make_stability_map(const MapOrder& order, int jobs, const MapProgress& progress, std::stop_token stop,
                                MapSoFar* so_far) {
    if (jobs < 1) throw Refused("--jobs", jobs, "", "a whole number from 1 on");
    check_order(order);
    StabilityMap map{.order = order, .probe = {}, .cells = {}};
    {
        const auto lesson = order.lesson->make();
        const Probe* probe = watched(*lesson, order.probe);
        map.probe = probe ? probe->name : "";
    }
    map.cells.resize(order.across.values.size() * order.up.values.size());
    Work work(map, progress, stop, so_far);
    const auto most = static_cast<int>(std::min<std::size_t>(map.cells.size(), 256));
    parallel_jobs(std::min(jobs, most), [&work](int) { work.take_part(); });
    map.complete = work.finish();
    if (!map.complete) map.cells.clear();
    return map;
}

}  // namespace pliant
