#include <pliant/run/step_trace.h>

#include <algorithm>

namespace pliant {

bool changes(const Lesson& lesson, const Stage& stage, const Field& field) {
    if (std::ranges::find(stage.writes, field.name) != stage.writes.end()) return true;
    return std::ranges::any_of(field.defined_by, [&](std::string_view name) {
        const Field* source = lesson.find_field(name);
        return source && changes(lesson, stage, *source);
    });
}

namespace {
std::shared_ptr<const std::vector<Real>> copy_of(const Field& field) {
    const auto numbers = field.view();
    return std::make_shared<const std::vector<Real>>(numbers.begin(), numbers.end());
}
}  // namespace

void StepTrace::start(const Lesson& lesson, Index step) {
    step_ = step;
    moments_.resize(1);
    moments_[0] = {};
    for (const Field& f : lesson.fields) moments_[0].fields.push_back(f.in_use() ? copy_of(f) : nullptr);
}

void StepTrace::finished(const Lesson& lesson, const Stage& stage, Index passes) {
    if (moments_.empty()) return;
    Moment moment = moments_.back();
    moment.stage = &stage;
    moment.passes = passes;
    for (std::size_t k = 0; k < lesson.fields.size(); ++k) {
        const Field& field = lesson.fields[k];
        if (field.in_use() && changes(lesson, stage, field)) moment.fields[k] = copy_of(field);
    }
    moments_.push_back(std::move(moment));
}

std::span<const Real> StepTrace::numbers(const Lesson& lesson, const Moment& moment, std::string_view field) const {
    const Field* f = lesson.find_field(field);
    if (!f) return {};
    const auto& copy = moment.fields[static_cast<std::size_t>(f - lesson.fields.data())];
    return copy ? std::span<const Real>(*copy) : std::span<const Real>();
}

std::span<const Real> StepTrace::before(const Lesson& lesson, const Stage& stage, std::string_view field) const {
    if (moments_.empty()) return {};
    for (std::size_t k = moments_.size() - 1; k > 0; --k)
        if (moments_[k].stage == &stage) return numbers(lesson, moments_[k - 1], field);
    return numbers(lesson, moments_.back(), field);
}

std::span<const Real> StepTrace::after(const Lesson& lesson, const Stage& stage, std::string_view field) const {
    for (std::size_t k = moments_.size(); k-- > 1;)
        if (moments_[k].stage == &stage) return numbers(lesson, moments_[k], field);
    return {};
}

std::span<const Real> StepTrace::at(const Lesson& lesson, Index passes, std::string_view field) const {
    for (std::size_t k = moments_.size(); k-- > 0;)
        if (moments_[k].passes <= passes) return numbers(lesson, moments_[k], field);
    return {};
}

std::size_t StepTrace::bytes() const {
    std::size_t sum = 0;
    for (std::size_t k = 0; k < moments_.size(); ++k)
        for (std::size_t f = 0; f < moments_[k].fields.size(); ++f) {
            const auto& copy = moments_[k].fields[f];
            if (copy && (k == 0 || copy != moments_[k - 1].fields[f])) sum += copy->size() * sizeof(Real);
        }
    return sum;
}

}  // namespace pliant
