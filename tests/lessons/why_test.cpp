// Every explanation of every lesson, evaluated again and compared with the value that it explains.
#include <pliant/lesson/scene_file.h>
#include <pliant/lesson/texts.h>
#include <pliant/lesson/why.h>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <set>

using namespace pliant;

namespace {

// A few rows of a field: both ends, the largest value, and some between.
std::set<Index> sample_rows(const Field& field, Index seed) {
    const Index n = field.size();
    if (n == 0) return {};
    std::vector<Real> sizes;
    row_values(field, -1, sizes);
    const Index largest = std::ranges::max_element(sizes, {}, [](Real x) { return std::abs(x); }) - sizes.begin();
    return {0, n - 1, largest, (7 * seed + n / 3) % n, (11 * seed + n / 2) % n};
}

void check_answer(const Answer& a, const std::string& where) {
    using Kind = Answer::Kind;
    INFO(where << ": " << a.field << "[" << a.index << "] component " << a.component << "\n" << why_text(a));
    REQUIRE(std::isfinite(a.value));
    if (a.kind == Kind::computed || a.kind == Kind::part || a.kind == Kind::combined) {
        CHECK(!a.formula.empty());
        CHECK(!a.substituted.empty());
        CHECK(std::abs(a.evaluated - a.value) <= 1e-9 * std::abs(a.value) + 1e-12 * a.conditioning);
    }
    for (const Answer& input : a.inputs) check_answer(input, where);
}

// All that the stage wrote can be explained, by itself or by definition.
void check_stage(Runner& runner, const Stage& stage, const std::string& where) {
    const Lesson& lesson = runner.lesson();
    for (const Field& field : lesson.fields) {
        if (!field.in_use() || !changes(lesson, stage, field)) continue;
        for (const Index row : sample_rows(field, runner.place().step))
            for (int c = 0; c < (field.rank == Rank::scalar ? 1 : field.components); ++c) {
                const Answer a = why(runner, field.name, row, c, 1);
                INFO(where << ": " << field.name << "[" << row << "]");
                CHECK((a.kind == Answer::Kind::computed || a.kind == Answer::Kind::state));
                if (!runner.inside_step()) CHECK(a.kind == Answer::Kind::computed);
                check_answer(a, where);
            }
    }
    for (const std::string_view name : stage.writes) {
        if (lesson.find_field(name) || !lesson.probe(name).value()) continue;
        check_answer(why(runner, name, 0, -1, 1), where);
    }
}

void check_every_stage(Runner& runner, const std::string& where) {
    const Index steps = runner.is_static() ? 1 : 4;
    while (runner.place().step < steps) {
        runner.step_pass();
        const auto last = runner.last_stage();
        if (!last) break;
        const Stage& stage = *runner.stages()[*last];
        // Inner loops of many passes are looked at now and then.
        const Index passes = runner.passes_in_stage();
        if (passes > 2 && passes % 17 != 0) continue;
        check_stage(runner, stage, where + ", stage " + std::string(stage.name));
    }
}

}  // namespace

TEST_CASE("every number that a stage writes is explained by a formula that gives it back") {
    for (const LessonEntry& entry : lessons()) {
        Runner runner(entry);
        check_every_stage(runner, std::string(entry.info.id));
    }
}

TEST_CASE("explanations hold in every scene, method and preset", "[slow]") {
    for (const LessonEntry& entry : lessons()) {
        const auto made = entry.make();
        for (const Parameter* p : made->parameters) {
            if (p->info.kind != Kind::choice && p->info.kind != Kind::toggle) continue;
            for (Real v = p->info.useful.min; v <= p->info.useful.max; ++v) {
                Runner runner(entry, {{std::string(p->info.key), p->text(v)}});
                check_every_stage(runner, std::string(entry.info.id) + " " + std::string(p->info.key) + "=" + p->text(v));
            }
        }
        for (const std::string& name : preset_names(entry.info.id)) {
            Runner runner(entry, preset(entry, name).parameters);
            check_every_stage(runner, std::string(entry.info.id) + " preset " + name);
        }
    }
}

TEST_CASE("asking changes nothing: the run goes on with the same bits") {
    for (const LessonEntry& entry : lessons()) {
        Runner asked(entry), left_alone(entry);
        for (int k = 0; k < 7; ++k) asked.step_pass(), left_alone.step_pass();
        for (const Field& f : asked.lesson().fields)
            if (f.in_use() && f.size() > 0) why(asked, f.name, f.size() / 2, -1, 2);
        INFO(entry.info.id);
        CHECK(asked.place() == left_alone.place());
        for (int k = 0; k < 9; ++k) asked.step_pass(), left_alone.step_pass();
        CHECK(asked.place() == left_alone.place());
        CHECK(state_hash(asked.lesson()) == state_hash(left_alone.lesson()));
    }
}

TEST_CASE("questions lead down to parameters and the state before") {
    for (const LessonEntry& entry : lessons()) {
        Runner runner(entry);
        runner.step_stage();
        std::set<Answer::Kind> found;
        const auto collect = [&](const auto& self, const Answer& a) -> void {
            if (a.inputs.empty()) found.insert(a.kind);
            for (const Answer& input : a.inputs) self(self, input);
        };
        for (const Field& f : runner.lesson().fields)
            if (f.in_use() && f.size() > 0) collect(collect, why(runner, f.name, f.size() / 2, -1, 3));
        INFO(entry.info.id);
        CHECK(found.contains(Answer::Kind::parameter));
        CHECK(found.contains(Answer::Kind::state));
    }
}

TEST_CASE("what does not exist is refused in words") {
    Runner runner(lessons().front());
    runner.step();
    CHECK_THROWS_AS(why(runner, "no_such_field", 0, -1), Refused);
    CHECK_THROWS_AS(why(runner, runner.lesson().fields.front().name, 1 << 30, -1), Refused);
    CHECK_THROWS_AS(why(runner, runner.lesson().fields.front().name, -1, -1), Refused);
    CHECK_THROWS_AS(why(runner, runner.lesson().fields.front().name, 0, 99), Refused);
}
