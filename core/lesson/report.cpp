#include <pliant/lesson/format.h>
#include <pliant/lesson/report.h>
#include <pliant/lesson/texts.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

// JSON has no NaN or infinity: an undefined value is null.
Json number(std::optional<Real> value) { return value && std::isfinite(*value) ? Json(*value) : Json(nullptr); }

std::string_view name_of(Kind kind) {
    switch (kind) {
        case Kind::number: return "number";
        case Kind::whole: return "whole number";
        case Kind::choice: return "choice";
        case Kind::toggle: return "switch";
    }
    return "";
}

std::string_view name_of(Holds holds) { return holds == Holds::yes ? "holds" : holds == Holds::no ? "violated" : "not expected"; }

Json value_json(const Parameter& p, Real value) {
    switch (p.info.kind) {
        case Kind::choice: return p.text(value);
        case Kind::toggle: return value != 0;
        case Kind::whole: return static_cast<long long>(value);
        case Kind::number: break;
    }
    return value;
}

Json parameter_json(const Parameter& p) {
    const ParameterInfo& info = p.info;
    Json j{{"key", info.key}, {"kind", name_of(info.kind)}, {"symbol", info.symbol}, {"unit", info.unit}, {"help", info.help}, {"default", value_json(p, info.initial)}};
    if (info.kind == Kind::choice) {
        for (const Option& o : info.options) j["options"].push_back({{"key", o.key}, {"label", o.label}});
    } else if (info.kind != Kind::toggle) {
        j["useful"] = {info.useful.min, info.useful.max};
        j["accepted"] = {{"min", p.accepted().min}, {"max", p.accepted().max}, {"open_min", p.accepted().open_min}, {"open_max", p.accepted().open_max}};
        j["scale"] = info.scale == Scale::log ? "log" : "linear";
    }
    j["effect"] = info.effect == Effect::live ? "live" : "rebuild";
    return j;
}

template <class List, class Make>
Json array_of(const List& list, Make make) {
    Json array = Json::array();
    for (const auto& item : list) array.push_back(make(item));
    return array;
}

Json curve_json(const Line& line, const Curve& curve) { return {{"unit", line.unit}, {"position", curve.position}, {"value", curve.value}}; }

Json lines_json(const Lesson& lesson) {
    Json lines = Json::object();
    for (const Line& line : lesson.lines) {
        if (!line.in_use()) continue;
        Curve curve, reference;
        line.sample(curve);
        Json& j = lines[std::string(line.name)] = curve_json(line, curve);
        j["position_name"] = line.position_name;
        j["position_unit"] = line.position_unit;
        if (!line.reference) continue;
        line.reference(reference);
        j["reference"] = {{"name", line.reference_name}, {"position", reference.position}, {"value", reference.value}};
    }
    return lines;
}

Json assumptions_json(const Lesson& lesson) {
    Json list = Json::object();
    for (const Assumption& a : lesson.assumptions) {
        if (!a.in_use()) continue;
        const Real value = a.value(), limit = a.limit();
        list[std::string(a.name)] = {{"unit", a.unit}, {"value", number(value)}, {"limit", number(limit)}, {"holds", value <= limit}, {"formula", a.formula}, {"broken", a.broken}};
    }
    return list;
}

Json conserved_json(const Runner& runner) {
    Json list = Json::object();
    for (const std::size_t i : runner.shown_laws()) {
        const Conserved& c = runner.lesson().conserved[i];
        const Holds holds = runner.holds(i);
        Json& j = list[std::string(c.probe)] = {{"unit", runner.lesson().probe(c.probe).unit}, {"status", name_of(holds)}};
        if (holds != Holds::not_expected) j["drift"] = number(runner.drift(i)), j["tolerance"] = number(c.tolerance());
    }
    return list;
}

Json cost_json(const Runner& runner) {
    Json cost = Json::object();
    for (const Stage* s : runner.stages()) cost[std::string(s->name)] = runner.cost(static_cast<std::size_t>(s - runner.lesson().stages.data())).total_ms;
    return cost;
}

Json failure_json(const Failure& f) {
    return {{"stage", f.stage}, {"field", f.field}, {"index", f.index}, {"step", f.step}, {"time", f.time}, {"what", f.what}, {"limit", f.limit}};
}

std::string table_row(std::string_view name, std::string_view value, std::string_view rest = "") { return fmt::format("  {:<28} {:>16}  {}\n", name, value, rest); }

std::string range_text(const Parameter& p) {
    if (p.info.kind == Kind::toggle) return "true, false";
    if (p.info.kind != Kind::choice) return p.accepted().text();
    std::string keys;
    for (const Option& o : p.info.options) keys += (keys.empty() ? "" : ", ") + std::string(o.key);
    return keys;
}

