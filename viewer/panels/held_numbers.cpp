// Key numbers and lights, measured when the run has moved: by the worker, since a stability limit may take long to find.
#include "panels/held_numbers.h"

#include <pliant/document/summary.h>
#include <pliant/math/watch.h>
#include <pliant/run/awaited.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <utility>

namespace pliant::viewer {
namespace {

std::string_view law_text(Law law) {
    return law == Law::constant ? "stays constant" : law == Law::never_grows ? "never grows" : "is zero";
}

// A law that only forbids growth says so: what is lost is no breach of it.
std::string light_name(const Conserved& c, Holds holds) {
    if (c.law != Law::never_grows) return words(c.probe);
    return fmt::format("{} {}", words(c.probe), holds == Holds::no ? "grows" : law_text(c.law));
}

void add_laws(const Runner& runner, std::vector<Light>& lights) {
    for (const std::size_t i : runner.shown_laws()) {
        const Conserved& c = runner.lesson().conserved[i];
        const std::string_view unit = runner.lesson().probe(c.probe).unit;
        const Holds holds = runner.holds(i);
        std::string help = fmt::format("{} {}", words(c.probe), law_text(c.law));
        if (holds == Holds::not_expected)
            help = fmt::format("{}: not expected to hold here", words(c.probe));
        else
            help += fmt::format(": off by {}, tolerance {}", format_quantity(runner.drift(i), unit),
                                format_quantity(runner.tolerance(i), unit));
        lights.push_back({holds, light_name(c, holds), help});
    }
}

// One light for all assumptions that hold, and one by name for each that does not.
void add_assumptions(const Lesson& lesson, std::vector<Light>& lights) {
    std::string holding;
    bool others = false;
    for (const Assumption& a : lesson.assumptions) {
        if (!a.in_use()) continue;
        const Real value = a.value(), limit = a.limit();
        const std::string text = fmt::format("{}: {}\n    {} against the limit {}\n", words(a.name), a.formula,
                                             format_quantity(value, a.unit), format_quantity(limit, a.unit));
        if (value <= limit)
            holding += text;
        else
            others = true, lights.push_back({Holds::no, words(a.otherwise_named.empty() ? a.name : a.otherwise_named),
                                             fmt::format("Assumption {}Beyond it: {}", text, a.broken)});
    }
    if (!holding.empty()) lights.push_back({Holds::yes, others ? "others" : "assumptions", "Assumptions that hold:\n" + holding});
}

// Undefined where it is not finite, which the run itself tells in words.
std::optional<Real> measured(const std::function<std::optional<Real>()>& value) {
    try {
        return value();
    } catch (const Diverged&) {
        return std::nullopt;
    }
}

}  // namespace

void measure_held_numbers(PanelContext& lab) {
    const Session& s = lab.session;
    const Runner& r = s.runner();
    HeldNumbers& held = lab.held;
    const std::pair now{s.open_count(), r.revision()};
    if (held.of == now || s.shows_last_step()) return;
    held.of = now;
    held.lights.clear(), held.key_numbers.clear();
    for (const Probe* p : key_probes(r.lesson())) {
        const Stage* awaited = awaited_stage(r, *p);
        // Where the number is still to come, its exact value is not told either.
        held.key_numbers.push_back({measured([&] { return r.value(*p); }),
                                    measured([&] { return awaited ? std::nullopt : r.exact(*p); }), not_yet(awaited)});
    }
    try {
        add_laws(r, held.lights);
        add_assumptions(s.lesson(), held.lights);
    } catch (const Cancelled&) {
        held.lights.clear();  // none are shown until the run moves on
    } catch (const Diverged&) {
        held.lights.clear();
    }
}

}  // namespace pliant::viewer
