#include <pliant/math/error.h>
#include <pliant/study/claims.h>
#include <pliant/study/claims_reader.h>
#include <pliant/text/texts.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <iterator>
#include <tuple>
#include <utility>

namespace pliant {
namespace {

struct Chapter {
    char letter;
    std::string_view title;
};
constexpr std::array<Chapter, 6> chapters{{{'E', "Elasticity"},
                                           {'I', "Time integration"},
                                           {'M', "Mesh-based Lagrangian methods"},
                                           {'P', "Mesh-free Lagrangian methods"},
                                           {'R', "Reduced models"},
                                           {'F', "Eulerian and hybrid fluids"}}};

const Chapter* chapter_with(char letter) { return std::ranges::find(chapters, letter, &Chapter::letter); }

ClaimMeasures& registered() {
    static ClaimMeasures all;
    return all;
}

ClaimTexts embedded() {
    ClaimTexts texts;
    for (const std::string_view path : texts_called("claims.md"))
        texts.emplace_back(path.substr(0, path.size() - std::string_view("/claims.md").size()), find_text(path));
    return texts;
}

// A claim in the order of the lectures: the place of its chapter, and its number. Throws Refused.
std::tuple<const Chapter*, int> place_of(const Claim& c) {
    int number = 0;
    const char* end = c.id.data() + c.id.size();
    const Chapter* chapter = c.id.empty() ? chapters.end() : chapter_with(c.id.front());
    if (chapter == chapters.end() || std::from_chars(c.id.data() + 1, end, number).ptr != end || number < 1)
        throw Refused(fmt::format("{}/claims.md: '{}' is no id of a claim: give the letter of a chapter ({}) and a number",
                                  c.lesson, c.id, "E, I, M, P, R, F"));
    return {chapter, number};
}

bool same_id(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, [](char x, char y) {
        return std::toupper(static_cast<unsigned char>(x)) == std::toupper(static_cast<unsigned char>(y));
    });
}

}  // namespace

std::string_view name_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::reproduced:
            return "reproduced";
        case Verdict::qualified:
            return "qualified";
        case Verdict::refuted:
            return "refuted";
    }
    return "";
}

std::vector<Claim> joined_claims(const ClaimTexts& texts, const ClaimMeasures& measures) {
    std::vector<Claim> all;
    for (const auto& [lesson, text] : texts)
        for (Claim& c : read_claims(text, lesson)) {
            const auto place = place_of(c);
            const auto next = std::ranges::upper_bound(all, place, {}, place_of);
            if (next != all.begin() && place_of(*std::prev(next)) == place)
                throw Refused(
                    fmt::format("{}/claims.md and {}/claims.md: both have a claim {}", std::prev(next)->lesson, lesson, c.id));
            all.insert(next, std::move(c));
        }
    for (const auto& [id, measure] : measures) {
        const auto found = std::ranges::find(all, id, &Claim::id);
        if (found == all.end())
            throw Refused(fmt::format("{} is measured, but has no words: give '## {}' in the claims.md of its lesson", id, id));
        if (found->measure) throw Refused(fmt::format("{} is measured by two functions: register one", id));
        found->measure = measure;
    }
    for (const Claim& c : all)
        if (!c.measure)
            throw Refused(
                fmt::format("{}/claims.md: nothing measures {}: register a ClaimRegistration beside the lesson", c.lesson, c.id));
    return all;
}

ClaimRegistration::ClaimRegistration(std::string_view id, std::function<Finding()> measure) {
    registered().emplace_back(id, std::move(measure));
}

const std::vector<Claim>& claims() {
    static const std::vector<Claim> all = joined_claims(embedded(), registered());
    return all;
}

std::vector<const Claim*> claims_of(std::string_view lesson) {
    std::vector<const Claim*> found;
    for (const Claim& c : claims())
        if (c.lesson == lesson) found.push_back(&c);
    return found;
}

std::string_view chapter_of(const Claim& claim) {
    const Chapter* found = chapter_with(claim.id.front());
    return found == chapters.end() ? "" : found->title;
}

const Claim& find_claim(std::string_view id) {
    const auto& all = claims();
    const auto found = std::ranges::find_if(all, [id](const Claim& c) { return same_id(c.id, id); });
    if (found != all.end()) return *found;
    std::string known;
    for (const Claim& c : all) known += fmt::format("{}{}", known.empty() ? "" : ", ", c.id);
    throw Refused(fmt::format("no claim is called '{}'; there are: {}", id, known));
}

}  // namespace pliant
