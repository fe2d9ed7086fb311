// Who may include whom: math <- continuum, mesh, time <- solids, particles, fluids <- lessons, and viewer apart from them. What a
// lesson declares, what runs it, what is written about it and the studies (text <- lesson <- run <- document <- study) know no
// solver, and no solver knows them. Read from the #include lines of the sources.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

using Names = std::set<std::string>;

// The folders of core that each folder may use besides itself.
const std::map<std::string, Names> allowed_folders{
    {"core/pliant/math", {}},
    {"core/pliant/continuum", {"math"}},
    {"core/pliant/mesh", {"math"}},
    {"core/pliant/time", {"math"}},
    {"core/pliant/solids", {"math", "continuum", "mesh", "time"}},
    {"core/pliant/particles", {"math", "continuum", "mesh", "time"}},
    {"core/pliant/fluids", {"math", "continuum", "mesh", "time"}},
    {"core/pliant/text", {"math"}},
    {"core/pliant/formula", {"math"}},
    {"core/pliant/lesson", {"math", "text", "formula"}},
    {"core/pliant/run", {"math", "text", "formula", "lesson"}},
    {"core/pliant/document", {"math", "text", "formula", "lesson", "run"}},
    {"core/pliant/study", {"math", "text", "formula", "lesson", "run", "document"}},
    {"lessons",
     {"math", "continuum", "mesh", "time", "solids", "particles", "fluids", "text", "formula", "lesson", "run", "document",
      "study"}},
    {"viewer", {"math", "text", "formula", "lesson", "run", "document", "study"}},
};

// The libraries of others, by the first part of what is included. Standard headers have neither folder nor ending.
const Names core_libraries{"Eigen", "fmt", "nlohmann", "oneapi", "zlib.h", "fcntl.h", "sys", "unistd.h"};
const Names viewer_libraries{"Eigen",   "fmt",       "nlohmann", "CLI",        "GLFW",         "GL",
                             "GLES3",   "EGL",       "glad",     "backends",   "imgui.h",      "imgui_internal.h",
                             "png.h",   "gif_lib.h", "zlib.h",   "emscripten", "emscripten.h", "unistd.h",
                             "dlfcn.h", "fcntl.h",   "signal.h"};

struct Include {
    int line = 0;
    bool quoted = false;
    std::string path;
};

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

std::string first_part(const std::string& path, std::size_t parts = 1) {
    std::size_t end = 0;
    for (std::size_t i = 0; i < parts && end != std::string::npos; ++i) end = path.find('/', end + (i ? 1 : 0));
    return path.substr(0, end);
}

// "core/pliant/solids" of core/solids/springs.h, "lessons" of anything there.
std::string group_of(const std::string& file) { return first_part(file, file.starts_with("core/") ? 3 : 1); }

bool is_standard(const std::string& included) { return included.find_first_of("./") == std::string::npos; }

// What is wrong with one #include, or "".
std::string objection(const std::string& file, const Include& include) {
    const std::string group = group_of(file);
    const auto allowed = allowed_folders.find(group);
    if (allowed == allowed_folders.end()) return fmt::format("the folder {} is not part of the layers", group);
    if (include.quoted) {
        if (group.starts_with("core/")) return "core names its headers as <pliant/...>";
        const bool leaves = include.path.find("..") != std::string::npos || include.path.starts_with("lessons/") ||
                            include.path.starts_with("viewer/");
        return leaves ? fmt::format("{} does not reach out of its folder", group) : "";
    }
    if (is_standard(include.path)) return "";
    const std::string library = first_part(include.path);
    if (library != "pliant") {
        const Names& libraries = group == "viewer" ? viewer_libraries : core_libraries;
        return libraries.contains(library) ? "" : fmt::format("{} is no library of {}", library, group);
    }
    const std::string folder = first_part(include.path.substr(7));
    return "core/pliant/" + folder == group || allowed->second.contains(folder)
               ? ""
               : fmt::format("{} lies above or beside {}", folder, group);
}

