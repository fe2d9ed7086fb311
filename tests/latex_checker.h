// Whether LaTeX of formulas is such as it reads: what braces, commands, indices, fences and matrices must be. Of the commands
// only those that plain LaTeX with amsmath has and formulas use.
#pragma once
#include <cctype>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

namespace pliant::test {

class LatexChecker {
public:
    explicit LatexChecker(std::string_view text) : text_(text) {}

    // "" for valid text, else what is wrong and where.
    std::string objection() {
        try {
            row(Ends::text);
            return "";
        } catch (const std::runtime_error& e) {
            return std::string(e.what()) + " at letter " + std::to_string(at_ + 1);
        }
    }

private:
    enum class Ends { text, brace, right, matrix };

    [[noreturn]] static void refuse(const std::string& what) { throw std::runtime_error(what); }
    bool done() const { return at_ >= text_.size(); }
    char here() const { return done() ? '\0' : text_[at_]; }
    void skip_blanks() {
        while (here() == ' ') ++at_;
    }

    static bool is_known(const std::string& command) {
        static const std::set<std::string> known{"alpha",  "beta",       "gamma",
                                                 "delta",  "varepsilon", "zeta",
                                                 "eta",    "theta",      "kappa",
                                                 "lambda", "mu",         "nu",
                                                 "xi",     "pi",         "rho",
                                                 "sigma",  "tau",        "varphi",
                                                 "chi",    "psi",        "omega",
                                                 "Gamma",  "Delta",      "Theta",
                                                 "Lambda", "Phi",        "Psi",
                                                 "Omega",  "sum",        "int",
                                                 "prod",   "partial",    "nabla",
                                                 "cdot",   "times",      "pm",
                                                 "infty",  "leftarrow",  "rightarrow",
                                                 "le",     "ge",         "approx",
                                                 "ne",     "in",         "propto",
                                                 "dots",   "circ",       "prime",
                                                 "sin",    "cos",        "tan",
                                                 "sinh",   "cosh",       "tanh",
                                                 "exp",    "angle",      "Leftrightarrow",
                                                 "ln",     "log",        "min",
                                                 "max",    "det",        "arcsin",
                                                 "arccos", "arctan",     "quad",
                                                 "sim",    "ll",         "gg",
                                                 "otimes", "ell",        "oint",
                                                 "langle", "rangle",     "%",
                                                 "{",      "}",          "|",
                                                 ",",      "&",          "#",
                                                 "$",      "_",          " "};
        return known.contains(command);
    }
    // One argument: "hat", "sqrt", or two: "frac".
    static int arguments_of(const std::string& command) {
        static const std::set<std::string> one{"sqrt", "hat", "tilde", "bar", "dot", "ddot"};
        return command == "frac" || command == "tfrac" ? 2 : one.contains(command) ? 1 : 0;
    }
    static bool takes_words(const std::string& command) {
        return command == "text" || command == "mathrm" || command == "operatorname";
    }

    // Behind the backslash.
    std::string command() {
        const std::size_t from = at_;
        while (std::isalpha(static_cast<unsigned char>(here()))) ++at_;
        if (at_ == from && !done()) ++at_;
        return std::string(text_.substr(from, at_ - from));
    }

    void group() {
        if (here() != '{') refuse("an argument in braces is missing");
        ++at_;
        row(Ends::brace);
    }
    // In words any letter may stand but those that LaTeX reads otherwise.
    void words() {
        if (here() != '{') refuse("words in braces are missing");
        for (++at_; here() != '}'; ++at_) {
            if (done()) refuse("words have no end");
            if (here() == '\\') {
                ++at_;
                if (std::string_view("%&#$_{}").find(here()) == std::string_view::npos) refuse("a command stands in words");
            } else if (std::string_view("%&#$_^{~").find(here()) != std::string_view::npos) {
                refuse(std::string("'") + here() + "' stands in words");
            }
        }
        ++at_;
    }
    void delimiter() {
        if (here() == '\\') {
            ++at_;
            const std::string name = command();
            if (name != "|" && name != "{" && name != "}" && name != "langle" && name != "rangle")
                refuse("no delimiter: \\" + name);
            return;
        }
        if (std::string_view("()[]|.").find(here()) == std::string_view::npos || done()) refuse("no delimiter");
        ++at_;
    }

    void row(Ends ends) {
        bool above = false, below = false, base = false;  // of the piece before
        for (;;) {
            skip_blanks();
            if (done()) {
                if (ends != Ends::text) refuse("a group has no end");
                return;
            }
            const char c = here();
            if (c == '}') {
                if (ends != Ends::brace) refuse("a brace closes nothing");
                ++at_;
                return;
            }
            if (c == '^' || c == '_') {
                bool& taken = c == '^' ? above : below;
                if (taken) refuse("two exponents, or two indices, in a row");
                if (!base && c == '_') refuse("an index of nothing");
                taken = true;
                ++at_;
                group();
                continue;
            }
            above = below = false;
            base = true;
            if (c == '{') {
                group();
            } else if (c == '\\') {
                ++at_;
                if (piece(ends)) return;
            } else if (c == '&') {
                if (ends != Ends::matrix) refuse("'&' stands outside of a matrix");
                ++at_;
            } else {
                if (static_cast<unsigned char>(c) >= 0x80) refuse("a letter that is not ASCII stands outside of words");
                if (std::string_view("%#$~").find(c) != std::string_view::npos) refuse(std::string("'") + c + "' is not escaped");
                ++at_;
            }
        }
    }
    // Behind a backslash; does it end the row?
    bool piece(Ends ends) {
        if (here() == '\\') {
            if (ends != Ends::matrix) refuse("a line ends outside of a matrix");
            ++at_;
            return false;
        }
        const std::string name = command();
        if (name == "left") {
            delimiter();
            row(Ends::right);
        } else if (name == "right") {
            if (ends != Ends::right) refuse("\\right without \\left");
            delimiter();
            return true;
        } else if (name == "begin") {
            words_are("{bmatrix}");
            row(Ends::matrix);
        } else if (name == "end") {
            if (ends != Ends::matrix) refuse("\\end without \\begin");
            words_are("{bmatrix}");
            return true;
        } else if (takes_words(name)) {
            words();
        } else if (const int count = arguments_of(name); count > 0) {
            for (int i = 0; i < count; ++i) group();
        } else if (!is_known(name)) {
            refuse("unknown command \\" + name);
        }
        return false;
    }
    void words_are(std::string_view wanted) {
        if (!text_.substr(at_).starts_with(wanted)) refuse("unknown environment");
        at_ += wanted.size();
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

inline std::string latex_objection(std::string_view text) { return LatexChecker(text).objection(); }

}  // namespace pliant::test
