#include <pliant/run/asking.h>
#include <pliant/run/evaluation.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant {

const Probe& probe_of(const Lesson& lesson, std::string_view name) {
    constexpr std::string_view prefix = "probe:";
    return lesson.probe(name.starts_with(prefix) ? name.substr(prefix.size()) : name);
}

Request Asking::request(Answer& answer) const {
    const Field* field = lesson_.find_field(answer.field);
    return {&answer, field, field ? nullptr : &probe_of(lesson_, answer.field)};
}

void Asking::stand_at(When when) {
    const bool here = standing_ && at_ == when && (earlier_known_ || when.passes == 0);
    if (here) return;
    if (!standing_ || at_.step != when.step || at_.passes >= when.passes) {
        if (!is_stored(when.step))
            throw Refused(fmt::format("step {} is no longer stored: there is nothing to explain it from", when.step));
    }
    while (at_.passes < when.passes) {
        earlier_known_ = at_.passes + 1 == when.passes;
        if (earlier_known_) {
            earlier_.resize(lesson_.fields.size());
            for (std::size_t k = 0; k < earlier_.size(); ++k) {
                earlier_[k].clear();
                if (!lesson_.fields[k].in_use()) continue;
                const auto numbers = lesson_.fields[k].view();
                earlier_[k].assign(numbers.begin(), numbers.end());
            }
        }
        revisit_.pass();
        ++at_.passes;
    }
}

const std::vector<Execution>& Asking::executions(Index step) {
    const auto known = executions_.find(step);
    if (known != executions_.end()) return known->second;
    std::vector<Execution>& list = executions_[step];
    if (!is_stored(step)) return list;
    const Place here = revisit_.here();
    while (runner_.place().step == step && runner_.place() != here) revisit_.pass(), ++at_.passes, earlier_known_ = false;
    if (runner_.place().step != step) return list = runner_.executed_before();
    list = runner_.executed();
    // A stage that is in the middle of its passes.
    if (runner_.passes_in_stage() > 0)
        list.push_back({runner_.stages()[runner_.next_stage()], here.passes - runner_.passes_in_stage(), here.passes});
    return list;
}

void Asking::find_writers(Request& r) {
    const When when = r.answer->when;
    for (const Execution& e : executions(when.step)) {
        if (e.begin >= when.passes) break;
        const bool writes = r.field ? changes(lesson_, *e.stage, *r.field)
                                    : std::ranges::find(e.stage->writes, r.probe->name) != e.stage->writes.end();
        if (writes) r.writers.insert(r.writers.begin(), {e.stage, e.begin, std::min(e.end, when.passes)});
    }
    r.target = r.writers.empty() ? when : When{when.step, r.writers.front().end};
}

bool Asking::has_writer(Answer& answer) {
    Request r = request(answer);
    find_writers(r);
    return !r.writers.empty();
}

Real Asking::value_now(const Answer& a) const {
    const Field* field = lesson_.find_field(a.field);
    if (field) return row_value(*field, a.index, a.component);
    return runner_.value(probe_of(lesson_, a.field)).value_or(0);
}

void Asking::answer(std::vector<Request>& level) {
    for (Request& r : level) find_writers(r);
    std::ranges::stable_sort(level, {}, &Request::target);
    for (Request& r : level)
        while (!explain_one(r)) {
        }
}

// False when the stage that was asked has not written the number yet, and an earlier one is to be asked.
bool Asking::explain_one(Request& r) {
    Answer& a = *r.answer;
    const bool defined = r.field ? static_cast<bool>(r.field->explain) : static_cast<bool>(r.probe->explain);
    if (r.writers.empty() && !defined) {
        a.kind = r.field ? Answer::Kind::state : Answer::Kind::given;
        return true;
    }
    if (r.writers.empty() && a.when.passes == 0)
        stand_at({a.when.step, 0});
    else
        stand_at(r.writers.empty() ? a.when : When{a.when.step, r.writers.front().end});
    const Question question{r.field ? r.field->name : r.probe->name, a.index, std::max(a.component, 0)};
    if (!r.writers.empty()) a.stage = r.writers.front().stage->name, a.source = r.writers.front().stage->source;
    std::optional<Explanation> e;
    if (defined)
        e = r.field ? r.field->explain(question) : r.probe->explain();
    else if (const Stage& stage = *r.writers.front().stage; stage.explain)
        e = stage.explain(question);
    else
        return a.kind = Answer::Kind::given, true;
    if (e) {
        a.kind = Answer::Kind::computed;
        return fill(a, *e, r), true;
    }
    r.writers.erase(r.writers.begin());
    if (r.writers.empty()) {
        a.kind = Answer::Kind::state;
        a.stage.clear(), a.source.clear();
        return true;
    }
    return false;
}

