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

// A symbol as a key: "k_0", "f^d", "x_ij", "~u". An exponent is none of it.
std::string key_of(const Notation& n) {
    if (n.kind == Kind::row) return n.of.size() == 1 ? key_of(n.of[0]) : letters_of(n);
    if (n.kind == Kind::accent) return n.text + letters_of(n);
    if (n.kind != Kind::scripts) return letters_of(n);
    std::string key = key_of(n.of[0]);
    if (!n.of[1].of.empty()) key += "_" + letters_of(n.of[1]);
    if (!n.of[2].of.empty() && !exponent_of(n.of[2])) key += "^" + letters_of(n.of[2]);
    return key;
}

// What the units of a row are found to be. Unknown symbols leave it empty.
class UnitReading {
public:
    explicit UnitReading(const SymbolUnits& symbols) : symbols_(symbols) {}

    std::string mismatch{}, unknown{};

    std::optional<Unit> row(Pieces pieces) {
        std::optional<Unit> whole;
        bool all_known = true, any = false;
        for (std::size_t from = 0; from < pieces.size();) {
            std::size_t end = from;
            while (end < pieces.size() && (end == from || !parts_equals(pieces[end]))) ++end;
            const Pieces term = pieces.subspan(from, end - from);
            from = end < pieces.size() ? end + 1 : end;
            if (is_zero(term)) continue;
            const std::optional<Unit> unit = product(term);
            all_known = all_known && unit;
            if (unit && whole && !(*unit == *whole) && mismatch.empty())
                mismatch = fmt::format("{} and {} are added or compared", whole->text(), unit->text());
            if (unit && !any) whole = unit;
            any = any || unit;
        }
        return all_known ? whole : std::nullopt;
    }
    static bool is_zero(Pieces term) { return term.size() == 1 && term[0].kind == Kind::digits && term[0].text == "0"; }

private:
    // What stands on both sides of it has the same unit: of a sum, and of the arguments of max.
    static bool parts_equals(const Notation& n) {
        return n.kind == Kind::comma || (n.kind == Kind::sign && (n.text == "+" || n.text == "−" || n.text == "±"));
    }
    static bool is_symbol(const Notation& n) {
        return n.kind == Kind::variable || n.kind == Kind::accent ||
               (n.kind == Kind::scripts && (n.of[0].kind == Kind::variable || n.of[0].kind == Kind::accent));
    }

