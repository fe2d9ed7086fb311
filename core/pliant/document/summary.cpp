#include <pliant/document/summary.h>
#include <pliant/lesson/setting_words.h>
#include <pliant/run/awaited.h>
#include <pliant/text/format.h>
#include <pliant/text/spoken.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

std::string place_sentence(const Runner& r) {
    if (r.is_static())
        return fmt::format("Static: {} {} done.\n", r.place().step, r.place().step == 1 ? "solve is" : "solves are");
    return fmt::format("S{}, time {}, time step {}.\n", place_words(r.place()).substr(1), format_quantity(r.time(), "s"),
                       format_quantity(r.time_step(), "s"));
}

// What was set inside a step and waits for the next one.
std::string waiting_sentences(const Runner& r) {
    std::string text;
    for (const Parameter* p : r.lesson().parameters)
        if (r.waits(*p))
            text += fmt::format("The {} is {} until the next step begins, and {} from there on.\n", spoken(p->info.key),
                                value_words(*p, p->value()), value_words(*p, r.wanted(*p)));
    return text;
}

std::string stage_sentence(const Runner& r) {
    const auto& stages = r.stages();
    if (stages.empty()) return "";
    const auto last = r.last_stage();
    std::string text = last && *last < stages.size() ? fmt::format("The stage {} has just run", spoken(stages[*last]->name))
                                                     : std::string("No stage has run yet");
    if (r.passes_in_stage() > 0) text += fmt::format(", {} so far", counted(r.passes_in_stage(), "pass"));
    return text + fmt::format("; {} is next.\n", spoken(stages[r.inside_step() ? r.next_stage() : 0]->name));
}

// A probe that is not finite is told as undefined: the summary is asked for when something went wrong, too.
std::optional<Real> finite(const std::function<std::optional<Real>()>& value) {
    const auto v = value();
    return v && std::isfinite(*v) ? v : std::nullopt;
}

std::string number_sentence(const Runner& r, const Probe& p, bool theory) {
    const auto value = finite(p.value);
    const std::string name = spoken(p.name);
    if (!value) return fmt::format("{} {} undefined.\n", name, is_or_are(name));
    std::string text = fmt::format("{} {} {}", name, is_or_are(name), format_quantity(*value, p.unit, 6));
    const auto exact = theory && p.exact && !awaited_stage(r, p) ? finite([&] { return p.exact(r.time()); }) : std::nullopt;
    if (exact)
        text += fmt::format("; exact {}, off by {}", format_quantity(*exact, p.unit, 6),
                            format_quantity(std::abs(*value - *exact), p.unit, 3));
    return text + ".\n";
}

std::string assumption_sentence(const Assumption& a) {
    const Real value = a.value(), limit = a.limit();
    const std::string against =
        fmt::format("{} against the limit {}", format_quantity(value, a.unit, 3), format_quantity(limit, a.unit, 3));
    if (value <= limit) return fmt::format("The assumption {} holds: {}.\n", spoken(a.name), against);
    const std::string times =
        limit > 0 && std::isfinite(value) ? fmt::format(", {} times the limit", format_quantity(value / limit, "", 3)) : "";
    return fmt::format("The assumption {} fails: {}{}. {}\n", spoken(a.name), against, times, a.broken);
}

std::string_view law_words(Law law) {
    return law == Law::constant ? "stay constant" : law == Law::never_grows ? "never grow" : "be zero";
}

std::string law_sentence(const Runner& r, std::size_t i) {
    const Conserved& c = r.lesson().conserved[i];
    const Holds holds = r.holds(i);
    const std::string name = spoken(c.probe);
    if (holds == Holds::not_expected)
        return c.law == Law::never_grows
                   ? fmt::format("{} may grow here.\n", name)
                   : fmt::format("{} {} not expected to {} here.\n", name, is_or_are(name), law_words(c.law));
    const std::string_view unit = r.lesson().probe(c.probe).unit;
    return fmt::format("{} should {}, and this {}: off by {}, tolerated {}.\n", name, law_words(c.law),
                       holds == Holds::yes ? "holds" : "fails", format_quantity(r.drift(i), unit, 3),
                       format_quantity(r.tolerance(i), unit, 3));
}

std::string failure_sentence(const Failure& f) {
    std::string text = fmt::format("The run stopped in step {}", f.step);
    if (!f.stage.empty()) text += fmt::format(", stage {}", spoken(f.stage));
    if (!f.field.empty()) text += fmt::format(", field {}", spoken(f.field));
    if (f.index >= 0) text += fmt::format(", index {}", f.index);
    text += fmt::format(": {}. {}\n", f.what, f.limit);
    return text +
           (f.step > 0 ? fmt::format("What stands here is the last good state, that of the end of step {}.\n", f.step - 1) : "");
}

}  // namespace

std::vector<const Probe*> key_probes(const Lesson& lesson) {
    std::vector<const Probe*> chosen;
    for (const std::string_view name : lesson.key_numbers()) chosen.push_back(&lesson.probe(name));
    for (const Probe& p : lesson.probes)
        if (lesson.key_numbers().empty() && chosen.size() < 3 && p.exact) chosen.push_back(&p);
    if (chosen.empty() && !lesson.probes.empty()) chosen.push_back(&lesson.probes.front());
    return chosen;
}

std::string summary_text(const Runner& r, const std::function<bool(std::string_view)>& hidden) {
    const auto told = [&](std::string_view name) { return !hidden || !hidden(name); };
    std::string text = fmt::format("Lesson {}.\n", r.info().title);
    text += place_sentence(r);
    text += waiting_sentences(r);
    text += stage_sentence(r);
    for (const Probe* p : key_probes(r.lesson()))
        if (told(p->name)) text += number_sentence(r, *p, told("theory"));
    for (const Assumption& a : r.lesson().assumptions)
        if (a.in_use() && told("lights")) text += assumption_sentence(a);
    for (const std::size_t i : r.shown_laws())
        if (told("lights")) text += law_sentence(r, i);
    if (r.failure()) text += failure_sentence(*r.failure());
    return text;
}

}  // namespace pliant
