// Bad input: exit code 2, nothing on standard output, one message that names what was given and what is accepted.
#include "pliant.h"

#include <sys/stat.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <regex>

using namespace pliant::test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_numeric(const Json& parameter) { return parameter["kind"] == "number" || parameter["kind"] == "whole number"; }

// Does the message tell the range in which this parameter is accepted, as "(-1, 0.5]"?
bool tells_range(const std::string& message, const Json& parameter) {
    static const std::regex interval(R"(([\[(])([-+.e\d]+), ([-+.e\d]+)([\])]))");
    std::smatch found;
    if (!std::regex_search(message, found, interval)) return false;
    const Json& accepted = parameter["accepted"];
    return (found[1] == "(") == accepted["open_min"] && (found[4] == ")") == accepted["open_max"] &&
           std::strtod(found.str(2).c_str(), nullptr) == accepted["min"].get<double>() &&
           std::strtod(found.str(3).c_str(), nullptr) == accepted["max"].get<double>();
}

void check_refused(const std::string& lesson, const Json& parameter, const std::string& value) {
    const std::string key = parameter["key"];
    const std::string message = refusal({"run", lesson, "--steps", "1", "--set", key + "=" + value}, {key + " = "});
    INFO(message);
    CHECK(tells_range(message, parameter));
}

}  // namespace

TEST_CASE("a mistyped name is refused with the nearest one", "[process]") {
    refusal({"lst"}, {"'lst'", "'list'"});
    refusal({"walktrough", "moduli"}, {"'walkthrough'"});
    for (const char* command : {"run", "describe", "walkthrough"})
        refusal({command, "elasticity/modulli"}, {"'elasticity/modulli'", "'elasticity/moduli'", "pliant list"});
    refusal({"run", "mesh/masspring"}, {"'mesh/mass_spring'"});
    refusal({"run", "moduli", "--set", "yungs_modulus=1"}, {"'yungs_modulus'", "'youngs_modulus'"});
    refusal({"run", "moduli", "--set", "test=tensoin"}, {"test = tensoin", "'tension'", "tension, shear, pressure"});
    refusal({"run", "mesh/mass_spring", "--set", "integrator=implicit_oiler"}, {"'implicit_euler'"});
    refusal({"run", "moduli", "--preset", "nothing"}, {"preset"});
    refusal({"shot", "moduli", "--steps", "0", "--field", "stres", "--out", "x.png"}, {"'stres'", "'stress'"});
    refusal({"--lesson", "modulii"}, {"'elasticity/moduli'"});
}

TEST_CASE("what stands for nothing known is refused without a guess", "[process]") {
    const std::string message = refusal({"run", "quaternions"}, {"'quaternions'", "pliant list"});
    CHECK_FALSE(contains(message, "did you mean"));
}

TEST_CASE("calls that lack something or have too much are refused", "[process]") {
    refusal({"run"}, {"lesson"});
    refusal({"describe"}, {"lesson"});
    refusal({"shot", "moduli"}, {"--out"});
    refusal({"run", "moduli", "more"}, {"more"});
    refusal({"run", "moduli", "--stpes", "3"}, {"--stpes", "--help"});
    refusal({"run", "moduli", "--steps"}, {"--steps"});
    refusal({"list", "moduli"}, {"moduli"});
    refusal({"walkthrough", "moduli", "--check", "--present"}, {"--check", "--present"});
    refusal({"walkthrough", "moduli", "--theme", "projector"}, {"--theme", "--present"});
    refusal({"walkthrough", "moduli", "--questions"}, {"--questions", "--out"});
    refusal({"walkthrough", "moduli", "--out", "x", "--check"}, {"--out", "--check"});
    refusal({"walkthrough", "moduli", "--out", "x", "--frames", "3"}, {"--frames", "--present"});
    refusal({"walkthrough", "moduli", "--out", ""}, {"--out"});
    refusal({"walkthrough", "moduli", "--out", "x", "--size", "9x9"}, {"--size"});
    refusal({"shot", "moduli", "--slide", "2", "--out", "x.png"}, {"--slide", "--layout deck"});
    refusal({"shot", "moduli", "--layout", "deck", "--slide", "9", "--out", "x.png"}, {"slide 9", "1 to 8"});
    refusal({"shot", "moduli", "--layout", "deck", "--slide", "0", "--out", "x.png"}, {"--slide"});
    refusal({"shot", "moduli", "--layout", "deck", "--set", "load=1", "--out", "x.png"}, {"--set", "walkthrough"});
    refusal({"run", "moduli", "--scene", "a.json", "--preset", "b"}, {"--scene or --preset"});
    refusal({"run", "moduli", "--steps", "3", "--time", "1"}, {"--steps, --time and --rest"});
    refusal({"run", "moduli", "--rest", "--time", "1"}, {"--steps, --time and --rest"});
    refusal({"run", "moduli", "--set", "youngs_modulus"}, {"youngs_modulus", "KEY=VALUE"});
    refusal({"run", "moduli", "--set", "=5"}, {"KEY=VALUE"});
    refusal({"run", "moduli", "--set", "youngs_modulus="}, {"youngs_modulus"});
    refusal({"run", "moduli", "--set", ""}, {"KEY=VALUE"});
}

