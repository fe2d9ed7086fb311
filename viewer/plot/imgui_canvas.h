// Draws into one of ImGui's draw lists with the current font.
#pragma once
#include "plot/canvas.h"

struct ImDrawList;

namespace pliant::viewer {

class MathType;

class ImguiCanvas final : public Canvas {
public:
    // mathematics: for words that have symbols; without it these are in the face of the words.
    explicit ImguiCanvas(ImDrawList& list, const MathType* mathematics = nullptr) : list_(list), mathematics_(mathematics) {}

    void fill(Box box, Rgba8 colour) override;
    void line(std::span<const Point> points, Rgba8 colour, float width) override;
    void polygon(std::span<const Point> corners, Rgba8 colour) override;
    void text(Point top_left, Rgba8 colour, std::string_view words) override;
    Point text_size(std::string_view words) const override;
    void push_clip(Box box) override;
    void pop_clip() override;

private:
    ImDrawList& list_;
    const MathType* mathematics_;
};

}  // namespace pliant::viewer
