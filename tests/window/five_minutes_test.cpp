// "Your first lesson, in five minutes" of README, played word by word: every key that it names in bold is pressed.
#include "desk.h"

#include <cmath>
#include <regex>
#include <set>

using namespace pliant::test;

namespace {

std::string five_minutes() {
    const std::string readme = contents_of(PLIANT_SOURCE_DIR "/README.md");
    const auto begin = readme.find("## Your first lesson"), end = readme.find("\n## ", begin + 4);
    REQUIRE(begin != std::string::npos);
    return readme.substr(begin, end - begin);
}

// Presses keys as README names them, and remembers which.
class Reader {
public:
    explicit Reader(Desk& desk) : desk_(desk) {}
    void press(const std::string& name) {
        pressed_.insert(name);
        static const std::map<std::string, std::string> on_keyboard{
            {"Space", "space"}, {".", "period"}, {"/", "slash"},        {",", "comma"},           {"<", "less"},
            {"→", "Right"},     {"←", "Left"},   {"]", "bracketright"}, {"Shift F2", "shift+F2"}, {"Shift F3", "shift+F3"}};
        const auto found = on_keyboard.find(name);
        std::string key = found == on_keyboard.end() ? name : found->second;
        if (key.size() == 1) key[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(key[0])));
        desk_.key(key);
    }
    // The keys in bold that were not pressed.
    std::set<std::string> left_out(const std::string& text) const {
        std::set<std::string> left;
        const std::regex bold(R"(\*\*([^*\n]{1,12})\*\*)");
        for (std::sregex_iterator it(text.begin(), text.end(), bold), none; it != none; ++it)
            if (!pressed_.contains((*it)[1])) left.insert((*it)[1]);
        return left;
    }

private:
    Desk& desk_;
    std::set<std::string> pressed_;
};

const Json& inspected(const Json& state) { return state["inspector"]; }

}  // namespace

