#include <pliant/document/report.h>
#include <pliant/document/report_json.h>
#include <pliant/text/format.h>
#include <pliant/text/spoken.h>

#include <fmt/format.h>

#include <cmath>

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

// A number that is not finite is told as undefined: a report is made of what went wrong, too, and one bad number must not take
// the others along.
std::optional<Real> if_finite(std::optional<Real> value) { return value && std::isfinite(*value) ? value : std::nullopt; }
std::optional<Real> closed_form(const Runner& runner, const Probe& p) { return p.exact ? p.exact(runner.time()) : std::nullopt; }

// JSON has no NaN or infinity: an undefined value is null.
Json number(std::optional<Real> value) { return if_finite(value) ? Json(*value) : Json(nullptr); }

std::string_view name_of(Holds holds) { return holds == Holds::yes ? "holds" : holds == Holds::no ? "violated" : "not expected"; }

Json curve_json(const Line& line, const Curve& curve) {
    return {{"unit", line.unit}, {"position", curve.position}, {"value", curve.value}};
}

Json lines_json(const Lesson& lesson) {
    Json lines = Json::object();
    for (const Line& line : lesson.lines) {
        if (!line.in_use()) continue;
        Json& j = lines[std::string(line.name)] = curve_json(line, curve_of(line.sample));
        j["position_name"] = line.position_name;
        j["position_unit"] = line.position_unit;
        if (line.reference) {
            const Curve reference = curve_of(line.reference);
            j["reference"] = {{"name", line.reference_name}, {"position", reference.position}, {"value", reference.value}};
        }
        for (const CompareCurve& other : line.others) {
            const Curve curve_beside = curve_of(other.sample);
            if (!curve_beside.position.empty())
                j["others"][std::string(other.name)] = {{"position", curve_beside.position}, {"value", curve_beside.value}};
        }
    }
    return lines;
}

Json assumptions_json(const Lesson& lesson) {
    Json list = Json::object();
    for (const Assumption& a : lesson.assumptions) {
        if (!a.in_use()) continue;
        const Real value = a.value(), limit = a.limit();
        list[std::string(a.name)] = {{"unit", a.unit},          {"value", number(value)}, {"limit", number(limit)},
                                     {"holds", value <= limit}, {"formula", a.formula},   {"broken", a.broken}};
    }
    return list;
}

Json conserved_json(const Runner& runner) {
    Json list = Json::object();
    for (const std::size_t i : runner.shown_laws()) {
        const Conserved& c = runner.lesson().conserved[i];
        const Holds holds = runner.holds(i);
        Json& j = list[std::string(c.probe)] = {{"unit", runner.lesson().probe(c.probe).unit}, {"status", name_of(holds)}};
        if (holds != Holds::not_expected) j["drift"] = number(runner.drift(i)), j["tolerance"] = number(runner.tolerance(i));
    }
    return list;
}

Json cost_json(const Runner& runner) {
    Json cost = Json::object();
    for (const Stage* s : runner.stages()) cost[std::string(s->name)] = runner.cost(*s).total_ms;
    return cost;
}

Json failure_json(const Failure& f) {
    return {{"stage", f.stage}, {"field", f.field}, {"index", f.index}, {"step", f.step},
            {"time", f.time},   {"what", f.what},   {"limit", f.limit}};
}

std::string table_row(std::string_view name, std::string_view value, std::string_view rest = "") {
    return fmt::format("  {:<28} {:>16}  {}\n", name, value, rest);
}

std::string law_row(const Runner& runner, std::size_t i) {
    const Conserved& c = runner.lesson().conserved[i];
    const Holds holds = runner.holds(i);
    const std::string_view unit = runner.lesson().probe(c.probe).unit;
    std::string rest;
    if (holds == Holds::no)
        rest = fmt::format("off by {}, tolerated {}", format_quantity(runner.drift(i), unit, 3),
                           format_quantity(runner.tolerance(i), unit, 3));
    return table_row(c.probe, name_of(holds), rest);
}

}  // namespace

std::string_view status_of(const Runner& runner) {
    return runner.failure() ? "diverged" : runner.lesson().at_rest() ? "at_rest" : "ok";
}

