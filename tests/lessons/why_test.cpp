// Every explanation of every lesson, evaluated again and compared with the value that it explains.
#include "../every_lesson.h"
#include "why_checks.h"

#include <pliant/document/scene_file.h>
#include <pliant/text/texts.h>

using namespace pliant;
using namespace pliant::test;

TEST_CASE("every number that a stage writes is explained by a formula that gives it back", "[every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        Runner runner(entry);
        check_every_stage(runner, std::string(entry.info.id));
    }
}

namespace {
// A static lesson, whose step may take thousands of passes, is asked when it is done.
void check_briefly(Runner& runner, const std::string& where) {
    if (!runner.is_static()) return check_every_stage(runner, where, 1, 101);
    runner.step();
    for (const Stage* stage : runner.stages()) check_stage(runner, *stage, where);
    check_probes(runner, where);
}
}  // namespace

TEST_CASE("explanations hold in every scene, method and preset", "[slow][every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        const auto made = entry.make();
        for (const Parameter* p : made->parameters) {
            if (p->info.kind != Kind::choice && p->info.kind != Kind::toggle) continue;
            for (Real v = p->info.useful.min; v <= p->info.useful.max; ++v) {
                Runner runner(entry, {{std::string(p->info.key), p->text(v)}});
                check_briefly(runner, std::string(entry.info.id) + " " + std::string(p->info.key) + "=" + p->text(v));
            }
        }
        for (const std::string& name : preset_names(entry.info.id)) {
            Runner runner(entry, preset(entry, name).parameters);
            check_briefly(runner, std::string(entry.info.id) + " preset " + name);
        }
    }
}

TEST_CASE("asking changes nothing: the run goes on with the same bits", "[every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
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

TEST_CASE("questions lead down to parameters and the state before", "[every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        Runner runner(entry);
        runner.step_stage();
        std::set<Answer::Kind> found;
        const auto collect = [&](const auto& self, const Answer& a) -> void {
            if (a.inputs.empty()) found.insert(a.kind);
            for (const Answer& input : a.inputs) self(self, input);
        };
        for (const Field& f : runner.lesson().fields)
            if (f.in_use() && f.size() > 0) collect(collect, why(runner, f.name, largest_row(f), -1, 3));
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
