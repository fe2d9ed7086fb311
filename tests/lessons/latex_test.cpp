// Every formula that a lesson shows is valid LaTeX, as its page prints it.
#include "../every_lesson.h"
#include "../latex_checker.h"

#include <pliant/document/extensions.h>
#include <pliant/formula/notation.h>

#include <catch2/catch_test_macros.hpp>

using namespace pliant;
using namespace pliant::test;

namespace {

void check_latex(std::string_view formula) {
    const std::string text = latex(formula);
    INFO(formula << "\n" << text);
    CHECK(latex_objection(text).empty());
    if (const std::string wrong = latex_objection(text); !wrong.empty()) FAIL_CHECK(wrong);
}

void check_slides(const Walkthrough& w) {
    for (const Slide& s : w.slides)
        for (const Block& b : s.blocks)
            if (b.kind == BlockKind::formula)
                for (const std::string& line : b.lines) check_latex(line);
}

// With each option of each choice, since those decide which formula is in force.
void check_stages(Lesson& lesson) {
    for (const Stage& s : lesson.stages) check_latex(s.formula);
    for (Parameter* p : lesson.parameters) {
        if (p->info.kind != Kind::choice) continue;
        const Real chosen = p->value();
        for (std::size_t i = 0; i < p->info.options.size(); ++i) {
            p->set(static_cast<Real>(i));
            for (const Stage& s : lesson.stages) check_latex(s.formula_now());
        }
        p->set(chosen);
    }
}

}  // namespace

TEST_CASE("latex: what is no LaTeX is found") {
    for (const char* valid : {"", "a + b", "x_{ij}^{2}", "\\frac{a}{b}", "\\left(\\alpha\\right)", "\\text{slope of ε, at 3}",
                              "\\begin{bmatrix} a & b \\\\ c & d \\end{bmatrix}", "\\left\\|r\\right\\|", "\\left\\{a\\right.",
                              "10^{-3}\\%", "\\mathrm{m}^{2}"})
        CHECK(latex_objection(valid).empty());
    for (const char* wrong : {"{a",
                              "a}",
                              "\\frac{a}",
                              "\\fraction{a}{b}",
                              "x^{a}^{b}",
                              "x_{a}_{b}",
                              "\\left(a",
                              "a\\right)",
                              "α",
                              "a & b",
                              "a \\\\ b",
                              "5%",
                              "\\text{a_b}",
                              "\\text{5%}",
                              "\\text{a",
                              "\\begin{bmatrix} a",
                              "\\left a\\right)",
                              "_{a}",
                              "x^a",
                              "\\begin{matrix} a \\end{matrix}"}) {
        INFO(wrong);
        CHECK_FALSE(latex_objection(wrong).empty());
    }
}

TEST_CASE("latex: the formulas of every lesson are valid", "[every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        INFO(entry.info.id);
        const auto lesson = entry.make();
        check_stages(*lesson);
        for (const Assumption& a : lesson->assumptions) check_latex(a.formula);
        for (const Field& f : lesson->fields) check_latex(f.symbol);
        for (const Probe& p : lesson->probes) check_latex(p.symbol);
        for (const Parameter* p : lesson->parameters) check_latex(p->info.symbol);
        for (const Extension& e : extensions_of(entry)) check_slides(e.walkthrough);
        if (entry.info.id != "time/bead_chain") check_slides(walkthrough_of(entry));
    }
}
