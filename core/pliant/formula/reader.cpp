#include <pliant/formula/reader.h>
#include <pliant/formula/unicode.h>
#include <pliant/text/suggest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <numbers>
#include <utility>

namespace pliant {
namespace {

constexpr std::array<std::pair<std::string_view, Function>, 17> function_names{{{"asin", Function::asin},
                                                                                {"acos", Function::acos},
                                                                                {"atan2", Function::atan2},
                                                                                {"atan", Function::atan},
                                                                                {"sinh", Function::sinh},
                                                                                {"cosh", Function::cosh},
                                                                                {"tanh", Function::tanh},
                                                                                {"sin", Function::sin},
                                                                                {"cos", Function::cos},
                                                                                {"tan", Function::tan},
                                                                                {"exp", Function::exp},
                                                                                {"ln", Function::ln},
                                                                                {"log10", Function::log10},
                                                                                {"min", Function::min},
                                                                                {"max", Function::max},
                                                                                {"mean", Function::mean},
                                                                                {"floor", Function::floor}}};

constexpr std::array<std::pair<char32_t, Real>, 8> fractions{{{U'½', 1.0 / 2},
                                                              {U'¼', 1.0 / 4},
                                                              {U'¾', 3.0 / 4},
                                                              {U'⅓', 1.0 / 3},
                                                              {U'⅔', 2.0 / 3},
                                                              {U'⅙', 1.0 / 6},
                                                              {U'⅛', 1.0 / 8},
                                                              {U'⅕', 1.0 / 5}}};

bool takes_several(Function f) { return f == Function::min || f == Function::max || f == Function::atan2; }

bool takes_families(Function f) { return f == Function::min || f == Function::max || f == Function::mean; }

struct Column {
    std::size_t letters = 0, width = 0;  // before it; an accent above a letter takes no room of its own
};
Column column_of(std::string_view text, std::size_t byte) {
    Column column;
    for (std::size_t i = 0; i < byte && i < text.size(); ++column.letters) {
        const CodePoint c = code_point(text, i);
        column.width += !(c.letter >= 0x300 && c.letter <= 0x36f);
        i += c.bytes;
    }
    return column;
}

}  // namespace

int symbol_at(std::string_view text, std::size_t at, std::span<const FormulaSymbol> symbols) {
    int found = -1;
    std::size_t longest = 0;
    for (std::size_t k = 0; k < symbols.size(); ++k) {
        const std::string& symbol = symbols[k].text;
        if (symbol.size() <= longest || text.substr(at, symbol.size()) != symbol) continue;
        const std::size_t end = at + symbol.size();
        if (end < text.size() && continues_symbol(code_point(text, end).letter)) continue;
        found = static_cast<int>(k), longest = symbol.size();
    }
    return found;
}

std::string_view name_of(Function function) {
    const auto found = std::ranges::find(function_names, function, [](const auto& f) { return f.second; });
    return found->first;
}

BadFormula::BadFormula(std::string_view text, std::size_t at_byte, std::string_view what)
    : Error(ExitCode::check_failed,
            fmt::format("\"{}\" cannot be read at letter {}: {}\n  {}\n  {:{}}^", text, column_of(text, at_byte).letters + 1,
                        what, text, "", column_of(text, at_byte).width)) {}

void FormulaReader::refuse(std::string_view what) const { throw BadFormula(text_, at_, what); }

void FormulaReader::refuse_unknown() const {
    std::size_t end = at_;
    while (end < f_.right_end_ && continues_symbol(code_point(text_, end).letter)) end += code_point(text_, end).bytes;
    const std::string name(text_.substr(at_, end - at_));
    std::vector<std::string> known;
    std::string all;
    for (const FormulaSymbol& s : f_.symbols_) {
        known.push_back(s.text);
        all += (all.empty() ? "" : ", ") + s.text;
    }
    refuse(all.empty() ? fmt::format("no symbol '{}' is declared, nor any other", name)
                       : fmt::format("no symbol '{}' is declared{}; there are: {}", name, did_you_mean(name, known), all));
}

void FormulaReader::read() {
    split();
    at_ = f_.right_begin_;
    sum();
    skip_blanks();
    if (at_ < f_.right_end_) {
        const char32_t c = here();
        if (c != ',' && c != ':') refuse("an operator, or the end of the formula, is expected here");
        f_.right_end_ = at_;
        f_.remark_begin_ = at_;
    }
    while (f_.right_end_ > f_.right_begin_ && text_[f_.right_end_ - 1] == ' ') --f_.right_end_;
    check_families();
}

// The first sign of equality divides the sides.
void FormulaReader::split() {
    const std::size_t equals = text_.find('=');
    if (equals == std::string_view::npos) {
        f_.left_end_ = f_.right_begin_ = 0;
    } else {
        f_.left_end_ = text_.substr(0, equals).find_last_not_of(' ') + 1;
        f_.right_begin_ = text_.find_first_not_of(' ', equals + 1);
        if (f_.right_begin_ == std::string_view::npos) throw BadFormula(text_, equals, "nothing stands on the right side");
    }
    f_.right_end_ = f_.remark_begin_ = std::min(text_.find("   ", f_.right_begin_), text_.size());
}

// ------------------------------------------------------------------------------------------------------------- grammar

int FormulaReader::sum() {
    skip_blanks();
    const std::size_t begin = at_;
    int whole;
    if (take(U'−') || take('-'))
        whole = product(), whole = add(Operation::negative, {whole}, begin);
    else
        take('+'), whole = product();
    for (;;) {
        const bool plus = take('+');
        if (!plus && !take(U'−') && !take('-')) return whole;
        const int term = product();
        whole = add(plus ? Operation::sum : Operation::difference, {whole, term}, begin);
    }
}

int FormulaReader::product() {
    skip_blanks();
    const std::size_t begin = at_;
    int whole = power();
    bool divided = false;
    for (;;) {
        if (take('/')) {
            const int below = power();
            whole = add(Operation::quotient, {whole, below}, begin);
            divided = true;
        } else if (take(U'·') || take(U'×')) {
            const int factor = power();
            whole = add(Operation::product, {whole, factor}, begin);
        } else if (begins_factor()) {
            if (divided)
                refuse("a quotient goes on without a sign, which is read in two ways: put parentheses, or · for a product");
            const int factor = power();
            whole = add(Operation::product, {whole, factor}, begin);
        } else {
            return whole;
        }
    }
}

int FormulaReader::power() {
    skip_blanks();
    const std::size_t begin = at_;
    int base = primary();
    for (;;) {
        const std::size_t at = at_;
        if (const auto digits = exponent_digits()) {
            const int exponent = add_number(*digits, at);
            base = add(Operation::power, {base, exponent}, begin);
        } else if (here() == '^') {
            ++at_;
            const std::size_t sign_at = at_;
            const bool minus = take(U'−') || take('-');
            int exponent = primary();
            if (minus) exponent = add(Operation::negative, {exponent}, sign_at);
            base = add(Operation::power, {base, exponent}, begin);
        } else {
            return base;
        }
    }
}

int FormulaReader::primary() {
    skip_blanks();
    const std::size_t begin = at_;
    if (const int k = symbol_here(); k >= 0) {
        at_ += f_.symbols_[static_cast<std::size_t>(k)].text.size();
        const int node = add(Operation::symbol, {}, begin);
        f_.nodes_.back().symbol = k;
        return node;
    }
    if (const int k = named_here(); k >= 0) return call(k);
    if (const auto function = function_here()) return call(*function);
    if (const auto value = fraction_here()) {
        at_ += code_point(text_, at_).bytes;
        return add_number(*value, begin);
    }
    const char32_t c = here();
    if (is_digit(c)) return number();
    if (c == '(') return grouped();
    if (c == '|') return magnitude();
    if (c == U'√') return root();
    if (c == U'Σ') return total();
    if (take(U'π')) return add_number(std::numbers::pi, begin);
    if (c == 0) refuse("the formula ends where a number or a symbol is expected");
    if (is_letter(c)) refuse_unknown();
    refuse("a number, a symbol or a parenthesis is expected here");
}

int FormulaReader::grouped() {
    take('(');
    const int bars = std::exchange(bars_, 0);
    const int inner = sum();
    bars_ = bars;
    if (!take(')')) refuse("a parenthesis is not closed");
    f_.nodes_[static_cast<std::size_t>(inner)].grouped = true;
    return inner;
}

int FormulaReader::magnitude() {
    const std::size_t begin = at_;
    take('|');
    ++bars_;
    const int inner = sum();
    --bars_;
    if (!take('|')) refuse("a bar is not closed");
    return add(Operation::magnitude, {inner}, begin);
}

int FormulaReader::root() {
    const std::size_t begin = at_;
    take(U'√');
    const int inner = primary();
    return add(Operation::root, {inner}, begin);
}

// "cos θ", "max(a, b)", "sin²(κ/2)", "max_i |x_i|"
int FormulaReader::call(Function function) {
    const std::size_t begin = at_;
    const int first = node_count();
    at_ += name_of(function).size();
    if (takes_families(function)) skip_index();
    const std::size_t raised_at = at_;
    const auto exponent = exponent_digits();
    const std::size_t raised_end = at_;
    std::vector<int> of;
    if (take('(')) {
        const int bars = std::exchange(bars_, 0);
        do of.push_back(sum());
        while (takes_several(function) && take(','));
        bars_ = bars;
        if (!take(')')) refuse("the parenthesis of a function is not closed");
    } else {
        of.push_back(primary());
    }
    int node;
    if (takes_families(function) && of.size() == 1 && (function == Function::mean || has_free_family(first, node_count()))) {
        node = over_families(function == Function::mean  ? Operation::mean
                             : function == Function::max ? Operation::largest
                                                         : Operation::smallest,
                             first, of[0], begin);
    } else {
        node = add(Operation::call, std::move(of), begin);
        f_.nodes_.back().function = function;
    }
    if (!exponent) return node;
    const int power = add_number(*exponent, raised_at);
    f_.nodes_.back().end = raised_end;
    return add(Operation::power, {node, power}, begin);
}

int FormulaReader::number() {
    const std::size_t begin = at_;
    Real value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + f_.right_end_, value, std::chars_format::fixed);
    if (error != std::errc()) refuse("a number is expected here");
    at_ = static_cast<std::size_t>(end - text_.data());
    const bool degrees = here() == U'°' && take(U'°');
    const int node = add_number(value, begin);
    f_.nodes_.back().of_degrees = degrees;
    return node;
}

