#include <pliant/document/walkthrough_sentences.h>
#include <pliant/document/walkthrough_words.h>
#include <pliant/lesson/setting_words.h>
#include <pliant/text/format.h>
#include <pliant/text/spoken.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace pliant {
namespace {

std::string settings_said(const Lesson& lesson, const std::vector<std::string>& words, const Hides& hidden) {
    std::vector<std::string> parts;
    for (const auto& [key, text] : assignments_of(words)) {
        const Parameter& p = lesson.parameter(key);
        const bool covered = hidden && hidden(p.info.key);
        parts.push_back(covered ? fmt::format("{} to ?", spoken(p.info.key)) : setting_words(p, p.parse(text), "to"));
    }
    return "set " + listed_words(parts);
}

std::string run_said(const std::vector<std::string>& words) {
    if (words.size() == 2) return "run until nothing changes any more";
    if (words.size() == 3 && words[1] == "to") return fmt::format("run to the end of the stage “{}”", spoken(words[2]));
    if (words.size() == 3 && words[2] == "s") return fmt::format("run {} s of simulated time", words[1]);
    return fmt::format("run {} {}", words[1], words[1] == "1" ? "step" : "steps");
}

std::string said(const Lesson& lesson, const std::vector<std::string>& words, const Hides& hidden) {
    const std::string& verb = words.at(0);
    if (verb == "set") return settings_said(lesson, words, hidden);
    if (verb == "solve") return "solve it";
    if (verb == "reset") return "start again";
    if (verb == "run" && words.size() > 1) return run_said(words);
    if (verb == "release") return "let go";
    if (verb == "show") return fmt::format("colour by {}", spoken(words.at(1)));
    if (verb == "preset") return fmt::format("open the scene “{}”", spoken(words.at(1)));
    if (verb == "pull")
        return fmt::format("pull {} {} to ({}, {}, {}) m", name_of(lesson.can_pull().value_or(On::node)), words.at(1),
                           words.at(3), words.at(4), words.at(5));
    return fmt::format("{}", fmt::join(words, " "));
}

struct Named {
    std::string name, unit;
};

Named named_number(const Lesson& lesson, std::string_view name) {
    if (name == "time") return {"time", "s"};
    if (name == "step") return {"step", ""};
    for (const Parameter* p : lesson.parameters)
        if (p->info.is_called(name)) return {spoken(p->info.key), std::string(p->info.unit)};
    const Probe& probe = lesson.probe(name);
    return {spoken(probe.name), std::string(probe.unit)};
}

// With as many digits as it takes to tell two numbers apart that are not the same.
std::pair<std::string, std::string> told_apart(Real a, Real b, std::string_view unit) {
    std::pair<std::string, std::string> texts;
    for (const int digits : {3, 4, 5, 6, 8, 12}) {
        texts = {format_quantity(a, unit, digits), format_quantity(b, unit, digits)};
        if (texts.first != texts.second || a == b) break;
    }
    return texts;
}

std::string_view comparison_said(std::string_view sign) {
    return sign == "<" ? "below" : sign == "<=" ? "at most" : sign == ">" ? "above" : "at least";
}

}  // namespace

std::string action_sentence(const Lesson& lesson, const std::string& line, const Hides& hidden) {
    const auto words = words_of_line(line);
    if (words.empty()) return "";
    try {
        return said(lesson, words, hidden);
    } catch (const std::exception&) {
        return line;
    }
}

namespace {

// The verb of an action: as the first of the sentence, and behind others.
struct Verb {
    std::string_view action, first, later;
};
constexpr std::array verbs{Verb{"set", "sets it", "sets it"},
                           Verb{"preset", "opens another scene", "opens another scene"},
                           Verb{"reset", "starts again", "starts again"},
                           Verb{"run", "runs it", "runs"},
                           Verb{"solve", "solves it", "solves it"},
                           Verb{"pull", "pulls at it", "pulls at it"},
                           Verb{"release", "lets go", "lets go"},
                           Verb{"show", "shows another field", "shows another field"}};

// In the order in which they happen first. What starts again before it runs is not worth a word, nor is a field that is shown
// on the way.
std::string kinds_said(const std::vector<std::string>& lines) {
    std::vector<const Verb*> kinds;
    for (const std::string& line : lines) {
        const auto verb = std::ranges::find(verbs, words_of_line(line).at(0), &Verb::action);
        if (verb != verbs.end() && std::ranges::find(kinds, verb) == kinds.end()) kinds.push_back(verb);
    }
    const auto by_the_way = [](const Verb* v) { return v->action == "show" || v->action == "reset"; };
    if (!std::ranges::all_of(kinds, by_the_way)) std::erase_if(kinds, by_the_way);
    std::vector<std::string> parts;
    for (const Verb* v : kinds) parts.emplace_back(parts.empty() ? v->first : v->later);
    return listed_words(parts);
}

// The actions that wait for Next.
std::vector<std::string> waiting_lines(const Slide& slide) {
    std::vector<std::string> lines;
    SetUp set_up;
    for (const Block& b : slide.blocks) {
        if (b.kind == BlockKind::expect) set_up.end();
        if (b.kind != BlockKind::actions) continue;
        for (const std::string& raw : b.lines)
            if (const std::string line = trimmed(raw); !line.empty() && !set_up.takes(line)) lines.push_back(line);
    }
    return lines;
}

}  // namespace

std::string next_sentence(const Lesson& lesson, const Slide& slide) {
    const std::vector<std::string> lines = waiting_lines(slide);
    if (lines.empty()) return "";
    if (slide.has(BlockKind::ask)) return fmt::format("Next: {}", kinds_said(lines));
    std::vector<std::string> said_in_full;
    for (const std::string& line : lines)
        said_in_full.push_back(action_sentence(lesson, line, [&](std::string_view key) { return slide.hides(key); }));
    return fmt::format("Next: {}", fmt::join(said_in_full, "; "));
}

std::string expectation_sentence(const Lesson& lesson, const ExpectedNumber& e) {
    const Named named = named_number(lesson, e.name);
    const auto [left, right] = told_apart(e.left, e.right, named.unit);
    const std::string what = e.what.empty() ? "" : fmt::format(", {}", e.what);
    if (e.comparison != "=")
        return fmt::format("the {} {} {}, expected {} {}{}", named.name, is_or_are(named.name), left,
                           comparison_said(e.comparison), right, what);
    const std::string tolerance =
        e.relative ? fmt::format("{} %", format_quantity(100 * e.tolerance, "", 3)) : format_quantity(e.tolerance, named.unit, 3);
    return fmt::format("the {} {} {}, expected {}{}, within {}", named.name, is_or_are(named.name), left, right, what, tolerance);
}

}  // namespace pliant
