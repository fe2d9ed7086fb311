#include <pliant/document/walkthrough_sentences.h>
#include <pliant/document/walkthrough_words.h>
#include <pliant/lesson/setting_words.h>
#include <pliant/text/format.h>
#include <pliant/text/spoken.h>

#include <fmt/format.h>

#include <algorithm>
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

std::string expectation_sentence(const Lesson& lesson, const ExpectedNumber& e) {
    const Named named = named_number(lesson, e.name);
    const auto [left, right] = told_apart(e.left, e.right, named.unit);
    const std::string what = e.what.empty() ? "" : fmt::format(", {}", e.what);
    if (e.comparison != "=")
        return fmt::format("the {} is {}, expected {} {}{}", named.name, left, comparison_said(e.comparison), right, what);
    const std::string tolerance =
        e.relative ? fmt::format("{} %", format_quantity(100 * e.tolerance, "", 3)) : format_quantity(e.tolerance, named.unit, 3);
    return fmt::format("the {} is {}, expected {}{}, within {}", named.name, left, right, what, tolerance);
}

}  // namespace pliant
