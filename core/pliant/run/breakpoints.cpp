#include <pliant/run/breakpoints.h>
#include <pliant/text/format.h>
#include <pliant/text/quantity_text.h>
#include <pliant/text/spoken.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant {

bool Condition::holds(Real value) const {
    if (comparison == "<") return value < limit;
    if (comparison == "<=") return value <= limit;
    if (comparison == ">") return value > limit;
    return value >= limit;
}

std::string Condition::text() const { return fmt::format("{} {} {}", probe, comparison, format_exact(limit)); }

Condition parse_condition(std::string_view text, const Lesson& lesson) {
    const auto refuse = [&] {
        return Refused(
            fmt::format("the condition '{}' is not understood: write a probe, <, <=, > or >=, and a number, such as "
                        "'{} > 1e-3'",
                        text, lesson.probes.empty() ? "energy" : lesson.probes.front().name));
    };
    const std::size_t at = text.find_first_of("<>");
    if (at == std::string_view::npos) throw refuse();
    const auto trimmed = [](std::string_view s) {
        while (!s.empty() && s.front() == ' ') s.remove_prefix(1);
        while (!s.empty() && s.back() == ' ') s.remove_suffix(1);
        return s;
    };
    const std::size_t length = at + 1 < text.size() && text[at + 1] == '=' ? 2 : 1;
    Condition c{std::string(trimmed(text.substr(0, at))), std::string(text.substr(at, length)), 0};
    if (c.probe.empty()) throw refuse();
    const QuantityText limit = read_quantity(text.substr(at + length), lesson.probe(c.probe).unit);
    if (limit.problem != QuantityText::Problem::none || !std::isfinite(limit.value)) throw refuse();
    c.limit = limit.value;
    return c;
}

Breakpoints::Watch Breakpoints::look(const Runner& runner, bool whole_step) const {
    const Lesson& lesson = runner.lesson();
    Watch now = last_;
    now.conditions.clear();
    for (const Condition& c : conditions) {
        const auto value = lesson.probe(c.probe).value();
        now.conditions.push_back(value && c.holds(*value));
    }
    if (!whole_step) return now;
    now.assumptions.clear(), now.laws.clear();
    for (const Assumption& a : lesson.assumptions) now.assumptions.push_back(a.in_use() && !(a.value() <= a.limit()));
    for (std::size_t i = 0; i < lesson.conserved.size(); ++i) now.laws.push_back(runner.holds(i) == Holds::no);
    return now;
}

void Breakpoints::arm(const Runner& runner) { last_ = look(runner, true); }

namespace {
// The first that is set now and was not before.
int first_new(const std::vector<char>& now, const std::vector<char>& before) {
    for (std::size_t k = 0; k < now.size(); ++k)
        if (now[k] && !(k < before.size() && before[k])) return static_cast<int>(k);
    return -1;
}
}  // namespace

std::string Breakpoints::words_of(const Runner& runner, const Watch& now) {
    const Lesson& lesson = runner.lesson();
    if (const int k = first_new(now.conditions, last_.conditions); k >= 0) {
        const Condition& c = conditions[static_cast<std::size_t>(k)];
        const Probe& probe = lesson.probe(c.probe);
        return fmt::format("{} {} {}{}{}: it is {} now", spoken(probe.name), c.comparison, format_exact(c.limit),
                           probe.unit.empty() ? "" : " ", probe.unit, format_quantity(probe.value().value_or(0), probe.unit));
    }
    if (const int k = first_new(now.assumptions, last_.assumptions); k >= 0 && assumptions) {
        const Assumption& a = lesson.assumptions[static_cast<std::size_t>(k)];
        failed_assumption_ = static_cast<std::size_t>(k);
        return fmt::format("the assumption “{}” fails: {} is beyond {}. {}", spoken(a.name), format_quantity(a.value(), a.unit),
                           format_quantity(a.limit(), a.unit), a.broken);
    }
    if (const int k = first_new(now.laws, last_.laws); k >= 0 && laws) {
        const Conserved& c = lesson.conserved[static_cast<std::size_t>(k)];
        const std::string_view unit = lesson.probe(c.probe).unit;
        return fmt::format("{} is off by {}, and {} is tolerated", spoken(c.probe),
                           format_quantity(runner.drift(static_cast<std::size_t>(k)), unit),
                           format_quantity(runner.tolerance(static_cast<std::size_t>(k)), unit));
    }
    return "";
}

std::optional<std::string> Breakpoints::stops(const Runner& runner) {
    const bool whole_step = !runner.inside_step();
    std::string reason;
    failed_assumption_.reset();
    if (runner.passes_in_stage() == 0) {
        const Watch now = look(runner, whole_step);
        reason = words_of(runner, now);
        last_ = now;
    }
    if (!reason.empty()) return reason;
    const auto& running = runner.stages();
    if (running.empty()) return std::nullopt;
    if (const auto last = runner.last_stage(); last && passes.contains(running[*last]->name)) {
        const Index done = runner.passes_in_stage();
        return done ? fmt::format("pass {} of {}", done, spoken(running[*last]->name))
                    : fmt::format("the last pass of {}", spoken(running[*last]->name));
    }
    const Stage& next = *running[whole_step ? 0 : runner.next_stage()];
    if (runner.passes_in_stage() == 0 && stages.contains(next.name)) return fmt::format("before {}", spoken(next.name));
    return std::nullopt;
}

}  // namespace pliant
