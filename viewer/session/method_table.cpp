#include "session/method_table.h"

#include <pliant/document/summary.h>
#include <pliant/lesson/setting_words.h>
#include <pliant/text/format.h>

#include "session/session.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stop_token>
#include <utility>

namespace pliant::viewer {
namespace {

Runner::Assignments without(Runner::Assignments settings, const std::string& key) {
    std::erase_if(settings, [&](const auto& a) { return a.first == key; });
    return settings;
}

}  // namespace

void MethodTable::follow(const Session& session) {
    std::erase_if(cancelled_, [](const auto& job) { return job->work->done(); });
    if (std::exchange(lesson_, session.entry().info.id) != session.entry().info.id) {
        cancel();
        result_.reset();
        trouble_.clear();
        over.clear();
    }
    const auto choices = comparable_choices(session.lesson());
    const auto here = [&](const Parameter* p) { return p->info.key == over; };
    if (std::ranges::none_of(choices, here)) over = choices.empty() ? "" : std::string(choices.front()->info.key);
    if (under_way_) {
        const std::scoped_lock lock(under_way_->telling);
        if (under_way_->seconds)
            measured_ = Measured{under_way_->scene, under_way_->over, under_way_->steps, *under_way_->seconds};
    }
    if (!under_way_ || !under_way_->work->done()) return;
    const auto job = std::move(under_way_);
    take([&] { return job->work->take(); }, *job);
}

std::unique_ptr<MethodTable::Job> MethodTable::job_of(const Session& session) const {
    const Runner& r = session.runner();
    const SceneFile now = session.scene_file();
    const Until demo = Until::after_steps(session.entry().info.demo_steps);
    const Until until = r.is_static() ? Until::at_rest() : r.place().step > 0 ? Until::after_time(r.time()) : demo;
    return std::make_unique<Job>(SceneFile{.lesson = now.lesson, .parameters = now.parameters, .events = now.events}, over,
                                 until);
}

// 0 of one that ends by itself.
Index MethodTable::steps_of(const Session& session) const {
    const Runner& r = session.runner();
    if (r.is_static()) return 0;
    return r.place().step > 0 ? r.place().step : session.entry().info.demo_steps;
}

std::optional<Real> MethodTable::measured_seconds(const Session& session) const {
    if (!measured_ || measured_->over != over || measured_->steps != steps_of(session)) return std::nullopt;
    const bool same = without(measured_->scene.parameters, over) == without(session.scene_file().parameters, over);
    return same ? std::optional(measured_->seconds) : std::nullopt;
}

std::shared_ptr<const MethodComparison> MethodTable::so_far() const {
    if (!under_way_) return nullptr;
    const std::scoped_lock lock(under_way_->telling);
    return under_way_->so_far;
}

MethodTable::Work MethodTable::work(const Session& session) const {
    if (over.empty()) return {};
    const Parameter& choice = session.lesson().parameter(under_way_ ? under_way_->over : over);
    Work work{.runs = static_cast<Index>(choice.info.options.size())};
    if (under_way_) {
        const std::scoped_lock lock(under_way_->telling);
        return {work.runs, under_way_->steps, under_way_->seconds};
    }
    work.steps = steps_of(session);
    work.seconds = measured_seconds(session);
    if (work.steps > 0) return work;
    // One that is solved runs to its end, as this one has.
    const Index done = session.runner().place().step;
    if (const auto step_ms = session.costs().step_ms(); step_ms && done > 0)
        work.seconds = static_cast<Real>(work.runs * done) * *step_ms / 1000;
    return work;
}

void MethodTable::take(const std::function<std::optional<MethodComparison>()>& made, const Job& job) {
    trouble_.clear();
    try {
        auto all = made();
        if (!all) return;  // it would take long
        result_ = std::move(all);
        settings_ = without(job.scene.parameters, result_->parameter);
    } catch (const Cancelled&) {
        // The table that there was stays.
    } catch (const std::exception& e) {
        trouble_ = e.what();
    }
}

void MethodTable::start(const Session& session, bool asks) {
    cancel();
    trouble_.clear();
    auto job = job_of(session);
    job->watch.tell("methods", 0, 0);
    job->steps = steps_of(session);
    const auto known = measured_seconds(session);
    job->work.emplace([&j = *job, asks, known](const std::stop_token& stop) -> std::optional<MethodComparison> {
        const Watched watched(j.watch);
        const std::stop_callback on_stop(stop, [&j] { j.watch.cancel(); });
        const auto seconds = known ? known : seconds_to_compare(j.scene, j.over, j.until);
        {
            const std::scoped_lock lock(j.telling);
            j.seconds = seconds;
        }
        if (asks && Work{.seconds = seconds}.long_one()) return std::nullopt;
        return compare_methods(j.scene, j.over, j.until, [&j](const MethodComparison& runs) {
            const std::scoped_lock lock(j.telling);
            j.so_far = std::make_shared<const MethodComparison>(runs);
        });
    });
    under_way_ = std::move(job);
}

void MethodTable::make_now(const Session& session) {
    cancel();
    const auto job = job_of(session);
    take([&] { return compare_methods(job->scene, job->over, job->until); }, *job);
}

void MethodTable::cancel() {
    if (!under_way_) return;
    under_way_->work->ask_to_stop();
    cancelled_.push_back(std::move(under_way_));
}

bool MethodTable::outdated(const Session& session) const {
    return result_ && settings_ != without(session.scene_file().parameters, result_->parameter);
}

void open_method_beside(Session& session, const MethodComparison& comparison, std::size_t row) {
    const MethodRun& run = comparison.runs.at(row);
    const Parameter& p = session.lesson().parameter(comparison.parameter);
    compare_what_if(session, p, {run.label, run.option});
}

// ------------------------------------------------------------------------------------------------------------- what if

std::vector<WhatIf> what_if(const Session& session, const Parameter& p) {
    const Real now = session.runner().wanted(p);
    std::vector<WhatIf> all;
    const auto offer = [&](std::string_view how, Real value) {
        if (value == now || !p.accepted().contains(value)) return;
        all.push_back({fmt::format("{}: {}", how, format_quantity(value, p.info.unit)), p.text(value)});
    };
    switch (p.info.kind) {
        case Kind::number:
            offer("half", now / 2), offer("twice", 2 * now);
            break;
        case Kind::whole:
            offer("half", std::round(now / 2)), offer("twice", 2 * now);
            break;
        case Kind::toggle:
            all.push_back({now != 0 ? "off" : "on", p.text(1 - now)});
            break;
        case Kind::choice:
            for (std::size_t k = 0; k < p.info.options.size(); ++k)
                if (static_cast<Real>(k) != now)
                    all.push_back({std::string(p.info.options[k].label), std::string(p.info.options[k].key)});
            break;
        case Kind::file:
            break;
    }
    return all;
}

void compare_what_if(Session& session, const Parameter& p, const WhatIf& what) {
    session.later([&session, key = std::string(p.info.key), text = what.text] { session.beside_to_now({{key, text}}); });
}

namespace {

std::optional<Real> value_beside(const Runner& r, std::string_view name) {
    try {
        const auto v = r.value(r.lesson().probe(name));
        return v && std::isfinite(*v) ? v : std::nullopt;
    } catch (const Error&) {
        return std::nullopt;
    }
}

std::string change_words(const Probe& p, Real a, Real b) {
    const std::string name = spoken(p.name);
    if (a == b) return fmt::format("{} is the same", name);
    const std::string from_to =
        fmt::format("{} goes from {} to {}", name, format_quantity(a, p.unit, 3), format_quantity(b, p.unit, 3));
    if (a == 0 || (a < 0) != (b < 0)) return from_to;
    const Real ratio = b / a;
    if (ratio >= 2 || ratio <= 0.5) return fmt::format("{}, {} times as much", from_to, format_quantity(ratio, "", 2));
    return fmt::format("{}, {} % {}", from_to, format_quantity(100 * std::abs(ratio - 1), "", 3), ratio > 1 ? "more" : "less");
}

}  // namespace

std::string what_if_words(const Session& s) {
    if (!s.companion()) return "";
    const auto different = differing(s.runner(), s.companion()->runner());
    if (different.size() != 1 || !s.companion()->caught_up(s.runner())) return "";
    const Parameter& p = *different.front().parameter;
    if (!s.companion()->stopped().empty())
        return fmt::format("With another {} the run stops: {}", spoken(p.info.key), s.companion()->stopped());
    std::vector<std::string> changes;
    for (const Probe* probe : key_probes(s.lesson())) {
        const auto a = value_beside(s.runner(), probe->name), b = value_beside(s.companion()->runner(), probe->name);
        if (a && b) changes.push_back(change_words(*probe, *a, *b));
    }
    if (changes.empty()) return "";
    const auto value = [&](Real v) {
        return p.info.kind == Kind::choice   ? std::string(p.info.options[static_cast<std::size_t>(v)].label)
               : p.info.kind == Kind::toggle ? std::string(v != 0 ? "on" : "off")
               : p.info.kind == Kind::file   ? value_words(p, v)
                                             : format_quantity(v, p.info.unit);
    };
    return fmt::format("With {} {} in place of {}: {}.", spoken(p.info.key), value(different.front().b),
                       value(different.front().a), fmt::join(changes, "; "));
}

}  // namespace pliant::viewer
