// The question for a file, without its dialog.
#include "panels/file_choice.h"

#include "../process/process.h"

#include <pliant/math/error.h>
#include <catch2/catch_test_macros.hpp>

using namespace pliant;
using namespace pliant::viewer;
using pliant::test::Scratch;
namespace fs = std::filesystem;

namespace {

class Asked {
public:
    explicit Asked(FileChoice::Purpose purpose, std::string name = "") {
        fs::create_directories(scratch.folder() / "scenes" / "old");
        for (const char* file : {"b.json", "a.json", "notes.txt", "scenes/c.json"}) scratch.file(file, "{}");
        choice.ask(purpose, "Choose", {".json"}, std::move(name), [this](const std::string& path) {
            if (!refusal.empty()) throw Refused(refusal);
            chosen.push_back(path);
        });
        choice.go_to(scratch.folder());
    }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& e : choice.entries()) all.push_back(e.folder ? e.name + "/" : e.name);
        return all;
    }
    void type(const std::string& name) { choice.name = name, choice.accept(); }

    Scratch scratch;
    FileChoice choice;
    std::vector<std::string> chosen;
    std::string refusal;
};

}  // namespace

TEST_CASE("file choice: folders come first, then the files with the ending, then all of them") {
    Asked a(FileChoice::Purpose::open);
    CHECK(a.names() == std::vector<std::string>{"scenes/", "a.json", "b.json"});
    a.choice.show_all_files(true);
    CHECK(a.names() == std::vector<std::string>{"scenes/", "a.json", "b.json", "notes.txt"});
}

TEST_CASE("file choice: arrows go through the list, Enter goes into folders and takes files") {
    Asked a(FileChoice::Purpose::open);
    a.choice.move(1);
    CHECK(a.choice.name == "scenes");
    a.choice.move(-1);
    CHECK(a.choice.name == "scenes");
    a.choice.accept();
    CHECK(a.choice.folder().filename() == "scenes");
    CHECK(a.choice.name.empty());
    CHECK(a.names() == std::vector<std::string>{"old/", "c.json"});
    a.choice.move(-1);
    CHECK(a.choice.name == "c.json");
    a.choice.accept();
    CHECK(a.chosen == std::vector<std::string>{a.scratch.path("scenes/c.json")});
    CHECK_FALSE(a.choice.asking());
}

TEST_CASE("file choice: up leads to the folder above, and ends at the root") {
    Asked a(FileChoice::Purpose::open);
    a.type("scenes/old");
    CHECK(a.choice.folder().filename() == "old");
    CHECK(a.choice.entries().empty());
    a.choice.go_up();
    CHECK(a.choice.folder().filename() == "scenes");
    for (int i = 0; i < 50; ++i) a.choice.go_up();
    CHECK(a.choice.folder() == "/");
    CHECK(a.choice.complaint().empty());
}

TEST_CASE("file choice: what cannot be opened is told in words") {
    Asked a(FileChoice::Purpose::open);
    a.type("");
    CHECK_FALSE(a.choice.complaint().empty());
    a.type("none.json");
    CHECK(a.choice.complaint().find("none.json") != std::string::npos);
    a.type("nowhere/none.json");
    CHECK(a.choice.complaint().find("nowhere") != std::string::npos);
    a.refusal = "this is no scene";
    a.type("a.json");
    CHECK(a.choice.complaint() == "this is no scene");
    CHECK(a.choice.asking());
    a.choice.go_to(a.scratch.folder() / "missing");
    CHECK(a.choice.complaint().find("missing") != std::string::npos);
    CHECK(a.choice.folder() == fs::weakly_canonical(a.scratch.folder()));
    a.refusal.clear();
    a.type(a.scratch.path("b.json"));  // a whole path
    CHECK(a.chosen == std::vector<std::string>{a.scratch.path("b.json")});
}

TEST_CASE("file choice: a file that is there is replaced only when asked for") {
    Asked a(FileChoice::Purpose::save, "new");
    a.choice.accept();
    CHECK(a.chosen == std::vector<std::string>{a.scratch.path("new.json")});

    Asked b(FileChoice::Purpose::save);
    b.type("a");
    CHECK(b.choice.asks_to_replace());
    CHECK(b.choice.name == "a.json");
    CHECK(b.chosen.empty());
    b.choice.keep();
    CHECK_FALSE(b.choice.asks_to_replace());
    b.choice.accept();
    REQUIRE(b.choice.asks_to_replace());
    b.choice.accept();  // Enter again
    CHECK(b.chosen == std::vector<std::string>{b.scratch.path("a.json")});
    CHECK_FALSE(b.choice.asking());
}

TEST_CASE("file choice: the next question begins in the folder of the last answer") {
    Asked a(FileChoice::Purpose::open);
    a.type("scenes/c.json");
    a.choice.ask(FileChoice::Purpose::save, "Save", {".json"}, "x.json", [](const std::string&) {});
    CHECK(a.choice.folder().filename() == "scenes");
    CHECK(a.names() == std::vector<std::string>{"old/", "c.json"});
    a.choice.cancel();
    CHECK_FALSE(a.choice.asking());
}

TEST_CASE("file choice: of several endings each is shown, and the first is added to a name that has none") {
    Asked a(FileChoice::Purpose::add);
    a.scratch.file("talk.md", "# Talk");
    a.choice.ask(FileChoice::Purpose::add, "Add", {".md", ".json"}, "lecture.md",
                 [&](const std::string& path) { a.chosen.push_back(fs::path(path).filename()); });
    a.choice.go_to(a.scratch.folder());
    CHECK(a.names() == std::vector<std::string>{"scenes/", "a.json", "b.json", "talk.md"});
    CHECK(a.choice.ending_words() == ".md or .json");
    a.type("new");
    CHECK(a.chosen.back() == "new.md");
    a.choice.ask(FileChoice::Purpose::add, "Add", {".md", ".json"}, "",
                 [&](const std::string& path) { a.chosen.push_back(fs::path(path).filename()); });
    a.type("other.json");
    CHECK(a.chosen.back() == "other.json");
}
