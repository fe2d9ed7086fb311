// Scene files that are wrong: exit code 2, and the message begins with file, line and column of what is wrong.
#include "pliant.h"

#include <random>

using namespace pliant::test;

namespace {

struct Wrong {
    std::string what, text;
    int line, column;
    std::string words;  // that the message says
};

// The head of a scene whose next character is in line 2, column 1.
const std::string head = R"({"pliant": 1, "lesson": "elasticity/moduli",)"
                         "\n";

std::vector<Wrong> wrong_scenes() {
    return {
        {"empty", "", 1, 1, "not JSON"},
        {"blank lines alone", "\n\n", 3, 1, "end of input"},
        {"not JSON", "youngs_modulus = 5\n", 1, 1, "not JSON"},
        {"a list", "[1, 2]", 1, 1, "one JSON object"},
        {"a number", "3", 1, 1, "one JSON object"},
        {"cut off", head + R"( "parameters": {"youngs_modulus": 1)", 2, 36, "end of input"},
        {"text behind the end", head + R"( "parameters": {}} {})", 2, 20, "not JSON"},
        {"a comment", head + "// words\n}", 2, 1, "not JSON"},
        {"a comma too many", head + R"( "parameters": {},})", 2, 19, "not JSON"},
        {"no version", R"({"lesson": "elasticity/moduli"})", 1, 1, "\"pliant\""},
        {"version 0", R"({"pliant": 0, "lesson": "elasticity/moduli"})", 1, 2, "give 1"},
        {"a newer version", "{\n  \"pliant\": 3, \"lesson\": \"elasticity/moduli\"}", 2, 3, "newer than this program"},
        {"version 1.5", R"({"pliant": 1.5, "lesson": "elasticity/moduli"})", 1, 2, "give 1"},
        {"a version in quotes", R"({"pliant": "1", "lesson": "elasticity/moduli"})", 1, 2, "give 1"},
        {"no lesson", R"({"pliant": 1})", 1, 1, "\"lesson\" is missing"},
        {"a mistyped lesson",
         R"({"pliant": 1,)"
         "\n"
         R"(  "lesson": "elasticity/modulli"})",
         2, 3, "'elasticity/moduli'"},
        {"a lesson that is a number", R"({"pliant": 1, "lesson": 7})", 1, 15, "text in quotes, not 7"},
        {"a lesson that is nothing", R"({"pliant": 1, "lesson": null})", 1, 15, "text in quotes, not null"},
        {"a lesson without a name", R"({"pliant": 1, "lesson": ""})", 1, 15, "''"},
        {"an unknown key", head + R"(  "parametres": {}})", 2, 3, "'parameters'"},
        {"an unknown key with a slash", head + R"(  "a/b~c": {}})", 2, 3, "'a/b~c'"},
        {"an unknown key with escapes", head + R"(  "\u00e4\"b": {}})", 2, 3, "unknown key"},
        {"a key twice",
         head + R"( "parameters": {"length": 1,)"
                "\n"
                R"(   "length": 1}})",
         3, 4, "'length' is given twice"},
        {"a section twice",
         head + R"( "parameters": {},)"
                "\n"
                R"(   "parameters": {}})",
         3, 4, "given twice"},
        {"parameters as a list", head + R"( "parameters": [1]})", 2, 2, "object"},
        {"a mistyped parameter", head + R"( "parameters": {"lenght": 1}})", 2, 17, "'length'"},
        {"a number in quotes", head + R"( "parameters": {"length": "1"}})", 2, 17, "a number is expected"},
        {"null for a number", head + R"( "parameters": {"length": null}})", 2, 17, "a number is expected"},
        {"true for a number", head + R"( "parameters": {"length": true}})", 2, 17, "a number is expected"},
        {"a list for a number", head + R"( "parameters": {"length": [1]}})", 2, 17, "a number is expected"},
        {"a number out of range",
         head + R"( "parameters": {"length": 1,)"
                "\n"
                R"( "poisson_ratio": 0.5}})",
         3, 2, "(-1, 0.5)"},
        {"a fraction for a whole number", head + R"( "parameters": {"resolution": 2.5}})", 2, 17, "whole number"},
        {"a number beyond all numbers", head + R"( "parameters": {"length": 1e999}})", 2, 31, "1e999"},
        {"NaN", head + R"( "parameters": {"length": NaN}})", 2, 27, "not JSON"},
        {"a mistyped option", head + R"( "parameters": {"test": "tensoin"}})", 2, 17, "'tension'"},
        {"a number for an option", head + R"( "parameters": {"test": 0}})", 2, 17, "in quotes"},
        {"a camera of two numbers", head + R"( "camera": {"target": [0, 1]}})", 2, 13, "three numbers"},
        {"a camera with a word", head + R"( "camera": {"target": [0, 1, "z"]}})", 2, 13, "finite number"},
        {"a camera without a distance", head + R"( "camera": {"distance": 0}})", 2, 13, "above 0"},
        {"a mistyped key of the camera", head + R"( "camera": {"distanz": 1}})", 2, 13, "'distance'"},
        {"a mistyped field", head + R"( "view": {"field": "stres"}})", 2, 11, "'stress'"},
        {"a component too many", head + R"( "view": {"field": "stress", "component": 9}})", 2, 30, "0 to 8"},
        {"a mistyped stage", head + R"( "view": {"stage": "sovle"}})", 2, 11, "'solve'"},
        {"events as an object", head + R"( "events": {}})", 2, 2, "list"},
        {"an event before the start",
         head + R"( "events": [{"step": 0},)"
                "\n"
                R"(  {"step": -1}]})",
         3, 4, "from 0 on"},
        {"an event that sets nothing known", head + R"( "events": [{"step": 0, "set": {"lenght": 1}}]})", 2, 33, "'length'"},
        {"a pull of no place", head + R"( "events": [{"step": 0, "pull": {"index": 1}}]})", 2, 25, "'to'"},
        {"a pull of a fraction of a node", head + R"( "events": [{"step": 0, "pull": {"index": 1.5, "to": [0, 0, 0]}}]})", 2, 34,
         "whole number"},
        {"a pull of a node beyond all numbers", head + R"( "events": [{"step": 0, "pull": {"index": 1e300, "to": [0, 0, 0]}}]})",
         2, 34, "whole number"},
    };
}

