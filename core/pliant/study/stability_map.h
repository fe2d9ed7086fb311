// The stability atlas: a lesson run headless on a grid of two parameters, each cell classed by what its energy does, beside the
// bound that theory gives.
#pragma once
#include <pliant/document/unused.h>
#include <pliant/run/runner.h>
#include <pliant/study/map_knobs.h>
#include <pliant/study/stability_verdict.h>

#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace pliant {

// A run whose energy still rises, but which has not come round once, goes on to at most so many times the steps asked for.
inline constexpr Index most_extension = 16;
inline constexpr Index least_map_steps = 16;

struct MapOrder {
    const LessonEntry* lesson = nullptr;
    Runner::Assignments settings{};  // of the parameters that are not knobs; the others have their initial values
    Knob across{}, up{};
    Index steps = 200;           // of each cell, at least
    std::optional<Real> time{};  // s; in place of `steps`: to the nearest whole step, and least_map_steps at least
    std::string probe{};         // to watch; "": "energy", or "kinetic_energy", or none
};

struct MapCell {
    StabilityVerdict verdict{};
    Index steps = 0, passes = 0;  // done; passes count the work
    // Δt over the largest stable one by theory: 0 where every Δt is stable, infinite where none is. Empty without a theory.
    std::optional<Real> theory{};

    bool predicted_stable() const { return theory && *theory <= 1; }
};

struct StabilityMap {
    MapOrder order;
    std::string probe;           // that was watched; "" for none
    std::vector<MapCell> cells;  // row by row: that of column i and row j at i + columns() * j, row 0 has the first value of `up`
    bool complete = false;       // false when it was cancelled: `cells` is then empty

    Index columns() const { return static_cast<Index>(order.across.values.size()); }
    Index rows() const { return static_cast<Index>(order.up.values.size()); }
    const MapCell& at(Index i, Index j) const { return cells[static_cast<std::size_t>(i + columns() * j)]; }
    Index count(Stability kind) const;
};

// What a cell assigns: the settings and the two values.
Runner::Assignments cell_assignments(const MapOrder& order, const Lesson& lesson, Index i, Index j);

// Refuses what no cell could run: settings that the lesson does not accept, the same knob twice, a knob that is also set, a
// static lesson, too few steps, a probe that there is none of. Throws Refused.
void check_order(const MapOrder& order);

// What the order sets, and the knobs, that no cell uses.
std::vector<UnusedSetting> unused_settings(const MapOrder& order);

// Called after each cell, one call at a time, in any of the threads.
using MapProgress = std::function<void(Index done, Index total)>;

// The cells of a map while it is made, in any thread.
class MapSoFar {
public:
    // Row by row.
    void begin(Index columns, Index rows);
    void add(Index i, Index j, const MapCell& cell);
    Index done() const;
    // A map of these cells, in which one that is not there yet has what the next coarser one has; empty until the coarsest are
    // all there. It is not complete.
    std::optional<StabilityMap> map(const MapOrder& order) const;

private:
    mutable std::mutex mutex_;
    Index columns_ = 0, rows_ = 0, done_ = 0, coarsest_ = 1, coarse_left_ = 0;
    std::vector<std::optional<MapCell>> cells_;
};

// Runs every cell, at most `jobs` at a time, each of which has a Runner of its own, some far apart first, and those between
// them behind. The result is the same to the bit for any number of jobs. A stop that is asked for ends it after the
// steps that are being made. so_far: gets each cell when it is done, if given. Throws as check_order does.
StabilityMap make_stability_map(const MapOrder& order, int jobs, const MapProgress& progress = {}, std::stop_token stop = {},
                                MapSoFar* so_far = nullptr);

}  // namespace pliant
