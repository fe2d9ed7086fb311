// docs/lessons: a page for each lesson.
#include <pliant/document/extensions.h>
#include <pliant/document/report.h>
#include <pliant/document/share.h>
#include <pliant/formula/notation.h>
#include <pliant/run/until.h>
#include <pliant/study/claims_report.h>
#include <pliant/study/lesson_page.h>
#include <pliant/text/file.h>
#include <pliant/text/format.h>
#include <pliant/text/markdown.h>
#include <pliant/text/source_code.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pliant {
namespace {

constexpr std::size_t longest_excerpt = 25;                   // lines
constexpr std::size_t fewest_results = 6, most_results = 14;  // rows, where there are so many

std::string file_name(std::string_view id) {
    std::string name(id);
    std::ranges::replace(name, '/', '_');
    return name;
}

std::string code_names(const std::vector<std::string_view>& names) {
    return names.empty() ? "nothing" : fmt::format("`{}`", fmt::join(names, "`, `"));
}

// ------------------------------------------------------------------------------------------------------------ formulas

// "explicit: …;  implicit: …" line by line.
std::vector<std::string_view> parts_of(std::string_view formula) {
    std::vector<std::string_view> parts;
    while (!formula.empty()) {
        const std::size_t end = std::min(formula.find(";  "), formula.size());
        parts.push_back(formula.substr(0, end));
        formula.remove_prefix(std::min(end + 1, formula.size()));
        formula.remove_prefix(std::min(formula.find_first_not_of(' '), formula.size()));
    }
    return parts;
}

struct InForce {
    std::string formula;
    std::vector<std::string> settings;  // "scheme=bdf2"
};

// What the formula of a stage becomes with the options of the choice that changes it; none where it stays the same.
std::vector<InForce> in_force(Lesson& lesson, const Stage& stage) {
    if (!stage.formula_in_force) return {};
    for (Parameter* p : lesson.parameters) {
        if (p->info.kind != Kind::choice) continue;
        const Real chosen = p->value();
        std::vector<InForce> list;
        for (std::size_t i = 0; i < p->info.options.size(); ++i) {
            p->set(static_cast<Real>(i));
            const std::string now(stage.formula_now());
            const auto known = std::ranges::find(list, now, &InForce::formula);
            InForce& same = known == list.end() ? list.emplace_back(InForce{now, {}}) : *known;
            same.settings.push_back(fmt::format("{}={}", p->info.key, p->info.options[i].key));
        }
        p->set(chosen);
        if (list.size() > 1) return list;
    }
    return {};
}

// The whole, and what it becomes with each choice if that is more than its parts say.
std::string formulas_of(Lesson& lesson, const Stage& stage) {
    std::string text;
    const auto parts = parts_of(stage.formula);
    for (const std::string_view part : parts) text += fmt::format("$$\n{}\n$$\n\n", latex(part));
    const auto choices = in_force(lesson, stage);
    if (choices.size() <= parts.size()) return text;
    for (const InForce& f : choices) text += fmt::format("- `{}`: ${}$\n", fmt::join(f.settings, "`, `"), latex(f.formula));
    return text + "\n";
}

// -------------------------------------------------------------------------------------------------------------- stages

// The code of one stage after the other; what was shown before is named alone, and all where there are no sources.
class StageCode {
public:
    explicit StageCode(const std::string& sources) : sources_(sources) {}

