// The window of the lecturer, beside that of the lab: its page, its clock, and its keys, which act on the deck.
#pragma once
#include "panels/presenter_panel.h"
#include "platform/context.h"
#include "platform/gui.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pliant::viewer {

class PresenterWindow {
public:
    static constexpr const char* title = "Lecturer";

    // On another screen than the audience's, where there is one. The context of the audience is current again behind it. now: s.
    // Throws MachineLacks.
    PresenterWindow(Context& audience, Real now);
    ~PresenterWindow();
    PresenterWindow(const PresenterWindow&) = delete;
    PresenterWindow& operator=(const PresenterWindow&) = delete;

    bool close_requested() const { return context_->close_requested(); }
    // s until it has something new to show: the view, the picture of the next slide, an input, or another second of the clock.
    Real wait(Real now, const PresenterView& view, const std::string& busy, const SlidePreview& next);
    // Draws the page. The context and the GUI that were current are so again behind it.
    void frame(Real now, Theme theme, const PresenterView& view, const std::string& busy, const SlidePreview& next);
    // What keys have asked of the lab since the last call.
    std::vector<Action> take_actions();

    bool clock_paused() const { return clock_stopped_.has_value(); }
    long frames() const { return frames_; }
    const std::map<std::string, Rectangle>& controls() const { return controls_; }

private:
    class Current;  // makes it current, and what was before when it ends
    Real elapsed(Real now) const { return clock_stopped_.value_or(now) - clock_start_; }
    void obey(const PresenterWishes& wishes, Real now);

    Context& audience_;
    std::unique_ptr<Context> context_;
    std::unique_ptr<Gui> gui_;
    Fonts fonts_;
    float scale_ = 1;
    std::optional<Theme> theme_;
    Real clock_start_ = 0;
    std::optional<Real> clock_stopped_;
    std::unique_ptr<SceneRenderer> renderer_;  // of the next slide
    PresenterView shown_;
    KeptPicture next_shown_;
    std::string busy_shown_;
    Real drawn_ = -1;
    int unsettled_ = 4;  // frames until all that was asked for shows
    long frames_ = 0;
    std::vector<Action> actions_;
    std::map<std::string, Rectangle> controls_;
};

}  // namespace pliant::viewer
