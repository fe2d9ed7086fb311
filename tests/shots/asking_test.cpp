// Whatever number is seen can be asked: components of a vector, what a solve has left of its equations.
#include "app/lab.h"
#include "unseen.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>

using namespace pliant;
using namespace pliant::viewer;
using Catch::Matchers::ContainsSubstring;

namespace {

struct Asker {
    std::unique_ptr<Context> context = test::open_unseen({1280, 900});
    Lab lab;
    explicit Asker(std::string_view lesson) : lab(*context, lesson) {}
    void ask(const std::string& field, Index index, int component) {
        lab.session().ask({.field = field, .index = index, .component = component});
        REQUIRE(lab.session().inspector.answer);
        lab.state().side_wanted = SideTab::inspect;
        lab.session().inspector.thing = Thing{lab.session().lesson().field(field).on, index};
        for (int i = 0; i < 6; ++i) lab.frame(0), context->present();
    }
    const Answer& answer() { return *lab.session().inspector.answer; }
    bool can_ask(const std::string& symbol) { return lab.state().controls.contains("ask " + symbol); }
};

}  // namespace

TEST_CASE("the components of a vector can each be asked", "[why]") {
    Asker it("mesh/mass_spring");
    it.lab.session().run(Until::after_steps(20));
    it.ask("spring_force", 3, -1);
    REQUIRE(it.answer().inputs.size() == 3);
    for (const Answer& in : it.answer().inputs) CHECK(it.can_ask(in.symbol));
}

TEST_CASE("unknowns of one solve are said to be solved together, and lead on to what is left", "[why]") {
    Asker it("fluids/projection");
    it.lab.session().run(Until::at_rest());
    it.ask("pressure", 100, -1);
    const std::string words = words_of_solve(it.answer(), it.lab.session().lesson());
    CHECK_THAT(words, ContainsSubstring("Solved together with 575 other cells") && ContainsSubstring("go on from there"));
    CHECK_FALSE(it.can_ask("p_left"));
    CHECK(it.can_ask("d"));
    const auto left = std::ranges::find(it.answer().inputs, true, &Answer::leftover);
    REQUIRE(left != it.answer().inputs.end());
    CHECK(left->field == "divergence_after");
    CHECK_THAT(why_text(why(it.lab.session().runner(), "pressure", 100, -1)), ContainsSubstring("solved together with it"));
}

TEST_CASE("what follows from other rows by a formula is not said to be solved together", "[why]") {
    Runner r(find_lesson("mesh/mass_spring"));
    for (int i = 0; i < 5; ++i) r.step();
    for (const Field& f : r.lesson().fields) {
        if (!f.in_use() || f.size() == 0) continue;
        INFO(f.name);
        const Answer a = why(r, f.name, 0, 0);
        CHECK(std::ranges::none_of(a.inputs, &Answer::together));
    }
}
