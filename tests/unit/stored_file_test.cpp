// Files as parameters: what is read, what is refused, and what a scene file keeps of them.
#include <pliant/document/scene_file.h>
#include <pliant/document/share.h>
#include <pliant/lesson/registry.h>
#include <pliant/lesson/setting_words.h>
#include <pliant/text/file.h>
#include <pliant/text/stored_file.h>
#include <pliant/text/texts.h>
#include <unistd.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <array>
#include <filesystem>
#include <thread>

namespace pliant {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::ContainsSubstring;

struct ReadsFile final : Lesson {
    File body{*this, file_of("body", "that is read", {".body", ".part"}).with("own", "true")};
    Switch own{*this, setting_of("own", "", false)};
    VecX u = VecX::Zero(1);
    ReadsFile() {
        state = {state_array("u", "m", u)};
        fields = {scalar_field("u", "u", "m", On::node, u, "")};
        stages = {stage_of("read", "u = 1", "", [this] { u[0] = Real(body.bytes().size()); })};
    }
    int dimension() const override { return 2; }
    void reset() override { u[0] = 0; }
    Real time_step() const override { return 0; }
    void draw(Scene&) const override {}
};
const Registration<ReadsFile> reads_file{{.id = "time/reads_file", .title = "Reads a file", .summary = ""}};
const TextRegistration little_body{{{"meshes/little.body", "bundled"}}};

struct Folder {
    fs::path path = fs::temp_directory_path() / ("pliant_stored_file_" + std::to_string(::getpid()));
    Folder() { fs::create_directories(path / "below"); }
    ~Folder() { fs::remove_all(path); }
    std::string write(const std::string& name, std::string_view text) const {
        write_file((path / name).string(), text);
        return (path / name).string();
    }
};

std::string refusal_of(const Parameter& p, const std::string& text) {
    try {
        p.parse(text);
    } catch (const Refused& e) {
        return e.what();
    }
    return "accepted";
}

TEST_CASE("a file that is set is read once, and read again when asked") {
    const Folder folder;
    const std::string path = folder.write("a.part", "one");
    ReadsFile lesson;
    lesson.body.set(lesson.body.parse(path));
    CHECK(lesson.body.bytes() == "one");
    CHECK(lesson.body.path() == path);
    CHECK(lesson.body.parse(lesson.body.text()) == lesson.body.value());
    folder.write("a.part", "two");
    CHECK(lesson.body.parse(path) == lesson.body.value());
    const auto again = Real(store_file(path, lesson.body.info.endings, Reading::again));
    CHECK(again != lesson.body.value());
    CHECK(lesson.body.bytes() == "one");
    lesson.body.set(again);
    CHECK(lesson.body.bytes() == "two");
    fs::remove(path);
    CHECK(lesson.body.parse(path) == again);
    CHECK(value_words(lesson.body, again) == "a.part");
    CHECK(value_words(lesson.body, 0) == "none");
}

TEST_CASE("no file is a value as well") {
    ReadsFile lesson;
    CHECK(lesson.body.text() == "none");
    CHECK(lesson.body.parse("") == 0);
    CHECK(lesson.body.parse("none") == 0);
    CHECK(lesson.body.bytes().empty());
    CHECK(lesson.body.path().empty());
    CHECK_FALSE(lesson.body.given());
}

TEST_CASE("what is no file of the kind is refused with what is accepted") {
    const Folder folder;
    ReadsFile lesson;
    const Parameter& body = lesson.body;
    CHECK(refusal_of(body, (folder.path / "no.part").string()) ==
          "body = '" + (folder.path / "no.part").string() +
              "' is not there: give a file that ends in .body or .part, or one of the bodies that come with Pliant: little");
    CHECK_THAT(refusal_of(body, "litle"), ContainsSubstring("did you mean 'little'?"));
    CHECK_THAT(refusal_of(body, folder.path.string()), ContainsSubstring("is a folder"));
    CHECK_THAT(refusal_of(body, folder.write("a.step", "x")), ContainsSubstring("ends in .step: give a file that ends in .body"));
    CHECK_THAT(refusal_of(body, folder.write("plain", "x")), ContainsSubstring("has no ending"));
    CHECK_THAT(refusal_of(body, "/dev/null"), ContainsSubstring("is no file"));
    CHECK(refusal_of(body, folder.write("LARGE.PART", "x")) == "accepted");
    CHECK_THROWS_AS(lesson.body.set(1e6), Refused);
    CHECK_THROWS_AS(lesson.body.set(0.5), Refused);
    CHECK(lesson.body.value() == 0);
}

TEST_CASE("a body that comes with Pliant is found by its name, and a file of that name before it") {
    const Folder folder;
    ReadsFile lesson;
    for (const char* name : {"little", "little.body", "assets/meshes/little.body", "meshes/little"}) {
        lesson.body.set(lesson.body.parse(name));
        CHECK(lesson.body.path() == "little");
        CHECK(lesson.body.name() == "little.body");
        CHECK(lesson.body.bytes() == "bundled");
    }
    CHECK_THAT(refusal_of(lesson.body, "elsewhere/little.body"), ContainsSubstring("is not there"));
    folder.write("little.body", "own");
    const Index number = store_file("little.body", lesson.body.info.endings, Reading::if_new, folder.path.string());
    CHECK(stored_file(number).bytes == "own");
}

TEST_CASE("a scene file names a file from its own folder, and notices that it has changed") {
    const Folder folder;
    const std::string path = folder.write("below/a.part", "one");
    const SceneFile scene{.lesson = "time/reads_file", .parameters = {{"body", path}}};
    const std::string text = scene_text_for(scene, (folder.path / "s.json").string());
    CHECK_THAT(text, ContainsSubstring(R"("path": "below/a.part")"));
    CHECK_THAT(scene_text(scene), ContainsSubstring(R"("path": ")" + path + '"'));
    const auto opened = [&](std::string_view json) { return parse_scene(json, (folder.path / "s.json").string()); };
    CHECK(opened(text).parameters == scene.parameters);
    CHECK(opened(text).notes.empty());
    CHECK(read_share(share_text(scene)).parameters == scene.parameters);

    folder.write("below/a.part", "two");
    REQUIRE(opened(text).notes.size() == 1);
    CHECK_THAT(opened(text).notes[0], ContainsSubstring("has changed since the scene was saved"));
    const Runner run(find_lesson("time/reads_file"), opened(text).parameters);
    CHECK(dynamic_cast<const ReadsFile&>(run.lesson()).body.bytes() == "two");

    fs::remove(path);
    try {
        opened(text);
        FAIL("a missing file is accepted");
    } catch (const Refused& e) {
        CHECK_THAT(e.what(), ContainsSubstring("s.json:"));
        CHECK_THAT(e.what(), ContainsSubstring("'below/a.part' is not there"));
        CHECK_THAT(e.what(), ContainsSubstring("SHA-256 7692c3ad3540bb803c020b3aee66cd8887123234ea0c6e7143c0add73ff431ed"));
    }
}

TEST_CASE("a scene file names a body that comes with Pliant, with its hash or without") {
    for (const char* value : {R"("little")", R"({"path": "little"})", R"({"path": "little.body", "sha256": "0"})"}) {
        const SceneFile scene =
            parse_scene(R"({"pliant": 1, "lesson": "time/reads_file", "parameters": {"body": )" + std::string(value) + "}}",
                        "presets/s.json");
        CHECK(scene.parameters == Runner::Assignments{{"body", "little"}});
        CHECK(scene.notes.size() == (std::string_view(value).find("sha256") != std::string_view::npos ? 1 : 0));
        CHECK(parse_scene(scene_text(scene), "s.json").parameters == scene.parameters);
    }
    for (const char* value : {"3", "true", R"({"path": 3})", R"({"sha256": "0"})", R"({"path": "little", "more": 1})"})
        CHECK_THROWS_AS(
            parse_scene(R"({"pliant": 1, "lesson": "time/reads_file", "parameters": {"body": )" + std::string(value) + "}}",
                        "s.json"),
            Refused);
}

TEST_CASE("many threads name files at a time") {
    const Folder folder;
    std::array<std::string, 4> paths;
    for (std::size_t k = 0; k < paths.size(); ++k) paths[k] = folder.write(std::to_string(k) + ".part", std::to_string(k));
    const ReadsFile lesson;
    std::array<std::array<Real, 4>, 4> numbers;
    {
        std::vector<std::jthread> threads;
        for (auto& of_thread : numbers)
            threads.emplace_back([&] {
                for (std::size_t k = 0; k < paths.size(); ++k) of_thread[k] = lesson.body.parse(paths[k]);
            });
    }
    for (const auto& of_thread : numbers) CHECK(of_thread == numbers[0]);
    for (std::size_t k = 0; k < paths.size(); ++k)
        CHECK(stored_file(static_cast<Index>(numbers[0][k])).bytes == std::to_string(k));
}

}  // namespace
}  // namespace pliant
