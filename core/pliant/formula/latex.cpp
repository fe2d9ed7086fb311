// Formulas in LaTeX.
#include <pliant/formula/formula.h>
#include <pliant/formula/notation.h>
#include <pliant/formula/unicode.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace pliant {
namespace {

using Kind = Notation::Kind;
using Command = std::pair<std::string_view, std::string_view>;

constexpr std::array<Command, 58> commands{
    {{"α", "\\alpha"},      {"β", "\\beta"},    {"γ", "\\gamma"},     {"δ", "\\delta"},
     {"ε", "\\varepsilon"}, {"ζ", "\\zeta"},    {"η", "\\eta"},       {"θ", "\\theta"},
     {"κ", "\\kappa"},      {"λ", "\\lambda"},  {"μ", "\\mu"},        {"ν", "\\nu"},
     {"ξ", "\\xi"},         {"π", "\\pi"},      {"ρ", "\\rho"},       {"σ", "\\sigma"},
     {"τ", "\\tau"},        {"φ", "\\varphi"},  {"χ", "\\chi"},       {"ψ", "\\psi"},
     {"ω", "\\omega"},      {"Γ", "\\Gamma"},   {"Δ", "\\Delta"},     {"Θ", "\\Theta"},
     {"Λ", "\\Lambda"},     {"Σ", "\\sum"},     {"∫", "\\int"},       {"∏", "\\prod"},
     {"Φ", "\\Phi"},        {"Ψ", "\\Psi"},     {"Ω", "\\Omega"},     {"∂", "\\partial"},
     {"∇", "\\nabla"},      {"·", "\\cdot"},    {"×", "\\times"},     {"−", "-"},
     {"±", "\\pm"},         {"∞", "\\infty"},   {"←", "\\leftarrow"}, {"→", "\\rightarrow"},
     {"≤", "\\le"},         {"≥", "\\ge"},      {"≈", "\\approx"},    {"≠", "\\ne"},
     {"∈", "\\in"},         {"∝", "\\propto"},  {"…", "\\dots"},      {"∘", "\\circ"},
     {"°", "^{\\circ}"},    {"′", "\\prime"},   {"%", "\\%"},         {"~", "\\sim"},
     {"∠", "\\angle"},      {"⟨", "\\langle"},  {"⟩", "\\rangle"},    {"⇔", "\\Leftrightarrow"},
     {"−=", "-="},          {"Ẽ", "\\tilde{E}"}}};
constexpr std::array<Command, 12> names{{{"asin", "\\arcsin"},
                                         {"acos", "\\arccos"},
                                         {"atan", "\\arctan"},
                                         {"log10", "\\log_{10}"},
                                         {"atan2", "\\operatorname{atan2}"},
                                         {"tr", "\\operatorname{tr}"},
                                         {"div", "\\operatorname{div}"},
                                         {"grad", "\\operatorname{grad}"},
                                         {"curl", "\\operatorname{curl}"},
                                         {"diag", "\\operatorname{diag}"},
                                         {"mean", "\\operatorname*{mean}"},
                                         {"floor", "\\operatorname{floor}"}}};
constexpr std::array<std::string_view, 12> own_names{"sin", "cos", "tan", "sinh", "cosh", "tanh",
                                                     "exp", "ln",  "log", "min",  "max",  "det"};
constexpr std::array<Command, 5> accents{{{"^", "\\hat"}, {"~", "\\tilde"}, {"¯", "\\bar"}, {"˙", "\\dot"}, {"¨", "\\ddot"}}};

template <class Table>
std::string_view looked_up(const Table& table, std::string_view text) {
    const auto found = std::ranges::find(table, text, &Command::first);
    return found == table.end() ? std::string_view() : found->second;
}

std::string letters(std::string_view text) {
    if (text == "″") return "\\prime\\prime";
    if (const std::string_view command = looked_up(commands, text); !command.empty()) return std::string(command);
    const bool plain = std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
    return plain ? std::string(text) : fmt::format("\\text{{{}}}", text);
}

std::string name(std::string_view text) {
    if (const std::string_view command = looked_up(names, text); !command.empty()) return std::string(command);
    const bool known = std::ranges::find(own_names, text) != own_names.end();
    return known ? fmt::format("\\{}", text) : fmt::format("\\mathrm{{{}}}", text);
}

// A blank where two pieces would run together, or where the text has one.
void join(std::string& all, const std::string& more, bool spaced) {
    const std::size_t command = all.find_last_of('\\');
    const bool is_command =
        command != all.npos && command + 1 < all.size() &&
        std::ranges::all_of(all.substr(command + 1), [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); });
    const bool letter = !more.empty() && ((more[0] >= 'a' && more[0] <= 'z') || (more[0] >= 'A' && more[0] <= 'Z'));
    if (!all.empty() && (spaced || (is_command && letter))) all += ' ';
    all += more;
}

