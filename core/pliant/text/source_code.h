// Functions found in the sources of C++, for pages that show the code of what they explain.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

struct CodePlace {
    std::string file;      // from the root of the sources
    std::string function;  // "project", or "Projection::pass"
};
// Those of "core/pliant/solids/rod.cpp: rod_slopes, rod_strains; core/pliant/solids/springs.cpp: spring_tension". Throws Refused
// for a text of another form.
std::vector<CodePlace> code_places(std::string_view text);

struct CodeExcerpt {
    std::string text;    // the function from its first word to its last brace, with the remarks right above it, moved to the left
    int first_line = 0;  // of the remarks, or of the function, from 1
    std::size_t lines = 0;
};

// The definition of the function in a source, and the longest of several: the others hand on to it. Throws Refused, naming
// `path`, when there is none.
CodeExcerpt definition_in(std::string_view source, std::string_view function, std::string_view path);

// The first `most` lines of an excerpt, and a remark in place of the others.
std::string first_lines(const CodeExcerpt& excerpt, std::size_t most);

}  // namespace pliant
