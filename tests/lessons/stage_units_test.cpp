// The formulas of the stages against the units of the symbols that the lesson declares.
#include "../every_lesson.h"

#include <pliant/formula/equation_units.h>
#include <pliant/lesson/registry.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

using namespace pliant;
using namespace pliant::test;

namespace {

SymbolUnits declared_by(const Lesson& lesson) {
    SymbolUnits units;
    for (const Field& f : lesson.fields) units.add(f.symbol, Unit(f.unit));
    for (const Parameter* p : lesson.parameters) units.add(p->info.symbol, Unit(p->info.unit));
    for (const Probe& p : lesson.probes) units.add(p.symbol, Unit(p.unit));
    // The identity, a normal.
    for (const char* number : {"I", "n"}) units.add(number, Unit());
    return units;
}

// "a = b,  c ← d;  label: e = f" as its pieces; those that a label says to be the slide's may be wrong.
std::vector<std::string> equations_of(std::string text) {
    std::vector<std::string> pieces;
    for (const std::string_view mark : {";  ", ",  ", "   "})
        for (std::size_t at; (at = text.find(mark)) != text.npos;) text.replace(at, mark.size(), "\n");
    std::size_t from = 0;
    while (from <= text.size()) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        std::string piece = text.substr(from, end - from);
        from = end + 1;
        if (piece.find("slide") != piece.npos) continue;
        if (const std::size_t label = piece.find(": "); label != piece.npos) piece = piece.substr(label + 2);
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

}  // namespace

TEST_CASE("stages: both sides of a formula have the same unit where their symbols are declared", "[every_lesson]") {
    int checked = 0, all = 0;
    std::vector<std::string> open;
    for (const LessonEntry& entry : every_lesson()) {
        const auto lesson = entry.make();
        const SymbolUnits symbols = declared_by(*lesson);
        for (const Stage& stage : lesson->stages)
            for (const std::string& equation : equations_of(std::string(stage.formula))) {
                if (equation.find_first_of("=") == equation.npos && equation.find("←") == equation.npos) continue;
                const EquationCheck check = check_units(equation, symbols);
                INFO(entry.info.id << ", stage " << stage.name << ": " << equation);
                CHECK(check.mismatch == "");
                ++all;
                if (check.known)
                    ++checked;
                else
                    open.push_back(fmt::format("{}: {}", stage.name, equation));
            }
    }
    WARN(fmt::format("{} of {} equations of stages checked; not: {}", checked, all, fmt::join(open, " | ")));
    CHECK(checked + static_cast<int>(open.size()) == all);
}
