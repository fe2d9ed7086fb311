// What the lab shows at once.
#pragma once
#include <string>
#include <string_view>

namespace pliant::viewer {

// lab: all panels. slide: the picture, its plots and the numbers that matter, large. deck: a slide of the walkthrough beside
// them. presenter: the page of the lecturer, in place of what the audience sees; the window has it in a window of its own.
enum class Layout { lab, slide, deck, presenter };
std::string_view name_of(Layout layout);

// One panel in the place of the whole layout, which comes back as it was.
enum class Filled { none, picture, plot, matrix, atlas };

struct Fill {
    Filled what = Filled::none;
    std::string plot{};  // its name in PlotPanelState::chosen, or "cost" for cost and error
    explicit operator bool() const { return what != Filled::none; }
    bool operator==(const Fill&) const = default;
};

// "picture", "plot energy", "matrix", "atlas"; "" for none.
std::string text_of(const Fill& fill);
// Throws Refused, with what is accepted. Whether the lesson has the plot is not looked at.
Fill fill_from(std::string_view text);

}  // namespace pliant::viewer
