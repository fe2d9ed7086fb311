// `pliant handin`: what a student handed in, read and checked.
#include <pliant/document/hand_in.h>
#include <pliant/study/claims.h>
#include <pliant/study/claims_report.h>
#include <pliant/text/file.h>

#include "command_line/options.h"
#include "command_line/terminal.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace pliant::viewer {

namespace {

// What was predicted of a claim: it is measured again.
std::optional<HandInFinding> repeated_claim(const HandInEntry& e) {
    constexpr std::string_view mark = "claim ";
    if (!e.slide.starts_with(mark)) return std::nullopt;
    const Claim& claim = find_claim(std::string_view(e.slide).substr(mark.size()));
    const ClaimResult result = measured(claim);
    const std::string where = fmt::format("prediction, {}, {}", e.lesson, e.slide), came = figure_text(result);
    if (!result.finding) return HandInFinding{true, false, fmt::format("{}: {}", where, result.failure)};
    const std::string& right = claim.answers.at(static_cast<std::size_t>(claim.right_answer));
    return HandInFinding{true, (e.predicted == right) == e.right,
                         fmt::format("{}: “{}” was predicted; measured again, {} is {}, and “{}” is right", where, e.predicted,
                                     claim.figure, came, right)};
}

}  // namespace

int hand_in(const std::string& path, bool json) {
    const HandInRead read = read_hand_in(read_file(path), path);
    const auto findings = check_hand_in(read.hand_in, repeated_claim);
    print(json ? hand_in_report_json(read, findings) : hand_in_report(read, findings));
    const bool holds = read.unchanged && std::ranges::all_of(findings, &HandInFinding::holds);
    return holds ? 0 : static_cast<int>(ExitCode::check_failed);
}

}  // namespace pliant::viewer
