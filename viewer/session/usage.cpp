#include "session/usage.h"

#include <pliant/document/unused.h>
#include <pliant/lesson/setting_words.h>
#include <pliant/text/spoken.h>

#include <fmt/format.h>

#include <utility>

namespace pliant::viewer {
namespace {

// "the lattice is “sheet of squares” or “chain”", "the friction is above 0".
std::string need_said(const Lesson& lesson, const Need& need) {
    const Parameter& p = lesson.parameter(need.key);
    std::string values;
    for (const std::string& text : need.values) values += (values.empty() ? "" : " or ") + value_words(p, p.parse(text));
    const std::string_view where = need.what == Need::What::above ? "above " : need.what == Need::What::below ? "below " : "";
    return fmt::format("{} is {}{}", spoken(p.info.key), where, values);
}

std::string ways_said(const Lesson& lesson, const Ways& ways) {
    std::string text;
    for (const auto& way : ways) {
        std::string needs;
        for (const Need& need : way) needs += (needs.empty() ? "" : " and ") + need_said(lesson, need);
        text += (text.empty() ? "" : ", or when ") + needs;
    }
    return text;
}

}  // namespace

const std::string& UsageReasons::reason(const Runner& runner, const Parameter& parameter) {
    Runner::Assignments now;
    for (const Parameter* p : runner.lesson().parameters) now.emplace_back(p->info.key, p->text(runner.wanted(*p)));
    if (runner.info().id != lesson_ || now != values_) lesson_ = runner.info().id, values_ = std::move(now), reasons_.clear();
    const auto [entry, fresh] = reasons_.try_emplace(parameter.info.key);
    if (fresh) {
        const std::string needs = ways_said(runner.lesson(), ways_to_use(find_lesson(lesson_), values_, parameter.info.key));
        entry->second = needs.empty() ? "Not used by the present scene." : fmt::format("Used when {}.", needs);
    }
    return entry->second;
}

const std::string* UsageReasons::known(std::string_view key) const {
    const auto found = reasons_.find(key);
    return found == reasons_.end() ? nullptr : &found->second;
}

}  // namespace pliant::viewer