std::vector<std::string> objections(const std::string& file, const std::string& text) {
    std::vector<std::string> all;
    for (const Include& include : includes_of(text))
        if (const std::string wrong = objection(file, include); !wrong.empty())
            all.push_back(fmt::format("{}:{}: {}: {}", file, include.line, include.path, wrong));
    return all;
}

struct Source {
    std::string path, text;  // path: from the root of the project
};

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

}  // namespace

TEST_CASE("sources include only what their layer may use", "[layering]") {
    const std::string folder = GENERATE("core", "lessons", "viewer");
    const auto sources = sources_below(folder);
    INFO(folder);
    CHECK(sources.size() > 3);
    std::size_t seen = 0;
    std::vector<std::string> wrong;
    for (const Source& s : sources) {
        seen += includes_of(s.text).size();
        std::ranges::copy(objections(s.path, s.text), std::back_inserter(wrong));
    }
    CHECK(seen > sources.size());
    INFO(fmt::format("{}", fmt::join(wrong, "\n")));
    CHECK(wrong.empty());
}

TEST_CASE("headers of the core need no library that a user of the core does not see", "[layering]") {
    std::vector<std::string> wrong;
    for (const Source& s : sources_below("core"))
        for (const Include& include : includes_of(s.text))
            if (s.path.ends_with(".h") && first_part(include.path) == "fmt")
                wrong.push_back(fmt::format("{}:{}", s.path, include.line));
    INFO(fmt::format("{}", fmt::join(wrong, "\n")));
    CHECK(wrong.empty());
}

TEST_CASE("the check of the layers finds what does not belong", "[layering]") {
    const auto wrong = [](const char* file, const char* line) {
        return objections(file, std::string("#pragma once\n") + line + "\n").size() == 1;
    };
    CHECK(wrong("core/pliant/math/a.h", "#include <pliant/mesh/simplex_mesh.h>"));
    CHECK(wrong("core/pliant/mesh/a.h", "#include <pliant/continuum/strain.h>"));
    CHECK(wrong("core/pliant/time/a.h", "#include <pliant/solids/springs.h>"));
    CHECK(wrong("core/pliant/fluids/a.cpp", "#include <pliant/lesson/lesson.h>"));
    CHECK(wrong("core/pliant/solids/a.cpp", "#include <pliant/fluids/lattice.h>"));
    CHECK(wrong("core/pliant/lesson/a.cpp", "#include <pliant/solids/springs.h>"));
    CHECK(wrong("core/pliant/study/a.cpp", "#include <pliant/fluids/lattice.h>"));
    CHECK(wrong("core/pliant/lesson/a.cpp", "  #  include <imgui.h>"));
    CHECK(wrong("core/pliant/math/a.cpp", "#include <GLFW/glfw3.h>"));
    CHECK(wrong("core/pliant/math/a.cpp", "#include <GL/gl.h>"));
    CHECK(wrong("core/pliant/math/a.cpp", "#include \"../../../viewer/app/session.h\""));
    CHECK(wrong("core/pliant/other/a.cpp", "#include <pliant/math/types.h>"));
    CHECK(wrong("lessons/mesh/rod/rod.cpp", "#include \"../../../viewer/app/session.h\""));
    CHECK(wrong("lessons/mesh/rod/rod.cpp", "#include <imgui.h>"));
    CHECK(wrong("viewer/app/a.cpp", "#include <pliant/solids/springs.h>"));
    CHECK(wrong("viewer/app/a.cpp", "#include \"../lessons/mesh/rod/rod.h\""));
    CHECK_FALSE(wrong("core/pliant/solids/a.h", "#include <pliant/mesh/simplex_mesh.h>"));
    CHECK_FALSE(wrong("core/pliant/solids/a.h", "#include <vector>"));
    CHECK_FALSE(wrong("core/pliant/solids/a.h", "// #include <imgui.h>"));
    CHECK_FALSE(wrong("lessons/mesh/rod/rod.cpp", "#include \"rod.h\""));
}
