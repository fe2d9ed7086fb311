#include <pliant/document/report.h>
#include <pliant/document/report_json.h>
#include <pliant/text/format.h>
#include <pliant/text/markdown.h>
#include <pliant/text/stored_file.h>
#include <pliant/text/texts.h>

#include <fmt/format.h>

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

std::string_view name_of(Kind kind) {
    switch (kind) {
        case Kind::number:
            return "number";
        case Kind::whole:
            return "whole number";
        case Kind::choice:
            return "choice";
        case Kind::toggle:
            return "switch";
        case Kind::file:
            return "file";
    }
    return "";
}

Json parameter_json(const Parameter& p) {
    const ParameterInfo& info = p.info;
    Json j{{"key", info.key},   {"kind", name_of(info.kind)}, {"symbol", info.symbol},
           {"unit", info.unit}, {"help", info.help},          {"default", value_json(p, info.initial)}};
    if (info.kind == Kind::choice) {
        for (const Option& o : info.options) j["options"].push_back({{"key", o.key}, {"label", o.label}});
    } else if (info.kind == Kind::file) {
        j["endings"] = info.endings;
        j["bundled"] = bundled_bodies(info.endings);
    } else if (info.kind != Kind::toggle) {
        j["useful"] = {info.useful.min, info.useful.max};
        j["accepted"] = {{"min", p.accepted().min},
                         {"max", p.accepted().max},
                         {"open_min", p.accepted().open_min},
                         {"open_max", p.accepted().open_max}};
        j["scale"] = info.scale == Scale::log ? "log" : "linear";
    }
    j["group"] = key_of(info.group);
    j["effect"] = name_of(info.effect);
    return j;
}

template <class List, class Make>
Json array_of(const List& list, Make make) {
    Json array = Json::array();
    for (const auto& item : list) array.push_back(make(item));
    return array;
}

std::string range_text(const Parameter& p) {
    if (p.info.kind == Kind::toggle) return "true, false";
    if (p.info.kind == Kind::file) return "a file that ends in " + accepted_files(p.info.endings);
    if (p.info.kind != Kind::choice) return p.accepted().text();
    std::string keys;
    for (const Option& o : p.info.options) keys += (keys.empty() ? "" : ", ") + std::string(o.key);
    return keys;
}

}  // namespace

std::string list_text() {
    std::string text;
    for (const LessonEntry& e : lessons())
        text += fmt::format("{:<28} {}\n{:<28}   {}\n", e.info.id, e.info.title, "", e.info.summary);
    return text;
}

std::string list_json() {
    return array_of(lessons(),
                    [](const LessonEntry& e) {
                        return Json{{"lesson", e.info.id},
                                    {"chapter", e.chapter()},
                                    {"title", e.info.title},
                                    {"summary", e.info.summary},
                                    {"presets", preset_names(e.info.id)}};
                    })
               .dump(2) +
           "\n";
}

