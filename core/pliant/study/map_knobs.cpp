#include <pliant/study/map_knobs.h>
#include <pliant/text/format.h>
#include <pliant/text/number_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace pliant {
namespace {

constexpr std::string_view forms = "give KEY=FROM:TO:COUNT, KEY=FROM:TO:COUNT:log or KEY=VALUE,VALUE,...";

std::vector<std::string> split(std::string_view text, char at) {
    std::vector<std::string> parts{""};
    for (const char c : text) c == at ? parts.emplace_back() : (parts.back() += c, parts.back());
    return parts;
}

bool is_named(const Parameter& p) { return p.info.has_options(); }

void check_count(std::string_view key, Index count) {
    if (count < 2 || count > most_knob_values)
        throw Refused(fmt::format("{} takes {} value{}: give 2 to {}", key, count, count == 1 ? "" : "s", most_knob_values));
}

Index count_of(std::string_view key, const std::string& text) {
    const auto count = whole_number(text);
    if (!count)
        throw Refused(
            fmt::format("{}: '{}' is no number of values: give a whole number from 2 to {}", key, text, most_knob_values));
    return *count;
}

}  // namespace

Knob knob_of(const Parameter& p, Real a, Real b, Index count, Spacing spacing) {
    const std::string_view key = p.info.key;
    if (is_named(p))
        throw Refused(
            fmt::format("{} has options, not a range: list them, such as {}={}", key, key, p.text(0) + "," + p.text(1)));
    check_count(key, count);
    p.check(a), p.check(b);
    if (!(a < b)) throw Refused(fmt::format("{} from {} to {} is no range: give the lower end first", key, p.text(a), p.text(b)));
    if (spacing == Spacing::log && !(a > 0))
        throw Refused(
            fmt::format("{} from {} cannot be spaced logarithmically: give a range above 0, or leave out :log", key, p.text(a)));
    Knob knob{std::string(key), spacing, {}};
    for (Index i = 0; i < count; ++i) {
        const Real s = static_cast<Real>(i) / static_cast<Real>(count - 1);
        Real value = spacing == Spacing::log ? a * std::pow(b / a, s) : a + s * (b - a);
        if (p.info.kind == Kind::whole) value = std::round(value);
        knob.values.push_back(i == 0 ? a : i == count - 1 ? b : value);
    }
    if (std::ranges::adjacent_find(knob.values, std::greater_equal{}) != knob.values.end())
        throw Refused(fmt::format("{} from {} to {} has no {} different values: give fewer", key, p.text(a), p.text(b), count));
    return knob;
}

Knob knob_of(const Parameter& p, std::vector<Real> values) {
    check_count(p.info.key, static_cast<Index>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
        p.check(values[i]);
        if (std::find(values.begin(), values.begin() + static_cast<Index>(i), values[i]) !=
            values.begin() + static_cast<Index>(i))
            throw Refused(fmt::format("{} = {} is listed twice: name each value once", p.info.key, p.text(values[i])));
    }
    return {std::string(p.info.key), Spacing::list, std::move(values)};
}

Knob parse_knob(const Lesson& lesson, std::string_view text) {
    const auto equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0) throw Refused(fmt::format("--map {} is no knob: {}", text, forms));
    const Parameter& p = lesson.parameter(text.substr(0, equals));
    const std::string_view range = text.substr(equals + 1);
    if (range.find(':') == std::string_view::npos) {
        std::vector<Real> values;
        for (const std::string& word : split(range, ',')) values.push_back(p.parse(word));
        return knob_of(p, std::move(values));
    }
    const auto parts = split(range, ':');
    if (parts.size() < 3 || parts.size() > 4) throw Refused(fmt::format("--map {} is no range: {}", text, forms));
    if (parts.size() == 4 && parts[3] != "log")
        throw Refused(fmt::format("--map {}: '{}' is no spacing: give log, or nothing for equal steps", text, parts[3]));
    if (is_named(p)) return knob_of(p, 0, 1, 2, Spacing::linear);
    const Real a = p.parse(parts[0]), b = p.parse(parts[1]);
    return knob_of(p, a, b, count_of(p.info.key, parts[2]), parts.size() == 4 ? Spacing::log : Spacing::linear);
}

std::string text_of(const Lesson& lesson, const Knob& knob) {
    const Parameter& p = lesson.parameter(knob.key);
    if (knob.spacing != Spacing::list)
        return fmt::format("{}={}:{}:{}{}", knob.key, p.text(knob.values.front()), p.text(knob.values.back()), knob.values.size(),
                           knob.spacing == Spacing::log ? ":log" : "");
    std::string text = knob.key;
    for (std::size_t i = 0; i < knob.values.size(); ++i) text += (i ? "," : "=") + p.text(knob.values[i]);
    return text;
}

Knob useful_knob(const Parameter& p, Index count) {
    const Interval& range = p.info.useful;
    if (is_named(p)) {
        std::vector<Real> options;
        for (Real k = 0; k <= range.max; ++k) options.push_back(k);
        return knob_of(p, std::move(options));
    }
    const bool log = p.info.scale == Scale::log && range.min > 0;
    // An end that the range leaves open is not accepted.
    const Real inset = (range.max - range.min) / static_cast<Real>(count);
    const Real a = p.accepted().contains(range.min) ? range.min : range.min + inset,
               b = p.accepted().contains(range.max) ? range.max : range.max - inset;
    if (p.info.kind == Kind::whole) {
        const auto whole = static_cast<Index>(b - a) + 1;
        if (whole <= count || !log) return knob_of(p, a, b, std::min(count, whole), Spacing::linear);
        return knob_of(p, a, b, count, Spacing::linear);
    }
    return knob_of(p, a, b, count, log ? Spacing::log : Spacing::linear);
}

bool can_be_knob(const Parameter& p) { return p.used() && p.info.useful.max > p.info.useful.min; }

std::pair<const Parameter*, const Parameter*> first_knobs(const Lesson& lesson) {
    std::vector<const Parameter*> chosen;
    const auto take = [&](const Parameter& p) {
        if (chosen.size() < 2 && can_be_knob(p) && std::ranges::find(chosen, &p) == chosen.end()) chosen.push_back(&p);
    };
    for (const std::string_view key : lesson.map_knobs()) take(lesson.parameter(key));
    constexpr std::array<std::string_view, 6> likely{"time_step",        "omega",         "stiffness", "k_structural",
                                                     "spring_stiffness", "youngs_modulus"};
    for (const std::string_view key : likely)
        for (const Parameter* p : lesson.parameters)
            if (p->info.key == key) take(*p);
    for (const Parameter* p : lesson.parameters)
        if (p->info.kind == Kind::number && p->info.scale == Scale::log) take(*p);
    for (const Parameter* p : lesson.parameters)
        if (p->info.kind == Kind::number) take(*p);
    if (chosen.size() < 2) throw Refused("this lesson has no two parameters that a map could span");
    return {chosen[0], chosen[1]};
}

}  // namespace pliant
