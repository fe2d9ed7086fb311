// What a lesson declares, in a line or two each: parameters with what the solver accepts, fields with a bound, stages, probes,
// assumptions; and curves point by point. What else one of them declares is set afterwards.
#pragma once
#include <pliant/lesson/lesson.h>
#include <pliant/text/format.h>

namespace pliant {

// A number, what its slider spans, and what the solver accepts; the slider linear, or logarithmic.
inline ParameterInfo quantity(std::string_view key, std::string_view symbol, std::string_view unit, Real initial, Interval useful,
                              Interval accepted, std::string_view help) {
    return quantity(key, symbol, unit, initial, useful, help).accepts(accepted);
}
inline ParameterInfo log_quantity(std::string_view key, std::string_view symbol, std::string_view unit, Real initial,
                                  Interval useful, Interval accepted, std::string_view help) {
    return quantity(key, symbol, unit, initial, useful, accepted, help).log();
}

// The same field, computed only in some scenes; with a bound.
inline Field when(std::function<bool()> uses, Field field) {
    field.used = std::move(uses);
    return field;
}
inline Field within(std::function<Real()> magnitude, Field field) {
    field.bound = std::move(magnitude);
    return field;
}

using Why = std::function<std::optional<Explanation>(const Question&)>;

inline Stage stage_of(std::string_view name, std::string_view formula, std::string_view source, std::function<void()> run,
                      std::vector<std::string_view> reads, std::vector<std::string_view> writes, Why why,
                      std::function<bool()> active = {}) {
    return {.name = name,
            .formula = formula,
            .source = source,
            .run = std::move(run),
            .reads = std::move(reads),
            .writes = std::move(writes),
            .active = std::move(active),
            .explain = std::move(why)};
}
// The formula that is in force, of one that says several things.
inline Stage in_force(std::function<std::string_view()> formula, Stage stage) {
    stage.formula_in_force = std::move(formula);
    return stage;
}

inline Probe measured(std::string_view name, std::string_view symbol, std::string_view unit, std::string_view help,
                      std::function<std::optional<Real>()> value, std::function<std::optional<Real>(Real t)> exact = {},
                      std::function<Explanation()> explain = {}) {
    return {name, symbol, unit, help, std::move(value), std::move(exact), std::move(explain)};
}

inline Assumption assumption(std::string_view name, std::string_view unit, std::function<Real()> value,
                             std::function<Real()> limit, std::string_view formula, std::string_view broken,
                             std::function<bool()> used = {}, std::function<std::optional<Fix>()> fix = {}) {
    return {name, unit, std::move(value), std::move(limit), formula, broken, std::move(used), std::move(fix)};
}

// One parameter set to a value: "Δt = 5 ms".
inline Fix set_to(const Parameter& parameter, Real value, int digits = 4) {
    return {std::string(parameter.info.symbol) + " = " + format_quantity(value, parameter.info.unit, digits),
            {{std::string(parameter.info.key), format_exact(value)}}};
}

inline void add(Curve& curve, Real at, Real number) { curve.position.push_back(at), curve.value.push_back(number); }
// f at so many places from one end to the other, both included.
inline void add_range(Curve& curve, Real from, Real to, int places, const std::function<Real(Real)>& f) {
    for (int k = 0; k < places; ++k) {
        const Real at = from + (to - from) * k / (places - 1);
        add(curve, at, f(at));
    }
}

}  // namespace pliant
