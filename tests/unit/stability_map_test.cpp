// The stability atlas: its knobs, how a cell is classed, and the map beside theory.
#include <pliant/study/stability_report.h>

#include "oscillator_lesson.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <nlohmann/json.hpp>

#include <numbers>
#include <sstream>

using namespace pliant;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

using pliant::test::oscillator;

MapOrder order_of(Runner::Assignments settings, std::string_view across, std::string_view up) {
    const auto lesson = oscillator().make();
    return {.lesson = &oscillator(),
            .settings = std::move(settings),
            .across = parse_knob(*lesson, across),
            .up = parse_knob(*lesson, up)};
}

StabilityMap map_of(const std::string& scheme, std::string_view across, std::string_view up, Runner::Assignments more = {}) {
    more.emplace_back("scheme", scheme);
    return make_stability_map(order_of(more, across, up), 1);
}

std::string refusal_of(std::string_view knob) {
    const auto lesson = oscillator().make();
    try {
        parse_knob(*lesson, knob);
    } catch (const Refused& e) {
        return e.what();
    }
    return "accepted";
}

StabilityVerdict judged(const std::vector<Real>& energy, const std::vector<Real>& exact = {}) {
    StabilityWatch watch;
    for (std::size_t i = 0; i < energy.size(); ++i) watch.add(energy[i], exact.empty() ? std::nullopt : std::optional(exact[i]));
    return watch.verdict(true, true);
}

std::vector<Real> sampled(std::size_t count, Real (*energy)(Real)) {
    std::vector<Real> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(energy(static_cast<Real>(i)));
    return values;
}

}  // namespace

TEST_CASE("a knob takes linear, logarithmic and listed values, ends included", "[atlas]") {
    const auto lesson = oscillator().make();
    CHECK(parse_knob(*lesson, "omega=1:3:5").values == std::vector<Real>{1, 1.5, 2, 2.5, 3});
    const Knob log = parse_knob(*lesson, "time_step=1e-3:1:4:log");
    CHECK(log.values.front() == 1e-3);
    CHECK(log.values.back() == 1);
    CHECK_THAT(log.values[1], WithinRel(1e-2, 1e-14));
    CHECK(parse_knob(*lesson, "omega=5,2,7").values == std::vector<Real>{5, 2, 7});
    CHECK(parse_knob(*lesson, "scheme=implicit_euler,explicit_euler").values == std::vector<Real>{2, 0});
    CHECK(parse_knob(*lesson, "count=1:9:3").values == std::vector<Real>{1, 5, 9});
    for (const char* text : {"omega=1:3:5", "time_step=0.001:1:4:log", "omega=5,2,7", "scheme=implicit_euler,explicit_euler"})
        CHECK(text_of(*lesson, parse_knob(*lesson, text)) == text);
}

