// The stability map that the lab makes beside the run: two knobs of the open lesson, made in threads of their own. It draws
// nothing.
#pragma once
#include <pliant/math/background.h>
#include <pliant/math/watch.h>
#include <pliant/study/stability_map.h>

#include "plot/map_plot.h"

#include <list>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace pliant::viewer {

class Session;

class Atlas {
public:
    Atlas() = default;
    Atlas(const Atlas&) = delete;
    Atlas& operator=(const Atlas&) = delete;
    // What is being made is cancelled, which takes a step of the lesson at most.
    ~Atlas() = default;

    // --- what is asked for ---
    static constexpr Index first_cells = 24, first_steps = 200;
    std::string across{}, up{};  // keys of the knobs
    Index cells = first_cells;   // along each knob, at most
    Index steps = first_steps;
    // What a person has set of a knob in place of what its slider spans. Belongs to the key: another knob has none.
    struct Span {
        Interval range{};
        bool log = false;
        bool operator==(const Span&) const = default;
    };
    std::optional<Span> across_span{}, up_span{};

    // The knobs of the lesson that is open; another lesson cancels what is being made and forgets the map. Call in every frame.
    void follow(const Session& session);
    // Are the knobs those of the lesson that is open?
    bool follows(const Session& session) const;

    // Of the parameters as they are. Throws Refused, and then nothing has changed.
    void start(const Session& session);
    void make_now(const Session& session);  // in this thread
    // A map of the open lesson that was made before.
    void show(StabilityMap map) { cancel(), take(std::move(map)); }
    // What would be made: without cells. Throws as start does.
    StabilityMap unmade(const Session& session) const { return {.order = order_of(session), .probe = {}, .cells = {}}; }
    void cancel();
    bool busy() const { return under_way_ != nullptr; }
    Watch::Progress progress() const;  // in cells

    // --- what came out ---
    // While it is made what there is of it so far: coarse at first, and then finer; it is not complete.
    const StabilityMap* map() const { return map_.get(); }
    Index cells_done() const { return done_; }               // of the map that is shown
    long made() const { return made_; }                      // how many maps there were, whole ones and what there was so far
    const MapPicture& picture() const { return *picture_; }  // only with a map
    // The present scene on the map; empty when it lies outside, or has other parameters beside the knobs.
    std::optional<MapPlace> present(const Session& session) const;
    // Has anything beside the knobs changed since the map was made, or the lesson?
    bool outdated(const Session& session) const;
    const std::string& trouble() const { return trouble_; }  // why there is no map; "" when nothing went wrong

private:
    struct Job {
        explicit Job(MapOrder wanted) : order(std::move(wanted)) {}
        MapOrder order;
        Watch watch;
        MapSoFar so_far;
        bool shown = false;                              // of it
        std::optional<Background<StabilityMap>> work{};  // last: it is waited for before the others go
    };
    MapOrder order_of(const Session& session) const;
    void take(StabilityMap map);
    void take_so_far();

    std::string_view lesson_{};
    std::unique_ptr<StabilityMap> map_;  // where the picture looks for it
    std::optional<MapPicture> picture_;
    std::string trouble_;
    Index done_ = 0;
    long made_ = 0;
    std::unique_ptr<Job> under_way_;
    std::list<std::unique_ptr<Job>> cancelled_;  // until their threads are done
};

// The scene of a cell in the lab: its parameters in one step of undo, from the start.
void open_cell(Session& session, const StabilityMap& map, Index i, Index j);

}  // namespace pliant::viewer