    std::string of(const Stage& stage) {
        std::string text;
        if (stage.code.empty()) return text;
        for (const CodePlace& place : code_places(stage.code)) {
            if (sources_.empty()) {
                text += fmt::format("`{}` in [{}](../../{})\n\n", place.function, place.file, place.file);
                continue;
            }
            const CodeExcerpt excerpt = definition_in(read_file(sources_ + "/" + place.file), place.function, place.file);
            const std::string link = excerpt.lines > longest_excerpt ? fmt::format("#L{}", excerpt.first_line) : "";
            text += fmt::format("`{}` in [{}](../../{}{})", place.function, place.file, place.file, link);
            const auto [shown, is_new] = shown_.emplace(place.file + place.function, stage.name);
            text += is_new ? fmt::format("\n\n```cpp\n{}```\n\n", first_lines(excerpt, longest_excerpt))
                           : fmt::format(", as at `{}`.\n\n", shown->second);
        }
        return text;
    }

private:
    std::string sources_;
    std::map<std::string, std::string_view> shown_;
};

std::string stages_of(Lesson& lesson, const std::string& sources) {
    std::string text =
        "\n## Stages\n\nA step runs these in turn, those that the scene needs; ↻ marks a stage that goes on pass by pass.\n";
    StageCode code(sources);
    int number = 0;
    for (const Stage& s : lesson.stages) {
        text += fmt::format("\n### {}. {}{}\n\n{}", ++number, s.name, s.again ? " ↻" : "", formulas_of(lesson, s));
        text += fmt::format("Reads {}, writes {}.", code_names(s.reads), code_names(s.writes));
        if (!s.loop_from.empty()) text += fmt::format(" Then on from `{}`, until it is done.", s.loop_from);
        text += s.source.empty() ? "\n\n" : fmt::format(" Source: {}.\n\n", s.source);
        text += code.of(s);
        while (text.ends_with("\n\n")) text.pop_back();
    }
    return text;
}

// ------------------------------------------------------------------------------------------------------------- results

struct Measured {
    const Probe* probe;
    Real value;
    std::optional<Real> exact;
};

// Those with a closed form first, and others until there are enough.
std::vector<Measured> key_numbers(const Runner& runner) {
    std::vector<Measured> all;
    for (const Probe& p : runner.lesson().probes)
        if (const auto value = runner.value(p)) all.push_back({&p, *value, p.exact ? runner.exact(p) : std::nullopt});
    std::stable_partition(all.begin(), all.end(), [](const Measured& m) { return m.exact.has_value(); });
    const auto known =
        static_cast<std::size_t>(std::ranges::count_if(all, [](const Measured& m) { return m.exact.has_value(); }));
    all.resize(std::min(all.size(), std::clamp(known, fewest_results, most_results)));
    return all;
}

std::string difference(const Measured& m) {
    if (!m.exact) return "";
    const Real off = std::abs(m.value - *m.exact);
    if (*m.exact == 0) return steady_figure(off, m.probe->unit);
    return steady_figure(off / std::abs(*m.exact));
}

std::string figure(Real value, std::string_view unit) {
    return std::floor(value) == value && std::abs(value) < 1e4 ? format_quantity(value, unit) : steady_figure(value, unit);
}

std::string numbers_of(const LessonEntry& entry) {
    Runner runner(entry, {}, 0);
    advance(runner, runner.is_static() ? Until::at_rest() : Until::after_steps(entry.info.demo_steps));
    const std::string when =
        runner.is_static() ? "The scene that the lesson opens with, solved:"
                           : fmt::format("The scene that the lesson opens with, after {} steps, at t = {}:", runner.place().step,
                                         format_quantity(runner.time(), "s"));
    std::string text =
        fmt::format("{}\n\n| | measured | closed form | difference, relative | what it is |\n|---|---|---|---|---|\n", when);
    for (const Measured& m : key_numbers(runner))
        text += fmt::format("| `{}` | {} | {} | {} | {} |\n", m.probe->name, figure(m.value, m.probe->unit),
                            m.exact ? figure(*m.exact, m.probe->unit) : "", difference(m), cell(m.probe->help));
    return text + fmt::format("\n```\npliant run {}\n```\n", entry.info.id);
}

std::string claims_in(const LessonEntry& entry) {
    std::string text;
    for (const Claim* c : claims_of(entry.info.id)) {
        const ClaimResult result = measured(*c);
        text += fmt::format("- **{}, {}**: {}\n", c->id, outcome_of(result), c->statement);
        if (!result.finding) {
            text += fmt::format("  `pliant claims {}` measures it.\n", c->id);
            continue;
        }
        text += fmt::format("  Measured: {} ({}; asked for: {}). {}\n",
                            steady_figure(result.finding->figure, c->unit, rounding_of(*c)), c->figure, c->criterion,
                            result.finding->text);
        if (!result.finding->condition.empty()) text += fmt::format("  Condition: {}\n", result.finding->condition);
    }
    return text.empty() ? text : "\nWhat the lectures claim, [measured](../claims.md):\n\n" + text;
}

// ---------------------------------------------------------------------------------------------------------- extensions

// The options of `pliant run` that do what the first action does: "run 0.5 s". Empty for others.
std::string run_options(std::string_view action) {
    if (!action.starts_with("run ")) return "";
    action.remove_prefix(4);
    if (action == "rest") return " --rest";
    if (action.ends_with(" steps")) return fmt::format(" --steps {}", action.substr(0, action.size() - 6));
    if (action.ends_with(" s")) return fmt::format(" --time {}", action.substr(0, action.size() - 2));
    return "";
}

std::string extension_text(const LessonEntry& entry, const Extension& e) {
    std::string text = fmt::format("\n### {}\n", e.slide().title);
    std::string first_action;
    for (const Block& b : e.slide().blocks) {
        if (b.kind == BlockKind::text) text += fmt::format("\n{}\n", b.paragraph());
        if (b.kind == BlockKind::formula)
            for (const std::string_view part : parts_of(b.paragraph())) text += fmt::format("\n$$\n{}\n$$\n", latex(part));
        if (b.kind == BlockKind::ask) text += fmt::format("\n**{}**\n", b.paragraph());
        if (b.kind == BlockKind::actions && first_action.empty() && !b.lines.empty()) first_action = b.lines.front();
    }
    const std::string share = share_text(e.scene), options = run_options(first_action);
    text += fmt::format("\n```\n{}\n```\n",
                        options.empty() ? share : fmt::format("pliant run {} --scene {}{}", entry.info.id, share, options));
    text += "\n<details><summary>Answer</summary>\n";
    for (const Block& b : e.slide().blocks) {
        if (b.kind == BlockKind::answer) text += fmt::format("\n{}\n", b.paragraph());
        if (b.kind == BlockKind::actions) text += fmt::format("\nDone: `{}`\n", fmt::join(b.lines, "`, `"));
        if (b.kind == BlockKind::expect) text += fmt::format("\nChecked: `{}`\n", fmt::join(b.lines, "`, `"));
    }
    return text + "\n</details>\n";
}

std::string extensions_in(const LessonEntry& entry) {
    std::string text;
    for (const Extension& e : extensions_of(entry)) text += extension_text(entry, e);
    if (text.empty()) return text;
    return fmt::format(
               "\n## Possibilities for extensions\n\nCopy what begins with `pliant1:` and press Ctrl Shift V in the lab to open "
               "the scene, or run "
               "the whole line. `pliant walkthrough {} --check` checks the answers.\n",
               entry.info.id) +
           text;
}

std::string introduction_of(const LessonEntry& entry) {
    const Walkthrough w = walkthrough_of(entry);
    return fmt::format("\n## Why\n\n{}\n", fmt::join(w.introduction, "\n\n"));
}

}  // namespace

std::string lesson_markdown(const LessonEntry& entry, const std::string& sources) {
    const auto lesson = entry.make();
    std::string text = fmt::format("# {}\n\n`{}`. {}\n", entry.info.title, entry.info.id, entry.info.summary);
    text += fmt::format("\n<!-- Made by `pliant describe {} --markdown`; edit the lesson, not this page. -->\n", entry.info.id);
    text += introduction_of(entry);
    text += fmt::format("\n![{}](../pictures/lessons/{}.png)\n", entry.info.title, file_name(entry.info.id));
    text += stages_of(*lesson, sources);
    text += "\n## Results\n\n" + numbers_of(entry) + claims_in(entry);
    text += extensions_in(entry);
    return text + "\n## All that it declares\n" + describe_markdown(*lesson, entry.info.id);
}

}  // namespace pliant
