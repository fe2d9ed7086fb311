// docs/claims.md.
#include <pliant/study/claims_report.h>

#include <fmt/format.h>

#include <algorithm>

namespace pliant {
namespace {

std::string page_of(std::string_view lesson) {
    std::string name(lesson);
    std::ranges::replace(name, '/', '_');
    return fmt::format("lessons/{}.md", name);
}

std::string command_of(const Claim& c) {
    std::string command = fmt::format("pliant run {}", c.lesson);
    for (const auto& [key, value] : c.scene) command += fmt::format(" --set {}={}", key, value);
    return command;
}

std::string section(const ClaimResult& r) {
    const Claim& c = *r.claim;
    const std::string_view verdict = outcome_of(r);
    std::string text = fmt::format("\n### {}: {}\n\n> {}\n>\n> {}\n\n", c.id, verdict, c.statement, c.source);
    text += fmt::format("- Experiment: {}\n- Figure: {}; criterion {}\n", c.experiment, c.figure, c.criterion);
    if (r.finding) {
        text +=
            fmt::format("- Measured: **{}**. {}\n", steady_figure(r.finding->figure, c.unit, rounding_of(c)), r.finding->text);
        if (!r.finding->condition.empty()) text += fmt::format("- Condition: {}\n", r.finding->condition);
    } else {
        text += fmt::format("- {}\n", r.failure);
    }
    return text + fmt::format("- Lesson: [{}]({}), `{}`\n", c.lesson, page_of(c.lesson), command_of(c));
}

}  // namespace

std::string claims_markdown(std::span<const ClaimResult> results) {
    std::string text =
        "# Claims\n\nWhat the lectures say of each method, as experiments that Pliant makes. A claim is *reproduced* when its "
        "figure meets the criterion, *qualified* when it does so under a condition that the experiment finds, and *refuted* "
        "when it does not. `pliant claims` measures all of them; in the lab the key K shows those of the lesson.\n\n"
        "Lectures: U, Utrecht slides; S, survey of deformable models; C, COL781 lecture 36; T, transcript of a second Utrecht "
        "deck. What a source calls ours no lecture says: Pliant adds it.\n\n<!-- Made by `pliant claims --markdown`; edit the "
        "claims beside the lessons, not this page. -->\n";
    std::string_view chapter;
    for (const ClaimResult& r : results) {
        if (chapter_of(*r.claim) != chapter) {
            chapter = chapter_of(*r.claim);
            text += fmt::format("\n## {}\n", chapter);
        }
        text += section(r);
    }
    return text;
}

}  // namespace pliant