TEST_CASE("a run to rest of a scene that never rests is refused before its first step", "[process]") {
    refusal({"run", "navier_stokes", "--set", "scene=box", "--rest"}, {"never comes to rest", "stirring", "--steps or --time"});
    refusal({"run", "navier_stokes", "--set", "scene=karman", "--rest", "--json"}, {"never comes to rest", "reynolds"});
    refusal({"run", "mass_spring", "--preset", "slippery_bouncer", "--rest"}, {"never comes to rest", "damping mode"});
    refusal({"run", "advection", "--rest"}, {"never comes to rest"});
}

TEST_CASE("a length of the run that is none is refused", "[process]") {
    for (const char* steps : {"-1", "1.5", "many", "nan", "1e3x", "99999999999999999999"})
        refusal({"run", "mesh/mass_spring", "--steps", steps}, {"steps"});
    for (const char* time : {"-1", "nan", "inf", "-inf", "long"}) refusal({"run", "mesh/mass_spring", "--time", time}, {"time"});
}

TEST_CASE("pictures and windows that cannot be are refused", "[process]") {
    const auto shot = [](const char* option, const char* value) {
        return Arguments{"shot", "moduli", "--steps", "0", "--out", "x.png", option, value};
    };
    for (const char* size : {"10x10", "1280", "1280x", "x720", "1280x720x3", "-5x400", "99999x400", "1280*720", "4294967936x360"})
        refusal(shot("--size", size), {size, "1280x720"});
    for (const char* scale : {"0", "0.9", "3.5", "nan", "-inf"}) refusal(shot("--ui-scale", scale), {"--ui-scale", "1 to 3"});
    refusal(shot("--theme", "bright"), {"bright", "dark or projector"});
    refusal(shot("--layout", "page"), {"page", "slide", "lab"});
    refusal(shot("--backend", "vulkan"), {"vulkan", "osmesa"});
    refusal(shot("--component", "99"), {"--component"});
    refusal(shot("--stage", "lunch"), {"lunch", "solve"});
    refusal({"--size", "10x10"}, {"10x10"});
    refusal({"--theme", "bright"}, {"dark or projector"});
    refusal({"--ui-scale", "9"}, {"1 to 3"});
    CHECK_FALSE(fs::exists("x.png"));
}

TEST_CASE("a number that is none is refused for every parameter", "[process][every_lesson]") {
    for (const std::string& lesson : every_lesson())
        for (const Json& p : parameters_of(lesson))
            if (is_numeric(p)) check_refused(lesson, p, "nan");
}

TEST_CASE("infinite numbers, and numbers just outside the range, are refused for every parameter",
          "[process][slow][every_lesson]") {
    for (const std::string& lesson : every_lesson())
        for (const Json& p : parameters_of(lesson)) {
            if (!is_numeric(p)) continue;
            check_refused(lesson, p, "inf");
            check_refused(lesson, p, "-inf");
            check_refused(lesson, p, "1e999");
            const double low = p["accepted"]["min"], high = p["accepted"]["max"];
            const bool whole = p["kind"] == "whole number";
            check_refused(lesson, p, exactly(p["accepted"]["open_min"] ? low : whole ? low - 1 : std::nextafter(low, -infinity)));
            check_refused(lesson, p,
                          exactly(p["accepted"]["open_max"] ? high
                                  : whole                   ? high + 1
                                                            : std::nextafter(high, infinity)));
        }
}

