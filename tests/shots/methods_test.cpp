// All methods at the present setting in one press, and what would be if one parameter were another.
#include "app/lab.h"
#include "unseen.h"
#include "waiting.h"

#include <imgui.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cfloat>
#include <utility>

using namespace pliant;
using namespace pliant::viewer;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("one key compares all methods where the run stands; a row becomes run B", "[methods]") {
    const auto context = test::open_unseen({1280, 800});
    Lab lab(*context, "time/integration");
    const auto frames = [&](int count) {
        for (int i = 0; i < count; ++i) lab.frame(0), context->present();
    };
    lab.session().run(Until::after_steps(60));
    lab.perform(Action::methods);
    frames(3);
    MethodTable& table = lab.state().methods.table;
    for (int wait = 0; wait < 3000 && table.busy(); ++wait) std::this_thread::sleep_for(std::chrono::milliseconds(10)), frames(1);
    REQUIRE(table.result());
    CHECK(table.trouble().empty());
    CHECK(table.result()->steps == 60);
    CHECK(table.result()->runs.size() == 8);
    CHECK_FALSE(table.outdated(lab.session()));
    frames(3);
    CHECK(lab.state().side == SideTab::methods);
    CHECK(lab.state().controls.contains("method implicit_euler"));
    open_method_beside(lab.session(), *table.result(), 0);
    frames(2);
    REQUIRE(lab.session().companion());
    CHECK(lab.session().runner().place().step == 60);
    CHECK(lab.session().companion()->runner().place().step == 60);
    lab.session().assign(lab.session().lesson().parameter("omega"), 3);
    CHECK(table.outdated(lab.session()));
}

TEST_CASE("what if: half and twice a number, the other options of a choice, and what that does in words", "[methods]") {
    Session s("mesh/mass_spring");
    s.run(Until::after_steps(50));
    const Parameter& dt = s.lesson().parameter("time_step");
    const auto numbers = what_if(s, dt);
    REQUIRE(numbers.size() == 2);
    CHECK_THAT(numbers[0].words, ContainsSubstring("half: "));
    compare_what_if(s, dt, numbers[0]);
    REQUIRE(s.companion());
    CHECK(s.runner().place().step == 50);
    CHECK(s.companion()->runner().place().step == 100);
    const std::string words = what_if_words(s);
    CHECK_THAT(words, ContainsSubstring("With time step ") && ContainsSubstring("in place of") && ContainsSubstring("energy"));
    s.close_companion();
    CHECK(what_if_words(s).empty());
    CHECK(what_if(s, s.lesson().parameter("ground")).size() == 1);
    CHECK(what_if(s, s.lesson().parameter("integrator")).size() + 1 == s.lesson().parameter("integrator").info.options.size());
    s.assign(s.lesson().parameter("gravity"), 0);
    CHECK(what_if(s, s.lesson().parameter("gravity")).empty());
}

TEST_CASE("the table of methods is readable in narrow panels", "[methods]") {
    const auto width_of = [](const std::string& text, ImFont* font) {
        return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x;
    };
    for (const auto& [size, scale] : {std::pair{Size{1440, 810}, 1.f}, {Size{1280, 720}, 1.5f}, {Size{1920, 1080}, 1.5f}}) {
        const auto context = test::open_unseen(size);
        Lab lab(*context, "time/integration");
        lab.set_scale(scale);
        const auto frames = [&](int count) {
            for (int i = 0; i < count; ++i) lab.frame(0), context->present();
        };
        lab.session().run(Until::after_steps(40));
        frames(2);
        MethodTable& table = lab.state().methods.table;
        table.follow(lab.session());
        table.make_now(lab.session());
        lab.state().side_wanted = SideTab::methods;
        frames(6);
        CAPTURE(size.width, scale);
        REQUIRE(table.result());
        for (const MethodRun& r : table.result()->runs) {
            CAPTURE(r.label);
            const float least = width_of("semi-implicit", lab.state().fonts.small);
            // A name takes room for its first words, a number all that it needs.
            REQUIRE(lab.state().controls.contains("method name " + r.option));
            CHECK(lab.state().controls.at("method name " + r.option).width >=
                  std::min(least, width_of(r.label, lab.state().fonts.small)) - 1);
        }
    }
}

TEST_CASE("a comparison that takes long tells so and waits for its button", "[methods]") {
    const auto context = test::open_unseen({1280, 800});
    Lab lab(*context, "time/integration");
    const auto frames = [&](int count) {
        for (int i = 0; i < count; ++i) lab.frame(0), context->present();
    };
    MethodTable& table = lab.state().methods.table;
    table.follow(lab.session());
    const MethodTable::Work before = table.work(lab.session());
    CHECK(before.runs == 8);
    CHECK(before.steps == lab.session().entry().info.demo_steps);
    CHECK_FALSE(before.seconds);
    CHECK_FALSE(MethodTable::Work{.runs = 8, .steps = 10, .seconds = 3}.long_one());
    CHECK(MethodTable::Work{.runs = 8, .steps = 1000000, .seconds = 300}.long_one());
    lab.session().run(Until::after_steps(60));
    CHECK(table.work(lab.session()).steps == 60);
    lab.state().side_wanted = SideTab::methods;
    frames(4);
    CHECK(lab.state().controls.contains("methods work"));
}

TEST_CASE("the first steps of every method are measured, and what takes long is told and not run", "[methods]") {
    Session s("mesh/mass_spring");
    MethodTable table;
    const auto wait = [&] {
        for (int k = 0; k < 6000 && table.busy(); ++k)
            std::this_thread::sleep_for(std::chrono::milliseconds(10)), table.follow(s);
        REQUIRE_FALSE(table.busy());
        CHECK(table.trouble().empty());
    };
    table.follow(s);
    s.run(Until::after_steps(20));
    CHECK_FALSE(table.work(s).seconds);
    table.start(s, true);
    wait();
    REQUIRE(table.result());
    const MethodTable::Work small = table.work(s);
    REQUIRE(small.seconds);
    CHECK(*small.seconds > 0);
    CHECK_FALSE(table.so_far());
    // An implicit step costs many times what an explicit one does, which the present run makes: a million of them take long.
    s.assign(s.lesson().parameter("time_step"), 1e-6);
    s.reset();
    const SceneFile now = s.scene_file();
    const SceneFile scene{.lesson = now.lesson, .parameters = now.parameters};
    const auto seconds = seconds_to_compare(scene, "", Until::after_steps(1000000));
    REQUIRE(seconds);
    CHECK(MethodTable::Work{.seconds = seconds}.long_one());
}

TEST_CASE("the bar of a comparison moves with the steps, and each row comes with its run", "[methods]") {
    const SceneFile scene{.lesson = "mesh/mass_spring", .parameters = {}};
    Watch watch;
    const Watched watched(watch);
    std::vector<Index> shares;
    std::size_t rows = 0;
    const MethodComparison c = compare_methods(scene, "", Until::after_steps(12), [&](const MethodComparison& so_far) {
        CHECK(so_far.runs.size() == ++rows);
        const Watch::Progress p = watch.progress();
        CHECK(p.what == "methods");
        REQUIRE(p.share());
        shares.push_back(p.done);
    });
    CHECK(rows == c.runs.size());
    CHECK(shares.front() > 0);
    CHECK(std::ranges::is_sorted(shares));
    CHECK(shares.back() > shares.front());
    CHECK(std::ranges::any_of(c.runs, [](const MethodRun& r) { return r.error.has_value(); }));
}
