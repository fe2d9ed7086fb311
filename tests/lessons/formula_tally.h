// Which formulas of explanations are data: read, evaluated as the lesson does, and of the unit of what they explain. Those that
// differ by numbers alone count as one.
#pragma once
#include <pliant/formula/formula.h>
#include <pliant/formula/unicode.h>
#include <pliant/run/why.h>

#include <map>
#include <string>
#include <vector>

namespace pliant {

class FormulaTally {
public:
    void begin() { found_.clear(); }
    void note(const Answer& a) {
        if (a.formula.empty() || a.kind == Answer::Kind::combined) return;
        const std::string wrong = objection(a);
        std::string& known = found_[without_numbers(a.formula)];
        if (known.empty()) known = wrong;
    }
    // "formula: why it is no data", one a line.
    std::string text() const {
        std::string list;
        for (const auto& [formula, wrong] : found_)
            if (!wrong.empty()) list += "  " + formula + ": " + wrong + "\n";
        return list;
    }
    std::size_t all() const { return found_.size(); }
    std::size_t wrong() const {
        std::size_t n = 0;
        for (const auto& [formula, wrong] : found_) n += !wrong.empty();
        return n;
    }

private:
    static std::string without_numbers(std::string_view formula) {
        std::string text;
        for (std::size_t i = 0; i < formula.size();) {
            const CodePoint c = code_point(formula, i);
            const bool digit = is_digit(c.letter) || lowered_digit(c.letter) >= 0;
            if (!digit)
                text += formula.substr(i, c.bytes);
            else if (!text.ends_with('#'))
                text += '#';
            i += c.bytes;
        }
        return text;
    }
    static std::string objection(const Answer& a) {
        if (a.as_data) return a.unit_check.empty() ? "units are not known" : "";
        std::vector<std::string> symbols;
        for (const Answer& input : a.inputs) symbols.push_back(input.symbol);
        try {
            Formula(a.formula, std::move(symbols));
        } catch (const BadFormula& e) {
            return e.what();
        }
        return "gives another number";
    }

    std::map<std::string, std::string> found_;
};

inline FormulaTally& formula_tally() {
    static FormulaTally tally;
    return tally;
}

}  // namespace pliant
