#include <pliant/formula/equation_units.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <span>
#include <vector>

namespace pliant {
namespace {

using Kind = Notation::Kind;
using Pieces = std::span<const Notation>;

std::string letters_of(const Notation& n) {
    std::string text = n.kind == Kind::accent ? "" : n.text;
    for (const Notation& part : n.of) text += letters_of(part);
    return text;
}

// A whole number above the line, "2", "−1"; "−T" of an inverse is −1, "T" of a transpose 1.
std::optional<int> exponent_of(const Notation& above) {
    const std::string letters = letters_of(above);
    constexpr std::string_view minus = "−";
    const bool negative = letters.starts_with(minus);
    const std::string_view text = std::string_view(letters).substr(negative ? minus.size() : 0);
    if (text == "T") return negative ? -1 : 1;
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return negative ? -value : value;
}

// A symbol as a key: "k_0", "f^d", "x_ij". An exponent is none of it.
std::string key_of(const Notation& n) {
    if (n.kind == Kind::row) return n.of.size() == 1 ? key_of(n.of[0]) : letters_of(n);
    if (n.kind != Kind::scripts) return letters_of(n);
    std::string key = letters_of(n.of[0]);
    if (!n.of[1].of.empty()) key += "_" + letters_of(n.of[1]);
    if (!n.of[2].of.empty() && !exponent_of(n.of[2])) key += "^" + letters_of(n.of[2]);
    return key;
}

// What the units of a row are found to be. Unknown symbols leave it empty.
class UnitReading {
public:
    explicit UnitReading(const SymbolUnits& symbols) : symbols_(symbols) {}

    std::string mismatch{};

    std::optional<Unit> row(Pieces pieces) {
        std::optional<Unit> whole;
        bool all_known = true, any = false;
        for (std::size_t from = 0; from < pieces.size();) {
            std::size_t end = from;
            while (end < pieces.size() && (end == from || !is_sum(pieces[end]))) ++end;
            const Pieces term = pieces.subspan(from, end - from);
            from = end < pieces.size() ? end + 1 : end;
            if (is_zero(term)) continue;
            const std::optional<Unit> unit = product(term);
            all_known = all_known && unit;
            if (unit && whole && !(*unit == *whole) && mismatch.empty())
                mismatch = fmt::format("{} and {} are added", whole->text(), unit->text());
            if (unit && !any) whole = unit;
            any = any || unit;
        }
        return all_known ? whole : std::nullopt;
    }
    static bool is_zero(Pieces term) { return term.size() == 1 && term[0].kind == Kind::digits && term[0].text == "0"; }

private:
    static bool is_sum(const Notation& n) { return n.kind == Kind::sign && (n.text == "+" || n.text == "−" || n.text == "±"); }
    static bool is_symbol(const Notation& n) {
        return n.kind == Kind::variable || n.kind == Kind::accent ||
               (n.kind == Kind::scripts && (n.of[0].kind == Kind::variable || n.of[0].kind == Kind::accent));
    }

    std::optional<Unit> product(Pieces term) {
        Unit whole;
        for (std::size_t k = 0; k < term.size(); ++k) {
            std::size_t used = 1;
            const auto factor = factor_at(term, k, used);
            if (!factor) return std::nullopt;
            whole = whole * *factor;
            k += used - 1;
        }
        return whole;
    }