std::string names(const std::vector<std::string_view>& list) { return fmt::format("{}", fmt::join(list, ", ")); }

}  // namespace

std::string_view status_of(const Runner& runner) { return runner.failure() ? "diverged" : runner.lesson().at_rest() ? "at_rest" : "ok"; }

std::string list_text() {
    std::string text;
    for (const LessonEntry& e : lessons()) text += fmt::format("{:<28} {}\n{:<28}   {}\n", e.info.id, e.info.title, "", e.info.summary);
    return text;
}

std::string list_json() {
    return array_of(lessons(), [](const LessonEntry& e) {
               return Json{{"lesson", e.info.id}, {"chapter", e.chapter()}, {"title", e.info.title}, {"summary", e.info.summary}, {"presets", preset_names(e.info.id)}};
           }).dump(2) + "\n";
}

std::string describe_json(const LessonEntry& entry) {
    const auto lesson = entry.make();
    Json j{{"lesson", entry.info.id}, {"title", entry.info.title}, {"summary", entry.info.summary}, {"dimension", lesson->dimension()}};
    j["parameters"] = array_of(lesson->parameters, [](const Parameter* p) { return parameter_json(*p); });
    j["stages"] = array_of(lesson->stages, [](const Stage& s) {
        return Json{{"name", s.name}, {"formula", s.formula}, {"source", s.source}, {"reads", s.reads}, {"writes", s.writes}, {"loop", bool(s.again)}, {"loop_from", s.loop_from}};
    });
    j["fields"] = array_of(lesson->fields, [](const Field& f) {
        return Json{{"name", f.name}, {"symbol", f.symbol}, {"unit", f.unit}, {"on", pliant::name_of(f.on)}, {"rank", pliant::name_of(f.rank)}, {"components", f.components}, {"help", f.help}};
    });
    j["probes"] = array_of(lesson->probes, [](const Probe& p) {
        return Json{{"name", p.name}, {"symbol", p.symbol}, {"unit", p.unit}, {"help", p.help}, {"exact", bool(p.exact)}};
    });
    j["lines"] = array_of(lesson->lines, [](const Line& l) {
        return Json{{"name", l.name}, {"unit", l.unit}, {"position", l.position_name}, {"position_unit", l.position_unit}, {"help", l.help}};
    });
    j["assumptions"] = array_of(lesson->assumptions, [](const Assumption& a) {
        return Json{{"name", a.name}, {"unit", a.unit}, {"formula", a.formula}, {"broken", a.broken}};
    });
    j["conserved"] = array_of(lesson->conserved, [](const Conserved& c) { return Json(c.probe); });
    j["presets"] = preset_names(entry.info.id);
    return j.dump(2) + "\n";
}

std::string describe_text(const LessonEntry& entry) {
    const auto lesson = entry.make();
    std::string text = fmt::format("{}: {}\n{}\n\nParameters\n", entry.info.id, entry.info.title, entry.info.summary);
    for (const Parameter* p : lesson->parameters)
        text += fmt::format("  {:<20} {:>14} {:<8} {}\n  {:<20} {}\n", p->info.key, p->text(p->info.initial), p->info.unit, range_text(*p), "", p->info.help);
    text += "\nStages\n";
    for (const Stage& s : lesson->stages) text += fmt::format("  {:<20} {}\n", s.name, s.formula);
    text += "\nFields\n";
    for (const Field& f : lesson->fields) text += fmt::format("  {:<20} {} per {} {}\n", f.name, pliant::name_of(f.rank), pliant::name_of(f.on), f.unit.empty() ? "" : fmt::format("[{}]", f.unit));
    text += "\nProbes\n";
    for (const Probe& p : lesson->probes) text += fmt::format("  {:<20} {:<10} {}\n", p.name, p.unit, p.help);
    if (!lesson->lines.empty()) text += "\nLines\n";
    for (const Line& l : lesson->lines) text += fmt::format("  {:<20} {}\n", l.name, l.help);
    const auto presets = preset_names(entry.info.id);
    if (!presets.empty()) text += fmt::format("\nPresets\n  {}\n", fmt::join(presets, ", "));
    return text;
}

