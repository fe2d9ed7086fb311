// What a lesson declares and what a run found, as text, JSON and Markdown. Everything here is made from the declarations.
#pragma once
#include <pliant/document/unused.h>
#include <pliant/run/runner.h>

#include <string>

namespace pliant {

// `pliant list`
std::string list_text();
std::string list_json();

// `pliant describe LESSON`: parameters, stages, fields, probes, lines, assumptions, conserved quantities, presets.
std::string describe_text(const LessonEntry& entry);
std::string describe_json(const LessonEntry& entry);
// The tables of the lesson's page, but for its stages.
std::string describe_markdown(const Lesson& lesson, std::string_view id);

// `pliant run LESSON`: one object with lesson, parameters, unused (what is set without effect, and what it needs), dimension,
// steps, time, status, probes, lines, assumptions, conserved, cost and, when the run stopped early, failure; inside a step also
// passes, and beside: the same of the run that stands beside it. With names of fields also fields: of each its unit, what it is
// on and its value, a number for each node, cell, ... in their order, or a list of those of a vector or tensor. Throws Refused
// for a field that the scene does not have.
std::string run_json(const Runner& runner, const std::vector<UnusedSetting>& unused, const Runner* beside = nullptr,
                     const std::vector<std::string>& fields = {});
// The same for people: probes against exact, assumptions, conserved quantities, milliseconds per stage.
std::string run_text(const Runner& runner);

// "ok", "at_rest" or "diverged".
std::string_view status_of(const Runner& runner);

}  // namespace pliant
