#include <pliant/run/asking.h>
#include <pliant/run/evaluation.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant {

When now_of(const Runner& runner) {
    const Place here = runner.place();
    if (here.passes > 0 || here.step == 0) return {here.step, here.passes};
    const auto& done = runner.executed_before();
    return {here.step - 1, done.empty() ? 0 : done.back().end};
}

namespace {

void ask_below(Asking& asking, Answer& a, std::vector<Request>& next) {
    if (a.kind == Answer::Kind::part)
        for (Answer& input : a.inputs) ask_below(asking, input, next);
    else if (a.can_ask)
        next.push_back(asking.request(a)), a.can_ask = false;
}

// The length of a vector and the norm of a tensor follow from the components.
void combine(Answer& a, const Field& field) {
    a.kind = Answer::Kind::combined;
    const auto names = component_names(field);
    const std::string symbol(field.symbol.empty() ? field.name : field.symbol);
    Explanation length{fmt::format("|{0}| = √(Σ_c {0}_c²)", symbol)};
    for (int c = 0; c < field.components; ++c) {
        Answer part{.symbol = fmt::format("{}_{}", symbol, names[static_cast<std::size_t>(c)]),
                    .field = std::string(field.name),
                    .index = a.index,
                    .component = c,
                    .value = row_value(field, a.index, c),
                    .unit = std::string(field.unit)};
        part.when = a.when;
        part.can_ask = true;
        length.inputs.push_back(Input::now(part.symbol, field.name, a.index, c).in(symbol + "_c"));
        a.inputs.push_back(std::move(part));
    }
    evaluate(a, length);
}

void check_question(const Lesson& lesson, std::string_view name, Index index, int& component) {
    const Field* field = lesson.find_field(name);
    if (!field) {
        const Probe* probe = nullptr;
        try {
            probe = &probe_of(lesson, name);
        } catch (const Refused&) {
            lesson.field(name);  // says which fields there are
        }
        if (!probe->value()) throw Refused(fmt::format("the probe '{}' has no value now", name));
        if (index != 0) throw Refused(fmt::format("'{}' is one number: leave the index out, or give 0", name));
        component = -1;
        return;
    }
    lesson.field(name);
    if (index < 0 || index >= field->size())
        throw Refused(fmt::format("index = {} is outside the field '{}', which has {} {}s: give 0 to {}", index, name,
                                  field->size(), name_of(field->on), field->size() - 1));
    if (component < -1 || component >= field->components)
        throw Refused(fmt::format("component = {} does not exist: '{}' has {}; -1 stands for the whole", component, name,
                                  field->components));
    if (field->rank == Rank::scalar) component = -1;
}

Answer unanswered(const Lesson& lesson, const AskedNumber& q, When now) {
    int component = q.component;
    check_question(lesson, q.field, q.index, component);
    const Field* f = lesson.find_field(q.field);
    Answer root{.field = std::string(q.field), .index = q.index, .component = component, .of_probe = !f};
    root.symbol = f ? f->symbol : probe_of(lesson, q.field).symbol;
    if (f && component >= 0) root.symbol += "_" + component_names(*f)[static_cast<std::size_t>(component)];
    root.unit = f ? f->unit : probe_of(lesson, q.field).unit;
    root.when = q.when.value_or(now);
    return root;
}

void find_value(Asking& asking, const Lesson& lesson, Answer& root) {
    // Inside a step a field may still be what the step before left. A probe that follows from fields is what they make of it now.
    const bool follows = root.of_probe && probe_of(lesson, root.field).explain;
    if (root.when.step > 0 && !follows && !asking.has_writer(root)) {
        const auto& before = asking.executions(root.when.step - 1);
        if (!before.empty()) root.when = {root.when.step - 1, before.back().end};
    }
    asking.stand_at(root.when);
    root.value = asking.value_now(root);
    root.can_ask = true;
    const Field* f = lesson.find_field(root.field);
    if (f && f->rank != Rank::scalar && root.component < 0) combine(root, *f);
}

}  // namespace

std::vector<Answer> why(Runner& runner, std::span<const AskedNumber> questions, int depth) {
    const Lesson& lesson = runner.lesson();
    std::vector<Answer> roots;
    for (const AskedNumber& q : questions) roots.push_back(unanswered(lesson, q, now_of(runner)));

    Asking asking(runner);
    for (Answer& root : roots) find_value(asking, lesson, root);
    std::vector<Request> level, next;
    for (Answer& root : roots) {
        if (root.kind != Answer::Kind::combined)
            ask_below(asking, root, level);
        else
            for (Answer& part : root.inputs) ask_below(asking, part, level);
    }
    for (int d = 0; d < depth && !level.empty(); ++d) {
        asking.answer(level);
        next.clear();
        if (d + 1 < depth)
            for (const Request& r : level)
                for (Answer& input : r.answer->inputs) ask_below(asking, input, next);
        level = std::move(next);
        next = {};
    }
    return roots;
}

Answer why(Runner& runner, std::string_view field, Index index, int component, int depth, std::optional<When> when) {
    const AskedNumber question{field, index, component, when};
    return why(runner, std::span(&question, 1), depth).front();
}

}  // namespace pliant
