// Whether two generated pages say the same: numbers differ from compiler to compiler in their last digits.
#pragma once
#include <pliant/math/types.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace pliant::test {

// A page as words and numbers in turn.
struct Piece {
    std::string words;
    Real number = 0;
};

// "3.2×10⁻¹³" as "3.2e-13", "10⁻⁹" as "1e-9".
inline std::string plain_numbers(std::string text) {
    const std::vector<std::pair<std::string, std::string>> raised{{"⁻", "-"}, {"⁰", "0"}, {"¹", "1"}, {"²", "2"},
                                                                  {"³", "3"}, {"⁴", "4"}, {"⁵", "5"}, {"⁶", "6"},
                                                                  {"⁷", "7"}, {"⁸", "8"}, {"⁹", "9"}};
    static const std::regex power(R"((\d)×10((?:⁻|⁰|¹|²|³|⁴|⁵|⁶|⁷|⁸|⁹)+)|\b10((?:⁻|⁰|¹|²|³|⁴|⁵|⁶|⁷|⁸|⁹)+))");
    std::string result;
    for (std::smatch m; std::regex_search(text, m, power); text = m.suffix()) {
        std::string exponent = m[2].matched ? m.str(2) : m.str(3);
        for (const auto& [sign, digit] : raised)
            for (std::size_t at; (at = exponent.find(sign)) != std::string::npos;) exponent.replace(at, sign.size(), digit);
        result += m.prefix().str() + (m[1].matched ? m.str(1) : "1") + "e" + exponent;
    }
    return result + text;
}

inline std::vector<Piece> pieces_of(const std::string& text) {
    static const std::regex number(R"(\d+(?:\.\d+)?(?:e[-+]?\d+)?)");
    const std::string plain = plain_numbers(text);
    std::vector<Piece> pieces;
    auto at = plain.begin();
    for (std::sregex_iterator m(plain.begin(), plain.end(), number), end; m != end; ++m) {
        pieces.push_back({std::string(at, plain.begin() + m->position()), std::strtod(m->str().c_str(), nullptr)});
        at = plain.begin() + m->position() + m->length();
    }
    pieces.push_back({std::string(at, plain.end())});
    return pieces;
}

// A number that is rounding may have either sign.
inline std::string without_sign(std::string words) {
    for (const std::string sign : {"−", "-"})
        if (words.ends_with(sign)) words.resize(words.size() - sign.size());
    return words;
}

inline bool alike(Real a, Real b) {
    constexpr Real digits = 0.02;
    return a == b || std::abs(a - b) <= digits * std::max(a, b);
}

inline bool alike(const Piece& a, const Piece& b) {
    constexpr Real rounding = 1e-9;
    if (a.number > 0 && b.number > 0 && a.number < rounding && b.number < rounding)
        return without_sign(a.words) == without_sign(b.words);
    return a.words == b.words && alike(a.number, b.number);
}

// The first place where two pages differ, or "".
inline std::string page_difference(const std::string& page, const std::string& wanted) {
    const auto a = pieces_of(page), b = pieces_of(wanted);
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (!alike(a[i], b[i]))
            return fmt::format("'{}{}' where '{}{}' is measured", a[i].words, a[i].number, b[i].words, b[i].number);
    return a.size() == b.size() ? "" : "one page is longer";
}

}  // namespace pliant::test
