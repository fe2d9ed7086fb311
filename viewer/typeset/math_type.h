// The faces in which formulas are set, and their letters on the screen.
#pragma once
#include "typeset/math_box.h"

#include <array>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

struct ImDrawList;
struct ImFont;
struct ImVec2;

namespace pliant::viewer {

class MathType final : public MathMetrics {
public:
    MathType();
    // The mathematical face and that of the words, each at some heights; any size is drawn from the nearest.
    MathType(std::vector<ImFont*> signs, std::vector<ImFont*> words);

    LetterBounds bounds(char32_t letter, MathFace face, float size) const override;
    // What was set before in the same size and room is kept, so that a frame costs no more than to draw it. A box stays until a
    // few hundred others have been asked for.
    const MathBox& formula(std::string_view text, float size, float width = 0, Numbers numbers = Numbers::plain) const;
    // Of a text that may have quantities in it, "k = 200 N/m", with its fractions in the line.
    const MathBox& label(std::string_view text, float size, float width = 0) const;
    // The same without letters where the text has no symbols, so that the face of the words serves it better.
    const MathBox& label_with_symbols(std::string_view text, float size) const;
    const MathBox& sentence(std::string_view text, float size, float width = 0) const;
    // As fitted_formula.
    const MathBox& fitted(std::string_view text, float largest, float smallest, float width, float height) const;

    // at: the left end of the first line's baseline, px.
    void draw(ImDrawList& list, const MathBox& box, const ImVec2& at, unsigned colour) const;

private:
    struct Sized {
        const ImFont* font;
        float scale;  // of its letters
    };
    struct Kept;
    Sized sized(MathFace face, float size) const;
    const MathBox& kept(char kind, std::string_view text, std::array<float, 4> room, const std::function<MathBox()>& set) const;
    std::vector<ImFont*> signs_{}, words_{};  // by height, the lowest first
    std::shared_ptr<Kept> kept_;
};

// As an item of ImGui at its cursor.
void draw_item(const MathType& type, const MathBox& box, unsigned colour);
// A formula no wider than `width`, in the colour of ImGui's text; size: height of a line of type, px.
void formula_item(const MathType& type, std::string_view text, float size, float width, Numbers numbers = Numbers::plain);

}  // namespace pliant::viewer