    std::optional<Unit> factor_at(Pieces term, std::size_t k, std::size_t& used) {
        const Notation& n = term[k];
        const Notation* next = k + 1 < term.size() ? &term[k + 1] : nullptr;
        switch (n.kind) {
            case Kind::prefix:
                return prefix(n, next, used);
            case Kind::sign:
                return n.text == "·" || n.text == "×" || n.text == ":" ? std::optional(Unit()) : std::nullopt;
            case Kind::digits:
            case Kind::large:
                return Unit();
            case Kind::variable:
            case Kind::accent:
                return symbol(n, next, used);
            case Kind::scripts:
                return scripts(n, next, used);
            case Kind::name:
                return called(n.text, next, used);
            case Kind::fence:
                return n.text == "[]" ? std::nullopt : row(n.of[0].of);
            case Kind::row:
                return row(n.of);
            case Kind::fraction: {
                const auto above = row(n.of[0].of), below = row(n.of[1].of);
                return above && below ? std::optional(*above / *below) : std::nullopt;
            }
            case Kind::root: {
                const auto under = row(n.of[0].of);
                return under ? under->power(1, 2) : std::nullopt;
            }
            default:
                return std::nullopt;
        }
    }
    // "Δt" may be a symbol of its own; else a difference or a derivative has the unit of what follows, and a slope is per metre.
    std::optional<Unit> prefix(const Notation& n, const Notation* next, std::size_t& used) {
        if (n.text == "∇") return Unit() / Unit("m");
        if (n.text != "−" && next && is_symbol(*next) && !next->spaced)
            if (const auto whole = symbols_.of(joined(n, *next))) {
                used = 2;
                return raised(*whole, *next);
            }
        return Unit();
    }
    static Notation joined(const Notation& prefix, const Notation& symbol) {
        if (symbol.kind != Kind::scripts) return {.kind = Kind::variable, .text = prefix.text + letters_of(symbol)};
        Notation whole = symbol;
        whole.of[0] = {.kind = Kind::variable, .text = prefix.text + letters_of(symbol.of[0])};
        return whole;
    }
    static std::optional<Unit> raised(const Unit& unit, const Notation& n) {
        if (n.kind != Kind::scripts || n.of[2].of.empty()) return unit;
        const auto exponent = exponent_of(n.of[2]);
        return exponent ? unit.power(*exponent) : unit;
    }
    // A symbol that parentheses follow closely is a function of what is in them, "u(x)". Letters side by side may be one symbol.
    std::optional<Unit> symbol(const Notation& n, const Notation* next, std::size_t& used) {
        if (next && is_symbol(*next) && !next->spaced)
            if (const auto pair = symbols_.of(joined(n, *next))) {
                used = 2;
                return raised(*pair, *next);
            }
        if (next && next->kind == Kind::fence && next->text == "()" && !next->spaced) used = 2;
        return symbols_.of(n);
    }
    std::optional<Unit> scripts(const Notation& n, const Notation* next, std::size_t& used) {
        const Notation& base = n.of[0];
        if (base.kind == Kind::large) return Unit();
        if (base.kind == Kind::name) return called(base.text, next, used);
        std::optional<Unit> unit;
        std::size_t none = 1;
        if (base.kind == Kind::prefix)
            unit = base.text == "∇" ? std::optional(Unit() / Unit("m")) : std::nullopt;
        else if (is_symbol(n)) {
            unit = symbols_.of(n);
            if (next && next->kind == Kind::fence && next->text == "()" && !next->spaced) used = 2;
        } else
            unit = factor_at(Pieces(&base, 1), 0, none);
        return unit ? raised(*unit, n) : std::nullopt;
    }
    std::optional<Unit> called(const std::string& name, const Notation* next, std::size_t& used) {
        if (!next) return std::nullopt;
        used = 2;
        const bool keeps = name == "tr" || name == "min" || name == "max" || name == "diag";
        if (name == "det") return std::nullopt;
        std::size_t none = 1;
        return keeps ? factor_at(Pieces(next, 1), 0, none) : std::optional(Unit());
    }

    const SymbolUnits& symbols_;
};

}  // namespace

void SymbolUnits::add(std::string_view symbol, const Unit& unit) {
    if (symbol.empty()) return;
    const std::string key = key_of(notation(symbol));
    const auto [at, is_new] = units_.emplace(key, unit);
    if (!is_new && !(at->second == unit)) ambiguous_.insert(key);
}

std::optional<Unit> SymbolUnits::of(const Notation& symbol) const {
    const auto found = [&](const std::string& key) -> std::optional<Unit> {
        const auto at = units_.find(key);
        return at == units_.end() || ambiguous_.contains(key) ? std::nullopt : std::optional(at->second);
    };
    // A hat may make a direction of a vector, and two primes a rate of a rate.
    const std::string key = key_of(symbol);
    const bool hat = symbol.kind == Kind::accent ? symbol.text == "^" : !symbol.of.empty() && symbol.of[0].text == "^";
    if (hat || key.find("″") != key.npos) return std::nullopt;
    if (const auto whole = found(key)) return whole;
    return symbol.kind == Kind::scripts || symbol.kind == Kind::accent ? found(letters_of(symbol.of[0])) : std::nullopt;
}

EquationCheck check_units(std::string_view equation, const SymbolUnits& symbols) {
    const Notation whole = notation(equation);
    EquationCheck result;
    UnitReading reading(symbols);
    std::optional<Unit> first;
    std::size_t sides = 0, from = 0;
    result.known = true;
    const auto ends_side = [](const Notation& n) {
        return n.kind == Kind::relation || n.kind == Kind::comma || n.kind == Kind::words || n.kind == Kind::gap;
    };
    while (from < whole.of.size()) {
        std::size_t end = from;
        while (end < whole.of.size() && !ends_side(whole.of[end])) ++end;
        const Pieces side = Pieces(whole.of).subspan(from, end - from);
        const bool zero = UnitReading::is_zero(side);
        const std::optional<Unit> unit = side.empty() || zero ? std::nullopt : reading.row(side);
        result.known = result.known && (unit || zero);
        if (unit && first && !(*unit == *first) && reading.mismatch.empty())
            reading.mismatch = fmt::format("{} and {}: {}", first->text(), unit->text(), equation);
        if (unit && !first) first = unit;
        ++sides;
        if (end < whole.of.size() && whole.of[end].kind != Kind::relation) break;
        from = end + 1;
    }
    result.known = result.known && sides > 1;
    result.mismatch = reading.mismatch;
    return result;
}

}  // namespace pliant
