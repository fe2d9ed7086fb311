#include <pliant/lesson/setting_words.h>
#include <pliant/text/format.h>
#include <pliant/text/spoken.h>
#include <pliant/text/stored_file.h>

#include <fmt/format.h>

#include <filesystem>

namespace pliant {

std::string value_words(const Parameter& p, Real value) {
    switch (p.info.kind) {
        case Kind::choice:
            return fmt::format("“{}”", p.info.options.at(static_cast<std::size_t>(value)).label);
        case Kind::toggle:
            return value != 0 ? "on" : "off";
        case Kind::file:
            return value == 0 ? "none" : std::filesystem::path(stored_file(static_cast<Index>(value)).name).filename().string();
        case Kind::number:
        case Kind::whole:
            break;
    }
    return format_quantity(value, p.info.unit, 6);
}

std::string setting_words(const Parameter& p, Real value, std::string_view between) {
    return fmt::format("{} {}{}{}", spoken(p.info.key), between, between.empty() ? "" : " ", value_words(p, value));
}

std::string settings_words(const Lesson& lesson, const std::vector<std::pair<std::string, std::string>>& settings,
                           std::string_view between) {
    std::vector<std::string> parts;
    for (const auto& [key, text] : settings) {
        const Parameter& p = lesson.parameter(key);
        parts.push_back(setting_words(p, p.parse(text), between));
    }
    return listed_words(parts);
}

std::string range_words(const Interval& range, std::string_view unit) {
    // A unit that both have stands behind the second.
    std::string from = range.min == 0 ? "0" : format_quantity(range.min, unit, 6);
    const std::string to = format_quantity(range.max, unit, 6), behind = " " + unit_shown(range.max, unit, 6);
    if (behind.size() > 1 && from.ends_with(behind)) from.resize(from.size() - behind.size());
    return fmt::format("{}{} to {}{}", range.open_min ? "above " : "", from, range.open_max ? "below " : "", to);
}

std::string refusal_words(const Parameter& p, std::string_view refusal) {
    const std::string_view key = p.info.key;
    return std::string(refusal.starts_with(key) ? spoken(key) : "") +
           std::string(refusal.substr(refusal.starts_with(key) ? key.size() : 0));
}

std::string listed_words(const std::vector<std::string>& parts) {
    std::string text;
    for (std::size_t i = 0; i < parts.size(); ++i) text += (i == 0 ? "" : i + 1 < parts.size() ? ", " : " and ") + parts[i];
    return text;
}

}  // namespace pliant