// Signs bring their own room along.
bool has_room(const Notation& n) {
    return n.kind == Kind::sign || n.kind == Kind::relation || n.kind == Kind::comma || n.kind == Kind::gap;
}

// Between formulas and words a blank has to be asked for: LaTeX drops it.
bool needs_blank(const Notation& before, const Notation& n) {
    return n.spaced && (before.kind == Kind::words || n.kind == Kind::words) && !has_room(before) && !has_room(n);
}

std::string row_of(const Notation& row) {
    std::string all;
    const Notation* before = nullptr;
    for (const Notation& n : row.of) {
        const bool blank = before && needs_blank(*before, n);
        join(all, (blank ? "\\ " : "") + latex(n), n.spaced || (before && before->kind == Kind::gap));
        before = &n;
    }
    return all;
}

std::string scripts(const Notation& n) {
    std::string text = latex(n.of[0]);
    const auto put = [&](const char* mark, const Notation& row) {
        if (!row.of.empty()) text += fmt::format("{}{{{}}}", mark, latex(row));
    };
    put("_", n.of[1]), put("^", n.of[2]);
    return text;
}

// The letter of a fence.
std::string fence_letter(std::string_view letter) {
    if (letter.empty()) return ".";  // left open
    if (letter == "‖") return "\\|";
    if (letter == "⟨") return "\\langle ";
    if (letter == "⟩") return "\\rangle{}";
    return letter == "{" || letter == "}" ? "\\" + std::string(letter) : std::string(letter);
}

std::string fence(const Notation& n) {
    const std::string_view pair = n.text;
    const std::size_t open = code_point(pair, 0).bytes;
    return fmt::format("\\left{}{}\\right{}", fence_letter(pair.substr(0, open)), latex(n.of[0]),
                       fence_letter(pair.substr(open)));
}

std::string grid(const Notation& n) {
    std::string rows;
    for (const Notation& row : n.of) {
        std::string entries;
        for (const Notation& entry : row.of) entries += (entries.empty() ? "" : " & ") + latex(entry);
        rows += (rows.empty() ? "" : " \\\\ ") + entries;
    }
    return fmt::format("\\begin{{bmatrix}} {} \\end{{bmatrix}}", rows);
}

}  // namespace

std::string latex(const Notation& n) {
    switch (n.kind) {
        case Kind::row:
            return row_of(n);
        case Kind::words:
            return fmt::format("\\text{{{}}}", n.text);
        case Kind::name:
            return name(n.text);
        case Kind::gap:
            return "\\quad";
        case Kind::fraction:
            return fmt::format("\\{}{{{}}}{{{}}}", n.text.empty() ? "frac" : "tfrac", latex(n.of[0]), latex(n.of[1]));
        case Kind::root:
            return fmt::format("\\sqrt{{{}}}", latex(n.of[0]));
        case Kind::scripts:
            return scripts(n);
        case Kind::accent:
            return fmt::format("{}{{{}}}", looked_up(accents, n.text), latex(n.of[0]));
        case Kind::fence:
            return fence(n);
        case Kind::grid:
            return grid(n);
        case Kind::variable:
        case Kind::digits:
        case Kind::sign:
        case Kind::prefix:
        case Kind::relation:
        case Kind::comma:
        case Kind::large:
            return letters(n.text);
    }
    return "";
}

std::string latex(std::string_view text) { return latex(notation(text)); }

std::string Formula::latex() const { return pliant::latex(std::string_view(text_).substr(0, right_end_)); }

}  // namespace pliant
