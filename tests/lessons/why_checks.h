// Explanations, evaluated again and compared with the values that they explain.
#pragma once
#include <pliant/run/why.h>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

namespace pliant {

inline Index largest_row(const Field& field) {
    std::vector<Real> sizes;
    row_values(field, -1, sizes);
    return std::ranges::max_element(sizes, {}, [](Real x) { return std::abs(x); }) - sizes.begin();
}

// A few rows of a field: both ends, the largest value, and some between.
inline std::set<Index> sample_rows(const Field& field, Index seed) {
    const Index n = field.size();
    if (n == 0) return {};
    return {0, n - 1, largest_row(field), (7 * seed + n / 3) % n, (11 * seed + n / 2) % n};
}

inline void check_answer(const Answer& a, const std::string& where) {
    INFO(where << ": " << a.field << "[" << a.index << "] component " << a.component << "\n" << why_text(a));
    REQUIRE(std::isfinite(a.value));
    CHECK(a.trouble == "");
    if (a.kind == Answer::Kind::computed || a.kind == Answer::Kind::part || a.kind == Answer::Kind::combined) {
        CHECK(!a.formula.empty());
        CHECK(!a.substituted.empty());
        // What a slide has wrong on purpose is found to be so.
        CHECK((a.unit_check == "ok") != a.wrong_unit);
        CHECK(!a.latex.empty());
        CHECK(std::abs(a.evaluated - a.value) <= 1e-9 * std::abs(a.value) + 1e-12 * a.conditioning);
    }
    for (const Answer& input : a.inputs) check_answer(input, where);
}

// All that the stage wrote can be explained, by itself or by definition.
inline void check_stage(Runner& runner, const Stage& stage, const std::string& where) {
    const Lesson& lesson = runner.lesson();
    std::vector<AskedNumber> questions;
    for (const Field& field : lesson.fields) {
        if (!field.in_use() || !changes(lesson, stage, field)) continue;
        for (const Index row : sample_rows(field, runner.place().step))
            for (int c = 0; c < (field.rank == Rank::scalar ? 1 : field.components); ++c)
                questions.push_back({field.name, row, c});
    }
    for (const std::string_view name : stage.writes)
        if (!lesson.find_field(name) && lesson.probe(name).value()) questions.push_back({name});
    for (const Answer& a : why(runner, questions)) {
        INFO(where << ": " << a.field << "[" << a.index << "]");
        CHECK((a.kind == Answer::Kind::computed || a.kind == Answer::Kind::state));
        if (!runner.inside_step()) CHECK(a.kind == Answer::Kind::computed);
        check_answer(a, where);
    }
}

// The probes that say how they came about: of the number that is read now.
inline void check_probes(Runner& runner, const std::string& where) {
    for (const Probe& probe : runner.lesson().probes) {
        const std::optional<Real> value = probe.value();
        if (!probe.explain || !value) continue;
        const Answer a = why(runner, "probe:" + std::string(probe.name), 0, -1, 1);
        INFO(where << ": " << probe.name);
        CHECK(a.value == *value);
        check_answer(a, where);
    }
}

// every: of the passes of a long inner loop, each so many-th is looked at.
inline void check_every_stage(Runner& runner, const std::string& where, Index more_steps = 4, Index every = 17) {
    const Index steps = runner.place().step + (runner.is_static() ? 1 : more_steps);
    while (runner.place().step < steps) {
        runner.step_pass();
        const auto last = runner.last_stage();
        if (!last) break;
        const Stage& stage = *runner.stages()[*last];
        // Of a loop over several stages, the first two rounds and the end stand for all.
        const auto rounds = std::ranges::count(runner.executed(), &stage, &Execution::stage);
        if (runner.inside_step() && rounds > (runner.passes_in_stage() ? 1 : 2)) continue;
        // Inner loops of many passes are looked at now and then.
        const Index passes = runner.passes_in_stage();
        if (passes > 2 && passes % every != 0) continue;
        check_stage(runner, stage, where + ", stage " + std::string(stage.name));
    }
    check_probes(runner, where);
}

}  // namespace pliant
