// The faces in which formulas are set, and their letters on the screen.
#pragma once
#include "typeset/math_box.h"

#include <string_view>
#include <vector>

struct ImDrawList;
struct ImFont;
struct ImVec2;

namespace pliant::viewer {

class MathType final : public MathMetrics {
public:
    MathType() = default;
    // The mathematical face and that of the words, each at some heights; any size is drawn from the nearest.
    MathType(std::vector<ImFont*> signs, std::vector<ImFont*> words);

    LetterBounds bounds(char32_t letter, MathFace face, float size) const override;
    // at: the left end of the first line's baseline, px.
    void draw(ImDrawList& list, const MathBox& box, const ImVec2& at, unsigned colour) const;

private:
    struct Sized {
        const ImFont* font;
        float scale;  // of its letters
    };
    Sized sized(MathFace face, float size) const;
    std::vector<ImFont*> signs_{}, words_{};  // by height, the lowest first
};

// As an item of ImGui at its cursor.
void draw_item(const MathType& type, const MathBox& box, unsigned colour);
// A formula no wider than `width`, in the colour of ImGui's text; size: height of a line of type, px.
void formula_item(const MathType& type, std::string_view text, float size, float width, Numbers numbers = Numbers::plain);

}  // namespace pliant::viewer
