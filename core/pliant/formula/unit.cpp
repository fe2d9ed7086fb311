#include <pliant/formula/unicode.h>
#include <pliant/formula/unit.h>
#include <pliant/math/error.h>

#include <fmt/format.h>

#include <utility>

namespace pliant {
namespace {

// Names, and the powers of m, kg, s, K and ° that each stands for.
struct NamedUnit {
    std::string_view name;
    std::array<std::int16_t, Unit::bases> powers;
};
constexpr std::array<NamedUnit, 17> named_units{{{"m", {1, 0, 0, 0, 0}},
                                                 {"kg", {0, 1, 0, 0, 0}},
                                                 {"s", {0, 0, 1, 0, 0}},
                                                 {"K", {0, 0, 0, 1, 0}},
                                                 {"°", {0, 0, 0, 0, 1}},
                                                 {"N", {1, 1, -2, 0, 0}},
                                                 {"Pa", {-1, 1, -2, 0, 0}},
                                                 {"J", {2, 1, -2, 0, 0}},
                                                 {"W", {2, 1, -3, 0, 0}},
                                                 {"Hz", {0, 0, -1, 0, 0}},
                                                 {"rad", {}},
                                                 {"cells", {}},
                                                 {"steps", {}},
                                                 {"passes", {}},
                                                 {"iterations", {}},
                                                 {"pairs", {}},
                                                 {"1", {}}}};

}  // namespace

// unit = product ["/" product | "/" "(" product ")"], product = factor {" " factor}, factor = name [power]
class UnitReader {
public:
    explicit UnitReader(std::string_view text) : text_(text) {}

    Unit read() {
        Unit unit;
        product(unit, 1);
        if (take('/')) {
            const bool grouped = take('(');
            grouped ? product(unit, -1) : factor(unit, -1);
            if (grouped && !take(')')) refuse();
        }
        if (at_ < text_.size()) refuse();
        return unit;
    }

private:
    [[noreturn]] void refuse() const {
        throw Refused(
            fmt::format("'{}' is no unit: give a product such as \"kg m²/s²\" or \"1/(m s)\" of m, kg, s, K, °, N, Pa, J, "
                        "W, Hz, rad, or a count such as cells",
                        text_));
    }
    bool take(char c) {
        if (at_ >= text_.size() || text_[at_] != c) return false;
        return ++at_, true;
    }
    void product(Unit& unit, int sign) {
        do factor(unit, sign);
        while (take(' '));
    }
    void factor(Unit& unit, int sign) {
        const NamedUnit& named = name();
        Unit one;
        for (std::size_t b = 0; b < Unit::bases; ++b) one.powers_[b] = static_cast<std::int16_t>(Unit::whole * named.powers[b]);
        unit.multiply(one, sign * exponent());
    }
    // The longest name that stands here.
    const NamedUnit& name() {
        const NamedUnit* found = nullptr;
        for (const NamedUnit& u : named_units)
            if (text_.substr(at_).starts_with(u.name) && (!found || u.name.size() > found->name.size())) found = &u;
        if (!found) refuse();
        at_ += found->name.size();
        return *found;
    }
    int exponent() {
        int power = 0;
        bool raised = false;
        while (at_ < text_.size()) {
            const CodePoint c = code_point(text_, at_);
            const int digit = raised_digit(c.letter);
            if (digit < 0) break;
            power = 10 * power + digit, raised = true, at_ += c.bytes;
        }
        return raised ? power : 1;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

Unit::Unit(std::string_view text) {
    if (!text.empty()) *this = UnitReader(text).read();
}

Unit& Unit::multiply(const Unit& other, int times) {
    for (std::size_t b = 0; b < bases; ++b) powers_[b] = static_cast<std::int16_t>(powers_[b] + times * other.powers_[b]);
    return *this;
}

Unit operator*(const Unit& a, const Unit& b) { return Unit(a).multiply(b, 1); }
Unit operator/(const Unit& a, const Unit& b) { return Unit(a).multiply(b, -1); }

std::optional<Unit> Unit::power(int numerator, int denominator) const {
    Unit raised;
    for (std::size_t b = 0; b < bases; ++b) {
        const int p = powers_[b] * numerator;
        if (p % denominator != 0) return std::nullopt;
        raised.powers_[b] = static_cast<std::int16_t>(p / denominator);
    }
    return raised;
}

std::string Unit::text() const {
    constexpr std::array<std::string_view, bases> names{"m", "kg", "s", "K", "°"};
    constexpr std::array<std::size_t, bases> order{kilogram, metre, second, kelvin, degree};
    constexpr std::array<std::string_view, 10> raised{"⁰", "", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    const auto part = [&](std::size_t b, int p) {
        if (p % whole == 0 && p / whole < 10) return fmt::format("{}{}", names[b], raised[static_cast<std::size_t>(p / whole)]);
        return fmt::format("{}^({}/{})", names[b], p, static_cast<int>(whole));
    };
    std::string above, below;
    int divisors = 0;
    for (const std::size_t b : order) {
        const int p = powers_[b];
        if (p == 0) continue;
        std::string& side = p > 0 ? above : below;
        if (!side.empty()) side += ' ';
        side += part(b, p > 0 ? p : -p);
        divisors += p < 0;
    }
    if (above.empty()) above += '1';
    if (below.empty()) return above;
    return divisors > 1 ? fmt::format("{}/({})", above, below) : fmt::format("{}/{}", above, below);
}

std::string Unit::usual_text() const {
    if (is_number()) return "";
    for (const char* usual : {"N", "N/m", "Pa", "J", "W", "N s/m", "Pa s"})
        if (Unit(usual) == *this) return usual;
    return text();
}

bool is_unit(std::string_view text) {
    try {
        return Unit(text), true;
    } catch (const Refused&) {
        return false;
    }
}

bool is_prefixed_unit(std::string_view text) {
    if (is_unit(text)) return true;
    for (const std::string_view prefix : {"p", "n", "µ", "μ", "m", "c", "k", "M", "G", "T"})
        if (text.starts_with(prefix) && text.size() > prefix.size() && is_unit(text.substr(prefix.size()))) return true;
    return false;
}

}  // namespace pliant
