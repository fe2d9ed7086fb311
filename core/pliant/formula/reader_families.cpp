// Families of numbers, what runs over them, and functions that a formula is given.
#include <pliant/formula/reader.h>
#include <pliant/formula/unicode.h>

#include <utility>

namespace pliant {

// A family alone is an argument as a whole.
int FormulaReader::call(int named) {
    const std::size_t begin = at_;
    at_ += f_.functions_[static_cast<std::size_t>(named)].name.size();
    take('(');
    const int bars = std::exchange(bars_, 0), first = node_count();
    std::vector<int> of;
    do {
        skip_blanks();
        const std::size_t from = at_;
        const int k = symbol_here();
        if (k >= 0 && f_.symbols_[static_cast<std::size_t>(k)].family) {
            at_ += f_.symbols_[static_cast<std::size_t>(k)].text.size();
            skip_blanks();
            if (here() == ',' || here() == ')') {
                of.push_back(add(Operation::family, {}, from));
                f_.nodes_.back().symbol = k;
                continue;
            }
            at_ = from;
        }
        of.push_back(sum());
    } while (take(','));
    bars_ = bars;
    if (!take(')')) refuse("the parenthesis of a function is not closed");
    const int node = add(Operation::named, std::move(of), begin);
    f_.nodes_.back().symbol = named;
    f_.nodes_.back().first = first;
    return node;
}

// "Σ_b K_ab u_b": of the whole term that follows.
int FormulaReader::total() {
    const std::size_t begin = at_;
    const int first = node_count();
    take(U'Σ');
    skip_index();
    const int term = product();
    return over_families(Operation::total, first, term, begin);
}

bool FormulaReader::has_free_family(int first, int last) const {
    for (int k = first; k < last; ++k) {
        const FormulaNode& n = f_.nodes_[static_cast<std::size_t>(k)];
        if (n.operation == Operation::symbol && n.repeated_for < 0 && f_.symbols_[static_cast<std::size_t>(n.symbol)].family)
            return true;
    }
    return false;
}

int FormulaReader::over_families(Operation operation, int first, int inner, std::size_t begin) {
    if (!has_free_family(first, node_count())) throw BadFormula(text_, begin, "no family of numbers stands in what it runs over");
    const int node = add(operation, {inner}, begin);
    f_.nodes_.back().first = first;
    for (int k = first; k < node; ++k) {
        FormulaNode& n = f_.nodes_[static_cast<std::size_t>(k)];
        if (n.repeated_for < 0 && !runs_over_family(n.operation)) n.repeated_for = node;
    }
    return node;
}

void FormulaReader::check_families() const {
    for (const FormulaNode& n : f_.nodes_)
        if (n.operation == Operation::symbol && n.repeated_for < 0 && f_.symbols_[static_cast<std::size_t>(n.symbol)].family)
            throw BadFormula(text_, n.begin, "this stands for many numbers: take them by Σ, max, min or mean");
}

int FormulaReader::named_here() const {
    int found = -1;
    std::size_t longest = 0;
    for (std::size_t k = 0; k < f_.functions_.size(); ++k) {
        const std::string& name = f_.functions_[k].name;
        if (name.size() <= longest || text_.substr(at_, name.size()) != name) continue;
        if (at_ + name.size() < f_.right_end_ && text_[at_ + name.size()] == '(')
            found = static_cast<int>(k), longest = name.size();
    }
    return found;
}

void FormulaReader::skip_index() {
    while (here() != 0 && (here() == '_' || !lowered(here()).empty())) {
        const bool word = here() == '_';
        at_ += code_point(text_, at_).bytes;
        while (word && (is_letter(here()) || is_digit(here()))) at_ += code_point(text_, at_).bytes;
    }
}

}  // namespace pliant
