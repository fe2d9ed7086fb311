// Numbers that are typed: the whole text goes to a reader of ours, so that nothing of it is cut off or clamped on the way.
#pragma once
#include <imgui.h>
#include <pliant/math/types.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace pliant::viewer {

// The text that is being typed, and in which control: at most one at a time.
struct TypedNumber {
    ImGuiID control = 0;
    std::array<char, 512> text{};
};

// Draws the slider with this label, which must not take text itself, or in its place a field of text: Ctrl and a click, or Enter
// on the slider, begin with what it holds now. Gives the text once it has been entered, by Enter or by going elsewhere; Escape
// takes it back.
std::optional<std::string> slider_or_text(TypedNumber& typed, const char* label, const std::string& now,
                                          const std::function<void()>& draw_slider);

// A field of text alone, with the same rules.
std::optional<std::string> number_field(TypedNumber& typed, const char* label, const std::string& now);

// Words, in a line as wide as there is room, with the same rules; the hint shows while it is empty.
std::optional<std::string> words_field(TypedNumber& typed, const char* label, const char* hint, const std::string& now);

// A number that was typed for what is called `name`, within these ends. Throw Refused, in words.
Index whole_typed(std::string_view name, std::string_view text, Index least, Index most);
Real number_typed(std::string_view name, std::string_view text, Real least, Real most);

}  // namespace pliant::viewer