TEST_CASE("knobs that make no axis are refused in words", "[atlas]") {
    CHECK_THAT(refusal_of("omga=1:2:3"), ContainsSubstring("omega"));
    CHECK_THAT(refusal_of("omega"), ContainsSubstring("FROM:TO:COUNT"));
    CHECK_THAT(refusal_of("omega=1:2"), ContainsSubstring("FROM:TO:COUNT"));
    CHECK_THAT(refusal_of("omega=1:2:3:4:5"), ContainsSubstring("FROM:TO:COUNT"));
    CHECK_THAT(refusal_of("omega=1:2:3:cubic"), ContainsSubstring("cubic"));
    CHECK_THAT(refusal_of("omega=1:2:1"), ContainsSubstring("2 to"));
    CHECK_THAT(refusal_of("omega=1:2:-3"), ContainsSubstring("2 to"));
    CHECK_THAT(refusal_of("omega=1:2:2.5"), ContainsSubstring("2.5"));
    CHECK_THAT(refusal_of("omega=1:2:9999"), ContainsSubstring("2 to"));
    CHECK_THAT(refusal_of("omega=1:2e4:3"), ContainsSubstring("outside the accepted range"));
    CHECK_THAT(refusal_of("omega=2:1:3"), ContainsSubstring("lower end"));
    CHECK_THAT(refusal_of("omega=1:1:3"), ContainsSubstring("lower end"));
    CHECK_THAT(refusal_of("omega=0:1:3:log"), ContainsSubstring("above 0"));
    CHECK_THAT(refusal_of("omega=nan:1:3"), ContainsSubstring("not"));
    CHECK_THAT(refusal_of("omega=x:1:3"), ContainsSubstring("not a number"));
    CHECK_THAT(refusal_of("omega=3"), ContainsSubstring("2 to"));
    CHECK_THAT(refusal_of("omega=3,4,3"), ContainsSubstring("twice"));
    CHECK_THAT(refusal_of("omega=3,"), ContainsSubstring("not a number"));
    CHECK_THAT(refusal_of("scheme=1:3:3"), ContainsSubstring("explicit_euler,semi_implicit_euler"));
    CHECK_THAT(refusal_of("scheme=explicit_euler,magic"), ContainsSubstring("magic"));
    CHECK_THAT(refusal_of("count=1:3:9"), ContainsSubstring("fewer"));
}

TEST_CASE("the first knobs of a lesson are its time step and what is most like a stiffness", "[atlas]") {
    const auto lesson = oscillator().make();
    const auto [across, up] = first_knobs(*lesson);
    CHECK(across->info.key == "time_step");
    CHECK(up->info.key == "omega");
    const Knob knob = useful_knob(*across, 7);
    CHECK(knob.spacing == Spacing::log);
    CHECK(knob.values.size() == 7);
    CHECK(useful_knob(lesson->parameter("scheme"), 7).values.size() == 7);
    CHECK(useful_knob(lesson->parameter("count"), 40).values.size() == 9);
}

TEST_CASE("a bounded energy is stable however wide it swings, and a growth by a tiny factor is not", "[atlas]") {
    CHECK(judged(sampled(200, [](Real n) { return 1 + 0.9 * std::sin(0.7 * n); })).kind == Stability::stable);
    CHECK(judged(sampled(200, [](Real n) { return 20 - 19 * std::cos(0.31 * n); })).kind == Stability::stable);
    const StabilityVerdict growing = judged(sampled(200, [](Real n) { return std::pow(1.00002, 2 * n); }));
    CHECK(growing.kind == Stability::diverged);
    REQUIRE(growing.growth);
    CHECK_THAT(*growing.growth, WithinAbs(1.00002, 2e-7));
    CHECK(judged(sampled(800, [](Real n) { return std::pow(1.001, n) * (1 + 0.2 * std::sin(0.7 * n)); })).kind ==
          Stability::diverged);
    CHECK(judged(sampled(200, [](Real n) { return 1 + 1e-12 * n; })).kind == Stability::stable);  // rounding
    CHECK(judged(std::vector<Real>(200, 0)).kind == Stability::stable);
}

TEST_CASE("a loss counts against the exact solution, and a gain that it has too is none", "[atlas]") {
    const auto decaying = sampled(200, [](Real n) { return std::exp(-0.02 * n); });
    CHECK(judged(decaying).kind == Stability::dissipative);
    CHECK(judged(decaying, decaying).kind == Stability::stable);
    CHECK(judged(sampled(200, [](Real n) { return std::exp(-0.03 * n); }), decaying).kind == Stability::dissipative);
    const auto driven = sampled(200, [](Real n) { return 1 + 0.1 * n; });
    CHECK(judged(driven).kind == Stability::diverged);
    CHECK(judged(driven, driven).kind == Stability::stable);
}