TEST_CASE("a value of the wrong kind is refused for every parameter", "[process][slow][every_lesson]") {
    for (const std::string& lesson : every_lesson())
        for (const Json& p : parameters_of(lesson)) {
            const std::string key = p["key"];
            const auto refuse = [&](const char* value, const std::string& word) {
                refusal({"run", lesson, "--set", key + "=" + value}, {key + " = ", word});
            };
            if (is_numeric(p)) {
                refuse("twelve", "number");
                refuse("1,500", "two ways");
                refuse("2*3", "number");
                refuse("3 parsec", "parsec");
                refuse("0x10", "number");
                refuse("1 2", "number");
                if (p["kind"] == "whole number") refuse("1.5", "whole number");
            } else if (p["kind"] == "choice") {
                for (const Json& option : p["options"]) refuse("1e400", option["key"]);
            } else if (p["kind"] == "file") {
                refuse("perhaps", "is not there");
            } else {
                refuse("perhaps", "true or false");
            }
        }
}

TEST_CASE("a file that cannot be written is refused before the run, and nothing is left", "[process]") {
    const Scratch scratch;
    const std::string file = scratch.file("file", "here first\n");
    const auto before = scratch.names();
    for (const std::string& path : {scratch.path("missing/probes.csv"), file + "/probes.csv", scratch.folder().string()}) {
        CAPTURE(path);
        refusal({"run", "moduli", "--set", "resolution=1", "--csv", path}, {path});
        refusal({"shot", "moduli", "--steps", "0", "--out", path}, {path});
    }
    refusal({"tour", "--out", file}, {file});
    refusal({"tour", "--out", file + "/tour"}, {file});
    CHECK(scratch.names() == before);
    CHECK(contents_of(file) == "here first\n");
}

TEST_CASE("a refused run leaves the file of an earlier one as it was", "[process]") {
    const Scratch scratch;
    const std::string csv = scratch.file("probes.csv", "precious\n");
    refusal({"run", "moduli", "--set", "youngs_modulus=-1", "--csv", csv}, {"youngs_modulus"});
    refusal({"run", "moduli", "--steps", "-1", "--csv", csv}, {"steps"});
    refusal({"run", "mesh/mass_spring", "--time", "nan", "--csv", csv}, {"time"});
    CHECK(contents_of(csv) == "precious\n");
    CHECK(scratch.names() == std::vector<std::string>{"probes.csv"});
}

TEST_CASE("a pipe is written to and a link is followed, not replaced", "[process]") {
    const Scratch scratch;
    const std::string pipe = scratch.path("pipe"), link = scratch.path("link.csv"), target = scratch.path("target.csv");
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    const int reader = open(pipe.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    fs::create_symlink("target.csv", link);
    output_of({"run", "moduli", "--set", "resolution=1", "--csv", pipe});
    output_of({"run", "moduli", "--set", "resolution=1", "--csv", link});
    CHECK(fs::is_fifo(pipe));
    std::string text(1 << 16, ' ');
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, read(reader, text.data(), text.size()))));
    close(reader);
    CHECK(text.starts_with("step,"));
    CHECK(fs::is_symlink(link));
    CHECK(contents_of(target) == text);
    CHECK(scratch.names().size() == 3);
}

TEST_CASE("output that cannot be written is an error", "[process]") {
    if (!fs::exists("/dev/full")) SKIP("this system has no /dev/full");
    const Scratch scratch;
    for (const Arguments& arguments :
         {Arguments{"list", "--json"}, Arguments{"run", "moduli", "--set", "resolution=1", "--json"}}) {
        Child child(PLIANT_PROGRAM, arguments, "/dev/full", scratch.folder() / "err");
        REQUIRE(child.wait());
        CHECK(child.exit_code() == refused);
        CHECK(contains(contents_of(scratch.folder() / "err"), "standard output"));
    }
}

TEST_CASE("without a display the window says what to do instead", "[process]") {
    for (const Environment& environment : {Environment{}, Environment{{"DISPLAY", ""}}, Environment{{"DISPLAY", ":987"}}}) {
        for (const Arguments& arguments : {Arguments{}, Arguments{"walkthrough", "moduli", "--present", "--notes"}}) {
            const Outcome outcome = call(arguments, environment);
            INFO(outcome.err);
            CHECK(outcome.exit_code == machine_lacks);
            CHECK(contains(outcome.err, "display"));
            CHECK(contains(outcome.err, "pliant shot"));
            CHECK(outcome.out.empty());
        }
    }
}
