#include <pliant/lesson/format.h>
#include <pliant/lesson/revisit.h>
#include <pliant/lesson/why.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pliant {

When now_of(const Runner& runner) {
    const Place here = runner.place();
    if (here.passes > 0 || here.step == 0) return {here.step, here.passes};
    const auto& done = runner.executed_before();
    return {here.step - 1, done.empty() ? 0 : done.back().end};
}

namespace {

constexpr std::string_view probe_prefix = "probe:";

const Probe& probe_of(const Lesson& lesson, std::string_view name) {
    return lesson.probe(name.starts_with(probe_prefix) ? name.substr(probe_prefix.size()) : name);
}

// A number whose origin is wanted, and where the answer goes.
struct Request {
    Answer* answer;
    const Field* field;  // or
    const Probe* probe;
    std::vector<Execution> writers{};  // candidates, the latest first
    When target{};                     // where to stand when asking
};

// One level of questions after the other; the run passes over the places of a level once, in their order.
class Asking {
public:
    explicit Asking(Runner& runner) : runner_(runner), lesson_(runner.lesson()), revisit_(runner) {}

    void answer(std::vector<Request>& level);
    Request request(Answer& answer) const;
    void stand_at(When when);
    Real value_now(const Answer& a) const;
    bool is_stored(Index step) { return revisit_.start_of(step) && (at_ = {step, 0}, standing_ = true); }
    const std::vector<Execution>& executions(Index step);
    bool has_writer(Answer& answer);

private:
    void find_writers(Request& r);
    bool explain_one(Request& r);
    void fill(Answer& a, const Explanation& e, const Request& r);
    Answer input(const Input& in, const Request& r);
    Real look_up(const Input& in, const Request& r) const;

    Runner& runner_;
    const Lesson& lesson_;
    Revisit revisit_;
    When at_;
    bool standing_ = false;                   // at at_; else at the present
    bool earlier_known_ = false;              // does earlier_ belong to at_?
    std::vector<std::vector<Real>> earlier_;  // the fields one pass ago
    std::map<Index, std::vector<Execution>> executions_;
};

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
            break;
        case From::constant:
            a.kind = Answer::Kind::constant;
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

// How much cancels: each input moved by a part in a million of its size, and a part of what cancels in it. Of the very many
// inputs of a long sum a sample stands for all.
Real conditioning_of(const Explanation& e, const Answer& a, std::vector<Real>& values) {
    constexpr Real nudge = 1e-6;
    constexpr std::size_t most = 512;
    const std::size_t stride = values.size() / most + 1;
    Real sum = 0;
    for (std::size_t k = 0; k < values.size(); k += stride) {
        const Real kept = values[k], size = std::max(std::abs(kept), a.inputs[k].conditioning);
        values[k] = kept + nudge * size;
        sum += static_cast<Real>(stride) * std::abs(e.evaluate(values) - a.evaluated) / nudge;
        values[k] = kept;
    }
    return sum;
}

// The numbers of a formula that was declared.
void Asking::fill(Answer& a, const Explanation& e, const Request& r) {
    std::vector<Real> values;
    a.inputs.reserve(e.inputs.size());
    for (const Input& in : e.inputs) {
        Answer& child = a.inputs.emplace_back(input(in, r));
        if (in.why) {
            fill(child, *in.why, r);
            child.value = child.evaluated;
        }
        values.push_back(child.value);
    }
    a.formula = e.formula;
    a.substituted = substituted(e, values);
    a.evaluated = e.evaluate(values);
    a.conditioning = conditioning_of(e, a, values);
}

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
    std::vector<Real> values;
    Real sum = 0;
    for (int c = 0; c < field.components; ++c) {
        Answer part{.symbol = fmt::format("{}_{}", symbol, names[static_cast<std::size_t>(c)]),
                    .field = std::string(field.name),
                    .index = a.index,
                    .component = c,
                    .value = row_value(field, a.index, c),
                    .unit = std::string(field.unit)};
        part.when = a.when;
        part.can_ask = true;
        sum += part.value * part.value;
        values.push_back(part.value);
        a.inputs.push_back(std::move(part));
    }
    a.formula = fmt::format("|{}| = √(Σ {}_c²)", symbol, symbol);
    a.substituted = fmt::format("|{}| = √(", symbol);
    for (std::size_t c = 0; c < values.size(); ++c)
        a.substituted += fmt::format("{}{}²", c ? " + " : "", as_factor(values[c], true));
    a.substituted += ")";
    a.evaluated = std::sqrt(sum);
    a.conditioning = a.evaluated;
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

}  // namespace

Answer why(Runner& runner, std::string_view field, Index index, int component, int depth, std::optional<When> when) {
    const Lesson& lesson = runner.lesson();
    check_question(lesson, field, index, component);
    const Field* f = lesson.find_field(field);
    Answer root{.field = std::string(field), .index = index, .component = component, .of_probe = !f};
    root.symbol = f ? f->symbol : probe_of(lesson, field).symbol;
    if (f && component >= 0) root.symbol += "_" + component_names(*f)[static_cast<std::size_t>(component)];
    root.unit = f ? f->unit : probe_of(lesson, field).unit;
    root.when = when.value_or(now_of(runner));

    Asking asking(runner);
    // Inside a step a field may still be what the step before left.
    if (root.when.step > 0 && !asking.has_writer(root)) {
        const auto& before = asking.executions(root.when.step - 1);
        if (!before.empty()) root.when = {root.when.step - 1, before.back().end};
    }
    if (asking.is_stored(root.when.step)) asking.stand_at(root.when);
    root.value = asking.value_now(root);
    root.can_ask = true;
    if (f && f->rank != Rank::scalar && component < 0) combine(root, *f);

    std::vector<Request> level, next;
    if (root.kind == Answer::Kind::combined)
        for (Answer& part : root.inputs) ask_below(asking, part, level);
    else
        ask_below(asking, root, level);
    for (int d = 0; d < depth && !level.empty(); ++d) {
        asking.answer(level);
        next.clear();
        if (d + 1 < depth)
            for (const Request& r : level)
                for (Answer& input : r.answer->inputs) ask_below(asking, input, next);
        level = std::move(next);
        next = {};
    }
    return root;
}

}  // namespace pliant
