#include <pliant/math/error.h>
#include <pliant/study/claims.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <tuple>

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

std::vector<Claim>& registered() {
    static std::vector<Claim> all;
    return all;
}

// Place of a claim in the order of the lectures.
std::tuple<const Chapter*, int> place_of(const Claim& c) {
    int number = 0;
    std::from_chars(c.id.data() + 1, c.id.data() + c.id.size(), number);
    return {chapter_with(c.id.front()), number};
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

const std::vector<Claim>& claims() { return registered(); }

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

void register_claim(const Claim& claim) {
    auto& all = registered();
    all.insert(std::ranges::upper_bound(all, place_of(claim), {}, place_of), claim);
}

}  // namespace pliant
