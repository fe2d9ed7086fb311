// The words of every slide are seen whole, on a small screen with large type.
#include "../every_lesson.h"
#include "command_line/pictures.h"
#include "hand.h"

#include <pliant/document/walkthrough.h>
#include <pliant/text/texts.h>

#include <imgui_internal.h>

#include <catch2/catch_test_macros.hpp>

#include <string_view>

using namespace pliant;
using namespace pliant::test;
using namespace pliant::viewer;

namespace {

// How much of the words lies outside of their part of the slide, px.
float hidden_words() {
    float hidden = -1;
    for (const ImGuiWindow* w : ImGui::GetCurrentContext()->Windows)
        if (w->Active && std::string_view(w->Name).starts_with("Slide words/words")) hidden = w->ScrollMax.y;
    return hidden;
}

}  // namespace

TEST_CASE("no slide hides its words at 1280 x 720 px and scale 1.5", "[deck][every_lesson]") {
    for (const LessonEntry& entry : every_lesson()) {
        if (find_text(std::string(entry.info.id) + "/walkthrough.md").empty()) continue;
        Hand hand(entry.info.id);
        hand.lab.set_scale(1.5f);
        hand.lab.state().layout = Layout::deck;
        const std::size_t count = walkthrough_of(entry).slides.size();
        for (std::size_t n = 0; n < count; ++n)
            for (const bool revealed : {false, true}) {
                show_slide(hand.lab.session(), n, revealed);
                hand.frames(2);
                CAPTURE(entry.info.id, n + 1, revealed);
                CHECK(hidden_words() == 0);
            }
    }
}
