#include <pliant/document/action_words.h>
#include <pliant/document/summary.h>
#include <pliant/document/walkthrough_words.h>
#include <pliant/text/format.h>
#include <pliant/text/number_text.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <vector>

namespace pliant {
namespace {

using Words = std::vector<std::string>;

std::string value_words(const Parameter& p, const std::string& text) {
    const Real value = p.parse(text);
    switch (p.info.kind) {
        case Kind::choice:
            return std::string(p.info.options[static_cast<std::size_t>(value)].label);
        case Kind::toggle:
            return value != 0 ? "on" : "off";
        default:
            return format_quantity(value, p.info.unit);
    }
}

std::string settings_words(const Words& words, const Lesson& lesson) {
    std::vector<std::string> parts;
    for (const auto& [key, text] : assignments_of(words)) {
        const Parameter& p = lesson.parameter(key);
        parts.push_back(fmt::format("{} to {}", spoken(p.info.key), value_words(p, text)));
    }
    if (parts.size() < 2) return fmt::format("Set {}", parts.empty() ? "" : parts[0]);
    const std::string last = parts.back();
    parts.pop_back();
    return fmt::format("Set {} and {}", fmt::join(parts, ", "), last);
}

std::string run_words(const Words& words) {
    if (words.size() == 2 && words[1] == "rest") return "Run until nothing changes any more";
    if (words.size() == 3 && words[1] == "to") return fmt::format("Run to the end of the stage {}", spoken(words[2]));
    if (words.size() == 3 && words[2] == "s")
        if (const auto seconds = finite_number(words[1])) return fmt::format("Run {}", format_quantity(*seconds, "s"));
    if (words.size() == 3 && words[2].starts_with("step"))
        return fmt::format("Run {} {}", words[1], words[1] == "1" ? "step" : "steps");
    return "";
}

std::string known_action(const Words& words, const Lesson& lesson) {
    const bool two = words.size() == 2;
    if (words[0] == "set" && words.size() > 1) return settings_words(words, lesson);
    if (words[0] == "run") return run_words(words);
    if (words[0] == "reset") return "Start again";
    if (words[0] == "release") return "Let go";
    if (words[0] == "show" && two) return fmt::format("Show the {}", spoken(words[1]));
    if (words[0] == "preset" && two) return fmt::format("Open the scene {}", spoken(words[1]));
    if (words[0] == "pull" && words.size() == 6)
        return fmt::format("Pull node {} to ({}, {}, {}) m", words[1], words[3], words[4], words[5]);
    return "";
}

std::string unit_of_quantity(const std::string& name, const Lesson& lesson) {
    if (name == "time") return "s";
    if (name == "step") return "";
    const auto parameter = std::ranges::find(lesson.parameters, name, [](const Parameter* p) { return p->info.key; });
    return std::string(parameter != lesson.parameters.end() ? (*parameter)->info.unit : lesson.probe(name).unit);
}

}  // namespace

std::string action_words(const std::string& line, const Lesson& lesson) {
    const Words words = words_of_line(line);
    if (words.empty()) return line;
    try {
        const std::string known = known_action(words, lesson);
        return known.empty() ? line : known;
    } catch (const Refused&) {
        return line;  // told when it is done
    }
}

std::string expectation_words(const std::string& line, const Lesson& lesson) {
    Words words = words_of_line(line);
    if (words.size() < 3) return line;
    try {
        const std::string unit = unit_of_quantity(words[0], lesson);
        std::string factor, term;
        std::size_t at = 2;
        const auto first = finite_number(words[at]);
        if (first && at + 1 < words.size() && words[at + 1] != "within") factor = format_quantity(*first, "") + " times ", ++at;
        const std::string& word = words[at++];
        if (const auto number = finite_number(word))
            term = format_quantity(*number, unit);
        else
            term = word == "exact" ? "the exact value" : word == "before" ? "its value before" : spoken(word);
        std::string text = fmt::format("{} {} {}{}", spoken(words[0]), words[1], factor, term);
        if (at + 1 >= words.size()) return text;
        const bool relative = at + 2 < words.size();
        const Real tolerance = finite_number(words[at + 1]).value_or(0);
        if (tolerance == 0) return text;
        return text + (relative ? fmt::format(", to {} %", format_quantity(100 * tolerance, ""))
                                : fmt::format(" ± {}", format_quantity(tolerance, unit)));
    } catch (const Refused&) {
        return line;
    }
}

}  // namespace pliant
