#include <pliant/math/error.h>
#include <pliant/study/claims.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <tuple>

namespace pliant {
namespace {

constexpr std::string_view chapters = "EIMPRF";

std::vector<Claim>& registered() {
    static std::vector<Claim> all;
    return all;
}

// Place of a claim in the order of the lectures.
std::tuple<std::size_t, int> place_of(const Claim& c) {
    int number = 0;
    std::from_chars(c.id.data() + 1, c.id.data() + c.id.size(), number);
    return {chapters.find(c.id.front()), number};
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
