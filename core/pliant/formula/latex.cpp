// Formulas and symbols in LaTeX.
#include <pliant/formula/formula.h>
#include <pliant/formula/unicode.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace pliant {
namespace {

constexpr std::array<std::pair<char32_t, std::string_view>, 46> latex_letters{
    {{U'α', "\\alpha"},       {U'β', "\\beta"},        {U'γ', "\\gamma"},  {U'δ', "\\delta"},  {U'ε', "\\varepsilon"},
     {U'ζ', "\\zeta"},        {U'η', "\\eta"},         {U'θ', "\\theta"},  {U'κ', "\\kappa"},  {U'λ', "\\lambda"},
     {U'μ', "\\mu"},          {U'ν', "\\nu"},          {U'ξ', "\\xi"},     {U'π', "\\pi"},     {U'ρ', "\\rho"},
     {U'σ', "\\sigma"},       {U'τ', "\\tau"},         {U'φ', "\\varphi"}, {U'χ', "\\chi"},    {U'ψ', "\\psi"},
     {U'ω', "\\omega"},       {U'Γ', "\\Gamma"},       {U'Δ', "\\Delta"},  {U'Θ', "\\Theta"},  {U'Λ', "\\Lambda"},
     {U'Σ', "\\sum"},         {U'Φ', "\\Phi"},         {U'Ψ', "\\Psi"},    {U'Ω', "\\Omega"},  {U'∂', "\\partial"},
     {U'∇', "\\nabla"},       {U'·', "\\cdot"},        {U'×', "\\times"},  {U'−', "-"},        {U'∞', "\\infty"},
     {U'←', "\\leftarrow"},   {U'≤', "\\le"},          {U'≥', "\\ge"},     {U'≈', "\\approx"}, {U'…', "\\dots"},
     {U'½', "\\tfrac{1}{2}"}, {U'¼', "\\tfrac{1}{4}"}, {U'∈', "\\in"},     {U'∘', "\\circ"},   {U'°', "^{\\circ}"},
     {U'√', "\\sqrt{}"}}};

// Letters above the line: ᵃ to ᶻ as they stand in symbols, and what is below the line beside digits.
constexpr std::array<std::pair<char32_t, char>, 26> raised_letters{
    {{U'ᵃ', 'a'}, {U'ᵇ', 'b'}, {U'ᶜ', 'c'}, {U'ᵈ', 'd'}, {U'ᵉ', 'e'}, {U'ᶠ', 'f'}, {U'ᵍ', 'g'}, {U'ʰ', 'h'}, {U'ⁱ', 'i'},
     {U'ʲ', 'j'}, {U'ᵏ', 'k'}, {U'ˡ', 'l'}, {U'ᵐ', 'm'}, {U'ⁿ', 'n'}, {U'ᵒ', 'o'}, {U'ᵖ', 'p'}, {U'ʳ', 'r'}, {U'ˢ', 's'},
     {U'ᵗ', 't'}, {U'ᵘ', 'u'}, {U'ᵛ', 'v'}, {U'ʷ', 'w'}, {U'ˣ', 'x'}, {U'ʸ', 'y'}, {U'ᶻ', 'z'}, {U'ᵀ', 'T'}}};
constexpr std::array<std::pair<char32_t, char>, 17> lowered_letters{{{U'ₐ', 'a'},
                                                                     {U'ₑ', 'e'},
                                                                     {U'ₒ', 'o'},
                                                                     {U'ₓ', 'x'},
                                                                     {U'ₕ', 'h'},
                                                                     {U'ₖ', 'k'},
                                                                     {U'ₗ', 'l'},
                                                                     {U'ₘ', 'm'},
                                                                     {U'ₙ', 'n'},
                                                                     {U'ₚ', 'p'},
                                                                     {U'ₛ', 's'},
                                                                     {U'ₜ', 't'},
                                                                     {U'ᵢ', 'i'},
                                                                     {U'ⱼ', 'j'},
                                                                     {U'ᵣ', 'r'},
                                                                     {U'ᵤ', 'u'},
                                                                     {U'ᵥ', 'v'}}};
constexpr std::array<std::pair<char32_t, std::string_view>, 4> accents{
    {{U'\u0302', "\\hat"}, {U'\u0303', "\\tilde"}, {U'\u0304', "\\bar"}, {U'\u0307', "\\dot"}}};

template <class Table>
auto looked_up(const Table& table, char32_t c) {
    const auto found = std::ranges::find(table, c, [](const auto& entry) { return entry.first; });
    return found == table.end() ? std::nullopt : std::optional(found->second);
}

// Letters with an accent of their own code point.
std::string accented(char32_t c) {
    switch (c) {
        case U'ũ':
            return "\\tilde{u}";
        case U'ñ':
            return "\\tilde{n}";
        case U'ã':
            return "\\tilde{a}";
        case U'û':
            return "\\hat{u}";
        case U'ê':
            return "\\hat{e}";
        case U'ŷ':
            return "\\hat{y}";
        case U'ū':
            return "\\bar{u}";
        default:
            return "";
    }
}

struct SymbolWriter {
    std::string_view symbol;
    std::string body{}, above{}, below{};
    std::size_t at = 0;

