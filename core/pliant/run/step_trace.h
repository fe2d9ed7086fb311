// What each stage of the latest step found and left: copies of the fields between the stages, for looking at before, after and
// their difference. A runner fills one in where it is given one, and spends nothing where it is not.
#pragma once
#include <pliant/lesson/lesson.h>

#include <memory>
#include <span>
#include <vector>

namespace pliant {

class StepTrace {
public:
    // The runner tells what happens.
    void start(const Lesson& lesson, Index step);
    void finished(const Lesson& lesson, const Stage& stage, Index passes);

    bool empty() const { return moments_.empty(); }
    Index step() const { return step_; }
    void clear() { moments_.clear(); }

    // The numbers of a field before and after the latest execution of a stage in this step; empty where it has not run.
    // A stage that runs now has a before: what the stages up to here have left.
    std::span<const Real> before(const Lesson& lesson, const Stage& stage, std::string_view field) const;
    std::span<const Real> after(const Lesson& lesson, const Stage& stage, std::string_view field) const;
    // The numbers as the stages left them after so many passes of the step.
    std::span<const Real> at(const Lesson& lesson, Index passes, std::string_view field) const;

    // Stages that have ended in this step so far.
    std::size_t stages() const { return moments_.empty() ? 0 : moments_.size() - 1; }
    std::size_t bytes() const;

private:
    using Numbers = std::vector<Real>;
    struct Moment {
        const Stage* stage = nullptr;  // that has just ended; none at the start of the step
        Index passes = 0;
        std::vector<std::shared_ptr<const Numbers>> fields;  // in the order of lesson.fields; shared where nothing has changed
    };
    std::span<const Real> numbers(const Lesson& lesson, const Moment& moment, std::string_view field) const;

    Index step_ = 0;
    std::vector<Moment> moments_;
};

// Does the field change when this stage runs: is it written by it, or defined by fields that are?
bool changes(const Lesson& lesson, const Stage& stage, const Field& field);

}  // namespace pliant
