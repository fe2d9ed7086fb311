#include "plot/imgui_canvas.h"

#include "platform/index_letters.h"
#include "typeset/math_type.h"

#include <imgui.h>

#include <cmath>

namespace pliant::viewer {
namespace {

ImVec2 im(Point p) { return {p.x, p.y}; }
ImU32 im(Rgba8 c) { return IM_COL32(c.r, c.g, c.b, c.a); }

// A line may not be mitred where it turns by more than a right angle: its corner would stick out.
bool sharp(Point a, Point b, Point c) { return (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) < 0; }

// Of words that have symbols in them, in the height of a line; null for others.
const MathBox* formula_of(std::string_view words, const MathType* mathematics) {
    if (!mathematics) return nullptr;
    const MathBox& set = mathematics->label_with_symbols(words, ImGui::GetFontSize());
    return set.letters.empty() ? nullptr : &set;
}

bool same(Point a, Point b) { return std::abs(a.x - b.x) < 0.01f && std::abs(a.y - b.y) < 0.01f; }

}  // namespace

void ImguiCanvas::fill(Box box, Rgba8 colour) { list_.AddRectFilled(im(box.min), im(box.max), im(colour)); }

void ImguiCanvas::line(std::span<const Point> points, Rgba8 colour, float width) {
    // The longest stretch that ImGui may take at once: its vertices are counted with 16 bits.
    constexpr int longest = 2048;
    const auto stroke = [&] {
        if (list_._Path.Size > 1)
            list_.PathStroke(im(colour), 0, width);
        else
            list_.PathClear();
    };
    Point before{}, last{};
    for (const Point point : points) {
        const int size = list_._Path.Size;
        if (size > 0 && same(last, point)) continue;
        if (size >= longest || (size > 1 && sharp(before, last, point))) {
            stroke();
            list_.PathLineTo(im(last));
        }
        list_.PathLineTo(im(point));
        before = last;
        last = point;
    }
    stroke();
}

void ImguiCanvas::polygon(std::span<const Point> corners, Rgba8 colour) {
    // ImGui smooths the edges of polygons whose corners go clockwise on the screen.
    float area = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point a = corners[i], b = corners[(i + 1) % corners.size()];
        area += a.x * b.y - a.y * b.x;
    }
    for (std::size_t i = 0; i < corners.size(); ++i) list_.PathLineTo(im(corners[area >= 0 ? i : corners.size() - 1 - i]));
    list_.PathFillConvex(im(colour));
}

void ImguiCanvas::text(Point top_left, Rgba8 colour, std::string_view words) {
    const MathBox* const formula = formula_of(words, mathematics_);
    if (!formula) return list_.AddText(im(top_left), im(colour), with_index_letters(words).c_str());
    mathematics_->draw(list_, *formula, {top_left.x, top_left.y + ImGui::GetFont()->Ascent}, im(colour));
}

Point ImguiCanvas::text_size(std::string_view words) const {
    if (const MathBox* const formula = formula_of(words, mathematics_)) return {formula->width, ImGui::GetFontSize()};
    const ImVec2 size = ImGui::CalcTextSize(with_index_letters(words).c_str());
    return {size.x, size.y};
}

void ImguiCanvas::push_clip(Box box) { list_.PushClipRect(im(box.min), im(box.max), true); }
void ImguiCanvas::pop_clip() { list_.PopClipRect(); }

}  // namespace pliant::viewer
