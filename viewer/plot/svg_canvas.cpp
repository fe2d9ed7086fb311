#include "plot/svg_canvas.h"

#include <pliant/formula/notation.h>
#include <pliant/formula/unicode.h>

#include <fmt/format.h>

#include <utility>

namespace pliant::viewer {
namespace {

std::string escaped(std::string_view words) {
    std::string text;
    for (const char c : words) {
        if (c == '&')
            text += "&amp;";
        else if (c == '<')
            text += "&lt;";
        else if (c == '>')
            text += "&gt;";
        else if (static_cast<unsigned char>(c) >= 0x20)
            text += c;
    }
    return text;
}

// Symbols slanted, indices and exponents small and off the line; whatever the typeface is.
class SvgWords {
public:
    explicit SvgWords(float size) : size_(size) {}

    std::string of(const Notation& row) {
        put(row, 0, size_);
        return std::move(text_);
    }

private:
    using Kind = Notation::Kind;

    // A blank before what the formula sets apart.
    static bool apart(const Notation& n) {
        return n.spaced || n.kind == Kind::relation || n.kind == Kind::gap ||
               (n.kind == Kind::sign && n.text != "·" && n.text != "/");
    }
    void leaf(std::string_view text, float raise, float size, bool slanted) {
        std::string attributes;
        if (raise != raise_) attributes += fmt::format(" dy=\"{:.2f}\"", raise_ - raise);
        if (size != size_) attributes += fmt::format(" font-size=\"{:.3g}\"", size);
        if (slanted) attributes += " font-style=\"italic\"";
        raise_ = raise;
        text_ += attributes.empty() ? escaped(text) : fmt::format("<tspan{}>{}</tspan>", attributes, escaped(text));
    }
    void put(const Notation& n, float raise, float size) {
        switch (n.kind) {
            case Kind::row:
            case Kind::grid:
                for (std::size_t k = 0; k < n.of.size(); ++k) {
                    if (k > 0 && (apart(n.of[k]) || n.of[k - 1].kind == Kind::relation)) leaf(" ", raise, size, false);
                    put(n.of[k], raise, size);
                }
                break;
            case Kind::scripts:
                put(n.of[0], raise, size);
                put(n.of[1], raise - 0.2f * size, 0.72f * size);
                put(n.of[2], raise + 0.35f * size, 0.72f * size);
                break;
            case Kind::fraction:
                leaf(n.text, raise, size, false);
                break;
            case Kind::root:
                leaf("√", raise, size, false), put(n.of[0], raise, size);
                break;
            case Kind::accent:
                put(n.of[0], raise, size), leaf(combining(n.text), raise, size, false);
                break;
            case Kind::fence: {
                const std::size_t open = code_point(n.text, 0).bytes;
                leaf(n.text.substr(0, open), raise, size, false);
                put(n.of[0], raise, size);
                leaf(n.text.substr(open), raise, size, false);
                break;
            }
            default:
                leaf(n.text, raise, size, n.kind == Kind::variable);
        }
    }
    static std::string_view combining(std::string_view accent) {
        return accent == "~"   ? "\u0303"
               : accent == "^" ? "\u0302"
               : accent == "¯" ? "\u0304"
               : accent == "˙" ? "\u0307"
                               : "\u0308";
    }

    float size_, raise_ = 0;
    std::string text_;
};

// fill="#rrggbb" or stroke="#rrggbb", with an opacity where it is not full.
std::string paint(const char* what, Rgba8 colour) {
    std::string text = fmt::format("{}=\"#{:02x}{:02x}{:02x}\"", what, colour.r, colour.g, colour.b);
    if (colour.a < 255) text += fmt::format(" {}-opacity=\"{:.3g}\"", what, colour.a / 255.0);
    return text;
}

std::string list_of(std::span<const Point> points) {
    std::string text;
    for (const Point p : points) text += fmt::format("{}{:.2f},{:.2f}", text.empty() ? "" : " ", p.x, p.y);
    return text;
}

std::string rectangle(Box box) {
    return fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"", box.min.x, box.min.y, box.width(),
                       box.height());
}

}  // namespace

SvgCanvas::SvgCanvas(Box view, const Canvas& measure) : view_(view), measure_(measure) {}

void SvgCanvas::fill(Box box, Rgba8 colour) { body_ += rectangle(box) + " " + paint("fill", colour) + "/>\n"; }

void SvgCanvas::line(std::span<const Point> points, Rgba8 colour, float width) {
    body_ += fmt::format("<polyline points=\"{}\" fill=\"none\" {} stroke-width=\"{:.3g}\" stroke-linejoin=\"round\"/>\n",
                         list_of(points), paint("stroke", colour), width);
}

void SvgCanvas::polygon(std::span<const Point> corners, Rgba8 colour) {
    body_ += fmt::format("<polygon points=\"{}\" {}/>\n", list_of(corners), paint("fill", colour));
}

void SvgCanvas::text(Point top_left, Rgba8 colour, std::string_view words) {
    const Point size = text_size(words);
    // The base line of DejaVu Sans lies at about four fifths of the height of a line. textLength keeps the layout in another
    // typeface.
    body_ += fmt::format(
        "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.3g}\" textLength=\"{:.2f}\" lengthAdjust=\"spacingAndGlyphs\" "
        "{}>{}</text>\n",
        top_left.x, top_left.y + 0.8f * size.y, 0.86f * size.y, size.x, paint("fill", colour),
        SvgWords(0.86f * size.y).of(in_line(notation(words, Numbers::with_units))));
}

void SvgCanvas::push_clip(Box box) {
    body_ +=
        fmt::format("<clipPath id=\"clip{}\">{}/></clipPath>\n<g clip-path=\"url(#clip{})\">\n", clips_, rectangle(box), clips_);
    ++clips_;
}

void SvgCanvas::pop_clip() { body_ += "</g>\n"; }

std::string SvgCanvas::document() const {
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"{2:.0f} {3:.0f} {0:.0f} "
               "{1:.0f}\" "
               "font-family=\"DejaVu Sans, Verdana, sans-serif\">\n",
               view_.width(), view_.height(), view_.min.x, view_.min.y) +
           body_ + "</svg>\n";
}

}  // namespace pliant::viewer