    std::optional<Unit> product(Pieces term) {
        Unit whole;
        for (std::size_t k = 0; k < term.size(); ++k) {
            std::size_t used = 1;
            const auto factor = factor_at(term, k, used);
            if (!factor) {
                if (unknown.empty()) unknown = key_of(term[k]);
                return std::nullopt;
            }
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
                return n.text == "|" || n.text == "‖" ? std::nullopt : std::optional(Unit());
            case Kind::digits:
            case Kind::large:
                return Unit();
            case Kind::variable:
                // "dx", "dA": a small part of what follows has its unit.
                if (n.text == "d" && next && is_symbol(*next) && !next->spaced && !symbols_.of(n)) return prefix(n, next, used);
                return symbol(n, next, used);
            case Kind::accent:
                return symbol(n, next, used);
            case Kind::scripts:
                return scripts(n, term.subspan(k + 1), used);
            case Kind::name:
                return called(n.text, term.subspan(k + 1), used);
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
    std::optional<Unit> scripts(const Notation& n, Pieces rest, std::size_t& used) {
        const Notation& base = n.of[0];
        const Notation* next = rest.empty() ? nullptr : &rest[0];
        if (base.kind == Kind::large) return Unit();
        if (base.kind == Kind::name) return called(base.text, rest, used);
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
    // rest: what follows the name, of which one factor is its argument.
    std::optional<Unit> called(const std::string& name, Pieces rest, std::size_t& used) {
        if (rest.empty()) return std::nullopt;
        std::size_t taken = 1;
        const std::optional<Unit> of = factor_at(rest, 0, taken);
        used = 1 + taken;
        if (name == "sign" || name == "atan2") return of ? std::optional(Unit()) : std::nullopt;
        if (name == "tr" || name == "min" || name == "max" || name == "diag") return of;
        if (name == "div" || name == "curl" || name == "grad") return of ? std::optional(*of / Unit("m")) : std::nullopt;
        // A determinant of what has a unit depends on how many rows it has; a sine takes degrees.
        const bool takes_degrees = name == "sin" || name == "cos" || name == "tan";
        if (of && !of->is_number() && !(takes_degrees && *of == Unit("°"))) {
            if (name == "det") return std::nullopt;
            if (mismatch.empty()) mismatch = fmt::format("{} of {}", name, of->text());
        }
        return of ? std::optional(Unit()) : std::nullopt;
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

void SymbolUnits::set(std::string_view symbol, const Unit& unit) {
    const std::string key = key_of(notation(symbol));
    units_.insert_or_assign(key, unit);
    ambiguous_.erase(key);
}

void SymbolUnits::complete_with(SymbolUnits others) { others_.push_back(std::move(others)); }

std::optional<Unit> SymbolUnits::of(const Notation& symbol) const {
    auto unit = declared(symbol);
    for (const SymbolUnits& more : others_)
        if (!unit) unit = more.of(symbol);
    return unit;
}

std::optional<Unit> SymbolUnits::declared(const Notation& symbol) const {
    const auto found = [&](const std::string& key) -> std::optional<Unit> {
        const auto at = units_.find(key);
        return at == units_.end() || ambiguous_.contains(key) ? std::nullopt : std::optional(at->second);
    };
    const std::string key = key_of(symbol);
    if (const auto whole = found(key)) return whole;
    const Notation& base = symbol.kind == Kind::scripts ? symbol.of[0] : symbol;
    auto unit = found(key_of(base));
    if (!unit && base.kind == Kind::accent && base.text != "^") unit = found(letters_of(base));
    if (unit && key.find("″") != key.npos) return *unit / *Unit("s").power(2);
    return unit;
}

namespace {

bool equates(const Notation& relation) { return relation.text != "~" && relation.text != "∝" && relation.text != "∈"; }

// The sides of an equation, which relations part.
struct Sides {
    std::vector<Pieces> sides{};
    bool equated = false;
};

// Those that a text gives: commas, words and gaps stand between them.
std::vector<Sides> equations_in(Pieces whole) {
    std::vector<Sides> all(1);
    const auto ends_side = [](const Notation& n) {
        return n.kind == Kind::relation || n.kind == Kind::comma || n.kind == Kind::words || n.kind == Kind::gap;
    };
    for (std::size_t from = 0; from <= whole.size();) {
        std::size_t end = from;
        while (end < whole.size() && !ends_side(whole[end])) ++end;
        all.back().sides.push_back(whole.subspan(from, end - from));
        if (end < whole.size() && whole[end].kind == Kind::relation)
            all.back().equated = equates(whole[end]);
        else
            all.emplace_back();
        from = end + 1;
    }
    std::erase_if(all, [](const Sides& s) { return s.sides.size() < 2 || !s.equated; });
    return all;
}

}  // namespace

EquationCheck check_units(std::string_view equation, const SymbolUnits& symbols) {
    const Notation whole = notation(equation);
    const std::vector<Sides> equations = equations_in(whole.of);
    UnitReading reading(symbols);
    EquationCheck result{.known = !equations.empty()};
    for (const Sides& e : equations) {
        std::optional<Unit> first;
        for (const Pieces side : e.sides) {
            if (UnitReading::is_zero(side)) continue;
            const std::optional<Unit> unit = side.empty() ? std::nullopt : reading.row(side);
            if (side.empty() && reading.unknown.empty()) reading.unknown = "words";
            result.known = result.known && unit;
            if (unit && first && !(*unit == *first) && reading.mismatch.empty())
                reading.mismatch = fmt::format("{} and {}: {}", first->text(), unit->text(), equation);
            if (unit && !first) first = unit;
        }
    }
    result.mismatch = reading.mismatch, result.unknown = reading.unknown;
    return result;
}

}  // namespace pliant
