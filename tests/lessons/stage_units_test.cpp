// The formulas of the stages against the units of the symbols that the lesson declares.
#include "../every_lesson.h"

#include <pliant/formula/equation_units.h>
#include <pliant/run/why.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

using namespace pliant;
using namespace pliant::test;

namespace {

// Of what a stage of the lesson writes, its inputs and theirs, as its explanations name them.
SymbolUnits explained_by(Runner& runner, const Stage& stage) {
    std::vector<AskedNumber> questions;
    for (const std::string_view name : stage.writes)
        if (const Field* field = runner.lesson().find_field(name); field && field->in_use() && field->size() > 0)
            questions.push_back({name, field->size() / 2, 0});
    SymbolUnits units;
    const auto add = [&](const auto& self, const Answer& a) -> void {
        if (!a.symbol.empty() && is_unit(a.unit)) units.add(a.symbol, Unit(a.unit));
        for (const Answer& input : a.inputs) self(self, input);
    };
    for (const Answer& a : why(runner, questions, 3)) add(add, a);
    return units;
}

// The stage's own symbols come before those of the lesson, these before what is declared, and this before what is explained.
SymbolUnits known_in(const Lesson& lesson, const Stage& stage, const SymbolUnits& explained) {
    SymbolUnits units;
    for (const Field& f : lesson.fields) units.add(f.symbol, Unit(f.unit));
    for (const Parameter* p : lesson.parameters) units.add(p->info.symbol, Unit(p->info.unit));
    for (const Probe& p : lesson.probes) units.add(p.symbol, Unit(p.unit));
    for (const Symbol& s : lesson.formula_symbols) units.set(s.symbol, Unit(s.unit));
    for (const Symbol& s : stage.symbols) units.set(s.symbol, Unit(s.unit));
    units.complete_with(explained);
    // The identity, a normal.
    for (const char* number : {"I", "n"}) units.add(number, Unit());
    return units;
}

bool equates(std::string_view text) {
    constexpr std::array<std::string_view, 7> relations{"=", "←", "≈", "≤", "≥", "<", ">"};
    return std::ranges::any_of(relations, [&](std::string_view r) { return text.find(r) != text.npos; });
}

// "a = b,  c ← d;  label: e = f" as its pieces; those that a label says to be the slide's may be wrong.
std::vector<std::string> equations_of(std::string text) {
    std::vector<std::string> pieces;
    for (const std::string_view mark : {";  ", ",  ", ":  ", "   "})
        for (std::size_t at; (at = text.find(mark)) != text.npos;) text.replace(at, mark.size(), "\n");
    std::size_t from = 0;
    while (from <= text.size()) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        std::string piece = text.substr(from, end - from);
        from = end + 1;
        if (piece.find("slide") != piece.npos) continue;
        if (const std::size_t label = piece.find(": "); label != piece.npos && !equates(piece.substr(0, label)))
            piece = piece.substr(label + 2);
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

}  // namespace

TEST_CASE("stages: both sides of a formula have the same unit", "[every_lesson]") {
    int all = 0;
    std::vector<std::string> open;
    for (const LessonEntry& entry : every_lesson()) {
        Runner runner(entry);
        runner.step();
        const Lesson& lesson = runner.lesson();
        for (const Stage& stage : lesson.stages) {
            const SymbolUnits symbols = known_in(lesson, stage, stage.in_use() ? explained_by(runner, stage) : SymbolUnits());
            for (const std::string& equation : equations_of(std::string(stage.formula))) {
                if (!equates(equation)) continue;
                const EquationCheck check = check_units(equation, symbols);
                INFO(entry.info.id << ", stage " << stage.name << ": " << equation);
                CHECK(check.mismatch == "");
                ++all;
                if (!check.known)
                    open.push_back(fmt::format("{}, {}: {} (unknown: {})", entry.info.id, stage.name, equation, check.unknown));
            }
        }
    }
    WARN(fmt::format("{} of {} equations of stages are not checked: {}", open.size(), all, fmt::join(open, " | ")));
    // What a formula says in words.
    CHECK(open.size() <= 2);
}