namespace {
Json field_json(const Field& f) {
    const auto view = f.view();
    Json value = Json::array();
    for (Index r = 0; r < f.size(); ++r) {
        const auto row = view.subspan(static_cast<std::size_t>(r * f.components), static_cast<std::size_t>(f.components));
        if (f.rank == Rank::scalar) {
            value.push_back(number(row[0]));
            continue;
        }
        Json list = Json::array();
        for (const Real x : row) list.push_back(number(x));
        value.push_back(std::move(list));
    }
    return {{"unit", f.unit}, {"on", pliant::name_of(f.on)}, {"value", std::move(value)}};
}

Json json_of_run(const Runner& runner, const std::vector<UnusedSetting>& unused, const std::vector<std::string>& fields) {
    const Lesson& lesson = runner.lesson();
    Json j{{"lesson", runner.info().id},      {"parameters", Json::object()}, {"unused", unused_json(unused)},
           {"dimension", lesson.dimension()}, {"steps", runner.place().step}, {"time", runner.time()},
           {"status", status_of(runner)}};
    if (runner.inside_step()) j["passes"] = runner.place().passes;
    for (const Parameter* p : lesson.parameters) j["parameters"][std::string(p->info.key)] = value_json(*p, p->value());
    j["probes"] = Json::object();
    for (const Probe& p : lesson.probes)
        j["probes"][std::string(p.name)] = {
            {"unit", p.unit}, {"value", number(p.value())}, {"exact", number(closed_form(runner, p))}};
    // Scripts that ask by an older name find it, with the name that it has now.
    for (const Probe& p : lesson.probes)
        if (!p.formerly.empty() && !j["probes"].contains(p.formerly)) {
            Json same = j["probes"][std::string(p.name)];
            same["now"] = p.name;
            j["probes"][std::string(p.formerly)] = std::move(same);
        }
    j["lines"] = lines_json(lesson);
    j["assumptions"] = assumptions_json(lesson);
    j["conserved"] = conserved_json(runner);
    for (const std::string& name : fields) j["fields"][name] = field_json(lesson.field(name));
    j["cost"] = cost_json(runner);
    if (runner.failure()) j["failure"] = failure_json(*runner.failure());
    return j;
}
}  // namespace

std::string run_json(const Runner& runner, const std::vector<UnusedSetting>& unused, const Runner* beside,
                     const std::vector<std::string>& fields) {
    Json j = json_of_run(runner, unused, fields);
    if (beside) j["beside"] = json_of_run(*beside, {}, fields);
    return j.dump(2) + "\n";
}

std::string run_text(const Runner& runner) {
    const Lesson& lesson = runner.lesson();
    const Index steps = runner.place().step;
    std::string text = fmt::format("{}: {} step{}", runner.info().id, steps, steps == 1 ? "" : "s");
    if (const Index passes = runner.place().passes)
        text += fmt::format(" and {} pass{} of the next", passes, passes == 1 ? "" : "es");
    if (!runner.is_static()) text += fmt::format(", t = {}", format_quantity(runner.time(), "s"));
    text += fmt::format(", {}\n\nProbes\n", status_of(runner));
    for (const Probe& p : lesson.probes) {
        const auto value = if_finite(p.value()), exact = if_finite(closed_form(runner, p));
        text += table_row(p.name, value ? format_quantity(*value, p.unit, 6) : "undefined",
                          exact ? "exact " + format_quantity(*exact, p.unit, 6) : "");
    }
    bool heading = false;
    for (const Assumption& a : lesson.assumptions) {
        if (!a.in_use()) continue;
        if (!heading) text += "\nAssumptions\n", heading = true;
        const Real value = a.value(), limit = a.limit();
        text += table_row(a.name, value <= limit ? "holds" : "BROKEN",
                          fmt::format("{} against {}{}", format_quantity(value, a.unit), format_quantity(limit, a.unit),
                                      value <= limit ? "" : fmt::format(": {}", a.broken)));
    }
    if (!lesson.conserved.empty()) text += "\nConserved\n";
    for (const std::size_t i : runner.shown_laws()) text += law_row(runner, i);
    text += "\nCost\n";
    for (const Stage* s : runner.stages()) {
        const StageCost& c = runner.cost(*s);
        text += table_row(s->name, fmt::format("{:.3f} ms", c.total_ms), c.passes > c.runs ? counted(c.passes, "pass") : "");
    }
    return text;
}

}  // namespace pliant
