#include "session/autopsy.h"

#include <pliant/document/summary.h>
#include <pliant/text/format.h>
#include <pliant/text/spoken.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

bool rebuilds(const Lesson& lesson, const Fix& fix) {
    return std::ranges::any_of(fix.assign,
                               [&](const auto& a) { return lesson.parameter(a.first).info.effect == Effect::rebuild; });
}

void take_fix(Autopsy& a, const Lesson& lesson, std::optional<Fix> fix) {
    a.fix = std::move(fix);
    a.restarts = a.fix && rebuilds(lesson, *a.fix);
}

std::string capital(std::string text) {
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

std::string against_of(const Failure& f, std::string_view unit) {
    if (!f.value || !f.bound) return capital(f.what);
    return fmt::format("{}, at most {} is accepted: {}", format_quantity(*f.value, unit), format_quantity(*f.bound, unit),
                       excess(std::abs(*f.value), *f.bound, unit, "bound"));
}

}  // namespace

std::string excess(Real value, Real bound, std::string_view unit, std::string_view bound_name) {
    const Real times = value / bound;
    if (bound > 0 && std::isfinite(times)) return fmt::format("{} times the {}", format_quantity(times, "", 3), bound_name);
    return fmt::format("{} beyond the {}", format_quantity(value - bound, unit, 3), bound_name);
}

std::string Autopsy::text() const {
    std::string all = headline;
    for (const std::string* part : {&where, &against, &limit})
        if (!part->empty()) all += "\n" + *part;
    for (std::size_t n = 0; n < fixes(); ++n) all += (n == 0 ? "\nTo mend it: " : ", or ") + fix_at(n).label;
    return all;
}

Autopsy autopsy_of(const Runner& runner, const Failure& f) {
    Autopsy a;
    a.headline = f.step >= 0 ? fmt::format("Stopped in step {}", f.step) : std::string("Stopped");
    if (!f.stage.empty()) a.headline += fmt::format(": stage {}", spoken(f.stage));
    const Field* field = runner.lesson().find_field(f.field);
    if (field && field->in_use() && f.index >= 0 && f.index < field->size()) {
        a.field = f.field;
        a.thing = Thing{field->on, f.index};
        a.where = fmt::format("{} of {} {}", spoken(f.field), name_of(field->on), f.index);
    } else if (!f.field.empty()) {
        a.where = spoken(f.field);
    }
    a.against = against_of(f, field ? field->unit : "");
    a.limit = f.limit;
    take_fix(a, runner.lesson(), runner.lesson().fix(f));
    if (a.fix) a.others = runner.lesson().other_fixes(f);
    // What is left of a run that blows up is torn before the bound is met: it would blow up again.
    a.restarts = a.fix.has_value();
    return a;
}

Autopsy autopsy_of(const Runner& runner, const Assumption& assumption) {
    Autopsy a;
    a.headline = fmt::format("Stopped after step {}: the assumption {} fails", runner.place().step, spoken(assumption.name));
    a.where = std::string(assumption.formula);
    const Real value = assumption.value(), limit = assumption.limit();
    a.against = fmt::format("{} against the limit {}: {}", format_quantity(value, assumption.unit),
                            format_quantity(limit, assumption.unit), excess(value, limit, assumption.unit, "limit"));
    a.limit = capital(std::string(assumption.broken));
    if (assumption.fix) take_fix(a, runner.lesson(), assumption.fix());
    return a;
}

}  // namespace pliant::viewer
