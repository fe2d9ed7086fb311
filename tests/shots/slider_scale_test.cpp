// Every useful value of every slider is within the reach of a mouse, and the steps of the keys go through all of it.
#include "panels/slider_scale.h"

#include <pliant/document/scene_file.h>
#include <pliant/text/format.h>
#include <pliant/text/texts.h>

#include "../every_lesson.h"

#include <fmt/format.h>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

namespace {

// Of a slider of 180 px, what its grip leaves it.
constexpr int pixels = 164;
constexpr Real pixel = 1.0 / pixels;

std::vector<const Parameter*> numbers_of(const Lesson& lesson) {
    std::vector<const Parameter*> numbers;
    for (const Parameter* p : lesson.parameters)
        if (p->info.kind == Kind::number || p->info.kind == Kind::whole) numbers.push_back(p);
    return numbers;
}

Real at_pixel(const SliderScale& scale, Real place, Real width = pixel) {
    return scale.snapped(std::round(place / width) * width, width);
}

bool has_digits(Real value, int digits) {
    return format_exact(value).size() < 24 && std::stod(fmt::format("{:.{}e}", value, digits - 1)) == value;
}

// The numbers to which the presets of the lesson set a parameter, within its ends.
std::set<Real> preset_values(const LessonEntry& entry, const Parameter& p, const SliderScale& scale) {
    std::set<Real> values;
    for (const std::string& name : preset_names(entry.info.id))
        for (const auto& [key, text] : preset(entry, name).parameters)
            if (p.info.is_called(key))
                if (const Real value = p.parse(text); value >= scale.least() && value <= scale.greatest()) values.insert(value);
    return values;
}

}  // namespace

TEST_CASE("a mouse reaches the default, the ends and the numbers of the presets", "[lab][every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        const auto lesson = entry.make();
        for (const Parameter* p : numbers_of(*lesson)) {
            CAPTURE(entry.info.id, p->info.key);
            const SliderScale scale(*p, false, p->info.initial);
            CHECK(at_pixel(scale, scale.place(p->info.initial)) == p->info.initial);
            CHECK(at_pixel(scale, 0) == scale.least());
            CHECK(at_pixel(scale, 1) == scale.greatest());
            CHECK(scale.least() <= p->info.useful.min);
            for (const Real value : preset_values(entry, *p, scale)) {
                CAPTURE(value);
                const Real got = at_pixel(scale, scale.place(value));
                const bool next_whole = p->info.kind == Kind::whole && std::abs(got - value) <= 1;
                CHECK((next_whole || std::abs(scale.place(got) - scale.place(value)) <= 1.001 * pixel));
                // Finely, within a tenth of that.
                const Real fine = at_pixel(scale, scale.place(value), pixel / 10);
                CHECK((fine == value || std::abs(scale.place(fine) - scale.place(value)) <= 0.1001 * pixel));
            }
        }
    }
}

TEST_CASE("each pixel of a slider is a short number that is accepted, in order", "[lab][every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        const auto lesson = entry.make();
        for (const Parameter* p : numbers_of(*lesson))
            for (const bool extreme : {false, true}) {
                CAPTURE(entry.info.id, p->info.key, extreme);
                const SliderScale scale(*p, extreme, p->info.initial);
                Real before = scale.least();
                for (int k = 0; k <= pixels; ++k) {
                    const Real value = scale.snapped(k * pixel, pixel);
                    CAPTURE(k, value);
                    REQUIRE_NOTHROW(p->check(value));
                    REQUIRE(value >= before);
                    const bool given = value == p->info.initial || k == 0 || k == pixels || value == scale.value_at(k * pixel);
                    REQUIRE((given || p->info.kind == Kind::whole || has_digits(value, 4)));
                    before = value;
                }
            }
    }
}

TEST_CASE("the steps of the keys lead from end to end of a slider, and back", "[lab][every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        const auto lesson = entry.make();
        for (const Parameter* p : numbers_of(*lesson)) {
            CAPTURE(entry.info.id, p->info.key);
            const SliderScale scale(*p, false, p->info.initial);
            for (const int direction : {1, -1}) {
                const Real end = direction > 0 ? scale.greatest() : scale.least();
                Real value = p->info.initial;
                int steps = 0;
                for (; value != end && steps < 400; ++steps) {
                    const Real next = scale.stepped(value, direction);
                    REQUIRE((direction > 0 ? next > value : next < value));
                    REQUIRE_NOTHROW(p->check(next));
                    value = next;
                }
                CHECK(value == end);
                CHECK(scale.stepped(end, direction) == end);
            }
            if (p->info.kind == Kind::whole) CHECK(std::abs(scale.stepped(p->info.initial, 1, true) - p->info.initial) <= 1);
        }
    }
}

TEST_CASE("the roundest number of a range is the one that a person would take", "[lab]") {
    CHECK(roundest(0.94e-4, 1.06e-4) == 1e-4);
    CHECK(roundest(0.342, 0.358) == 0.35);
    CHECK(roundest(-0.3, 0.1) == 0);
    CHECK(roundest(4.7, 5.3) == 5);
    CHECK(roundest(-212, -188) == -200);
    CHECK(roundest(9.805, 9.815) == 9.81);
    CHECK(roundest(0.0249, 0.0251) == 0.025);
}

TEST_CASE("a logarithmic slider whose number may be 0 has it at its left end", "[lab]") {
    const auto lesson = find_lesson("mesh/mass_spring").make();
    const Parameter& damping = lesson->parameter("damping");
    const SliderScale scale(damping, false, damping.info.initial);
    CHECK(scale.snapped(0, pixel) == 0);
    CHECK(scale.place(0) == 0);
    CHECK(scale.snapped(0.05, pixel) > 0);
    CHECK(scale.stepped(damping.info.useful.min, -1) == 0);
    CHECK(scale.stepped(0, 1) == damping.info.useful.min);
    // One that may not be 0 begins where it is useful.
    const Parameter& dt = lesson->parameter("time_step");
    CHECK(SliderScale(dt, false, dt.info.initial).snapped(0, pixel) == dt.info.useful.min);
}

TEST_CASE("the limit of explicit Euler is within reach, with and without extreme ranges", "[lab]") {
    const auto lesson = find_lesson("mesh/mass_spring").make();
    const Parameter& dt = lesson->parameter("time_step");
    for (const Real wanted : {1e-5, 1e-4, 250e-6, 1e-3, 0.02}) {
        CAPTURE(wanted);
        const SliderScale scale(dt, false, dt.info.initial);
        CHECK(std::abs(at_pixel(scale, scale.place(wanted)) / wanted - 1) < 0.05);
        const SliderScale wide(dt, true, dt.info.initial);
        CHECK(std::abs(at_pixel(wide, wide.place(wanted)) / wanted - 1) < 0.1);
    }
    // Of a range that goes far beyond what is useful, what is useful keeps its room.
    const Parameter& g = lesson->parameter("gravity");
    const SliderScale wide(g, true, 9.81);
    CHECK(std::abs(at_pixel(wide, wide.place(5)) - 5) < 0.5);
    CHECK(wide.greatest() == 1e6);
}
