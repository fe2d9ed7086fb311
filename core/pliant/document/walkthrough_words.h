// How the blocks of a walkthrough are called, and how its lines fall into words.
#pragma once
#include <pliant/document/walkthrough.h>
#include <pliant/run/runner.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

// By the name of its fence: "ask", "do"; empty when no block is called so.
std::optional<BlockKind> block_kind(std::string_view name);
std::string_view name_of(BlockKind kind);

// Split at blanks.
std::vector<std::string> words_of_line(const std::string& line);
// "KEY=VALUE" words behind the first one. Throws Refused.
Runner::Assignments assignments_of(const std::vector<std::string>& words);
// Without the blanks at both ends.
std::string trimmed(std::string_view line);

// Tells the actions that are the set-up of a slide from those that wait for Next, asked line by line.
class SetUp {
public:
    bool takes(const std::string& line);
    void end() { open_ = false; }

private:
    bool open_ = true;
};

}  // namespace pliant
