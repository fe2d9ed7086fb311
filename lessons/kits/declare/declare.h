// What a lesson declares, in a line or two each: fields with a bound, stages, probes, assumptions; and curves point by point.
// What else one of them declares is set afterwards.
#pragma once
#include <pliant/lesson/lesson.h>

namespace pliant {

// The same field, computed only in some scenes; with a bound.
inline Field when(std::function<bool()> uses, const Field& field) { return field.when(std::move(uses)); }
inline Field within(std::function<Real()> magnitude, const Field& field) { return field.stops_at(std::move(magnitude)); }

using Why = std::function<std::optional<Explanation>(const Question&)>;

inline Stage stage_of(std::string_view name, std::string_view formula, std::string_view source, std::function<void()> run,
                      std::vector<std::string_view> reads, std::vector<std::string_view> writes, Why why,
                      std::function<bool()> active = {}) {
    return stage_of(name, formula, source, std::move(run))
        .maps(std::move(reads), std::move(writes))
        .because(std::move(why))
        .when(std::move(active));
}
// The formula that is in force, of one that says several things.
inline Stage in_force(std::function<std::string_view()> formula, const Stage& stage) { return stage.shows(std::move(formula)); }

inline Probe measured(std::string_view name, std::string_view symbol, std::string_view unit, std::string_view help,
                      std::function<std::optional<Real>()> value, std::function<std::optional<Real>(Real t)> exact = {},
                      std::function<Explanation()> explain = {}) {
    return {name, symbol, unit, help, std::move(value), std::move(exact), std::move(explain)};
}

inline Assumption assumption(std::string_view name, std::string_view unit, std::function<Real()> value,
                             std::function<Real()> limit, std::string_view formula, std::string_view broken,
                             std::function<bool()> used = {}, std::function<std::optional<Fix>()> fix = {}) {
    return assumption_of(name, unit, std::move(value), std::move(limit), formula, broken)
        .when(std::move(used))
        .mended_by(std::move(fix));
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
