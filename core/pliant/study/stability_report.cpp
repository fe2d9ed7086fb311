#include <pliant/document/report_json.h>
#include <pliant/study/stability_report.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

Json number(const std::optional<Real>& value) { return value && std::isfinite(*value) ? Json(*value) : Json(nullptr); }
std::string cell_text(const std::optional<Real>& value) { return value && std::isfinite(*value) ? format_exact(*value) : ""; }

// Where every step is stable, or none, there is no ratio to print.
std::optional<Real> ratio(const MapCell& c) { return c.theory && *c.theory > 0 ? c.theory : std::nullopt; }
const char* prediction(const MapCell& c) { return !c.theory ? "" : c.predicted_stable() ? "stable" : "unstable"; }

std::string_view name_of(Spacing spacing) {
    return spacing == Spacing::linear ? "linear" : spacing == Spacing::log ? "log" : "list";
}

Json knob_json(const Lesson& lesson, const Knob& knob) {
    const Parameter& p = lesson.parameter(knob.key);
    Json j{{"key", knob.key},
           {"symbol", p.info.symbol},
           {"unit", p.info.unit},
           {"spacing", name_of(knob.spacing)},
           {"values", Json::array()}};
    for (const Real v : knob.values) j["values"].push_back(value_json(p, v));
    return j;
}

Json cells_json(const StabilityMap& map) {
    Json kinds = Json::array(), growth = Json::array(), steps = Json::array(), stable = Json::array(), ratios = Json::array(),
         wrong = Json::array(), reasons = Json::array();
    for (Index j = 0; j < map.rows(); ++j)
        for (Index i = 0; i < map.columns(); ++i) {
            const MapCell& c = map.at(i, j);
            kinds.push_back(name_of(c.verdict.kind));
            growth.push_back(number(c.verdict.growth));
            steps.push_back(c.steps);
            stable.push_back(c.theory ? Json(c.predicted_stable()) : Json(nullptr));
            ratios.push_back(number(ratio(c)));
            wrong.push_back(contradicts_theory(map, i, j));
            reasons.push_back(c.verdict.reason);
        }
    return {
        {"class", kinds},       {"growth", growth}, {"steps", steps}, {"theory_stable", stable}, {"time_step_over_limit", ratios},
        {"contradicts", wrong}, {"reason", reasons}};
}

Json bound_json(const StabilityMap& map) {
    const auto values = [&](const MapPlace& p) {
        return Json{knob_value(map.order.across, p.across), knob_value(map.order.up, p.up)};
    };
    Json bound = Json::array();
    for (const auto& [a, b] : theory_bound(map)) bound.push_back({values(a), values(b)});
    return bound;
}

Index all_passes(const StabilityMap& map) {
    Index sum = 0;
    for (const MapCell& c : map.cells) sum += c.passes;
    return sum;
}

}  // namespace

std::string words_of(Stability kind) { return kind == Stability::not_converged ? "not converged" : std::string(name_of(kind)); }

std::string map_csv(const StabilityMap& map) {
    const auto lesson = map.order.lesson->make();
    const Parameter &x = lesson->parameter(map.order.across.key), &y = lesson->parameter(map.order.up.key);
    const auto column = [](const Parameter& p) {
        return p.info.unit.empty() ? std::string(p.info.key) : fmt::format("{} [{}]", p.info.key, p.info.unit);
    };
    std::string text =
        fmt::format("{},{},class,growth_per_step,steps,passes,time_step_over_limit,theory,contradicts\n", column(x), column(y));
    for (Index j = 0; j < map.rows(); ++j)
        for (Index i = 0; i < map.columns(); ++i) {
            const MapCell& c = map.at(i, j);
            text += fmt::format("{},{},{},{},{},{},{},{},{}\n", x.text(map.order.across.values[static_cast<std::size_t>(i)]),
                                y.text(map.order.up.values[static_cast<std::size_t>(j)]), name_of(c.verdict.kind),
                                cell_text(c.verdict.growth), c.steps, c.passes, cell_text(ratio(c)), prediction(c),
                                contradicts_theory(map, i, j) ? 1 : 0);
        }
    return text;
}

std::string map_json(const StabilityMap& map, const MapCost& cost) {
    const auto lesson = map.order.lesson->make();
    Json settings = Json::object(), counts = Json::object();
    for (const auto& [key, text] : map.order.settings) {
        const Parameter& p = lesson->parameter(key);
        settings[key] = value_json(p, p.parse(text));
    }
    for (int k = 0; k < stability_kinds; ++k)
        counts[std::string(name_of(static_cast<Stability>(k)))] = map.count(static_cast<Stability>(k));
    Json j{{"lesson", map.order.lesson->info.id}, {"settings", settings}, {"unused", unused_json(unused_settings(map.order))}};
    if (map.order.time)
        j["time"] = *map.order.time;
    else
        j["steps"] = map.order.steps;
    j["probe"] = map.probe.empty() ? Json(nullptr) : Json(map.probe);
    j["knobs"] = {knob_json(*lesson, map.order.across), knob_json(*lesson, map.order.up)};
    j["cells"] = cells_json(map);
    j["counts"] = counts;
    const auto found = agreement(map);
    j["agreement"] = found
                         ? Json{{"compared", found->compared}, {"at_bound", found->at_bound}, {"contradicts", found->contradicts}}
                         : Json(nullptr);
    j["bound"] = bound_json(map);
    j["cost"] = {{"passes", all_passes(map)}, {"seconds", cost.seconds}, {"jobs", cost.jobs}};
    return j.dump(1) + "\n";
}

std::string agreement_text(const StabilityMap& map) {
    const auto found = agreement(map);
    if (!found) return "The lesson names no stability limit to compare with.";
    if (found->compared == 0) return "The map has no cell that theory speaks of.";
    const auto of_all = [&](Index n) {
        return fmt::format("{} of {} {}", n, found->compared, found->compared == 1 ? "cell" : "cells");
    };
    if (found->contradicts > 0) return fmt::format("The map contradicts theory in {}.", of_all(found->contradicts));
    return fmt::format("The map agrees with theory in {}{}.", of_all(found->compared - found->at_bound),
                       found->at_bound == 0 ? "" : ", and the others lie within one cell of the bound");
}

std::string map_text(const StabilityMap& map, const MapCost& cost) {
    const auto lesson = map.order.lesson->make();
    std::string text = fmt::format("{}: {} across, {} up\n", map.order.lesson->info.id, text_of(*lesson, map.order.across),
                                   text_of(*lesson, map.order.up));
    for (int k = 0; k < stability_kinds; ++k)
        if (const Index n = map.count(static_cast<Stability>(k)))
            text += fmt::format("  {:>6}  {}\n", n, words_of(static_cast<Stability>(k)));
    text += fmt::format("  {}\n", agreement_text(map));
    return text + fmt::format("  {} cells in {:.2f} s with {} {}\n", map.cells.size(), cost.seconds, cost.jobs,
                              cost.jobs == 1 ? "job" : "jobs");
}

}  // namespace pliant
