// The sources of the project as text, and what they include.
#pragma once
#include <string>
#include <vector>

namespace layering {

struct Include {
    int line = 0;
    bool quoted = false;
    std::string path;
};

struct Source {
    std::string path, text;  // path: from the root of the project
};

// Of #include lines; others in comments do not count.
std::vector<Include> includes_of(const std::string& text);

// Headers and .cpp files in a folder of the project and below it, by their paths.
std::vector<Source> sources_below(const std::string& folder);

// "core/pliant" of core/pliant/math/types.h, for two parts.
std::string first_part(const std::string& path, std::size_t parts = 1);

}  // namespace layering