// ------------------------------------------------------------------------------------------------------------- letters

char32_t FormulaReader::code_point_here() const { return code_point(text_, at_).letter; }

void FormulaReader::skip_blanks() {
    while (at_ < f_.right_end_ && text_[at_] == ' ') ++at_;
}

bool FormulaReader::take(char32_t letter) {
    skip_blanks();
    if (here() != letter || letter == 0) return false;
    at_ += code_point(text_, at_).bytes;
    return true;
}

bool FormulaReader::begins_factor() {
    skip_blanks();
    if (symbol_here() >= 0 || named_here() >= 0 || function_here() || fraction_here()) return true;
    const char32_t c = here();
    return is_digit(c) || is_letter(c) || c == '(' || c == U'√' || (c == '|' && bars_ == 0);
}

std::optional<int> FormulaReader::exponent_digits() {
    std::size_t at = at_;
    int sign = 1, value = 0;
    bool any = false;
    while (at < f_.right_end_) {
        const CodePoint c = code_point(text_, at);
        const int digit = raised_digit(c.letter);
        if (!any && c.letter == U'⁻')
            sign = -1;
        else if (digit >= 0)
            value = 10 * value + digit, any = true;
        else
            break;
        at += c.bytes;
    }
    if (!any) return std::nullopt;
    at_ = at;
    return sign * value;
}

