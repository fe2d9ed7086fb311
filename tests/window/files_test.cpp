// Menus, the file dialog and what is remembered, under mouse and keys.
#include "desk.h"

using namespace pliant::test;

namespace {

bool asks(Desk& desk) {
    return desk.becomes([](const Json& s) { return s["dialog"] != ""; });
}

}  // namespace

TEST_CASE("the menus do what the keys do, by mouse and by keys", "[window]") {
    need_screen_and_mouse();
    Desk desk;
    desk.click("menu Run");
    desk.click("menu Pause");
    CHECK(desk.stays("playing", false));
    const long step = desk.state()["step"];
    desk.click("menu Run");
    desk.click("menu One step");
    CHECK(desk.stays("step", step + 1));
    desk.click("menu View");
    desk.click("menu Projector theme");
    CHECK(desk.becomes("theme", "projector"));
    // F10 goes to the menus: Run, its first entry.
    desk.key("F10");
    desk.key("Right");
    desk.key("Right");
    desk.key("Down");
    desk.key("Down");
    desk.key("Return");
    CHECK(desk.becomes([&](const Json& s) { return s["playing"] == true || s["step"].get<long>() != step + 1; }));
    CHECK(desk.complaints().empty());
}

TEST_CASE("a scene is saved and opened by the dialog", "[window]") {
    need_screen_and_mouse();
    Desk desk({"--lesson", "elasticity/moduli"});
    pause(desk);
    desk.hold("ctrl");
    desk.key("shift+s");
    desk.let_go("ctrl");
    REQUIRE(asks(desk));
    desk.key("ctrl+a");
    desk.type("first");
    desk.key("Return");
    CHECK(desk.becomes("dialog", ""));
    const std::string file = desk.scratch().path("first.json");
    CHECK(desk.becomes("file", file));
    CHECK(fs::exists(file));

    // The same name again asks, and Escape leaves the file and then the dialog.
    const std::string before = contents_of(file);
    desk.drag(desk.on("poisson_ratio"), desk.on("poisson_ratio", 0.3));
    desk.click("menu File");
    desk.click("menu Save as…");
    REQUIRE(asks(desk));
    desk.key("Return");
    desk.key("Escape");
    CHECK(contents_of(file) == before);
    desk.key("Escape");
    CHECK(desk.becomes("dialog", ""));
    CHECK(contents_of(file) == before);
    // Ctrl S writes to the file.
    desk.key("ctrl+s");
    CHECK(desk.becomes([&](const Json&) { return contents_of(file) != before; }));

    desk.key("bracketright");
    CHECK(desk.becomes("file", ""));
    desk.key("ctrl+o");
    REQUIRE(asks(desk));
    // What was typed went into the name, not to the lab.
    desk.type("nothing.json");
    desk.key("Return");
    CHECK(desk.becomes([](const Json& s) { return s["complaint"] != ""; }));
    desk.click("file entry first.json");
    desk.click("file accept");
    CHECK(desk.becomes("lesson", "elasticity/moduli"));
    CHECK(desk.becomes("dialog", ""));
    CHECK(desk.becomes("file", file));
    CHECK(desk.complaints().empty());
}

TEST_CASE("arrows choose a file, a scene travels through the clipboard", "[window]") {
    need_screen_and_mouse();
    Desk desk;
    pause(desk);
    desk.scratch().file("a.json", R"({"pliant": 1, "lesson": "fluids/navier_stokes"})");
    desk.key("ctrl+o");
    REQUIRE(asks(desk));
    // From the end of the list: the lab's own state.json, then the scene.
    desk.key("Up");
    desk.key("Up");
    desk.key("Return");
    CHECK(desk.becomes("dialog", ""));
    CHECK(desk.becomes("lesson", "fluids/navier_stokes"));
    desk.hold("ctrl");
    desk.key("shift+c");
    desk.let_go("ctrl");
    CHECK(desk.becomes([](const Json& s) { return s["message"].get<std::string>().starts_with("Copied"); }));
    const std::string lesson = desk.state()["lesson"];
    desk.key("bracketright");
    CHECK(desk.becomes([&](const Json& s) { return s["lesson"] != lesson; }));
    desk.hold("ctrl");
    desk.key("shift+v");
    desk.let_go("ctrl");
    CHECK(desk.becomes("lesson", lesson));
}

TEST_CASE("theme and recent files outlast a restart, a flag wins", "[window]") {
    need_screen_and_mouse();
    const Scratch scratch;
    const std::string config = scratch.path("config");
    const std::string scene = scratch.file("s.json", R"({"pliant": 1, "lesson": "elasticity/moduli"})");
    {
        Desk desk({"--scene", scene}, config);
        CHECK(desk.state()["theme"] == "dark");
        desk.key("t");
        CHECK(desk.becomes("theme", "projector"));
        CHECK(desk.close_window() == 0);
    }
    {
        Desk desk({}, config);
        CHECK(desk.state()["theme"] == "projector");
        CHECK(desk.state()["recent"] == Json::array({scene}));
        desk.click("menu File");
        desk.click("menu Open recent");
        desk.click("menu recent " + scene);
        CHECK(desk.becomes("lesson", "elasticity/moduli"));
        CHECK(desk.close_window() == 0);
    }
    {
        Desk desk({"--theme", "dark"}, config);
        CHECK(desk.state()["theme"] == "dark");
        CHECK(desk.close_window() == 0);
    }
    {
        Desk desk({"--no-settings"}, config);
        CHECK(desk.state()["theme"] == "dark");
        desk.key("t");
        CHECK(desk.becomes("theme", "projector"));
        CHECK(desk.close_window() == 0);
    }
    write_text(fs::path(config) / "pliant" / "settings.json", "{ this is broken");
    Desk desk({}, config);
    CHECK(desk.state()["theme"] == "dark");
    CHECK(desk.state()["message"].get<std::string>().find("settings.json.bad") != std::string::npos);
    CHECK(fs::exists(fs::path(config) / "pliant" / "settings.json.bad"));
}

TEST_CASE("a mesh of one's own is opened by the dialog", "[window]") {
    need_screen_and_mouse();
    const Scratch scratch;
    const std::string part = scratch.file("part.msh", contents_of(PLIANT_SOURCE_DIR "/assets/meshes/plate_with_hole_coarse.msh"));
    const std::string scene = scratch.file(
        "own.json", R"({"pliant": 1, "lesson": "mesh/fem", "parameters": {"scene": "own", "mesh_file": "gear_coarse"}})");
    Desk desk({"--scene", scene});
    pause(desk);
    const auto mesh_is = [&](const std::string& text) {
        return desk.becomes([&](const Json& s) { return s["parameters"]["mesh_file"] == text; });
    };
    CHECK(mesh_is("gear_coarse"));
    desk.click("open mesh_file");
    REQUIRE(asks(desk));
    desk.key("ctrl+a");
    desk.type(part);
    desk.key("Return");
    CHECK(desk.becomes("dialog", ""));
    CHECK(mesh_is(part));
    CHECK(desk.complaints().empty());
}