std::string message_for(const Scratch& scratch, const std::string& text) {
    const Outcome outcome = call({"run", "--scene", scratch.file("a.scene.json", text), "--steps", "1"});
    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    return outcome.err;
}

std::string place(const Scratch& scratch, int line, int column) {
    return scratch.path("a.scene.json") + ":" + std::to_string(line) + ":" + std::to_string(column) + ": ";
}

// Begins with the file and some line and column.
bool names_a_place(const Scratch& scratch, const std::string& message) {
    const std::string start = "pliant: " + scratch.path("a.scene.json") + ":";
    return message.starts_with(start) && std::isdigit(static_cast<unsigned char>(message[start.size()]));
}

}  // namespace

TEST_CASE("a wrong scene file is refused with line and column", "[process]") {
    const Scratch scratch;
    for (const Wrong& wrong : wrong_scenes()) {
        const std::string message = message_for(scratch, wrong.text);
        INFO(wrong.what << "\n" << message << "expected at " << wrong.line << ":" << wrong.column << ", saying: " << wrong.words);
        CHECK(contains(message, "pliant: " + place(scratch, wrong.line, wrong.column)));
        CHECK(contains(message, wrong.words));
        // Once.
        CHECK(message.find(scratch.path("a.scene.json")) == message.rfind(scratch.path("a.scene.json")));
    }
}

TEST_CASE("a scene file that is not text is refused", "[process]") {
    const Scratch scratch;
    CHECK(contains(message_for(scratch, head + " \"parameters\": {\"l\xe4nge\": 1}}"), place(scratch, 2, 20)));
    std::mt19937 random(7);
    std::string noise(100000, ' ');
    for (char& c : noise) c = static_cast<char>(random());
    CHECK(names_a_place(scratch, message_for(scratch, noise)));
    CHECK(names_a_place(scratch, message_for(scratch, std::string(1000, '\0'))));
}

