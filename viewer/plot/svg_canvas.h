// Writes a plot as SVG: for slides and papers.
#pragma once
#include <string>
#include <vector>

#include "plot/canvas.h"

namespace pliant::viewer {

class SvgCanvas final : public Canvas {
public:
    // The picture is what lies in `view`. Words are measured, and so laid out, as on `measure`, which must outlive this.
    SvgCanvas(Box view, const Canvas& measure);

    void fill(Box box, Rgba8 colour) override;
    void line(std::span<const Point> points, Rgba8 colour, float width) override;
    void polygon(std::span<const Point> corners, Rgba8 colour) override;
    void text(Point top_left, Rgba8 colour, std::string_view words) override;
    Point text_size(std::string_view words) const override { return measure_.text_size(words); }
    void push_clip(Box box) override;
    void pop_clip() override;

    // The whole document. Call once every clip is popped.
    std::string document() const;

private:
    Box view_;
    const Canvas& measure_;
    std::string body_;
    int clips_ = 0;
};

}  // namespace pliant::viewer