int FormulaReader::symbol_here() const { return symbol_at(text_.substr(0, f_.right_end_), at_, f_.symbols_); }

std::optional<Function> FormulaReader::function_here() const {
    for (const auto& [name, function] : function_names) {
        if (text_.substr(at_, name.size()) != name) continue;
        const std::size_t end = at_ + name.size();
        if (end >= f_.right_end_) continue;
        const char32_t next = code_point(text_, end).letter;
        if (!continues_symbol(next) || (takes_families(function) && (next == '_' || !lowered(next).empty()))) return function;
    }
    return std::nullopt;
}

std::optional<Real> FormulaReader::fraction_here() const {
    const auto found = std::ranges::find(fractions, here(), [](const auto& f) { return f.first; });
    return found == fractions.end() ? std::nullopt : std::optional(found->second);
}

// --------------------------------------------------------------------------------------------------------------- nodes

int FormulaReader::add(Operation operation, std::vector<int> of, std::size_t begin) {
    f_.nodes_.push_back({.operation = operation, .of = std::move(of), .begin = begin, .end = at_});
    return static_cast<int>(f_.nodes_.size()) - 1;
}

int FormulaReader::add_number(Real value, std::size_t begin) {
    const int node = add(Operation::number, {}, begin);
    f_.nodes_.back().number = value;
    return node;
}

}  // namespace pliant
