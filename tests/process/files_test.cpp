// The files that commands write: whole or not at all, in the mode that they had, through links, under names that tell the truth,
// and nobody else's is touched.
#include "pliant.h"

#include <sys/stat.h>

using namespace pliant::test;

namespace {

// A command that writes one file, of each kind.
struct Writing {
    std::string name;
    Arguments arguments;  // the path follows
    std::string beginning;
};
std::vector<Writing> writings() {
    return {{"probes.csv", {"run", "elasticity/moduli", "--set", "resolution=1", "--csv"}, "step,"},
            {"picture.png", {"shot", "elasticity/moduli", "--steps", "0", "--size", "320x200", "--out"}, "\x89PNG"},
            {"film.gif", {"shot", "elasticity/moduli", "--size", "320x200", "--seconds", "1", "--fps", "2", "--out"}, "GIF89a"}};
}

Arguments writing_to(const Writing& writing, const std::string& path) {
    Arguments arguments = writing.arguments;
    arguments.push_back(path);
    return arguments;
}

mode_t mode_of(const std::string& path) {
    struct stat found {};
    REQUIRE(stat(path.c_str(), &found) == 0);
    return found.st_mode & 07777;
}

const Arguments small_study{"study", "time/integration", "--map", "time_step=0.1,0.2", "omega=1,2", "--steps", "20", "--out"};

Arguments study_into(const std::string& folder) {
    Arguments arguments = small_study;
    arguments.push_back(folder);
    return arguments;
}

}  // namespace

TEST_CASE("files with the names that unfinished ones could have are left alone", "[process]") {
    const Scratch scratch;
    std::vector<std::string> mine;
    for (const Writing& w : writings())
        for (const char* ending : {".part", ".part0", ".part1", ".tmp", "~", ".bak"}) {
            mine.push_back(w.name + ending);
            scratch.file(mine.back(), "mine");
        }
    auto expected = mine;
    for (const Writing& w : writings()) {
        output_of(writing_to(w, scratch.path(w.name)));
        expected.push_back(w.name);
    }
    refusal({"run", "moduli", "--set", "youngs_modulus=-1", "--csv", scratch.path("probes.csv")});
    for (const std::string& name : mine) CHECK(contents_of(scratch.path(name)) == "mine");
    std::ranges::sort(expected);
    CHECK(scratch.names() == expected);
}

TEST_CASE("a file that is replaced keeps its mode, a new one gets that of the mask", "[process]") {
    const Scratch scratch;
    const mode_t mask = umask(0);
    umask(mask);
    for (const Writing& w : writings()) {
        INFO(w.name);
        const std::string path = scratch.path(w.name);
        output_of(writing_to(w, path));
        CHECK(mode_of(path) == (0666 & ~mask));
        for (const mode_t mode : {mode_t{0600}, mode_t{0664}, mode_t{0755}}) {
            REQUIRE(chmod(path.c_str(), mode) == 0);
            output_of(writing_to(w, path));
            CHECK(mode_of(path) == mode);
        }
    }
    output_of(study_into(scratch.path("maps")));
    for (const char* name : {"maps/map.csv", "maps/map.json", "maps/map.png"})
        REQUIRE(chmod(scratch.path(name).c_str(), 0600) == 0);
    output_of(study_into(scratch.path("maps")));
    for (const char* name : {"maps/map.csv", "maps/map.json", "maps/map.png"}) CHECK(mode_of(scratch.path(name)) == 0600);
}

TEST_CASE("a link stays a link, and what it leads to is written", "[process]") {
    for (const Writing& w : writings()) {
        INFO(w.name);
        const Scratch scratch;
        fs::create_directory(scratch.path("deep"));
        const std::string there = scratch.file("deep/there", "older"), absent = scratch.path("deep/absent");
        fs::create_symlink("deep/there", scratch.path("to_there_" + w.name));
        fs::create_symlink(absent, scratch.path("to_absent_" + w.name));
        fs::create_symlink("to_there_" + w.name, scratch.path("twice_" + w.name));
        for (const auto& [link, target] :
             {std::pair{"to_there_" + w.name, there}, {"to_absent_" + w.name, absent}, {"twice_" + w.name, there}}) {
            INFO(link);
            output_of(writing_to(w, scratch.path(link)));
            CHECK(fs::is_symlink(scratch.path(link)));
            CHECK(contents_of(target).starts_with(w.beginning));
            write_text(target, "older");
        }
        CHECK(scratch.names().size() == 4);
        CHECK(std::distance(fs::directory_iterator(scratch.path("deep")), fs::directory_iterator()) == 2);
    }
    // What a study writes into its folder as well.
    const Scratch scratch;
    fs::create_directory(scratch.path("maps"));
    fs::create_symlink("../elsewhere.json", scratch.path("maps/map.json"));
    output_of(study_into(scratch.path("maps")));
    CHECK(fs::is_symlink(scratch.path("maps/map.json")));
    CHECK(Json::parse(contents_of(scratch.path("elsewhere.json"))).contains("agreement"));
}

