// The session and its parameters: sliders, handles and undo.
#include "session/session.h"

#include <pliant/lesson/setting_words.h>
#include <pliant/text/format.h>
#include <pliant/text/spoken.h>
#include <pliant/text/stored_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace pliant::viewer {

bool Session::set(const Values& values) {
    const bool rebuilds = std::ranges::any_of(values, [](const auto& v) { return v.first->info.effect == Effect::rebuild; });
    const bool all_was_done = lesson().at_rest() && !runner_->inside_step();
    const int dimension = lesson().dimension();
    if (!guarded([&] { runner_->assign_values(values); })) return false;
    dismiss();
    if (!rebuilds) {
        // What is recorded of this step is how the step left it.
        if (companion_ && !sliced) companion_->follow(*runner_);
        seen();
        settle(all_was_done);
        return true;
    }
    // The domain may have another size, or the scene another dimension.
    if (lesson().dimension() == 2 || lesson().dimension() != dimension) camera.reset();
    begin_run();
    settle(all_was_done);
    return true;
}

bool Session::refuse_locked(const Parameter& parameter) {
    if (!locked(parameter)) return false;
    std::string name = spoken(parameter.info.key);
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    say(Message::Kind::refused,
        hides(parameter.info.key)
            ? fmt::format("The value of {} is shown after Next: it would give the answer away.", spoken(parameter.info.key))
            : fmt::format("{} is locked on this slide: press L to unlock it, or end the walkthrough.", name));
    return true;
}

void Session::assign(const Parameter& parameter, Real value, bool same_drag) {
    // Of the lesson that is open now.
    if (put_off([this, &parameter, value, same_drag, opened = open_count_] {
            if (opened == open_count_) assign(parameter, value, same_drag);
        }))
        return;
    const bool beside = companion_ && companion_->owns(parameter);
    if (parameter.looks()) {
        if (!refuse_locked(parameter)) look({{std::string(parameter.info.key), value}});
        return;
    }
    const Real before = (beside ? companion_->runner() : *runner_).wanted(parameter);
    if (before == value || refuse_locked(parameter)) return;
    if (!(beside ? set_beside(parameter, value) : set({{&parameter, value}}))) return;
    const bool joins = same_drag && !undo_.empty() && undo_.back().values.size() == 1 &&
                       undo_.back().values[0].first == &parameter && undo_.back().beside == beside;
    if (!joins) undo_.push_back({{{&parameter, before}}, beside});
}

// In both runs, at once, and no part of what can be undone.
void Session::look(const std::vector<std::pair<std::string, Real>>& values) {
    guarded([&] {
        look_at(*runner_, recorder_, values);
        if (companion_) companion_->look(values);
    });
    seen();
}

void Session::enter(const Parameter& parameter, std::string_view text) {
    try {
        const bool beside = companion_ && companion_->owns(parameter);
        const Real now = (beside ? companion_->runner() : *runner_).wanted(parameter);
        assign(parameter, parameter.parse(text, unit_shown(now, parameter.info.unit, value_digits)));
    } catch (const Refused& e) {
        say(Message::Kind::refused, refusal_words(parameter, e.what()));
    }
}

const Parameter* Session::taker_of(const std::string& path) const {
    for (const Parameter* p : addressed().lesson().parameters)
        if (p->info.kind == Kind::file && takes_ending(path, p->info.endings)) return p;
    return nullptr;
}

void Session::choose_file(const Parameter& parameter, const std::string& path) {
    const auto number = static_cast<Real>(store_file(path, parameter.info.endings, Reading::again));
    if (put_off([this, &parameter, path, opened = open_count_] {
            if (opened == open_count_) choose_file(parameter, path);
        }))
        return;
    const bool beside = companion_ && companion_->owns(parameter);
    const Runner& run = beside ? companion_->runner() : *runner_;
    Values before, wanted;
    const auto want = [&](const Parameter& p, Real value) {
        if (run.wanted(p) != value) before.emplace_back(&p, run.wanted(p)), wanted.emplace_back(&p, value);
    };
    want(parameter, number);
    for (const auto& [key, value] : parameter.info.companions)
        want(run.lesson().parameter(key), run.lesson().parameter(key).parse(value));
    for (const auto& w : wanted)
        if (refuse_locked(*w.first)) return;
    if (wanted.empty()) return say(Message::Kind::info, fmt::format("{} is the same as before.", value_words(parameter, number)));
    if (!beside) {
        if (set(wanted)) undo_.push_back({std::move(before), false});
        return;
    }
    for (const auto& [p, value] : wanted) assign(*p, value);
}

bool Session::assign_together(const std::vector<std::pair<std::string, Real>>& values) {
    if (put_off([this, values] { assign_together(values); })) return true;
    Values before, wanted;
    for (const auto& [key, value] : values) {
        const Parameter& p = lesson().parameter(key);
        if (runner_->wanted(p) == value) continue;
        if (refuse_locked(p)) return false;
        before.emplace_back(&p, runner_->wanted(p));
        wanted.emplace_back(&p, value);
    }
    if (!wanted.empty() && !set(wanted)) return false;
    if (!before.empty()) undo_.push_back({std::move(before), false});
    reset();
    return true;
}

void Session::restore_default(const Parameter& parameter) { assign(parameter, parameter.info.initial); }

void Session::restore_defaults() {
    if (put_off([this] { restore_defaults(); })) return;
    Values before, defaults;
    for (const Parameter* p : lesson().parameters) {
        if (runner_->wanted(*p) == p->info.initial) continue;
        before.emplace_back(p, runner_->wanted(*p));
        defaults.emplace_back(p, p->info.initial);
    }
    if (!defaults.empty() && set(defaults)) undo_.push_back({std::move(before), false});
}

void Session::undo() {
    if (put_off([this] { undo(); })) return;
    if (undo_.empty()) return;
    const Undo& last = undo_.back();
    last.beside ? set_beside(*last.values[0].first, last.values[0].second) : set(last.values);
    undo_.pop_back();
}

void Session::pull(const std::optional<Pull>& pulled) {
    if (put_off([this, pulled] { pull(pulled); })) return;
    if (!pulled) moves_handle_ = false;
    if (pulled)
        if (const auto values = lesson().dragged(*pulled); !values.empty()) return move_handle(values);
    hand_ = pulled;
    hand_used_ = true;
    runner_->pull(pulled);
    if (companion_) companion_->pull(pulled, lesson());
}

// The moves of one drag are one step of undo.
void Session::move_handle(const std::vector<std::pair<std::string, Real>>& values) {
    Values before, wanted;
    for (const auto& [key, value] : values) {
        const Parameter& p = lesson().parameter(key);
        if (!p.looks() && refuse_locked(p)) return;
        const Interval span = extreme ? p.accepted() : p.info.useful;
        const Real within = std::clamp(value, span.min, span.max);
        before.emplace_back(&p, runner_->wanted(p));
        wanted.emplace_back(&p, p.info.kind == Kind::number ? within : std::trunc(within));
    }
    if (wanted == before) return;
    if (std::ranges::all_of(wanted, [](const auto& w) { return w.first->looks(); })) {
        std::vector<std::pair<std::string, Real>> looked_at;
        for (const auto& [p, value] : wanted) looked_at.emplace_back(p->info.key, value);
        return look(looked_at);
    }
    const auto kept = camera;  // what is under the pointer stays there
    const bool moved_it = set(wanted);
    camera = kept;
    if (!moved_it) return;
    if (!std::exchange(moves_handle_, true)) undo_.push_back({std::move(before), false});
}

void Session::keep_hand() {
    if (hand_used_) pull(hand_);
}

}  // namespace pliant::viewer