TEST_CASE("a NUL byte is refused with its place, and so is what follows the end", "[process]") {
    using namespace std::string_literals;
    const Scratch scratch;
    const std::string whole = head + " \"parameters\": {}}";
    REQUIRE(call({"run", "--scene", scratch.file("a.scene.json", whole + " \n\t\r\n"), "--steps", "0"}).exit_code == 0);
    for (const auto& [text, line, column] : {std::tuple{whole + "\0"s, 2, 19},
                                             {whole + "\0 and more"s, 2, 19},
                                             {whole + "\n\0{}"s, 3, 1},
                                             {"\0"s + whole, 1, 1},
                                             {head + "\0 \"parameters\": {}}"s, 2, 1},
                                             {head + " \"para\0meters\": {}}"s, 2, 7}}) {
        const std::string message = message_for(scratch, text);
        INFO(message);
        CHECK(contains(message, place(scratch, line, column)));
        CHECK(contains(message, "NUL"));
    }
    for (const std::string more : {"x", "{}", ",", "}", "\"\"", "1", "null", "\x1a", "\xef\xbb\xbf"}) {
        const std::string message = message_for(scratch, whole + "\n" + more);
        INFO(more << "\n" << message);
        CHECK(contains(message, scratch.path("a.scene.json") + ":3:"));
    }
}

TEST_CASE("a deeply nested scene file is refused", "[process]") {
    const Scratch scratch;
    const auto nested = [](const std::string& opening) {
        std::string text = head + " \"parameters\": ";
        for (int i = 0; i < 200000; ++i) text += opening;
        return text;
    };
    const std::string lists = message_for(scratch, nested("[")), objects = message_for(scratch, nested("{\"a\":"));
    for (const std::string& message : {lists, objects}) {
        CHECK(contains(message, place(scratch, 2, 1).substr(0, place(scratch, 2, 1).size() - 3)));
        CHECK(contains(message, "nested"));
        CHECK(message.size() < 1000);
    }
}

TEST_CASE("every piece of a scene file that is cut off is refused with a place", "[process][slow]") {
    const Scratch scratch;
    const std::string whole = head + R"( "parameters": {"youngs_modulus": 1e6, "test": "shear"},
 "camera": {"target": [0, 0.5, 0], "distance": 3},
 "events": [{"step": 20, "set": {"load": 0}}]})";
    REQUIRE(call({"run", "--scene", scratch.file("a.scene.json", whole), "--steps", "0"}).exit_code == 0);
    for (std::size_t length = 0; length < whole.size(); ++length) {
        CAPTURE(length);
        CHECK(names_a_place(scratch, message_for(scratch, whole.substr(0, length))));
    }
}

TEST_CASE("a scene file that is not there, or is a folder, is refused", "[process]") {
    const Scratch scratch;
    for (const std::string& path :
         {scratch.path("missing.json"), scratch.folder().string(), scratch.file("file", "") + "/scene.json"}) {
        const Outcome outcome = call({"run", "--scene", path});
        INFO(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK(contains(outcome.err, path));
    }
}

TEST_CASE("a scene of another lesson is refused", "[process]") {
    const Scratch scratch;
    const std::string scene = scratch.file("scene.json", head + " \"parameters\": {}}");
    const Outcome outcome = call({"run", "mesh/mass_spring", "--scene", scene});
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.err, "elasticity/moduli"));
    CHECK(contains(outcome.err, "mesh/mass_spring"));
}

TEST_CASE("a byte order mark and the line ends of Windows are accepted", "[process]") {
    const Scratch scratch;
    const std::string scene = scratch.file(
        "scene.json",
        "\xef\xbb\xbf{\"pliant\": 1,\r\n \"lesson\": \"elasticity/moduli\",\r\n \"parameters\": {\"length\": 0.4}}\r\n");
    CHECK(json_of({"run", "--scene", scene, "--steps", "0"})["parameters"]["length"] == 0.4);
}

TEST_CASE("events of a scene file happen in their step", "[process]") {
    const Scratch scratch;
    const std::string scene = scratch.file(
        "scene.json", R"({"pliant": 1, "lesson": "mesh/mass_spring", "events": [{"step": 2, "set": {"time_step": 0.0005}}]})");
    const Json plain = json_of({"run", "mesh/mass_spring", "--steps", "4"});
    const double dt = plain["time"].get<double>() / 4;
    const double time = json_of({"run", "--scene", scene, "--steps", "4"})["time"];
    REQUIRE(std::abs(dt - 0.0005) > 1e-6);
    CHECK(std::abs(time - (2 * dt + 2 * 0.0005)) < 1e-12);
}