std::string describe_markdown(const LessonEntry& entry) {
    const auto lesson = entry.make();
    std::string text = fmt::format("# {}\n\n`{}`. {}\n\n<!-- Made by `pliant describe {} --markdown`; edit the lesson, not this page. -->\n", entry.info.title, entry.info.id, entry.info.summary, entry.info.id);
    text += "\n## Parameters\n\n| key | symbol | unit | default | accepted | takes effect | meaning |\n|---|---|---|---|---|---|---|\n";
    for (const Parameter* p : lesson->parameters)
        text += fmt::format("| `{}` | {} | {} | {} | {} | {} | {} |\n", p->info.key, p->info.symbol, p->info.unit, p->text(p->info.initial), range_text(*p),
                            p->info.effect == Effect::live ? "live" : "restarts", p->info.help);
    text += "\n## Stages of a step\n\n| stage | formula | source | reads | writes |\n|---|---|---|---|---|\n";
    for (const Stage& s : lesson->stages) text += fmt::format("| `{}`{} | {} | {} | {} | {} |\n", s.name, s.again ? " ↻" : "", s.formula, s.source, names(s.reads), names(s.writes));
    text += "\n## Fields\n\n| field | symbol | unit | kind | meaning |\n|---|---|---|---|---|\n";
    for (const Field& f : lesson->fields) text += fmt::format("| `{}` | {} | {} | {} per {} | {} |\n", f.name, f.symbol, f.unit, pliant::name_of(f.rank), pliant::name_of(f.on), f.help);
    text += "\n## Probes\n\n| probe | symbol | unit | exact known | meaning |\n|---|---|---|---|---|\n";
    for (const Probe& p : lesson->probes) text += fmt::format("| `{}` | {} | {} | {} | {} |\n", p.name, p.symbol, p.unit, p.exact ? "yes" : "", p.help);
    if (!lesson->lines.empty()) text += "\n## Lines\n\n| line | against | meaning |\n|---|---|---|\n";
    for (const Line& l : lesson->lines) text += fmt::format("| `{}` {} | {} {} | {} |\n", l.name, l.unit, l.position_name, l.position_unit, l.help);
    if (!lesson->assumptions.empty()) text += "\n## Assumptions\n\n| assumption | holds while | beyond it |\n|---|---|---|\n";
    for (const Assumption& a : lesson->assumptions) text += fmt::format("| {} | {} | {} |\n", a.name, a.formula, a.broken);
    const auto presets = preset_names(entry.info.id);
    if (!presets.empty()) text += fmt::format("\n## Presets\n\n`{}`\n", fmt::join(presets, "`, `"));
    return text;
}

std::string run_json(const Runner& runner) {
    const Lesson& lesson = runner.lesson();
    Json j{{"lesson", runner.info().id}, {"parameters", Json::object()}, {"dimension", lesson.dimension()}, {"steps", runner.place().step}, {"time", runner.time()}, {"status", status_of(runner)}};
    for (const Parameter* p : lesson.parameters) j["parameters"][std::string(p->info.key)] = value_json(*p, p->value());
    j["probes"] = Json::object();
    for (const Probe& p : lesson.probes)
        j["probes"][std::string(p.name)] = {{"unit", p.unit}, {"value", number(runner.value(p))}, {"exact", number(runner.exact(p))}};
    j["lines"] = lines_json(lesson);
    j["assumptions"] = assumptions_json(lesson);
    j["conserved"] = conserved_json(runner);
    j["cost"] = cost_json(runner);
    if (runner.failure()) j["failure"] = failure_json(*runner.failure());
    return j.dump(2) + "\n";
}

std::string run_text(const Runner& runner) {
    const Lesson& lesson = runner.lesson();
    std::string text = fmt::format("{}: {} steps", runner.info().id, runner.place().step);
    if (!runner.is_static()) text += fmt::format(", t = {}", format_quantity(runner.time(), "s"));
    text += fmt::format(", {}\n\nProbes\n", status_of(runner));
    for (const Probe& p : lesson.probes) {
        const auto value = runner.value(p), exact = runner.exact(p);
        text += table_row(p.name, value ? format_quantity(*value, p.unit, 6) : "undefined", exact ? "exact " + format_quantity(*exact, p.unit, 6) : "");
    }
    bool heading = false;
    for (const Assumption& a : lesson.assumptions) {
        if (!a.in_use()) continue;
        if (!heading) text += "\nAssumptions\n", heading = true;
        const Real value = a.value(), limit = a.limit();
        text += table_row(a.name, value <= limit ? "holds" : "BROKEN",
                          fmt::format("{} against {}{}", format_quantity(value, a.unit), format_quantity(limit, a.unit), value <= limit ? "" : fmt::format(": {}", a.broken)));
    }
    if (!lesson.conserved.empty()) text += "\nConserved\n";
    for (const std::size_t i : runner.shown_laws()) text += table_row(lesson.conserved[i].probe, name_of(runner.holds(i)));
    text += "\nCost\n";
    for (const Stage* s : runner.stages()) {
        const StageCost& c = runner.cost(static_cast<std::size_t>(s - lesson.stages.data()));
        text += table_row(s->name, fmt::format("{:.3f} ms", c.total_ms), c.passes > c.runs ? fmt::format("{} passes", c.passes) : "");
    }
    return text;
}

}  // namespace pliant
