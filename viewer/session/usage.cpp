#include "session/usage.h"

#include <pliant/document/unused.h>

#include <fmt/format.h>

#include <utility>

namespace pliant::viewer {

const std::string& UsageReasons::reason(const Runner& runner, const Parameter& parameter) {
    Runner::Assignments now;
    for (const Parameter* p : runner.lesson().parameters) now.emplace_back(p->info.key, p->text(runner.wanted(*p)));
    if (runner.info().id != lesson_ || now != values_) lesson_ = runner.info().id, values_ = std::move(now), reasons_.clear();
    const auto [entry, fresh] = reasons_.try_emplace(parameter.info.key);
    if (fresh) {
        const std::string needs = text_of(ways_to_use(find_lesson(lesson_), values_, parameter.info.key));
        entry->second = needs.empty() ? "Not used by the present scene." : fmt::format("Used with {}.", needs);
    }
    return entry->second;
}

}  // namespace pliant::viewer