TEST_CASE("a rise is not settled before the motion has come round", "[atlas]") {
    StabilityWatch watch;
    for (int n = 0; n < 100; ++n) watch.add(1 + 0.1 * std::sin(0.01 * n), std::nullopt);
    CHECK_FALSE(watch.verdict(false, false).settled);
    TurnMeter turn;
    turn.clear(1);
    for (int n = 0; n <= 1000; ++n) {
        const std::array<Real, 2> x{std::cos(0.01 * n), std::sin(0.01 * n)};
        turn.add(0, x);
    }
    CHECK_THAT(turn.turned(), WithinAbs(0.01 * 999, 1e-6));
}

TEST_CASE("every scheme agrees with its theory to one cell, from rest and with a speed", "[atlas]") {
    for (const char* speed : {"0", "1"})
        for (const char* scheme :
             {"explicit_euler", "semi_implicit_euler", "implicit_euler", "velocity_verlet", "runge_kutta_4", "midpoint"}) {
            INFO(scheme << ", speed " << speed);
            const StabilityMap map = map_of(scheme, "time_step=2e-3:1:16:log", "omega=1:100:14:log", {{"speed", speed}});
            const auto found = agreement(map);
            REQUIRE(found);
            CHECK(found->compared == 16 * 14);
            CHECK(found->contradicts == 0);
        }
    for (const char* scheme : {"explicit_euler", "semi_implicit_euler", "implicit_euler", "midpoint"}) {
        INFO(scheme);
        const StabilityMap map = map_of(scheme, "time_step=2e-3:1:16:log", "damping_ratio=0:2:11");
        CHECK(agreement(map)->contradicts == 0);
    }
}

TEST_CASE("an energy with another zero is classed the same", "[atlas]") {
    const auto kinds = [](const char* offset) {
        std::string text;
        for (const MapCell& c :
             map_of("semi_implicit_euler", "time_step=2e-3:1:10:log", "omega=1:100:8:log", {{"offset", offset}}).cells)
            text += c.verdict.kind == Stability::diverged ? 'X' : '.';
        return text;
    };
    CHECK(kinds("-3") == kinds("0"));
    CHECK(kinds("5") == kinds("0"));
}

TEST_CASE("the growth that is measured is the amplification of the scheme", "[atlas]") {
    const StabilityMap map = map_of("explicit_euler", "time_step=0.01,0.02", "omega=5,10");
    for (Index j = 0; j < 2; ++j)
        for (Index i = 0; i < 2; ++i) {
            const Real w =
                map.order.across.values[static_cast<std::size_t>(i)] * map.order.up.values[static_cast<std::size_t>(j)];
            REQUIRE(map.at(i, j).verdict.growth);
            CHECK_THAT(*map.at(i, j).verdict.growth, WithinRel(std::sqrt(1 + w * w), 1e-6));
        }
}

TEST_CASE("refusals, solvers that give up and blow-ups are told apart, with their reasons", "[atlas]") {
    const StabilityMap refused = map_of("semi_implicit_euler", "time_step=1e-3,1e-2", "omega=10,100", {{"forbidding", "on"}});
    CHECK(refused.at(0, 0).verdict.kind == Stability::stable);
    CHECK(refused.at(0, 1).verdict.kind == Stability::refused);
    CHECK(refused.at(0, 1).steps == 0);
    CHECK_FALSE(refused.at(0, 1).theory);
    CHECK_THAT(refused.at(1, 1).verdict.reason, ContainsSubstring("at most 50"));
    const StabilityMap stubborn = map_of("stubborn", "time_step=0.05,0.2", "omega=10,11");
    CHECK(stubborn.at(0, 0).verdict.kind == Stability::dissipative);
    CHECK(stubborn.at(1, 0).verdict.kind == Stability::not_converged);
    CHECK_THAT(stubborn.at(1, 0).verdict.reason, ContainsSubstring("did not converge"));
    const StabilityMap wild = map_of("semi_implicit_euler", "time_step=1,2", "omega=10,100");
    CHECK(wild.count(Stability::diverged) == 4);
    CHECK(wild.at(1, 1).steps < 10);
    REQUIRE(wild.at(1, 1).verdict.growth);
    CHECK(*wild.at(1, 1).verdict.growth > 100);
}

