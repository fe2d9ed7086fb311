#include "typeset/math_type.h"

#include <imgui.h>

#include "typeset/sentence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace pliant::viewer {
namespace {

void sort_by_height(std::vector<ImFont*>& fonts) {
    std::ranges::sort(fonts, {}, [](const ImFont* f) { return f->FontSize; });
}

const ImFontGlyph* glyph_of(const ImFont& font, char32_t letter) {
    return const_cast<ImFont&>(font).FindGlyph(static_cast<ImWchar>(letter));
}

}  // namespace

// Boxes by what they were made of: those of lately, and those before that are about to go.
struct MathType::Kept {
    using Key = std::tuple<char, std::array<float, 4>, std::string>;
    static constexpr std::size_t most = 600;
    std::map<Key, MathBox> lately, before;
};

MathType::MathType() : kept_(std::make_shared<Kept>()) {}

MathType::MathType(std::vector<ImFont*> signs, std::vector<ImFont*> words)
    : signs_(std::move(signs)), words_(std::move(words)), kept_(std::make_shared<Kept>()) {
    sort_by_height(signs_), sort_by_height(words_);
}

// The lowest that need not be enlarged by more than a tenth.
MathType::Sized MathType::sized(MathFace face, float size) const {
    const auto& fonts = face == MathFace::words ? words_ : signs_;
    const auto found = std::ranges::find_if(fonts, [&](const ImFont* f) { return 1.1f * f->FontSize >= size; });
    const ImFont* font = found == fonts.end() ? fonts.back() : *found;
    return {font, size / font->FontSize};
}

LetterBounds MathType::bounds(char32_t letter, MathFace face, float size) const {
    const auto [font, scale] = sized(face, size);
    const ImFontGlyph* g = glyph_of(*font, letter);
    if (!g) return {};
    return {g->AdvanceX * scale, g->X0 * scale, (g->Y0 - font->Ascent) * scale, g->X1 * scale, (g->Y1 - font->Ascent) * scale};
}

const MathBox& MathType::kept(char kind, std::string_view text, std::array<float, 4> room,
                              const std::function<MathBox()>& set) const {
    Kept::Key key{kind, room, std::string(text)};
    if (const auto found = kept_->lately.find(key); found != kept_->lately.end()) return found->second;
    if (kept_->lately.size() >= Kept::most) kept_->before = std::exchange(kept_->lately, {});
    if (auto old = kept_->before.extract(key)) return kept_->lately.insert(std::move(old)).position->second;
    return kept_->lately.emplace(std::move(key), set()).first->second;
}

const MathBox& MathType::formula(std::string_view text, float size, float width, Numbers numbers) const {
    return kept(numbers == Numbers::plain ? 'f' : 'n', text, {size, width},
                [&] { return set_formula(notation(text, numbers), *this, size, width); });
}

const MathBox& MathType::label(std::string_view text, float size, float width) const {
    return kept('l', text, {size, width},
                [&] { return set_formula(notation(text, Numbers::with_units), *this, size, width, Fractions::in_line); });
}

const MathBox& MathType::label_with_symbols(std::string_view text, float size) const {
    return kept('p', text, {size}, [&] {
        const Notation set = notation(text, Numbers::with_units);
        return is_prose(set) ? MathBox{} : set_formula(set, *this, size, 0, Fractions::in_line);
    });
}

const MathBox& MathType::sentence(std::string_view text, float size, float width) const {
    return kept('s', text, {size, width}, [&] { return set_sentence(text, *this, size, width); });
}

const MathBox& MathType::fitted(std::string_view text, float largest, float smallest, float width, float height) const {
    return kept('t', text, {largest, smallest, width, height},
                [&] { return fitted_formula(notation(text), *this, largest, smallest, width, height); });
}

void MathType::draw(ImDrawList& list, const MathBox& box, const ImVec2& at, unsigned colour) const {
    for (const PlacedLetter& l : box.letters) {
        const auto [font, scale] = sized(l.face, l.size);
        const ImFontGlyph* g = glyph_of(*font, l.letter);
        if (!g || !g->Visible) continue;
        // Drawn at its own height it stands on whole pixels, where it is sharp.
        const bool sharp = scale == 1 && l.stretch == 1;
        const float x = sharp ? std::round(at.x + l.x) : at.x + l.x, base = sharp ? std::round(at.y + l.y) : at.y + l.y;
        const float top = base + (g->Y0 - font->Ascent) * scale, bottom = base + (g->Y1 - font->Ascent) * scale;
        const float middle = (top + bottom) / 2, half = (bottom - top) / 2 * l.stretch;
        list.PrimReserve(6, 4);
        list.PrimRectUV({x + g->X0 * scale, middle - half}, {x + g->X1 * scale, middle + half}, {g->U0, g->V0}, {g->U1, g->V1},
                        colour);
    }
    for (const PlacedRule& r : box.rules)
        list.AddRectFilled({at.x + r.x0, std::round(at.y + r.y0)}, {at.x + r.x1, std::round(at.y + r.y0) + r.y1 - r.y0}, colour);
}

void draw_item(const MathType& type, const MathBox& box, unsigned colour) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    type.draw(*ImGui::GetWindowDrawList(), box, {at.x, at.y + box.above}, colour);
    ImGui::Dummy({box.width, box.height()});
}

void formula_item(const MathType& type, std::string_view text, float size, float width, Numbers numbers) {
    draw_item(type, type.formula(text, size, width, numbers), ImGui::GetColorU32(ImGuiCol_Text));
}

}  // namespace pliant::viewer
