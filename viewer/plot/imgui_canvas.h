// Draws into one of ImGui's draw lists with the current font.
#pragma once
#include "plot/canvas.h"

struct ImDrawList;

namespace pliant::viewer {

class ImguiCanvas final : public Canvas {
public:
    explicit ImguiCanvas(ImDrawList& list) : list_(list) {}

    void fill(Box box, Rgba8 colour) override;
    void line(std::span<const Point> points, Rgba8 colour, float width) override;
    void polygon(std::span<const Point> corners, Rgba8 colour) override;
    void text(Point top_left, Rgba8 colour, std::string_view words) override;
    Point text_size(std::string_view words) const override;
    void push_clip(Box box) override;
    void pop_clip() override;

private:
    ImDrawList& list_;
};

}  // namespace pliant::viewer
