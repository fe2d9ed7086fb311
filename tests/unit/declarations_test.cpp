// Declarations in a few lines say what the same members set one by one would.
#include <pliant/lesson/lesson.h>
#include <catch2/catch_test_macros.hpp>

namespace pliant {
namespace {

struct Declared final : Lesson {
    Number length{*this, log_quantity("length", "L", "m", 1, {0.1, 10}, {0, 100, true}, "of the rod"), [this] { return thick; }};
    Whole cells{*this, quantity("cells", "n", "", 8, {1, 64}, "along it").rebuilds()};
    bool thick = true;
    VecX u = VecX::Constant(3, 2);
    int dimension() const override { return 2; }
    void reset() override {}
    Real time_step() const override { return 0; }
    void draw(Scene&) const override {}
};

TEST_CASE("a parameter in a line: what it spans, what is accepted, when it is used") {
    Declared lesson;
    CHECK(lesson.length.info.scale == Scale::log);
    CHECK(lesson.length.accepted().max == 100);
    CHECK(lesson.length.accepted().open_min);
    CHECK(lesson.length.used());
    lesson.thick = false;
    CHECK_FALSE(lesson.length.used());
    CHECK(lesson.cells.info.effect == Effect::rebuild);
    CHECK(lesson.cells.used());
}

TEST_CASE("fields over an array and over a function") {
    Declared lesson;
    const Field stored = scalar_field("u", "u", "m/s", On::node, lesson.u, "").stops_at(5).when([&] { return lesson.thick; });
    CHECK(stored.view().data() == lesson.u.data());
    CHECK(stored.bound() == 5);
    CHECK(stored.in_use());
    lesson.thick = false;
    CHECK_FALSE(stored.in_use());
    const auto part = [&] { return std::span<const Real>(lesson.u.data(), 2); };
    const Field given = plane_vector_field("v", "v", "m/s", On::node, part, "").follows({"u"}, [](const Question& q) {
        return fixed_value(q.index == 3 ? "v = 3" : "v = 0");
    });
    CHECK(given.rank == Rank::vector);
    CHECK(given.size() == 1);
    CHECK(given.defined_by == std::vector<std::string_view>{"u"});
    CHECK(given.explain({"v", 3}).formula == "v = 3");
}

TEST_CASE("a probe that is not defined has neither a value nor a closed form") {
    bool defined = true;
    const Probe probe = probe_of(
                            "e", "E", "J", "", [] { return 2; }, [] { return fixed_value("E = 2"); })
                            .exactly([](Real t) { return 2 * t; })
                            .when([&] { return defined; });
    CHECK(probe.value() == 2);
    CHECK(probe.exact(3) == 6);
    CHECK(probe.explain().formula == "E = 2");
    defined = false;
    CHECK_FALSE(probe.value());
    CHECK_FALSE(probe.exact(3));
    CHECK_FALSE(probe_of("w", "", "", "", [] { return 1; }).when([] { return true; }).exact);
}

TEST_CASE("a stage, a line and an assumption") {
    int passes = 0;
    const Stage stage = stage_of("solve", "A u = f; or u = 0", "here", [&] { ++passes; })
                            .maps({"f"}, {"u"})
                            .shows([] { return std::string_view("A u = f"); })
                            .repeats([&] { return passes < 2; }, [&] { passes = 0; })
                            .when([] { return false; });
    stage.run();
    CHECK(stage.again());
    stage.begin();
    CHECK(passes == 0);
    CHECK_FALSE(stage.end);
    CHECK_FALSE(stage.in_use());
    CHECK(stage.formula_now() == "A u = f");
    CHECK(stage.reads == std::vector<std::string_view>{"f"});
    CHECK(stage.writes == std::vector<std::string_view>{"u"});

    const Line line = line_of("profile", "m/s", "x", "m", "", [](Curve& curve) { curve.value = {1}; })
                          .against(
                              "a table", [](Curve& curve) { curve.value = {2}; }, true)
                          .measures("u")
                          .on_log_axes();
    CHECK(curve_of(line.sample).value == std::vector<Real>{1});
    CHECK(curve_of(line.reference).value == std::vector<Real>{2});
    CHECK(line.reference_points);
    CHECK(line.log_log);
    CHECK(line.value_name == "u");

    const Assumption assumed = assumption_of(
                                   "small", "", [] { return 1; }, [] { return 2; }, "a ≤ 2", "too large")
                                   .mended_by(Fix{"a = 1", {{"a", "1"}}});
    CHECK(assumed.limit() == 2);
    CHECK(assumed.fix()->label == "a = 1");
    CHECK(assumed.in_use());
}

TEST_CASE("a fix is labelled with the symbol of its parameter and keeps every digit") {
    Declared lesson;
    const Fix fix = fix_by(lesson.length, 0.0123456789);
    CHECK(fix.label == "L = 12.35 mm");
    CHECK(fix.assign == decltype(fix.assign){{"length", "0.0123456789"}});
    CHECK(fix_by(lesson.cells, 32).label == "n = 32");
    CHECK(fix_by(lesson.cells, 32).assign.front().second == "32");
}

}  // namespace
}  // namespace pliant

TEST_CASE("an interval is written in few letters, and its ends read back to the bit") {
    CHECK(Interval{0, 1e15}.text() == "[0, 1e15]");
    CHECK(Interval{1e-6, 3600, true, false}.text() == "(1e-6, 3600]");
    CHECK(Interval{-0.5, 1.5, false, true}.text() == "[-0.5, 1.5)");
    CHECK(Interval{-2.1000000000000003e11, 1e100}.text() == "[-210000000000.00003, 1e100]");
}
