#include <pliant/math/error.h>
#include <pliant/math/watch.h>
#include <pliant/study/claims_report.h>
#include <pliant/text/format.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

// What a finding lacks, or "".
std::string objection(const Finding& f) {
    if (!std::isfinite(f.figure)) return fmt::format("its figure is {}, not a finite number", f.figure);
    if (f.text.empty()) return "its finding has no words";
    if (f.verdict == Verdict::qualified && f.condition.empty()) return "it is qualified, but by no condition";
    return "";
}

std::size_t count(std::span<const ClaimResult> results, std::string_view outcome) {
    std::size_t n = 0;
    for (const ClaimResult& r : results) n += outcome_of(r) == outcome;
    return n;
}

constexpr std::array<std::string_view, 4> outcomes{"reproduced", "qualified", "refuted", "failed"};

Json json_of(const ClaimResult& r) {
    const Claim& c = *r.claim;
    const Finding none;
    const Finding& f = r.finding ? *r.finding : none;
    Json j{{"id", c.id},
           {"lesson", c.lesson},
           {"statement", c.statement},
           {"source", c.source},
           {"experiment", c.experiment},
           {"figure", c.figure},
           {"value", r.finding ? Json(f.figure) : Json(nullptr)},
           {"unit", c.unit},
           {"criterion", c.criterion},
           {"verdict", outcome_of(r)},
           {"expected", name_of(c.expected)},
           {"finding", f.text},
           {"condition", f.condition},
           {"failure", r.failure},
           {"seconds", r.seconds},
           {"scene", Json::object()}};
    for (const auto& [key, value] : c.scene) j["scene"][key] = value;
    return j;
}

}  // namespace

bool ClaimResult::stands() const {
    return finding && finding->verdict != Verdict::refuted && finding->verdict == claim->expected;
}

ClaimResult measured(const Claim& claim) {
    ClaimResult result{.claim = &claim};
    const auto fail = [&](std::string_view why) {
        result.finding.reset();
        result.failure = fmt::format("{}: {}", claim.id, why);
    };
    const auto start = std::chrono::steady_clock::now();
    try {
        result.finding = claim.measure();
        if (const std::string wrong = objection(*result.finding); !wrong.empty()) fail(wrong);
    } catch (const Cancelled&) {
        throw;
    } catch (const Error& e) {
        fail(fmt::format("the experiment {}: {}", e.code() == ExitCode::diverged ? "diverged" : "was refused", e.what()));
    } catch (const std::exception& e) {
        fail(fmt::format("the experiment failed: {}", e.what()));
    }
    result.seconds = std::chrono::duration<Real>(std::chrono::steady_clock::now() - start).count();
    return result;
}

std::string_view outcome_of(const ClaimResult& r) { return r.finding ? name_of(r.finding->verdict) : "failed"; }

std::string figure_text(const ClaimResult& r) { return r.finding ? format_quantity(r.finding->figure, r.claim->unit, 3) : ""; }

std::string steady_figure(Real value, std::string_view unit, Real rounding) {
    if (!(std::abs(value) < rounding)) return format_quantity(value, unit, 3);
    const std::string power = format_quantity(rounding, "", 1);
    return unit.empty() ? fmt::format("below {}", power) : fmt::format("below {} {}", power, unit);
}

Real rounding_of(const Claim& claim) {
    constexpr Real usual = 1e-9;
    constexpr std::string_view at_most = "≤ 10⁻";
    if (!claim.criterion.starts_with(at_most)) return usual;
    constexpr std::array<std::string_view, 10> raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string_view rest = std::string_view(claim.criterion).substr(at_most.size());
    int power = 0;
    for (bool digit = true; digit;) {
        digit = false;
        for (std::size_t d = 0; d < raised.size(); ++d) {
            if (!rest.starts_with(raised[d])) continue;
            power = 10 * power + static_cast<int>(d);
            rest.remove_prefix(raised[d].size());
            digit = true;
            break;
        }
    }
    return std::min(usual, std::pow(Real{10}, -power));
}

std::string claims_json(std::span<const ClaimResult> results) {
    Json j{{"claims", Json::array()}};
    for (const ClaimResult& r : results) j["claims"].push_back(json_of(r));
    for (const std::string_view outcome : outcomes) j[std::string(outcome)] = count(results, outcome);
    return j.dump(2) + "\n";
}

std::string claims_tail(std::span<const ClaimResult> results) {
    Real seconds = 0;
    for (const ClaimResult& r : results) seconds += r.seconds;
    std::string text = fmt::format("{} {}: ", results.size(), results.size() == 1 ? "claim" : "claims");
    for (const std::string_view outcome : outcomes)
        if (const std::size_t n = count(results, outcome); n > 0 || outcome == "reproduced")
            text += fmt::format("{} {}, ", n, outcome);
    return text + fmt::format("in {}\n", format_quantity(seconds, "s", 2));
}

std::string fallen(std::span<const ClaimResult> results) {
    std::string text;
    for (const ClaimResult& r : results) {
        if (r.stands()) continue;
        const std::string why =
            !r.finding ? r.failure
            : r.finding->verdict == r.claim->expected
                ? fmt::format("{} is {}", r.claim->id, outcome_of(r))
                : fmt::format("{} is {}, where {} was expected", r.claim->id, outcome_of(r), name_of(r.claim->expected));
        text += fmt::format("{}{}", text.empty() ? "" : "; ", why);
    }
    return text;
}

}  // namespace pliant
