#include "sources.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace layering {
namespace fs = std::filesystem;

std::vector<Include> includes_of(const std::string& text) {
    std::vector<Include> found;
    std::istringstream in(text);
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        std::erase_if(line, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
        if (!line.starts_with("#include")) continue;
        const auto open = line.find_first_of("<\""), close = line.find_last_of(">\"");
        if (open < close && close != std::string::npos)
            found.push_back({number, line[open] == '"', line.substr(open + 1, close - open - 1)});
    }
    return found;
}

std::vector<Source> sources_below(const std::string& folder) {
    const fs::path root(PLIANT_SOURCE_DIR);
    std::vector<Source> sources;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        const std::string ending = entry.path().extension().string();
        if (!entry.is_regular_file() || (ending != ".h" && ending != ".cpp")) continue;
        std::ostringstream text;
        text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
        sources.push_back({fs::relative(entry.path(), root).generic_string(), text.str()});
    }
    std::ranges::sort(sources, {}, &Source::path);
    return sources;
}

std::string first_part(const std::string& path, std::size_t parts) {
    std::size_t end = 0;
    for (std::size_t i = 0; i < parts && end != std::string::npos; ++i) end = path.find('/', end + (i ? 1 : 0));
    return path.substr(0, end);
}

}  // namespace layering
