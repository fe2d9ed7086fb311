// Share strings and animations on the command line.
#include "pliant.h"

using namespace pliant::test;

namespace {
std::string share_of(Arguments arguments) {
    arguments.insert(arguments.begin(), "share");
    std::string text = output_of(arguments);
    REQUIRE(text.ends_with("\n"));
    text.pop_back();
    return text;
}
}  // namespace

TEST_CASE("a share string runs as the scene that it was made of", "[process]") {
    const Scratch scratch;
    const Arguments settings{"--set", "test=shear", "--set", "youngs_modulus=2.1000000000000003e11"};
    Arguments given{"elasticity/moduli"};
    given.insert(given.end(), settings.begin(), settings.end());
    const std::string text = share_of(given);
    CHECK(text.starts_with("pliant1:"));
    CHECK(text.find('\n') == text.npos);
    const Json shared = json_of({"run", "--scene", text, "--steps", "0"});
    CHECK(shared["lesson"] == "elasticity/moduli");
    CHECK(shared["parameters"]["youngs_modulus"] == 2.1000000000000003e11);
    CHECK(shared["parameters"]["test"] == "shear");

    const std::string scene = scratch.file(
        "s.json", R"({"pliant": 1, "lesson": "mesh/mass_spring", "events": [{"step": 2, "set": {"time_step": 0.0005}}]})");
    CHECK(without_cost(json_of({"run", "--scene", share_of({"--scene", scene}), "--steps", "5"})) ==
          without_cost(json_of({"run", "--scene", scene, "--steps", "5"})));
    CHECK(share_of({"--scene", share_of({"--scene", scene})}) == share_of({"--scene", scene}));
    CHECK(share_of({"mesh/mass_spring", "--preset", "beam"}).size() < 600);
}

TEST_CASE("a share string that is not whole, or a scene that cannot be shared, is refused", "[process]") {
    const std::string text = share_of({"mesh/mass_spring"});
    for (const auto& [arguments, words] : std::vector<std::pair<Arguments, std::string>>{
             {{"run", "--scene", text.substr(0, 20)}, "cut off"},
             {{"run", "--scene", "pliant7:" + text.substr(8)}, "version 7"},
             {{"run", "elasticity/moduli", "--scene", text}, "the share string is a scene of mesh/mass_spring"},
             {{"share", "mesh/mass_spring", "--set", "mass=-1"}, "mass"},
             {{"share"}, "--scene"}}) {
        const Outcome outcome = call(arguments);
        INFO(sentence(arguments) << "\n" << outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK(contains(outcome.err, words));
        CHECK(outcome.out.empty());
    }
}

TEST_CASE("shot writes an animation", "[process]") {
    const Scratch scratch;
    const auto shoot = [&](const std::string& name) {
        return call(
            {"shot", "mesh/mass_spring", "--size", "320x240", "--seconds", "1", "--fps", "5", "--out", scratch.path(name)});
    };
    REQUIRE(shoot("a.gif").exit_code == 0);
    REQUIRE(shoot("b.gif").exit_code == 0);
    const std::string gif = contents_of(scratch.path("a.gif"));
    CHECK(gif.starts_with("GIF89a"));
    CHECK(gif.size() > 10000);
    CHECK(gif == contents_of(scratch.path("b.gif")));

    for (const Arguments& more :
         {Arguments{"--out", scratch.path("c.gif")}, Arguments{"--out", scratch.path("c.png"), "--seconds", "2"},
          Arguments{"--out", scratch.path("c.gif"), "--seconds", "31"},
          Arguments{"--out", scratch.path("c.gif"), "--seconds", "2", "--fps", "51"}}) {
        Arguments arguments{"shot", "mesh/mass_spring"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = call(arguments);
        INFO(outcome.err);
        CHECK(outcome.exit_code == 2);
        CHECK_FALSE(fs::exists(arguments[3]));
    }
}
