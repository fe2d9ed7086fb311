// Who may include whom: math <- continuum, mesh, time <- solids, particles, fluids <- lessons, and viewer apart from them. What a
// lesson declares, what runs it, what is written about it and the studies (text <- lesson <- run <- document <- study <- lecture)
// know no solver, and no solver knows them. The folders of the viewer stand above each other, and its session draws nothing. Read
// from the #include lines of the sources.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include "sources.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace layering;

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
    {"core/pliant/mesh_file", {"math", "mesh", "text"}},
    {"core/pliant/formula", {"math", "text"}},
    {"core/pliant/lesson", {"math", "text", "formula"}},
    {"core/pliant/run", {"math", "text", "formula", "lesson"}},
    {"core/pliant/document", {"math", "text", "formula", "lesson", "run"}},
    {"core/pliant/study", {"math", "text", "formula", "lesson", "run", "document"}},
    {"core/pliant/lecture", {"math", "text", "formula", "lesson", "run", "document", "study"}},
    {"lessons",
     {"math", "continuum", "mesh", "mesh_file", "time", "solids", "particles", "fluids", "text", "formula", "lesson", "run",
      "document", "study"}},
    {"viewer", {"math", "text", "formula", "lesson", "run", "document", "study", "lecture"}},
};

// The folders of the viewer from the lowest to the highest, and which of the lower ones each may use.
const std::vector<std::pair<std::string, Names>> viewer_folders{
    {"platform", {}},
    {"typeset", {}},
    {"render", {"platform"}},
    {"plot", {"platform", "typeset", "render"}},
    {"session", {"platform", "render", "plot"}},
    {"panels", {"platform", "typeset", "render", "plot", "session"}},
    {"app", {"platform", "typeset", "render", "plot", "session", "panels"}},
    {"command_line", {"platform", "typeset", "render", "plot", "session", "panels", "app"}},
};

// The libraries of others, by the first part of what is included. Standard headers have neither folder nor ending.
const Names core_libraries{"Eigen", "fmt", "nlohmann", "oneapi", "zlib.h", "pugixml.hpp", "fcntl.h", "sys", "unistd.h"};
const Names screen_libraries{"GLFW", "GL", "GLES3", "EGL", "glad", "backends", "imgui.h", "imgui_internal.h"};
const Names viewer_libraries{"Eigen",    "fmt",       "nlohmann", "CLI",      "GLFW",       "GL",
                             "GLES3",    "EGL",       "glad",     "backends", "imgui.h",    "imgui_internal.h",
                             "png.h",    "gif_lib.h", "hpdf.h",   "zlib.h",   "emscripten", "emscripten.h",
                             "unistd.h", "dlfcn.h",   "fcntl.h",  "signal.h"};

// "core/pliant/solids" of core/solids/springs.h, "lessons" of anything there.
std::string group_of(const std::string& file) { return first_part(file, file.starts_with("core/") ? 3 : 1); }

bool is_standard(const std::string& included) { return included.find_first_of("./") == std::string::npos; }

// What is wrong with a header of the viewer's own in a file of it, or "". viewer/main.cpp is above all folders.
std::string objection_within_viewer(const std::string& file, const std::string& included) {
    const std::string own = first_part(file.substr(file.find('/') + 1)), other = first_part(included);
    if (own == "main.cpp" || own == other) return "";
    const auto layer = std::ranges::find(viewer_folders, own, [](const auto& f) { return f.first; });
    if (layer == viewer_folders.end()) return fmt::format("viewer/{} is not part of the layers", own);
    return layer->second.contains(other) ? "" : fmt::format("viewer/{} lies above or beside viewer/{}", other, own);
}

// What is wrong with one #include, or "".
std::string objection(const std::string& file, const Include& include) {
    const std::string group = group_of(file);
    const auto allowed = allowed_folders.find(group);
    if (allowed == allowed_folders.end()) return fmt::format("the folder {} is not part of the layers", group);
    if (include.quoted) {
        if (group.starts_with("core/")) return "core names its headers as <pliant/...>";
        const bool leaves = include.path.find("..") != std::string::npos || include.path.starts_with("lessons/") ||
                            include.path.starts_with("viewer/");
        if (leaves) return fmt::format("{} does not reach out of its folder", group);
        return group == "viewer" ? objection_within_viewer(file, include.path) : "";
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

TEST_CASE("each folder of the viewer uses only those below it", "[layering]") {
    Names below;
    for (const auto& [folder, used] : viewer_folders) {
        INFO(folder);
        CHECK(std::ranges::includes(below, used));
        below.insert(folder);
    }
}

TEST_CASE("what a session is needs neither ImGui nor GL", "[layering]") {
    std::map<std::string, std::string> texts;
    for (Source& s : sources_below("viewer")) texts.emplace(s.path, std::move(s.text));
    std::vector<std::string> wrong, files;
    Names reached;
    for (const auto& [path, text] : texts)
        if (path.starts_with("viewer/session/")) files.push_back(path), reached.insert(path);
    CHECK(files.size() > 20);
    while (!files.empty()) {
        const std::string file = files.back();
        files.pop_back();
        for (const Include& include : includes_of(texts.at(file))) {
            const std::string header = "viewer/" + include.path;
            if (include.quoted && texts.contains(header) && reached.insert(header).second) files.push_back(header);
            if (!include.quoted && screen_libraries.contains(first_part(include.path)))
                wrong.push_back(fmt::format("{}:{}: {}", file, include.line, include.path));
        }
    }
    CHECK(reached.contains("viewer/render/palette.h"));
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
    CHECK(wrong("core/pliant/math/a.cpp", "#include \"../../../viewer/session/session.h\""));
    CHECK(wrong("core/pliant/other/a.cpp", "#include <pliant/math/types.h>"));
    CHECK(wrong("lessons/mesh/rod/rod.cpp", "#include \"../../../viewer/session/session.h\""));
    CHECK(wrong("lessons/mesh/rod/rod.cpp", "#include <imgui.h>"));
    CHECK(wrong("viewer/app/a.cpp", "#include <pliant/solids/springs.h>"));
    CHECK(wrong("viewer/panels/a.cpp", "#include \"app/lab.h\""));
    CHECK(wrong("viewer/session/a.h", "#include \"panels/theme.h\""));
    CHECK(wrong("viewer/session/a.h", "#include \"typeset/math_box.h\""));
    CHECK(wrong("viewer/app/a.cpp", "#include \"command_line/options.h\""));
    CHECK(wrong("viewer/other/a.cpp", "#include \"app/lab.h\""));
    CHECK_FALSE(wrong("viewer/app/a.cpp", "#include \"panels/theme.h\""));
    CHECK_FALSE(wrong("viewer/main.cpp", "#include \"command_line/command_line.h\""));
    CHECK(wrong("viewer/app/a.cpp", "#include \"../lessons/mesh/rod/rod.h\""));
    CHECK_FALSE(wrong("core/pliant/solids/a.h", "#include <pliant/mesh/simplex_mesh.h>"));
    CHECK_FALSE(wrong("core/pliant/solids/a.h", "#include <vector>"));
    CHECK_FALSE(wrong("core/pliant/solids/a.h", "// #include <imgui.h>"));
    CHECK_FALSE(wrong("lessons/mesh/rod/rod.cpp", "#include \"rod.h\""));
}
