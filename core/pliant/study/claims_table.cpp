// The table that `pliant claims` prints.
#include <pliant/lesson/flowing_lines.h>
#include <pliant/study/claims_report.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pliant {
namespace {

constexpr std::size_t line_width = 100, gap = 2, indent = 7;
// Of claim, statement, figure, criterion, verdict.
constexpr std::array<std::size_t, 5> widths{5, 42, 17, 18, 10};
using Row = std::array<std::string, 5>;

std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
    return flowing_lines(text, static_cast<double>(width), columns_of);
}

std::string row_text(const Row& row) {
    std::array<std::vector<std::string>, 5> cells;
    std::size_t height = 1;
    for (std::size_t c = 0; c < row.size(); ++c) {
        cells[c] = wrapped(row[c], widths[c]);
        height = std::max(height, cells[c].size());
    }
    std::string text;
    for (std::size_t line = 0; line < height; ++line) {
        std::string whole;
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string part = line < cells[c].size() ? cells[c][line] : "";
            const std::size_t room = widths[c] + gap, taken = static_cast<std::size_t>(columns_of(part));
            whole += part + std::string(room > taken ? room - taken : 1, ' ');
        }
        whole.erase(whole.find_last_not_of(' ') + 1);
        text += whole + "\n";
    }
    return text;
}

std::string paragraph(const std::string& words) {
    std::string text;
    for (const std::string& line : wrapped(words, line_width - indent)) text += fmt::format("{:{}}{}\n", "", indent, line);
    return text;
}

}  // namespace

std::string claims_head() { return row_text({"claim", "statement", "figure", "criterion", "verdict"}) + "\n"; }

std::string claims_row(const ClaimResult& r) {
    const Claim& c = *r.claim;
    std::string text = row_text(
        {std::string(c.id), std::string(c.statement), figure_text(r), std::string(c.criterion), std::string(outcome_of(r))});
    if (!r.failure.empty()) text += paragraph(r.failure);
    if (r.finding) {
        text += paragraph(fmt::format("Figure: {}.", c.figure));
        text += paragraph(r.finding->text);
        if (!r.finding->condition.empty()) text += paragraph(fmt::format("Condition: {}", r.finding->condition));
        if (r.finding->verdict != c.expected) text += paragraph(fmt::format("Expected: {}.", name_of(c.expected)));
    }
    return text + "\n";
}

std::string claims_text(std::span<const ClaimResult> results) {
    std::string text = claims_head();
    for (const ClaimResult& r : results) text += claims_row(r);
    return text + claims_tail(results);
}

}  // namespace pliant