TEST_CASE("cells stand row by row, and any number of jobs gives the same bits", "[atlas]") {
    MapOrder order = order_of({{"scheme", "semi_implicit_euler"}}, "time_step=1e-3:1:9:log", "omega=1:100:7:log");
    const StabilityMap one = make_stability_map(order, 1);
    REQUIRE(one.complete);
    CHECK_THAT(*one.at(8, 0).theory, WithinRel(0.5, 1e-12));
    CHECK_THAT(*one.at(0, 6).theory, WithinRel(0.05, 1e-12));
    const std::string csv = map_csv(one);
    for (const int jobs : {2, 3}) CHECK(map_csv(make_stability_map(order, jobs)) == csv);
    CHECK(map_json(make_stability_map(order, 2), {}) == map_json(one, {}));
    order.time = 2;
    const StabilityMap timed = make_stability_map(order, 2);
    // Of the time asked for, where the motion comes round in it, and never too few to be judged.
    CHECK(timed.at(0, 6).steps == 2000);
    CHECK(timed.at(8, 0).steps == least_map_steps);
}

TEST_CASE("a map is cancelled between two steps, and its progress counts every cell", "[atlas]") {
    const MapOrder order = order_of({}, "time_step=1e-3:1:9:log", "omega=1:100:7:log");
    Index last = 0;
    const StabilityMap whole = make_stability_map(order, 2, [&](Index done, Index total) {
        CHECK(total == 63);
        CHECK(done == last + 1);
        last = done;
    });
    CHECK(last == 63);
    std::stop_source stop;
    Index seen = 0;
    const auto cancel = [&](Index done, Index) {
        seen = done;
        if (done == 5) stop.request_stop();
    };
    const StabilityMap cut = make_stability_map(order, 1, cancel, stop.get_token());
    CHECK_FALSE(cut.complete);
    CHECK(cut.cells.empty());
    CHECK(seen == 5);
}

TEST_CASE("what no cell could run is refused before the first", "[atlas]") {
    const auto refusal = [](const MapOrder& order, int jobs = 1) {
        try {
            make_stability_map(order, jobs);
        } catch (const Refused& e) {
            return std::string(e.what());
        }
        return std::string("accepted");
    };
    MapOrder order = order_of({}, "time_step=0.01,0.02", "omega=5,10");
    CHECK_THAT(refusal(order, 0), ContainsSubstring("--jobs"));
    CHECK_THAT(refusal(order_of({}, "omega=5,10", "omega=1,2")), ContainsSubstring("twice"));
    CHECK_THAT(refusal(order_of({{"omega", "3"}}, "time_step=0.01,0.02", "omega=5,10")), ContainsSubstring("--set omega"));
    CHECK_THAT(refusal(order_of({{"omga", "3"}}, "time_step=0.01,0.02", "omega=5,10")), ContainsSubstring("omega"));
    order.steps = 3;
    CHECK_THAT(refusal(order), ContainsSubstring("--steps"));
    order.steps = 200, order.probe = "energi";
    CHECK_THAT(refusal(order), ContainsSubstring("energy"));
    order.probe = "", order.time = -1;
    CHECK_THAT(refusal(order), ContainsSubstring("--time"));
}