std::string describe_json(const LessonEntry& entry) {
    const auto lesson = entry.make();
    Json j{{"lesson", entry.info.id},
           {"title", entry.info.title},
           {"summary", entry.info.summary},
           {"dimension", lesson->dimension()}};
    j["parameters"] = array_of(lesson->parameters, [](const Parameter* p) { return parameter_json(*p); });
    j["stages"] = array_of(lesson->stages, [](const Stage& s) {
        return Json{{"name", s.name},   {"formula", s.formula}, {"source", s.source},    {"code", s.code},
                    {"reads", s.reads}, {"writes", s.writes},   {"loop", bool(s.again)}, {"loop_from", s.loop_from}};
    });
    j["fields"] = array_of(lesson->fields, [](const Field& f) {
        return Json{{"name", f.name},
                    {"symbol", f.symbol},
                    {"unit", f.unit},
                    {"on", pliant::name_of(f.on)},
                    {"rank", pliant::name_of(f.rank)},
                    {"components", f.components},
                    {"help", f.help}};
    });
    j["probes"] = array_of(lesson->probes, [](const Probe& p) {
        return Json{{"name", p.name}, {"symbol", p.symbol}, {"unit", p.unit}, {"help", p.help}, {"exact", bool(p.exact)}};
    });
    j["lines"] = array_of(lesson->lines, [](const Line& l) {
        return Json{{"name", l.name},
                    {"unit", l.unit},
                    {"position", l.position_name},
                    {"position_unit", l.position_unit},
                    {"help", l.help}};
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
    for (const Group group : all_groups) {
        const auto members = lesson->parameters_of(group);
        if (!members.empty()) text += fmt::format(" {}\n", name_of(group));
        for (const Parameter* p : members)
            text += fmt::format("  {:<20} {:>14} {:<8} {}\n  {:<20} {}\n", p->info.key, p->text(p->info.initial), p->info.unit,
                                range_text(*p), "", p->info.help);
    }
    text += "\nStages\n";
    for (const Stage& s : lesson->stages) text += fmt::format("  {:<20} {}\n", s.name, s.formula);
    text += "\nFields\n";
    for (const Field& f : lesson->fields)
        text += fmt::format("  {:<20} {} per {} {}\n", f.name, pliant::name_of(f.rank), pliant::name_of(f.on),
                            f.unit.empty() ? "" : fmt::format("[{}]", f.unit));
    text += "\nProbes\n";
    for (const Probe& p : lesson->probes) text += fmt::format("  {:<20} {:<10} {}\n", p.name, p.unit, p.help);
    if (!lesson->lines.empty()) text += "\nLines\n";
    for (const Line& l : lesson->lines) text += fmt::format("  {:<20} {}\n", l.name, l.help);
    const auto presets = preset_names(entry.info.id);
    if (!presets.empty()) text += fmt::format("\nPresets\n  {}\n", fmt::join(presets, ", "));
    return text;
}

namespace {
std::string_view when_in_effect(Effect effect) {
    return effect == Effect::live ? "live" : effect == Effect::rebuild ? "restarts" : "only shown";
}
}  // namespace

std::string describe_markdown(const Lesson& lesson, std::string_view id) {
    std::string text =
        "\n### Parameters\n\n| key | symbol | unit | default | accepted | takes effect | meaning "
        "|\n|---|---|---|---|---|---|---|\n";
    for (const Group group : all_groups) {
        const auto members = lesson.parameters_of(group);
        if (!members.empty()) text += fmt::format("| **{}** | | | | | | |\n", name_of(group));
        for (const Parameter* p : members)
            text += fmt::format("| `{}` | {} | {} | {} | {} | {} | {} |\n", p->info.key, p->info.symbol, p->info.unit,
                                p->text(p->info.initial), range_text(*p), when_in_effect(p->info.effect), cell(p->info.help));
    }
    text += "\n### Fields\n\n| field | symbol | unit | kind | meaning |\n|---|---|---|---|---|\n";
    for (const Field& f : lesson.fields)
        text += fmt::format("| `{}` | {} | {} | {} per {} | {} |\n", f.name, cell(f.symbol), f.unit, pliant::name_of(f.rank),
                            pliant::name_of(f.on), cell(f.help));
    text += "\n### Probes\n\n| probe | symbol | unit | exact known | meaning |\n|---|---|---|---|---|\n";
    for (const Probe& p : lesson.probes)
        text += fmt::format("| `{}` | {} | {} | {} | {} |\n", p.name, cell(p.symbol), p.unit, p.exact ? "yes" : "", cell(p.help));
    if (!lesson.lines.empty()) text += "\n### Lines\n\n| line | against | meaning |\n|---|---|---|\n";
    for (const Line& l : lesson.lines)
        text += fmt::format("| `{}` {} | {} {} | {} |\n", l.name, l.unit, l.position_name, l.position_unit, cell(l.help));
    if (!lesson.assumptions.empty()) text += "\n### Assumptions\n\n| assumption | holds while | beyond it |\n|---|---|---|\n";
    for (const Assumption& a : lesson.assumptions)
        text += fmt::format("| {} | {} | {} |\n", a.name, cell(a.formula), cell(a.broken));
    const auto presets = preset_names(id);
    if (!presets.empty()) text += fmt::format("\n### Presets\n\n`{}`\n", fmt::join(presets, "`, `"));
    return text;
}

}  // namespace pliant
