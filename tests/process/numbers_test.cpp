// Numbers mean the same wherever they stand: decimal, whatever stands in front of them.
#include "pliant.h"

using namespace pliant::test;

TEST_CASE("a zero in front counts for nothing, in every option that takes a whole number", "[process]") {
    const Scratch scratch;
    CHECK(json_of({"run", "mesh/mass_spring", "--steps", "010"})["steps"] == 10);
    CHECK(json_of({"run", "mesh/mass_spring", "--steps", "008"})["steps"] == 8);
    CHECK(json_of({"run", "mesh/mass_spring", "--steps", "+3"})["steps"] == 3);
    CHECK(json_of({"run", "mesh/mass_spring", "--steps", "1e1"})["steps"] == 10);
    CHECK(json_of({"run", "mesh/mass_spring", "--steps", "0", "--set", "cells_x=010"})["parameters"]["cells_x"] == 10);
    CHECK(json_of({"why", "moduli", "--field", "stress", "--index", "010", "--depth", "01"})["index"] == 10);
    const auto shot = [&](const Arguments& more) {
        Arguments arguments{"shot", "moduli", "--size", "0320x0200", "--out"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return output_of(arguments);
    };
    // 20 frames, not 16: the header of each begins with these bytes.
    shot({scratch.path("film.gif"), "--seconds", "02", "--fps", "010"});
    const std::string film = contents_of(scratch.path("film.gif"));
    std::size_t frames = 0;
    for (std::size_t at = film.find("\x21\xf9\x04"); at != film.npos; at = film.find("\x21\xf9\x04", at + 1)) ++frames;
    CHECK(frames == 20);
    shot({scratch.path("deck.png"), "--layout", "deck", "--slide", "03"});
    shot({scratch.path("third.png"), "--layout", "deck", "--slide", "3"});
    CHECK(contents_of(scratch.path("deck.png")) == contents_of(scratch.path("third.png")));
    output_of({"study", "time/integration", "--map", "time_step=0.1:0.2:010", "omega=1,2", "--steps", "020", "--jobs", "02",
               "--out", scratch.path("maps")});
    const Json map = Json::parse(contents_of(scratch.path("maps/map.json")));
    CHECK(map["knobs"][0]["values"].size() == 10);
    CHECK(map["steps"] == 20);
    CHECK(map["cost"]["jobs"] == 2);
}

TEST_CASE("other ways of counting are refused by every option that takes a number", "[process]") {
    const std::string out = "never.png";
    const std::vector<std::pair<Arguments, std::string>> options{
        {{"run", "moduli"}, "--steps"},
        {{"run", "mesh/mass_spring"}, "--time"},
        {{"run", "fluids/diffusion"}, "--threads"},
        {{"why", "moduli", "--field", "stress"}, "--index"},
        {{"why", "moduli", "--field", "stress"}, "--component"},
        {{"why", "moduli", "--field", "stress"}, "--depth"},
        {{"shot", "moduli", "--out", out}, "--fps"},
        {{"shot", "moduli", "--out", out}, "--seconds"},
        {{"shot", "moduli", "--out", out}, "--component"},
        {{"shot", "moduli", "--out", out}, "--slide"},
        {{"shot", "moduli", "--out", out}, "--ui-scale"},
        {{"study", "integration", "--map", "time_step=0.1,0.2", "omega=1,2", "--out", "never"}, "--jobs"},
        {{"study", "integration", "--map", "time_step=0.1,0.2", "omega=1,2", "--out", "never"}, "--steps"},
        {{}, "--frames"},
        {{"walkthrough", "moduli", "--present"}, "--frames"}};
    for (const auto& [call, option] : options)
        for (const char* number : {"0x10", "0b10", "+-5", "--5", "1,250", "5five", "five", "1e999"}) {
            Arguments arguments = call;
            arguments.push_back(option + "=" + number);
            refusal(arguments, {option, number});
        }
    CHECK_FALSE(fs::exists(out));
}

TEST_CASE("two signs make no number", "[process]") {
    for (const char* number : {"+-5", "-+5", "++5", "--5", "+"})
        refusal({"run", "time/integration", "--set", std::string("x0=") + number}, {"x0 = '" + std::string(number) + "'"});
    CHECK(json_of({"run", "time/integration", "--steps", "0", "--set", "x0=+0.5"})["parameters"]["x0"] == 0.5);
    CHECK(json_of({"run", "time/integration", "--steps", "0", "--set", "x0=-0.5"})["parameters"]["x0"] == -0.5);
}

TEST_CASE("an empty text is refused by every option", "[process]") {
    const Scratch scratch;
    const Json lessons = json_of({"list"});
    const std::string png = scratch.path("x.png");
    const std::vector<std::pair<Arguments, std::vector<std::string>>> commands{
        {{"run", "moduli"}, {"--set", "--scene", "--preset", "--steps", "--time", "--threads", "--csv"}},
        {{"why", "moduli"}, {"--field", "--index", "--component", "--stage", "--depth", "--scene", "--preset", "--set"}},
        {{"share", "moduli"}, {"--scene", "--preset", "--set"}},
        {{"shot", "moduli", "--out", png},
         {"--scene", "--preset", "--set", "--seconds", "--fps", "--stage", "--field", "--component", "--size", "--ui-scale",
          "--theme", "--layout", "--slide", "--beside", "--claim", "--backend"}},
        {{"shot", "moduli"}, {"--out"}},
        {{"study", "integration", "--map", "time_step=0.1,0.2", "omega=1,2", "--out", scratch.path("maps")},
         {"--set", "--preset", "--steps", "--time", "--probe", "--jobs", "--size", "--ui-scale", "--theme"}},
        {{"tour"}, {"--out"}},
        {{"walkthrough", "moduli", "--present"}, {"--size", "--theme", "--ui-scale", "--frames", "--state", "--threads"}},
        {{}, {"--lesson", "--scene", "--size", "--theme", "--ui-scale", "--frames", "--state", "--threads"}}};
    for (const auto& [command, options] : commands)
        for (const std::string& option : options) {
            Arguments apart = command, together = command;
            apart.insert(apart.end(), {option, ""});
            together.push_back(option + "=");
            refusal(apart, {option, "empty"});
            refusal(together, {option, "empty"});
        }
    for (const char* command : {"run", "why", "share", "shot", "describe", "walkthrough", "study"})
        refusal({command, ""}, {"empty"});
    refusal({"claims", ""}, {"empty"});
    refusal({""}, {"no command"});
    CHECK(scratch.names().empty());
}
