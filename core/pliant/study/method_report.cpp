// What a comparison of methods says, for people and as JSON.
#include <pliant/document/summary.h>
#include <pliant/study/method_comparison.h>
#include <pliant/text/format.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

std::string error_words(const MethodRun& r) {
    if (!r.error) return "–";
    return *r.error < 1e-4 ? format_quantity(*r.error, "", 2) : fmt::format("{} %", format_quantity(100 * *r.error, "", 3));
}

// Columns count letters, of which some take more than one byte.
std::size_t letters(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}
std::string padded(const std::string& text, std::size_t width) {
    return text + std::string(width > letters(text) ? width - letters(text) : 0, ' ');
}

Json number_json(const std::optional<Real>& value) { return value && std::isfinite(*value) ? Json(*value) : Json(nullptr); }

}  // namespace

std::string comparison_text(const MethodComparison& c) {
    std::string text = fmt::format("{}: every {} of the scene, {} {} each\n", c.lesson, spoken(c.parameter), c.steps,
                                   c.steps == 1 ? "step" : "steps");
    text += !c.no_error.empty()
                ? c.no_error + "\n"
                : fmt::format("Errors are those of the {} at the end, against {}.\n", spoken(c.probe), c.reference);
    std::vector<std::vector<std::string>> rows{{"method", "", spoken(c.probe), "error", "passes", "time taken"}};
    for (const MethodRun& r : c.runs)
        rows.push_back({r.label, std::string(name_of(r.outcome)), r.value ? format_quantity(*r.value, c.unit, 4) : "–",
                        error_words(r), r.ran() ? fmt::format("{}", r.passes) : "–",
                        r.ran() ? format_quantity(r.ms / 1000, "s", 3) : "–"});
    std::vector<std::size_t> widths(rows[0].size(), 0);
    for (const auto& row : rows)
        for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], letters(row[k]));
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t k = 0; k < row.size(); ++k) line += padded(row[k], widths[k] + 2);
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    for (const MethodRun& r : c.runs)
        if (r.outcome == MethodRun::Outcome::stopped || r.outcome == MethodRun::Outcome::refused)
            text += fmt::format("{}: {}\n", r.label, r.words);
    return text;
}

std::string comparison_json(const MethodComparison& c) {
    Json j{{"lesson", c.lesson},       {"parameter", c.parameter}, {"probe", c.probe}, {"unit", c.unit},
           {"reference", c.reference}, {"no_error", c.no_error},   {"steps", c.steps}, {"methods", Json::array()}};
    for (const MethodRun& r : c.runs)
        j["methods"].push_back({{"option", r.option},
                                {"label", r.label},
                                {"outcome", name_of(r.outcome)},
                                {"words", r.words},
                                {"steps", r.steps},
                                {"time", r.time},
                                {"value", number_json(r.value)},
                                {"error", number_json(r.error)},
                                {"passes", r.passes},
                                {"ms", r.ms}});
    return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace pliant
