#include "session/atlas.h"

#include <pliant/math/parallel.h>

#include "session/session.h"

#include <algorithm>
#include <utility>

namespace pliant::viewer {
namespace {

bool is_knob(const MapOrder& order, std::string_view key) { return order.across.key == key || order.up.key == key; }

// One core is left to the lab.
int jobs_beside_lab() { return std::max(1, most_threads() - 1); }

Knob knob_with(const Parameter& p, const std::optional<Atlas::Span>& span, Index cells) {
    if (!span) return useful_knob(p, cells);
    return knob_of(p, span->range.min, span->range.max, cells, span->log ? Spacing::log : Spacing::linear);
}

// What a map assigns to a parameter beside its knobs.
Real value_in(const MapOrder& order, const Parameter& p) {
    for (const auto& [key, text] : order.settings)
        if (key == p.info.key) return p.parse(text);
    return p.info.initial;
}

}  // namespace

void Atlas::follow(const Session& session) {
    std::erase_if(cancelled_, [](const auto& job) { return job->work->done(); });
    if (std::exchange(lesson_, session.entry().info.id) != session.entry().info.id) {
        cancel();
        map_.reset(), picture_.reset();
        across = up = trouble_ = "";
        across_span.reset(), up_span.reset();
        try {
            const auto [x, y] = first_knobs(session.lesson());
            across = x->info.key, up = y->info.key;
        } catch (const Refused& e) {
            trouble_ = e.what();
        }
    }
    if (under_way_ && !under_way_->work->done()) take_so_far();
    if (!under_way_ || !under_way_->work->done()) return;
    trouble_.clear();
    try {
        take(under_way_->work->take());
    } catch (const std::exception& e) {
        trouble_ = e.what();
    }
    under_way_.reset();
}

bool Atlas::follows(const Session& session) const { return lesson_ == session.entry().info.id; }

MapOrder Atlas::order_of(const Session& session) const {
    const Lesson& lesson = session.lesson();
    MapOrder order{.lesson = &session.entry(), .steps = steps};
    order.across = knob_with(lesson.parameter(across), across_span, cells);
    order.up = knob_with(lesson.parameter(up), up_span, cells);
    for (const Parameter* p : lesson.parameters)
        if (const Real value = session.runner().wanted(*p); value != p->info.initial && !is_knob(order, p->info.key))
            order.settings.emplace_back(p->info.key, p->text(value));
    check_order(order);
    return order;
}

void Atlas::start(const Session& session) {
    auto job = std::make_unique<Job>(order_of(session));
    cancel();
    trouble_.clear();
    job->watch.tell("map", 0, static_cast<Index>(job->order.across.values.size() * job->order.up.values.size()));
    job->work.emplace([&j = *job](const std::stop_token& stop) {
        const auto tell = [&j](Index done, Index total) { j.watch.tell("map", done, total); };
        return make_stability_map(j.order, jobs_beside_lab(), tell, stop, &j.so_far);
    });
    under_way_ = std::move(job);
}

void Atlas::make_now(const Session& session) {
    cancel();
    trouble_.clear();
    take(make_stability_map(order_of(session), most_threads()));
}

void Atlas::cancel() {
    if (!under_way_) return;
    under_way_->work->ask_to_stop();
    cancelled_.push_back(std::move(under_way_));
}

Watch::Progress Atlas::progress() const { return under_way_ ? under_way_->watch.progress() : Watch::Progress{}; }

// As soon as the coarse cells are there, and then whenever a twentieth more is.
void Atlas::take_so_far() {
    const MapSoFar& so_far = under_way_->so_far;
    const Index done = so_far.done(), total = under_way_->watch.progress().total;
    if (under_way_->shown && done < done_ + total / 20) return;
    auto map = so_far.map(under_way_->order);
    if (!map) return;
    take(std::move(*map));
    under_way_->shown = true;
    done_ = done;
}

void Atlas::take(StabilityMap map) {
    done_ = static_cast<Index>(map.cells.size());
    map_ = std::make_unique<StabilityMap>(std::move(map));
    picture_.emplace(*map_);
    ++made_;
}

bool Atlas::outdated(const Session& session) const {
    if (!map_) return false;
    if (map_->order.lesson != &session.entry()) return true;
    return std::ranges::any_of(session.lesson().parameters, [&](const Parameter* p) {
        return !p->looks() && !is_knob(map_->order, p->info.key) && session.runner().wanted(*p) != value_in(map_->order, *p);
    });
}

std::optional<MapPlace> Atlas::present(const Session& session) const {
    if (!map_ || outdated(session)) return std::nullopt;
    const auto place = [&](const Knob& knob) {
        return knob_place(knob, session.runner().wanted(session.lesson().parameter(knob.key)));
    };
    const auto x = place(map_->order.across), y = place(map_->order.up);
    return x && y ? std::optional(MapPlace{*x, *y}) : std::nullopt;
}

void open_cell(Session& session, const StabilityMap& map, Index i, Index j) {
    std::vector<std::pair<std::string, Real>> values;
    for (const Parameter* p : session.lesson().parameters)
        if (!is_knob(map.order, p->info.key)) values.emplace_back(p->info.key, value_in(map.order, *p));
    values.emplace_back(map.order.across.key, map.order.across.values[static_cast<std::size_t>(i)]);
    values.emplace_back(map.order.up.key, map.order.up.values[static_cast<std::size_t>(j)]);
    session.assign_together(values);
}

}  // namespace pliant::viewer
