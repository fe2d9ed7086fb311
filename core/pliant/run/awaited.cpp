#include <pliant/run/awaited.h>

#include <algorithm>

namespace pliant {
namespace {

// The first stage in use that writes this name, while it has not run in the first step.
const Stage* stage_to_come(const Runner& runner, std::string_view name) {
    if (runner.place().step > 0) return nullptr;
    for (const Stage* stage : runner.stages()) {
        if (std::ranges::find(stage->writes, name) == stage->writes.end()) continue;
        const bool ran = std::ranges::find(runner.executed(), stage, &Execution::stage) != runner.executed().end();
        const bool runs = runner.inside_step() && runner.stages()[runner.next_stage()] == stage && runner.passes_in_stage() > 0;
        return ran || runs ? nullptr : stage;
    }
    return nullptr;
}

// By a field that is put in, or by one that a part of the formula takes.
const Stage* awaited_by(const Runner& runner, const Explanation& why) {
    for (const Input& in : why.inputs) {
        const Field* field = in.from == Input::From::now ? runner.lesson().find_field(in.name) : nullptr;
        const Stage* stage = field ? awaited_stage(runner, *field) : in.why ? awaited_by(runner, *in.why) : nullptr;
        if (stage) return stage;
    }
    return nullptr;
}

bool is_state(const Lesson& lesson, const Field& field) {
    const Real* const numbers = field.view().data();
    return std::ranges::any_of(lesson.state,
                               [&](const StateArray& s) { return s.name == field.name || s.view().data() == numbers; });
}

}  // namespace

const Stage* awaited_stage(const Runner& runner, const Field& field) {
    if (runner.place().step > 0 || !field.in_use()) return nullptr;
    for (const std::string_view source : field.defined_by)
        if (const Field* f = runner.lesson().find_field(source))
            if (const Stage* stage = awaited_stage(runner, *f)) return stage;
    const auto numbers = field.view();
    if (is_state(runner.lesson(), field) || std::ranges::any_of(numbers, [](Real value) { return value != 0; })) return nullptr;
    return stage_to_come(runner, field.name);
}

std::vector<std::string> awaited_fields(const Runner& runner) {
    std::vector<std::string> names;
    if (runner.place().step > 0) return names;
    for (const Field& field : runner.lesson().fields)
        if (awaited_stage(runner, field)) names.emplace_back(field.name);
    return names;
}

const Stage* awaited_stage(const Runner& runner, const Probe& probe) {
    if (runner.place().step > 0) return nullptr;
    if (const Stage* stage = stage_to_come(runner, probe.name))
        if (const auto value = probe.value(); !value || *value == 0) return stage;
    return probe.explain ? awaited_by(runner, probe.explain()) : nullptr;
}

}  // namespace pliant