TEST_CASE("the bound of theory lies where the time step is its limit, out to the edges", "[atlas]") {
    const StabilityMap map = map_of("semi_implicit_euler", "time_step=1e-2:1:9:log", "omega=1:100:7:log");
    const auto bound = theory_bound(map);
    REQUIRE_FALSE(bound.empty());
    Real lowest = 10, highest = -10;
    for (const auto& segment : bound)
        for (const MapPlace& p : segment) {
            CHECK_THAT(knob_value(map.order.across, p.across) * knob_value(map.order.up, p.up), WithinRel(2, 1e-9));
            lowest = std::min(lowest, p.up), highest = std::max(highest, p.up);
        }
    CHECK_THAT(highest, WithinAbs(6.5, 1e-9));
    CHECK(lowest < 1);
    CHECK(theory_bound(map_of("midpoint", "time_step=1e-2:1:9:log", "omega=1:100:7:log")).empty());
    // Of named options each row has a bound of its own.
    const StabilityMap named = map_of("stubborn", "time_step=1e-3:1:13:log", "omega=5,10");
    CHECK(theory_bound(named).empty());
    MapOrder order = order_of({}, "time_step=1e-2:1:9:log", "scheme=semi_implicit_euler,runge_kutta_4,midpoint");
    const auto rows = theory_bound(make_stability_map(order, 1));
    REQUIRE(rows.size() == 2);
    CHECK_THAT(knob_value(order.across, rows[0][0].across), WithinRel(0.2, 1e-9));
    CHECK(rows[0][0].up == -0.5);
    CHECK(rows[0][1].up == 0.5);
    CHECK_THAT(knob_value(order.across, rows[1][0].across), WithinRel(0.28284271247461903, 1e-9));
}

TEST_CASE("a map in files says what it is in numbers that read back, and nothing that is none", "[atlas]") {
    const StabilityMap map = map_of("explicit_euler", "time_step=1e-3:1:5:log", "damping_ratio=0:2:3", {{"omega", "7"}});
    const std::string csv = map_csv(map), text = map_json(map, {.seconds = 0.5, .jobs = 2});
    CHECK(csv.starts_with(
        "time_step [s],damping_ratio,class,growth_per_step,steps,passes,time_step_over_limit,theory,contradicts\n"));
    CHECK(std::ranges::count(csv, '\n') == 16);
    for (const char* bad : {"nan", "inf,", "Infinity", "NaN"}) {
        CHECK_THAT(csv, !ContainsSubstring(bad));
        CHECK_THAT(text, !ContainsSubstring(bad));
    }
    const auto json = nlohmann::ordered_json::parse(text);
    CHECK(json["lesson"] == "test/oscillator");
    CHECK(json["settings"]["omega"] == 7);
    CHECK(json["knobs"][0]["unit"] == "s");
    CHECK(json["knobs"][0]["values"].get<std::vector<Real>>() == map.order.across.values);
    CHECK(json["cells"]["class"].size() == 15);
    CHECK(json["cells"]["time_step_over_limit"][0].is_null());  // undamped, no step is stable
    CHECK(json["cells"]["theory_stable"][0] == false);
    CHECK(json["cells"]["growth"][0].get<Real>() == *map.at(0, 0).verdict.growth);
    CHECK(json["agreement"]["contradicts"] == 0);
    Index sum = 0;
    for (const auto& [name, count] : json["counts"].items()) sum += count.get<Index>();
    CHECK(sum == 15);
    CHECK(json["cost"]["jobs"] == 2);
    CHECK(json["cost"]["passes"].get<Index>() > 15 * 100);
    CHECK_THAT(map_text(map, {}), ContainsSubstring("agrees with theory"));
}

TEST_CASE("places on a knob and its values are one another's inverse", "[atlas]") {
    const auto lesson = oscillator().make();
    for (const char* text : {"omega=1:3:5", "time_step=1e-3:1:7:log", "omega=5,2,7"}) {
        const Knob knob = parse_knob(*lesson, text);
        for (std::size_t k = 0; k < knob.values.size(); ++k) {
            const auto place = knob_place(knob, knob.values[k]);
            REQUIRE(place);
            CHECK_THAT(*place, WithinAbs(static_cast<Real>(k), 1e-9));
            CHECK_THAT(knob_value(knob, *place), WithinRel(knob.values[k], 1e-12));
        }
        CHECK_FALSE(knob_place(knob, 1000));
    }
}