TEST_CASE("README's five minutes, word by word", "[window][readme]") {
    need_screen_and_mouse();
    const std::string text = five_minutes();
    Desk desk;
    Reader reader(desk);

    // 1. A block of springs falls. Pull it; drag beside it to turn the view; Home frames it again.
    REQUIRE(desk.becomes([](const Json& s) { return s["lesson"] == "mesh/mass_spring" && s["step"].get<long>() > 10; }));
    const Spot grip = grip_of(desk);
    desk.move({grip.x + 40, grip.y - 80});
    CHECK(desk.becomes([](const Json& s) { return s["pulling"] >= 0; }));
    desk.release();
    CHECK(desk.becomes("pulling", -1));
    desk.drag(desk.on("scene", 0.05, 0.9), desk.on("scene", 0.2, 0.8));
    reader.press("Home");

    // 2. Pause, steps and stages, forth and back; a ring, a condition, V.
    reader.press("Space");
    REQUIRE(desk.becomes("playing", false));
    const long step = desk.state()["step"];
    reader.press(".");
    CHECK(desk.becomes("step", step + 1));
    reader.press("F2");
    CHECK(desk.becomes("step", step + 2));
    reader.press("<");
    CHECK(desk.becomes("step", step + 1));
    reader.press("Shift F2");
    CHECK(desk.becomes("step", step));
    reader.press("/");
    REQUIRE(desk.becomes([](const Json& s) { return s["passes"] == 1; }));
    reader.press("F3");
    REQUIRE(desk.becomes([](const Json& s) { return s["passes"] == 2; }));
    reader.press(",");
    CHECK(desk.becomes([&](const Json& s) { return s["passes"] == 1 && s["step"] == step; }));
    reader.press("Shift F3");
    CHECK(desk.becomes([&](const Json& s) { return s["passes"] == 0 && s["step"] == step; }));
    desk.click("stage");
    CHECK(desk.becomes([](const Json& s) { return s["passes"] == 1; }));
    desk.click("stage back");
    CHECK(desk.becomes([](const Json& s) { return s["passes"] == 0; }));
    desk.click("back");
    CHECK(desk.becomes("step", step - 1));
    desk.click(desk.on("past", 0.25));
    CHECK(desk.becomes([&](const Json& s) { return s["step"].get<long>() < step - 1; }));
    desk.click("dot integrate");
    CHECK(desk.becomes([](const Json& s) { return inspected(s)["stops"].size() == 1; }));
    reader.press("Space");
    REQUIRE(desk.becomes([](const Json& s) { return s["playing"] == false && inspected(s)["stopped"] != ""; }));
    desk.click("dot integrate");
    // The condition that README gives is accepted in the lesson that it opened.
    const std::smatch condition = [&] {
        std::smatch found;
        REQUIRE(std::regex_search(text, found, std::regex("conditions such as `([^`]+)`")));
        return found;
    }();
    reader.press("F9");
    REQUIRE(desk.becomes([](const Json& s) { return s["controls"].contains("condition"); }));
    desk.click("condition");
    desk.type(condition[1]);
    desk.click("add condition");
    REQUIRE(desk.becomes([](const Json& s) { return inspected(s).contains("conditions"); }));
    desk.click("clear breaks");
    desk.key("Escape");
    desk.key("Escape");
    reader.press("V");
    CHECK(desk.becomes([](const Json& s) { return inspected(s)["compare"] == "before"; }));
    for (int more = 0; more < 4; ++more) reader.press("V");
    CHECK(desk.becomes([](const Json& s) { return inspected(s)["compare"] == "now"; }));

    // 3. All numbers of a node, why one is what it is, and why its inputs are, components too.
    reader.press("I");
    REQUIRE(desk.becomes([](const Json& s) { return inspected(s)["shown"] == true; }));
    desk.click("why spring_force");
    REQUIRE(desk.becomes([](const Json& s) { return inspected(s).contains("answer"); }));
    const Json inputs = inspected(desk.state())["answer"]["inputs"];
    REQUIRE(inputs.size() == 3);
    desk.click("ask " + inputs[1]["symbol"].get<std::string>());
    REQUIRE(
        desk.becomes([](const Json& s) { return inspected(s)["questions"] == 2 && inspected(s)["answer"]["component"] == 1; }));

    // 4. A number typed in the unit that is shown, arrows, the wheel; explicit Euler, and what it leads to; pin, second run,
    // cost.
    const auto step_is = [&](double dt) {
        return desk.becomes([&](const Json&) { return std::abs(desk.parameter("time_step") - dt) < 1e-12; });
    };
    const double default_step = desk.parameter("time_step");
    desk.hold("ctrl");
    desk.click("time_step");
    desk.let_go("ctrl");
    REQUIRE(desk.becomes("typing", true));
    desk.key("ctrl+a");
    desk.type("2");
    desk.key("Return");
    REQUIRE(step_is(2e-3));
    reader.press("→");
    CHECK(desk.becomes([&](const Json&) { return desk.parameter("time_step") > 2e-3; }));
    reader.press("←");
    CHECK(step_is(2e-3));
    desk.move(desk.on("time_step"));
    desk.hold("alt");
    desk.wheel(false);
    desk.let_go("alt");
    CHECK(desk.becomes([&](const Json&) { return desk.parameter("time_step") != 2e-3; }));
    desk.hold("shift");
    const double before_fine = desk.parameter("time_step");
    desk.drag(desk.on("time_step"), desk.on("time_step", 0.55));
    desk.let_go("shift");
    CHECK(desk.becomes([&](const Json&) { return desk.parameter("time_step") != before_fine; }));
    desk.double_click(desk.on("time_step"));
    CHECK(step_is(default_step));
    const Spot box = desk.on("integrator");
    const double row = desk.state()["controls"]["integrator"][3];
    desk.click(box);
    desk.click(Spot{box.x, box.y + static_cast<int>(row)});
    REQUIRE(desk.becomes([](const Json& s) { return s["parameters"]["integrator"] == "explicit_euler"; }));
    desk.key("space");
    REQUIRE(desk.becomes([](const Json& s) { return s["autopsy"] != ""; }));
    desk.key("Return");
    REQUIRE(desk.becomes("autopsy", ""));
    CHECK(desk.parameter("time_step") < 1e-3);
    desk.key("r");
    desk.right_click(desk.on("time_step"));
    REQUIRE(desk.becomes([](const Json& s) { return s["controls"].contains("what if 1"); }));
    desk.click("what if 1");
    REQUIRE(desk.becomes([](const Json& s) { return s["companion"].is_object(); }));
    reader.press("2");
    REQUIRE(desk.becomes([](const Json& s) { return s["companion"].is_null(); }));
    reader.press("G");
    CHECK(desk.becomes("pinned", true));
    reader.press("G");
    reader.press("2");
    REQUIRE(desk.becomes([](const Json& s) { return s["companion"].is_object(); }));
    reader.press("2");
    REQUIRE(desk.becomes([](const Json& s) { return s["companion"].is_null(); }));
    reader.press("C");
    CHECK(desk.becomes("cost_shown", true));
    reader.press("C");

    // 6 to 8. Panels by keys, the summary, patterns; claims; the atlas.
    reader.press("F6");
    CHECK(desk.becomes([](const Json& s) { return s.contains("focus"); }));
    reader.press("S");
    CHECK(desk.becomes([](const Json& s) { return s["summary"] != ""; }));
    reader.press("S");
    reader.press("P");
    CHECK(desk.becomes("patterns", true));
    reader.press("P");
    reader.press("K");
    CHECK(desk.becomes([](const Json& s) { return s["claims"]["shown"] == true; }));
    reader.press("W");
    REQUIRE(desk.becomes([](const Json& s) { return s["atlas"]["shown"] == true && s["controls"].contains("atlas make"); }));
    // Coarse at once: a cell can be opened before all of them are there.
    desk.click("atlas make");
    REQUIRE(desk.becomes(
        [](const Json& s) { return s["atlas"]["cells_done"].get<long>() > 0 && s["controls"].contains("atlas area"); }));
    const Json chosen = desk.state()["parameters"];
    desk.click(desk.on("atlas area", 0.05, 0.05));
    CHECK(desk.becomes([&](const Json& s) { return s["parameters"] != chosen; }));
    reader.press("Y");
    CHECK(desk.becomes([](const Json& s) { return s["methods"]["shown"] == true; }));
    // It may take long: it is begun, and can be called off.
    REQUIRE(desk.becomes([](const Json& s) { return s["methods"]["busy"] == true || s["methods"]["rows"].size() >= 3; }));

    // 5. The walkthrough asks, runs and checks; D shows it as a deck; H hands in.
    reader.press("N");
    REQUIRE(desk.becomes([](const Json& s) { return s["slide"] == 1 && s["revealed"] == false; }));
    reader.press("N");
    REQUIRE(desk.becomes("revealed", true));
    reader.press("D");
    REQUIRE(desk.becomes("layout", "deck"));
    reader.press("D");
    REQUIRE(desk.becomes("layout", "lab"));
    reader.press("H");
    REQUIRE(desk.becomes([](const Json& s) { return s["controls"].contains("hand-in save"); }));
    desk.click("hand-in close");

    // 9. Borders; the next lesson, the slide, the theme, the keys.
    const auto picture_wide = [](const Json& s) { return s["controls"]["scene"][2].get<double>(); };
    const double usual = picture_wide(desk.state());
    const Spot border = desk.on("border left");
    desk.drag(border, {border.x + 60, border.y});
    REQUIRE(desk.becomes([&](const Json& s) { return picture_wide(s) < usual - 30; }));
    desk.double_click(desk.on("border left"));
    CHECK(desk.becomes([&](const Json& s) { return picture_wide(s) == usual; }));
    reader.press("]");
    REQUIRE(desk.becomes([](const Json& s) { return s["lesson"] != "mesh/mass_spring"; }));
    reader.press("F7");
    desk.move(desk.on("scene"));
    reader.press("X");
    CHECK(desk.becomes("fill", "picture"));
    reader.press("X");
    CHECK(desk.becomes("fill", ""));
    reader.press("F11");
    reader.press("F11");
    desk.move(desk.on("scene"));
    reader.press("Tab");
    CHECK(desk.becomes("layout", "slide"));
    desk.key("Escape");
    CHECK(desk.becomes("layout", "lab"));
    reader.press("T");
    CHECK(desk.becomes("theme", "projector"));
    reader.press("F1");
    CHECK(desk.becomes("help", true));

    CHECK(reader.left_out(text) == std::set<std::string>());
    CHECK(desk.complaints().empty());
}
