// What a slide of a walkthrough locks, and what goes with it.
#include <pliant/document/hand_in.h>
#include <pliant/document/summary.h>

#include "parameters.h"
#include "session/session.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <string_view>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;
using Catch::Matchers::ContainsSubstring;

namespace {

// The first slide of this lesson allows youngs_modulus and load.
Session at_first_slide() {
    Session session("elasticity/moduli");
    session.start_walkthrough();
    REQUIRE(session.walkthrough);
    return session;
}

}  // namespace

TEST_CASE("a locked parameter is refused with the way out, and the one beside it is not", "[session][walkthrough]") {
    Session s = at_first_slide();
    CHECK(s.locked(parameter(s, "poisson_ratio")));
    s.assign(parameter(s, "poisson_ratio"), 0.1);
    CHECK(wanted(s, "poisson_ratio") == 0.3);
    REQUIRE(s.message());
    CHECK(s.message()->kind == Session::Message::Kind::refused);
    CHECK_THAT(s.message()->text, ContainsSubstring("Poisson's ratio is locked") && ContainsSubstring("press L"));
    s.dismiss();
    s.restore_default(parameter(s, "poisson_ratio"));
    CHECK_FALSE(s.message());
    CHECK_FALSE(s.can_undo());

    CHECK_FALSE(s.locked(parameter(s, "load")));
    s.assign(parameter(s, "load"), 1e4);
    CHECK(wanted(s, "load") == 1e4);
    CHECK_FALSE(s.message());
}

TEST_CASE("the lock is taken off and put back, and ends with the walkthrough", "[session][walkthrough]") {
    Session s = at_first_slide();
    s.toggle_lock();
    s.assign(parameter(s, "poisson_ratio"), 0.1);
    CHECK(wanted(s, "poisson_ratio") == 0.1);
    s.toggle_lock();
    s.assign(parameter(s, "poisson_ratio"), 0.2);
    CHECK(wanted(s, "poisson_ratio") == 0.1);
    s.end_walkthrough();
    CHECK_FALSE(s.walkthrough);
    s.assign(parameter(s, "poisson_ratio"), 0.2);
    CHECK(wanted(s, "poisson_ratio") == 0.2);
    s.toggle_lock();
    CHECK_FALSE(s.unlocked);
}

TEST_CASE("a slide that is reset forgets what was changed on it, with its undo", "[session][walkthrough]") {
    Session s = at_first_slide();
    s.go_to_slide(1);
    CHECK(s.walkthrough->slide_number() == 1);
    const auto hash = state_hash(s.lesson());
    const auto steps = s.recorder().series(0).steps();
    const Real width = wanted(s, "width");
    s.assign(parameter(s, "width"), 0.15);
    s.step();
    REQUIRE(s.can_undo());
    REQUIRE(state_hash(s.lesson()) != hash);
    s.reset_slide();
    CHECK(state_hash(s.lesson()) == hash);
    CHECK(s.recorder().series(0).steps() == steps);
    CHECK(wanted(s, "width") == width);
    CHECK_FALSE(s.can_undo());
    CHECK_FALSE(s.walkthrough->revealed());
    s.undo();
    CHECK(wanted(s, "width") == width);
}

TEST_CASE("a slide shows the colours of those before it", "[session][walkthrough]") {
    Session s = at_first_slide();
    s.go_to_slide(3);
    CHECK(s.colours.field == "strain");
    s.go_to_slide(0);
    CHECK(s.colours.field == s.lesson().first_colours().field);
    s.walkthrough_back();
    CHECK(s.walkthrough->slide_number() == 0);
    s.go_to_slide(99);
    REQUIRE(s.message());
    CHECK_THAT(s.message()->text, ContainsSubstring("slide 100"));
    CHECK(s.walkthrough->slide_number() == 0);
}

