// Claims measured now: what came out, as a table for people, as JSON for programs, and as the page of the documentation.
#pragma once
#include <pliant/study/claims.h>

#include <optional>
#include <span>

namespace pliant {

struct ClaimResult {
    const Claim* claim = nullptr;
    std::optional<Finding> finding{};  // empty when the experiment could not be made
    std::string failure{};             // why not, beginning with the id of the claim
    Real seconds = 0;                  // wall time of the experiment

    // Not refuted, and with the verdict that the claim expects.
    bool stands() const;
};

// Makes the experiment. Whatever it throws becomes a failure and never a verdict; so do a figure that is not finite, a finding
// without words, and a qualified verdict without its condition. Throws Cancelled when a Watch calls it off.
ClaimResult measured(const Claim& claim);

// "reproduced", "qualified", "refuted", or "failed" without a finding.
std::string_view outcome_of(const ClaimResult& result);
// "1.2×10⁻¹²", "412 kPa"; "" without a finding.
std::string figure_text(const ClaimResult& result);
// The same for generated pages, which any compiler has to make alike: three digits, and "below 10⁻⁹" for what is rounding, or
// below another power of ten. Findings use it for errors at that level.
std::string steady_figure(Real value, std::string_view unit = "", Real rounding = 1e-9);
// What is rounding for this claim: 10⁻⁹, or less where its criterion begins with a finer power, as in "≤ 10⁻¹²".
Real rounding_of(const Claim& claim);

// A table of 100 columns. Rows may be printed as they are measured: head, rows, tail.
std::string claims_head();
std::string claims_row(const ClaimResult& result);
std::string claims_tail(std::span<const ClaimResult> results);  // the counts
std::string claims_text(std::span<const ClaimResult> results);

// {"claims": [{"id", "lesson", "statement", "source", "experiment", "figure", "value", "unit", "criterion", "verdict",
// "expected", "finding", "condition", "failure", "seconds", "scene": {...}}], "reproduced", "qualified", "refuted",
// "failed"}
std::string claims_json(std::span<const ClaimResult> results);

// docs/claims.md.
std::string claims_markdown(std::span<const ClaimResult> results);

// The claims that do not stand, in a sentence; "" when all do.
std::string fallen(std::span<const ClaimResult> results);

}  // namespace pliant
