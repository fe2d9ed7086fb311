#include "session/inspector.h"

#include "session/drawn_run.h"

#include <pliant/run/revisit.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::viewer {

std::string_view name_of(Compare compare) {
    switch (compare) {
        case Compare::now:
            return "now";
        case Compare::before:
            return "before";
        case Compare::difference:
            return "difference";
        case Compare::side_by_side:
            return "side by side";
        case Compare::swipe:
            return "swipe";
    }
    return "";
}

// -------------------------------------------------------------------------------------------------- before and after

const Stage* Inspector::shown_stage(const Runner& runner) const {
    const auto& running = runner.stages();
    const auto named = std::ranges::find_if(running, [&](const Stage* s) { return s->name == stage; });
    if (named != running.end()) return *named;
    const auto last = runner.last_stage();
    return last && *last < running.size() ? running[*last] : nullptr;
}

void Inspector::renew_trace(Runner& runner) {
    const When now = now_of(runner);
    const auto& done = runner.inside_step() ? runner.executed() : runner.executed_before();
    if (!trace.empty() && trace.step() == now.step && trace.stages() == done.size()) return;
    trace.clear();
    if (now.passes == 0) return;
    Revisit revisit(runner);
    if (!revisit.start_of(now.step)) return;
    for (Index p = 0; p < now.passes; ++p) revisit.pass();
    trace = revisit.trace();
}

std::span<const Real> Inspector::before(const Runner& runner, std::string_view field) const {
    const Stage* shown = shown_stage(runner);
    return shown ? trace.before(runner.lesson(), *shown, field) : std::span<const Real>();
}

namespace {
Real length(std::span<const Real> row) {
    Real sum = 0;
    for (const Real x : row) sum += x * x;
    return std::sqrt(sum);
}
}  // namespace

std::optional<std::vector<Real>> Inspector::change(const Runner& runner, const Field& field, int component) const {
    const Stage* shown = shown_stage(runner);
    if (!shown) return std::nullopt;
    const auto found = trace.before(runner.lesson(), *shown, field.name);
    auto left = trace.after(runner.lesson(), *shown, field.name);
    const bool runs_now = runner.inside_step() && runner.passes_in_stage() > 0 && runner.stages()[runner.next_stage()] == shown;
    if (left.empty() || runs_now) left = field.view();
    if (found.size() != left.size() || found.empty()) return std::nullopt;
    const auto width = static_cast<std::size_t>(field.components);
    std::vector<Real> difference(left.size()), rows(left.size() / width);
    for (std::size_t k = 0; k < left.size(); ++k) difference[k] = left[k] - found[k];
    for (std::size_t r = 0; r < rows.size(); ++r) {
        if (component >= 0 || width == 1)
            rows[r] = difference[r * width + static_cast<std::size_t>(std::max(component, 0))];
        else
            rows[r] = length(std::span<const Real>(difference).subspan(r * width, width));
    }
    return rows;
}

bool Inspector::draw_before(Runner& runner, Scene& picture) const {
    const Stage* shown = shown_stage(runner);
    const When now = now_of(runner);
    if (!shown || now.passes == 0) return false;
    // The passes that had run when the stage began last.
    Index begin = runner.inside_step() && runner.passes_in_stage() > 0 && runner.stages()[runner.next_stage()] == shown
                      ? now.passes - runner.passes_in_stage()
                      : -1;
    for (const Execution& e : runner.inside_step() ? runner.executed() : runner.executed_before())
        if (e.stage == shown && (begin < 0 || e.begin < begin)) begin = std::max(begin, e.begin);
    if (begin < 0) return false;
    Revisit revisit(runner);
    if (!revisit.start_of(now.step)) return false;
    for (Index p = 0; p < begin; ++p) revisit.pass();
    draw_run(runner, picture);
    return true;
}

// ------------------------------------------------------------------------------------------------- things and pins

bool Inspector::pinned(std::string_view field, Index index, int component) const {
    return std::ranges::any_of(pins,
                               [&](const Pin& p) { return p.field == field && p.index == index && p.component == component; });
}

void Inspector::pin(const Runner& runner, const Field& field, Index index, int component) {
    if (pinned(field.name, index, component)) return;
    const std::string part =
        component >= 0 && field.rank != Rank::scalar ? "." + component_names(field)[static_cast<std::size_t>(component)] : "";
    pins.push_back({.field = std::string(field.name),
                    .index = index,
                    .component = component,
                    .title = fmt::format("{}{} of {} {}", field.name, part, name_of(field.on), index),
                    .unit = std::string(field.unit),
                    .from = runner.place().step + (runner.inside_step() ? 1 : 0)});
    record(runner);
}

void Inspector::record(const Runner& runner) {
    if (runner.inside_step() || runner.place() != runner.reach()) return;
    for (Pin& p : pins) {
        const Field* field = runner.lesson().find_field(p.field);
        const bool there = field && field->in_use() && p.index < field->size();
        const Index step = runner.place().step;
        p.series.add(step, runner.is_static() ? static_cast<Real>(step) : runner.time(),
                     there ? row_value(*field, p.index, p.component) : TimeSeries::undefined);
    }
}

std::string Inspector::pins_csv(bool has_clock) const {
    std::string text = "step,time [s]";
    std::vector<const TimeSeries*> all;
    for (const Pin& p : pins) {
        text += "," + csv_column(p.title, p.unit);
        all.push_back(&p.series);
    }
    return text + "\n" + csv_rows(all, has_clock);
}

std::string Inspector::thing_csv(const Lesson& lesson) const {
    std::string text = "quantity,component,value,unit\n";
    if (!thing) return text;
    for (const Field& f : lesson.fields) {
        if (!f.in_use() || f.on != thing->on || thing->index >= f.size()) continue;
        const auto names = component_names(f);
        for (int c = 0; c < f.components; ++c)
            text += fmt::format("{},{},{},{}\n", f.name, names[static_cast<std::size_t>(c)],
                                format_exact(row_value(f, thing->index, c)), f.unit);
    }
    return text;
}

// --------------------------------------------------------------------------------------------------------------- why

void Inspector::answer_last(Runner& runner) {
    const Asked& q = asked.back();
    answer = why(runner, q.field, q.index, q.component, 1, q.when);
    asked.back().title = title_of(*answer, runner.lesson());
}

void Inspector::ask(Runner& runner, Asked question) {
    asked.push_back(std::move(question));
    try {
        answer_last(runner);
    } catch (...) {
        asked.pop_back();
        throw;
    }
}

void Inspector::ask_back(Runner& runner) {
    if (!asked.empty()) asked.pop_back();
    answer.reset();
    if (!asked.empty()) answer_last(runner);
}

void Inspector::ask_again(Runner& runner) {
    if (asked.empty()) return;
    asked.erase(asked.begin() + 1, asked.end());
    asked.back().when.reset();
    answer_last(runner);
}

void Inspector::forget_run() {
    stopped.clear();
    trace.clear();
    asked.clear();
    answer.reset();
    for (Pin& p : pins) p.series.clear(), p.from = 0;
}

void Inspector::forget_lesson() { *this = {}; }

}  // namespace pliant::viewer