TEST_CASE("an extension opens its scene with a question, and answers when asked", "[session][walkthrough]") {
    Session s("elasticity/moduli");
    REQUIRE(s.extensions().size() > 1);
    for (std::size_t n = 0; n < s.extensions().size(); ++n) {
        const Extension& extension = s.extensions()[n];
        s.open_extension(n);
        INFO(extension.slide().title);
        REQUIRE(s.extension() == n);
        CHECK(s.walkthrough->slide().title == extension.slide().title);
        CHECK_FALSE(s.walkthrough->revealed());
        for (const auto& [key, value] : extension.scene.parameters)
            CHECK(s.lesson().parameter(key).text(wanted(s, key)) ==
                  s.lesson().parameter(key).text(s.lesson().parameter(key).parse(value)));
        s.walkthrough_next();
        CHECK(s.walkthrough->revealed());
        CHECK_FALSE(s.walkthrough->results().empty());
        for (const ExpectationResult& r : s.walkthrough->results()) {
            INFO(r.measured);
            CHECK(r.met);
        }
        // Back to its question, in its scene.
        s.walkthrough_back();
        CHECK(s.extension() == n);
        CHECK_FALSE(s.walkthrough->revealed());
    }
    s.start_walkthrough();
    CHECK_FALSE(s.extension());
    s.open_extension(0);
    s.end_walkthrough();
    CHECK_FALSE(s.extension());
    s.open_next(1);
    for (const Extension& e : s.extensions()) CHECK(e.scene.lesson == s.entry().info.id);
}

TEST_CASE("what is predicted after the answer was seen is handed in as such, in a walkthrough begun anew as well",
          "[session][walkthrough]") {
    Session s("mesh/mass_spring");
    s.start_walkthrough();
    const auto go_to = [&](std::string_view title) {
        const auto& slides = s.walkthrough->walkthrough().slides;
        s.go_to_slide(static_cast<std::size_t>(std::ranges::find(slides, title, &Slide::title) - slides.begin()));
        REQUIRE(s.walkthrough->slide().title == title);
    };
    go_to("Implicit Euler");
    s.walkthrough_next();  // skipped
    s.walkthrough_back();
    s.predict({.option = 2u});
    CHECK(s.walkthrough->guess().after_answer);
    s.walkthrough_next();
    REQUIRE(s.walkthrough->verdict());
    CHECK_THAT(s.walkthrough->verdict()->words, ContainsSubstring("after the answer"));
    const HandIn& kept = s.notebook.hand_in();
    REQUIRE(kept.entries.size() == 1);
    CHECK(kept.entries[0].after_answer);
    const HandInRead read = read_hand_in(hand_in_text(kept), "h.json");
    CHECK(read.hand_in == kept);
    const auto findings = check_hand_in(read.hand_in);
    CHECK_THAT(hand_in_report(read, findings),
               ContainsSubstring("1 prediction was made after the answer was seen") && !ContainsSubstring("was right"));
    CHECK_THAT(hand_in_report_json(read, findings), ContainsSubstring("\"after_answer\": true"));
    s.end_walkthrough();
    s.start_walkthrough();
    go_to("Implicit Euler");
    s.predict({.option = 2u});
    CHECK(s.walkthrough->guess().after_answer);
    const auto scene = parse_scene(scene_text(s.scene_file()), "s.json");
    REQUIRE(scene.slide);
    CHECK(scene.slide->predicted.after_answer);
    // Of a slide that was only played on the way, nothing has been seen.
    go_to("Semi-implicit Euler");
    s.predict({.option = 0u});
    CHECK_FALSE(s.walkthrough->guess().after_answer);
}

TEST_CASE("beside a question the summary tells neither its numbers nor what holds", "[session][walkthrough]") {
    Session s("mesh/mass_spring");
    s.start_walkthrough();
    const auto hidden = [&](std::string_view name) { return s.hides(name); };
    CHECK(s.hides("lights"));
    const std::string covered = summary_text(s.runner(), hidden);
    CHECK_THAT(covered, !ContainsSubstring("assumption") && !ContainsSubstring("should stay constant"));
    CHECK_THAT(covered, !ContainsSubstring("height is"));
    s.walkthrough_next();
    CHECK_FALSE(s.hides("lights"));
    CHECK_THAT(summary_text(s.runner(), hidden), ContainsSubstring("assumption"));
}
