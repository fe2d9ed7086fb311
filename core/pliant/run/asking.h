// How answers are found: the questions of a level together, while the run passes once over the places that they are about.
#pragma once
#include <pliant/run/revisit.h>
#include <pliant/run/why.h>

#include <map>
#include <vector>

namespace pliant {

// "probe:NAME" as well as NAME. Throws Refused.
const Probe& probe_of(const Lesson& lesson, std::string_view name);

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
    void mark_unknowns(Answer& a, const Explanation& e, const Request& r) const;
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

}  // namespace pliant