    std::string write() {
        while (at < symbol.size()) letter();
        std::string text = body;
        if (!below.empty()) text += fmt::format("_{{{}}}", below);
        if (!above.empty()) text += fmt::format("^{{{}}}", above);
        return text;
    }
    // A command is parted from the letter behind it.
    static void join(std::string& text, std::string_view more) {
        const bool command = !text.empty() && text.find_last_of('\\') != text.npos &&
                             std::ranges::all_of(text.substr(text.find_last_of('\\') + 1), [](char c) { return c >= 'A'; }) &&
                             text.back() != '}';
        if (command && !more.empty() && ((more[0] >= 'a' && more[0] <= 'z') || (more[0] >= 'A' && more[0] <= 'Z'))) text += ' ';
        text += more;
    }
    void letter() {
        const CodePoint c = code_point(symbol, at);
        at += c.bytes;
        if (c.letter == '_') return index();
        if (c.letter == '\'' || c.letter == U'′') return join(above, "\\prime");
        if (const int digit = raised_digit(c.letter); digit >= 0) return join(above, fmt::format("{}", digit));
        if (const int digit = lowered_digit(c.letter); digit >= 0) return join(below, fmt::format("{}", digit));
        if (const auto raised = looked_up(raised_letters, c.letter)) return join(above, std::string(1, *raised));
        if (const auto lowered = looked_up(lowered_letters, c.letter)) return join(below, std::string(1, *lowered));
        if (const auto accent = looked_up(accents, c.letter)) return put_accent(*accent);
        if (const std::string known = accented(c.letter); !known.empty()) return join(body, known);
        if (const auto command = looked_up(latex_letters, c.letter)) return join(body, *command);
        join(body, symbol.substr(at - c.bytes, c.bytes));
    }
    // Over the letter before it.
    void put_accent(std::string_view accent) {
        const std::size_t command = body.find_last_of('\\');
        const bool whole = command != body.npos && body.find(' ', command) == body.npos && command + 1 < body.size();
        const std::size_t from = whole ? command : body.empty() ? 0 : body.size() - 1;
        body = fmt::format("{}{}{{{}}}", body.substr(0, from), accent, body.substr(from));
    }
    // Everything behind the underscore, up to a prime.
    void index() {
        while (at < symbol.size()) {
            const CodePoint c = code_point(symbol, at);
            if (c.letter == U'′' || c.letter == '\'' || c.letter == '(' || c.letter == '|' || c.letter == '/') return;
            at += c.bytes;
            const auto command = looked_up(latex_letters, c.letter);
            const int digit = raised_digit(c.letter);
            if (digit >= 0) {
                join(above, fmt::format("{}", digit));
                continue;
            }
            join(below, c.letter == '_' ? "," : command ? *command : symbol.substr(at - c.bytes, c.bytes));
        }
    }
};

enum Binding { of_sum, of_product, of_power, of_atom };

struct Piece {
    std::string text;
    Binding binding = of_atom;
};

class LatexWriter {
public:
    LatexWriter(const Formula& formula, std::span<const std::string> numbers) : formula_(formula), numbers_(numbers) {
        for (const FormulaNode& n : formula.nodes()) pieces_.push_back(of(n));
    }
    std::string whole() const { return pieces_.back().text; }

private:
    const Piece& piece(int node) const { return pieces_[static_cast<std::size_t>(node)]; }
    static std::string in_parentheses(const std::string& text) { return fmt::format("\\left({}\\right)", text); }
    std::string bound(int node, Binding least) const {
        const Piece& p = piece(node);
        return p.binding < least ? in_parentheses(p.text) : p.text;
    }
    Piece symbol(const FormulaNode& n) const {
        const auto k = static_cast<std::size_t>(n.symbol);
        if (numbers_.empty()) {
            const std::string text = latex_symbol(formula_.symbols()[k]);
            return {text, text.find('^') == text.npos ? of_atom : of_power};
        }
        const bool signed_number = numbers_[k].starts_with('-');
        return {numbers_[k], signed_number || numbers_[k].find("\\times") != std::string::npos ? of_sum : of_atom};
    }
    Piece product(const FormulaNode& n) const {
        const std::string a = bound(n.of[0], of_product), b = bound(n.of[1], of_product);
        const auto digit = [](char c) { return c >= '0' && c <= '9'; };
        const bool dot = !numbers_.empty() || digit(b[0]) || b[0] == '-';
        return {fmt::format("{}{}{}", a, dot ? " \\cdot " : " ", b), of_product};
    }
    // \sin^{2}\left(x\right): an exponent stands behind the name.
    Piece call(const FormulaNode& n, const std::string& exponent = "") const {
        std::string arguments;
        for (const int k : n.of) arguments += (arguments.empty() ? "" : ", ") + piece(k).text;
        const std::string_view name = name_of(n.function);
        const std::string command = n.function == Function::asin    ? "\\arcsin"
                                    : n.function == Function::acos  ? "\\arccos"
                                    : n.function == Function::atan  ? "\\arctan"
                                    : n.function == Function::atan2 ? "\\operatorname{atan2}"
                                    : n.function == Function::log10 ? "\\log_{10}"
                                    : n.function == Function::floor ? "\\operatorname{floor}"
                                                                    : fmt::format("\\{}", name);
        return {command + exponent + in_parentheses(arguments), of_atom};
    }
    Piece power(const FormulaNode& n) const {
        const std::string exponent = fmt::format("^{{{}}}", piece(n.of[1]).text);
        const FormulaNode& base = formula_.nodes()[static_cast<std::size_t>(n.of[0])];
        if (base.operation == Operation::call) return call(base, exponent);
        const Piece& p = piece(n.of[0]);
        return {(p.binding < of_atom ? in_parentheses(p.text) : p.text) + exponent, of_power};
    }
    static std::string number_text(Real value) {
        if (value == 0.5 || value == 0.25) return value == 0.5 ? "\\tfrac{1}{2}" : "\\tfrac{1}{4}";
        return fmt::format("{:.10g}", value);
    }
    Piece number(const FormulaNode& n) const {
        const std::string_view written = std::string_view(formula_.text()).substr(n.begin, n.end - n.begin);
        if (written == "π") return {"\\pi", of_atom};
        if (n.of_degrees) return {fmt::format("{:.10g}^{{\\circ}}", n.number), of_power};
        const CodePoint c = code_point(written, 0);
        if (is_digit(c.letter) || raised_digit(c.letter) >= 0 || c.letter == U'⁻')
            return {fmt::format("{:.10g}", n.number), of_atom};
        return {number_text(n.number), of_atom};
    }
    Piece of(const FormulaNode& n) const {
        switch (n.operation) {
            case Operation::number:
                return number(n);
            case Operation::symbol:
                return symbol(n);
            case Operation::negative:
                return {"-" + bound(n.of[0], of_product), of_sum};
            case Operation::sum:
                return {fmt::format("{} + {}", piece(n.of[0]).text, bound_right(n.of[1])), of_sum};
            case Operation::difference:
                return {fmt::format("{} - {}", piece(n.of[0]).text, bound_right(n.of[1])), of_sum};
            case Operation::product:
                return product(n);
            case Operation::quotient:
                return {fmt::format("\\frac{{{}}}{{{}}}", piece(n.of[0]).text, piece(n.of[1]).text), of_product};
            case Operation::power:
                return power(n);
            case Operation::root:
                return {fmt::format("\\sqrt{{{}}}", piece(n.of[0]).text), of_atom};
            case Operation::magnitude:
                return {fmt::format("\\left|{}\\right|", piece(n.of[0]).text), of_atom};
            case Operation::call:
                return call(n);
        }
        return {};
    }
    // A sum on the right of a sign keeps its parentheses.
    std::string bound_right(int node) const { return bound(node, of_product); }

