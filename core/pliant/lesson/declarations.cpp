// Declarations in a few lines: a copy with one thing more.
#include <pliant/lesson/lesson.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

namespace pliant {
namespace {

template <class Declaration, class Member, class Value>
Declaration with(Declaration declared, Member Declaration::*member, Value value) {
    declared.*member = std::move(value);
    return declared;
}

}  // namespace

Field Field::stops_at(Real magnitude) const {
    return stops_at([magnitude] { return magnitude; });
}
Field Field::stops_at(std::function<Real()> magnitude) const { return with(*this, &Field::bound, std::move(magnitude)); }
Field Field::of_both_signs() const {
    Field field = *this;
    field.both_signs = true;
    return field;
}
Field Field::when(std::function<bool()> uses) const { return with(*this, &Field::used, std::move(uses)); }
Field Field::follows(std::vector<std::string_view> from, std::function<Explanation(const Question&)> why) const {
    return with(with(*this, &Field::defined_by, std::move(from)), &Field::explain, std::move(why));
}

Stage stage_of(std::string_view name, std::string_view formula, std::string_view source, std::function<void()> run) {
    return {.name = name, .formula = formula, .source = source, .run = std::move(run)};
}
Stage Stage::done_in(std::string_view places) const { return with(*this, &Stage::code, places); }
Stage Stage::where(std::vector<Symbol> of_formula) const { return with(*this, &Stage::symbols, std::move(of_formula)); }
Stage Stage::maps(std::vector<std::string_view> from, std::vector<std::string_view> to) const {
    return with(with(*this, &Stage::reads, std::move(from)), &Stage::writes, std::move(to));
}
Stage Stage::because(std::function<std::optional<Explanation>(const Question&)> why) const {
    return with(*this, &Stage::explain, std::move(why));
}
Stage Stage::when(std::function<bool()> runs) const { return with(*this, &Stage::active, std::move(runs)); }
Stage Stage::shows(std::function<std::string_view()> formula_that_holds) const {
    return with(*this, &Stage::formula_in_force, std::move(formula_that_holds));
}
Stage Stage::repeats(std::function<bool()> goes_on, std::function<void()> before, std::function<void()> after) const {
    Stage loop = with(*this, &Stage::again, std::move(goes_on));
    loop.begin = std::move(before), loop.end = std::move(after);
    return loop;
}
Stage Stage::loops_from(std::string_view first, std::function<bool()> goes_on) const {
    return with(with(*this, &Stage::loop_from, first), &Stage::again, std::move(goes_on));
}

Probe probe_of(std::string_view name, std::string_view symbol, std::string_view unit, std::string_view help,
               std::function<std::optional<Real>()> value, std::function<Explanation()> why) {
    Probe probe{.name = name, .symbol = symbol, .unit = unit, .help = help, .value = std::move(value)};
    return with(std::move(probe), &Probe::explain, std::move(why));
}
Probe probe_of(std::string_view name, std::string_view symbol, std::string_view unit, std::string_view help) {
    return {.name = name, .symbol = symbol, .unit = unit, .help = help, .value = {}};
}
Probe Probe::exactly(std::function<std::optional<Real>(Real)> closed_form) const {
    return with(*this, &Probe::exact, std::move(closed_form));
}
Probe Probe::exactly(std::function<std::optional<Real>()> at_all_times) const {
    return exactly([value = std::move(at_all_times)](Real) { return value(); });
}
Probe Probe::once(std::string_view name_before) const {
    Probe probe = *this;
    probe.formerly = name_before;
    return probe;
}
Probe Probe::when(std::function<bool()> defined) const {
    Probe some = with(*this, &Probe::value, [defined, all = value] { return defined() ? all() : std::nullopt; });
    if (exact) some.exact = [defined, all = exact](Real t) { return defined() ? all(t) : std::nullopt; };
    return some;
}

void Curve::add_range(Real from, Real to, int places, const std::function<Real(Real)>& f) {
    for (int k = 0; k < places; ++k) {
        const Real at = from + (to - from) * k / (places - 1);
        add(at, f(at));
    }
}

Line line_of(std::string_view name, std::string_view unit, std::string_view position_name, std::string_view position_unit,
             std::string_view help, std::function<void(Curve&)> sample) {
    return {.name = name,
            .unit = unit,
            .position_name = position_name,
            .position_unit = position_unit,
            .help = help,
            .sample = std::move(sample)};
}
Line Line::against(std::string_view what, std::function<void(Curve&)> curve, bool as_points) const {
    Line compared = with(*this, &Line::reference, std::move(curve));
    compared.reference_name = what, compared.reference_points = as_points;
    return compared;
}
Line Line::beside(std::vector<CompareCurve> curves) const { return with(*this, &Line::others, std::move(curves)); }
Line Line::measures(std::string_view name_of_values) const { return with(*this, &Line::value_name, name_of_values); }
Line Line::on_log_axes() const { return with(*this, &Line::log_log, true); }
Line Line::when(std::function<bool()> uses) const { return with(*this, &Line::used, std::move(uses)); }

Fix fix_by(const Parameter& parameter, Real value) {
    const ParameterInfo& info = parameter.info;
    return {fmt::format("{} = {}", info.symbol, format_quantity(value, info.unit)),
            {{std::string(info.key), format_exact(value)}}};
}

Assumption assumption_of(std::string_view name, std::string_view unit, std::function<Real()> value, std::function<Real()> limit,
                         std::string_view formula, std::string_view broken) {
    return {
        .name = name, .unit = unit, .value = std::move(value), .limit = std::move(limit), .formula = formula, .broken = broken};
}
Assumption Assumption::otherwise(std::string_view name_when_broken) const {
    return with(*this, &Assumption::otherwise_named, name_when_broken);
}
Assumption Assumption::when(std::function<bool()> uses) const { return with(*this, &Assumption::used, std::move(uses)); }
Assumption Assumption::mended_by(std::function<std::optional<Fix>()> asked) const {
    return with(*this, &Assumption::fix, std::move(asked));
}
Assumption Assumption::mended_by(Fix always) const {
    return mended_by([always = std::move(always)] { return std::optional(always); });
}

}  // namespace pliant