Real Asking::look_up(const Input& in, const Request& r) const {
    const Field* field = lesson_.find_field(in.name);
    if (!field) return runner_.value(probe_of(lesson_, in.name)).value_or(0);
    if (in.from == Input::From::now) return row_value(*field, in.index, in.component);
    const Index begin = r.writers.empty() ? 0 : r.writers.front().begin;
    std::span<const Real> numbers =
        in.from == Input::From::before ? revisit_.trace().at(lesson_, begin, in.name)
                                       : std::span<const Real>(earlier_[static_cast<std::size_t>(field - lesson_.fields.data())]);
    const auto at = static_cast<std::size_t>(in.index * field->components + in.component);
    if (at >= numbers.size())
        throw std::logic_error(fmt::format("an explanation asks for {} [{}], which does not exist", in.name, in.index));
    return numbers[at];
}

Answer Asking::input(const Input& in, const Request& r) {
    Answer a{
        .symbol = in.symbol, .field = in.name, .index = in.index, .component = in.component, .value = in.value, .unit = in.unit};
    a.when = {at_.step, at_.passes};
    using From = Input::From;
    switch (in.from) {
        case From::parameter:
            a.kind = Answer::Kind::parameter;
            a.value = lesson_.parameter(in.name).value();
            break;
        case From::constant:
            a.kind = Answer::Kind::constant;
            if (in.value_now) a.value = in.value_now();
            break;
        case From::part:
            a.kind = Answer::Kind::part;
            break;
        default: {
            a.kind = Answer::Kind::given;
            a.value = look_up(in, r);
            const Field* field = lesson_.find_field(in.name);
            a.unit = field ? field->unit : probe_of(lesson_, in.name).unit;
            if (field && field->rank == Rank::scalar) a.component = -1;
            if (!field) a.component = -1, a.of_probe = true;
            if (in.from == From::before) a.when.passes = r.writers.empty() ? 0 : r.writers.front().begin;
            if (in.from == From::earlier) a.when.passes = at_.passes - 1;
            const bool defined = field ? static_cast<bool>(field->explain) : static_cast<bool>(lesson_.probe(in.name).explain);
            a.can_ask = defined || has_writer(a);
            if (!a.can_ask) a.kind = Answer::Kind::state;
        }
    }
    return a;
}

// A number of the field that is explained, taken as the stage left it, is an unknown of the same solve: to ask for it in turn
// would lead back here. What else the stage writes tells what is left of the equation.
void Asking::mark_unknowns(Answer& a, const Explanation& e, const Request& r) const {
    if (!r.field || r.writers.empty()) return;
    const auto of_solve = [&](const Answer& in, const Input& declared) {
        return declared.from == Input::From::now && in.field == r.field->name;
    };
    bool any = false;
    for (std::size_t k = 0; k < e.inputs.size(); ++k)
        if (of_solve(a.inputs[k], e.inputs[k])) a.inputs[k].together = any = true, a.inputs[k].can_ask = false;
    if (!any) return;
    const auto& writes = r.writers.front().stage->writes;
    for (std::size_t k = 0; k < e.inputs.size(); ++k)
        if (e.inputs[k].from == Input::From::now && !a.inputs[k].together &&
            std::ranges::find(writes, a.inputs[k].field) != writes.end())
            a.inputs[k].leftover = true;
}

// The numbers of a formula that was declared.
void Asking::fill(Answer& a, const Explanation& e, const Request& r) {
    a.inputs.reserve(e.inputs.size());
    for (const Input& in : e.inputs) {
        Answer& child = a.inputs.emplace_back(input(in, r));
        if (!in.why) continue;
        fill(child, *in.why, r);
        child.value = child.evaluated;
    }
    mark_unknowns(a, e, r);
    evaluate(a, e);
}

}  // namespace pliant