TEST_CASE("a link that leads back to itself is named and refused before the run", "[process]") {
    const Scratch scratch;
    for (const Writing& w : writings()) {
        fs::create_symlink("b_" + w.name, scratch.path("a_" + w.name));
        fs::create_symlink("a_" + w.name, scratch.path("b_" + w.name));
        refusal(writing_to(w, scratch.path("a_" + w.name)), {scratch.path("a_" + w.name), "link"});
    }
    fs::create_directory(scratch.path("maps"));
    fs::create_symlink("map.csv", scratch.path("maps/map.csv"));
    refusal(study_into(scratch.path("maps")), {scratch.path("maps/map.csv"), "link"});
    CHECK(scratch.names().size() == 7);
}

TEST_CASE("a file with two names has the same contents under both", "[process]") {
    for (const Writing& w : writings()) {
        INFO(w.name);
        const Scratch scratch;
        const std::string path = scratch.file(w.name, "older");
        fs::create_hard_link(path, scratch.path("other"));
        output_of(writing_to(w, path));
        CHECK(contents_of(path).starts_with(w.beginning));
        CHECK(contents_of(scratch.path("other")) == contents_of(path));
    }
}

TEST_CASE("a file that may not be written is not replaced either", "[process]") {
    if (geteuid() == 0) SKIP("root may write everything");
    const Scratch scratch;
    for (const Writing& w : writings()) {
        const std::string path = scratch.file(w.name, "precious");
        REQUIRE(chmod(path.c_str(), 0444) == 0);
        refusal(writing_to(w, path), {path});
        CHECK(contents_of(path) == "precious");
    }
}

TEST_CASE("standard output may be the file", "[process]") {
    if (!fs::exists("/dev/stdout")) SKIP("this system has no /dev/stdout");
    const Scratch scratch;
    const std::string text = scratch.path("text");
    CHECK(call_with(">" + text, {"run", "elasticity/moduli", "--set", "resolution=1", "--csv", "/dev/stdout"}).exit_code == 0);
    const std::string both = contents_of(text);
    CHECK(both.starts_with("step,"));
    CHECK(contains(both, "elasticity/moduli: 1 step,"));
    const Outcome piped = call({"run", "elasticity/moduli", "--set", "resolution=1", "--csv", "/dev/stdout"});
    CHECK(piped.out.starts_with("step,"));
    CHECK(contains(piped.out, "elasticity/moduli: 1 step,"));
}

TEST_CASE("an ending that cannot be written is refused before the run", "[process]") {
    const Scratch scratch;
    const auto shot = [&](const std::string& name, const Arguments& more = {}) {
        Arguments arguments{"shot", "moduli", "--steps", "0", "--size", "320x200", "--out", scratch.path(name)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    };
    for (const char* name : {"x.jpg", "x.jpeg", "x.svg", "x.pdf", "x.PDF", "x", "x.", "png", ".png", "x.png.txt"})
        refusal(shot(name), {"--out", name, ".png"});
    refusal(shot("x.gif"), {"--seconds"});
    refusal({"shot", "moduli", "--seconds", "1", "--out", scratch.path("x.png")}, {"--seconds", ".gif"});
    refusal({"shot", "moduli", "--seconds", "1", "--out", scratch.path("x.webm")}, {"x.webm", ".gif"});
    for (const char* name : {"x.png", "x.json", "x.svg", "x.gif", "x.xlsx", "x.JSON"})
        refusal({"run", "moduli", "--csv", scratch.path(name)}, {"--csv", name, ".csv"});
    for (const char* name : {"maps.png", "maps.csv", "maps.json", "maps.html", "maps.gif"}) {
        refusal(study_into(scratch.path(name)), {"--out", name, "folder"});
        refusal({"tour", "--out", scratch.path(name)}, {"--out", name, "folder"});
    }
    for (const char* name : {"state.png", "state.csv"})
        refusal({"--no-settings", "--state", scratch.path(name)}, {"--state", name, ".json"});
    CHECK(scratch.names().empty());
    // Capitals are the same ending, and a table may have one that tells nothing.
    output_of(shot("X.PNG"));
    for (const char* name : {"x.CSV", "x", "x.a1B2", "x.txt"})
        output_of({"run", "moduli", "--set", "resolution=1", "--csv", scratch.path(name)});
    CHECK(scratch.names().size() == 5);
}