    const Formula& formula_;
    std::span<const std::string> numbers_;
    std::vector<Piece> pieces_;
};

}  // namespace

std::string latex_text(std::string_view text) {
    std::string latex, words;
    const auto end_words = [&] {
        if (!words.empty()) latex += fmt::format("\\text{{ {}}} ", words);
        words.clear();
    };
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        const std::string_view token = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const bool word =
            token.size() > 1 && std::ranges::all_of(token, [](char c) { return (c >= 'a' && c <= 'z') || c == ',' || c == ':'; });
        if (word)
            words += std::string(words.empty() ? "" : " ") + std::string(token);
        else if (!token.empty())
            end_words(), latex += latex_symbol(token) + " ";
    }
    end_words();
    while (latex.ends_with(' ')) latex.pop_back();
    return latex;
}

std::string latex_symbol(std::string_view symbol) {
    // Bars around a symbol are part of it.
    if (symbol.size() > 2 && symbol.front() == '|' && symbol.back() == '|')
        return fmt::format("\\left|{}\\right|", latex_symbol(symbol.substr(1, symbol.size() - 2)));
    return SymbolWriter{symbol}.write();
}

std::string Formula::latex(std::span<const std::string> numbers) const {
    const std::string whole = LatexWriter(*this, numbers).whole();
    return left().empty() ? whole : fmt::format("{} = {}", latex_symbol(left()), whole);
}

}  // namespace pliant
