#include "session/companion.h"

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

constexpr Real rounding = 1e-9;  // of a step

Runner::Assignments assignments_of(const Runner& a, const Runner::Assignments& changes) {
    Runner::Assignments all;
    for (const Parameter* p : a.lesson().parameters) all.emplace_back(std::string(p->info.key), p->text(a.wanted(*p)));
    all.insert(all.end(), changes.begin(), changes.end());
    return all;
}

Index rows_to_pull(const Lesson& lesson) {
    const auto on = lesson.can_pull();
    for (const Field& f : lesson.fields)
        if (on && f.on == *on && f.in_use()) return f.size();
    return 0;
}

}  // namespace

Companion::Companion(const LessonEntry& entry, const Runner& a, const Runner::Assignments& changes)
    : runner_(entry, assignments_of(a, changes)) {
    runner_.set_events(a.events());
    moved();
}

bool Companion::owns(const Parameter& parameter) const {
    return std::ranges::find(lesson().parameters, &parameter) != lesson().parameters.end();
}

void Companion::assign(const Parameter& parameter, Real value) {
    runner_.assign_values({{&parameter, value}});
    stopped_.clear();
}

void Companion::look(const std::vector<std::pair<std::string, Real>>& values) { look_at(runner_, recorder_, values); }

void Companion::follow_script(std::vector<Event> events) {
    runner_.set_events(std::move(events));
    restart();
}

void Companion::apply(const SceneChanges& changes) { apply_to(runner_, changes); }

void Companion::pull(const std::optional<Pull>& pull, const Lesson& of_a) {
    if (!pull || rows_to_pull(of_a) == rows_to_pull(lesson())) runner_.pull(pull);
}

void Companion::restart() {
    stopped_.clear();
    recorder_.clear();
    costs_.clear();
    tried([&] { runner_.reset(); });
    moved();
}

bool Companion::tried(const std::function<void()>& action) {
    try {
        action();
        return true;
    } catch (const Error& e) {
        stopped_ = e.what();
        return false;
    }
}

void Companion::moved() {
    tried([&] { recorder_.record(runner_); });
    costs_.record(runner_);
}

bool Companion::ahead(const Runner& a) const {
    if (runner_.is_static()) return runner_.place().step > a.place().step;
    return runner_.time() > a.time() + rounding * runner_.time_step();
}

bool Companion::behind(const Runner& a) const {
    if (runner_.inside_step()) return true;
    if (runner_.is_static()) return runner_.place().step < a.place().step && !lesson().at_rest();
    return runner_.time() + (1 - rounding) * runner_.time_step() <= a.time();
}

bool Companion::far_behind(const Runner& a) const {
    if (runner_.is_static()) return behind(a);
    return runner_.time() + 2 * (runner_.time_step() + a.time_step()) <= a.time();
}

void Companion::go_back(const Runner& a) {
    const Index here = runner_.place().step;
    const Real steps = runner_.is_static() ? static_cast<Real>(here - a.place().step)
                                           : std::ceil((runner_.time() - a.time()) / runner_.time_step() - rounding);
    const Index back = std::clamp(static_cast<Index>(steps), Index{1}, here);
    bool found = false;
    if (!tried([&] { found = runner_.go_to({here - back, 0}); })) return;
    // What is no longer stored is run again from the start, with the present parameters.
    found ? moved() : restart();
}

bool Companion::caught_up(const Runner& a) const { return !ahead(a) && (!stopped_.empty() || !behind(a)); }

bool Companion::follow_a_pass(const Runner& a) {
    if (ahead(a)) {
        stopped_.clear();
        go_back(a);
    } else if (tried([&] { runner_.step_pass(); }) && !runner_.inside_step()) {
        moved();
    }
    return stopped_.empty();
}

void Companion::follow(const Runner& a) {
    while (!caught_up(a) && follow_a_pass(a)) continue;
}

void look_at(Runner& runner, Recorder& recorder, const std::vector<std::pair<std::string, Real>>& values) {
    const Recorder::Readings before = Recorder::readings(runner);
    Runner::Values parameters;
    for (const auto& [key, value] : values) parameters.emplace_back(&runner.lesson().parameter(key), value);
    runner.assign_values(parameters);
    recorder.look_again(runner, before);
}

std::vector<Differing> differing(const Runner& a, const Runner& b) {
    std::vector<Differing> all;
    for (std::size_t i = 0; i < a.lesson().parameters.size(); ++i) {
        const Parameter &of_a = *a.lesson().parameters[i], &of_b = *b.lesson().parameters[i];
        if (a.wanted(of_a) != b.wanted(of_b)) all.push_back({&of_a, a.wanted(of_a), b.wanted(of_b)});
    }
    return all;
}

std::vector<Real> settings_of(const Runner& runner) {
    std::vector<Real> values;
    for (const Parameter* p : runner.lesson().parameters) values.push_back(runner.wanted(*p));
    return values;
}

}  // namespace pliant::viewer
