#include "app/presenter_window.h"

#include <imgui.h>

#include "platform/gl.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

namespace pliant::viewer {
namespace {

constexpr int frames_after_input = 4;
constexpr Real seconds_of_frame = 1.0 / 60;

std::string time_of_day() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    char text[16];
    return localtime_r(&now, &local) && std::strftime(text, sizeof text, "%H:%M", &local) > 0 ? text : "";
}

}  // namespace

class PresenterWindow::Current {
public:
    explicit Current(PresenterWindow& window) : window_(window), gui_(ImGui::GetCurrentContext()) {
        if (window_.context_) window_.context_->make_current();
    }
    ~Current() {
        window_.audience_.make_current();
        ImGui::SetCurrentContext(gui_);
    }
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

private:
    PresenterWindow& window_;
    ImGuiContext* gui_;
};

PresenterWindow::PresenterWindow(Context& audience, Real now) : audience_(audience), clock_start_(now) {
    const Current current(*this);
    context_ = open_context(Backend::window, {1100, 720}, title);
    context_->stand_beside(audience);
    gui_ = std::make_unique<Gui>(*context_);
    // Every key is for the deck, whatever was clicked here.
    ImGui::GetIO().ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    scale_ = std::clamp(context_->ui_scale(), 1.f, 3.f);
    fonts_ = load_fonts(scale_);
}

PresenterWindow::~PresenterWindow() {
    const Current current(*this);
    renderer_.reset();
    gui_.reset();
    context_.reset();
}

Real PresenterWindow::wait(Real now, const PresenterView& view, const std::string& busy, const SlidePreview& next) {
    const bool damaged = context_->take_damage();
    if (damaged || gui_->has_input() || view != shown_ || busy != busy_shown_ || next.picture != next_shown_)
        unsettled_ = frames_after_input;
    const Real next_second = clock_paused() ? drawn_ + 1 : clock_start_ + std::floor(drawn_ - clock_start_) + 1;
    return std::max(Real{0}, (unsettled_ > 0 ? drawn_ + seconds_of_frame : next_second) - now);
}

void PresenterWindow::obey(const PresenterWishes& wishes, Real now) {
    if (wishes.restart_clock) {
        clock_start_ = now;
        if (clock_stopped_) clock_stopped_ = now;
    }
    if (!wishes.pause_clock) return;
    if (clock_stopped_)
        clock_start_ += now - *std::exchange(clock_stopped_, std::nullopt);
    else
        clock_stopped_ = now;
}

void PresenterWindow::frame(Real now, Theme theme, const PresenterView& view, const std::string& busy, const SlidePreview& next) {
    const Current current(*this);
    gui_->begin_frame(seconds_of_frame);
    if (std::exchange(theme_, theme) != theme) apply_theme(theme, scale_);
    shown_ = view, busy_shown_ = busy, next_shown_ = next.picture, drawn_ = now;
    if (next.picture && !renderer_) renderer_ = std::make_unique<SceneRenderer>();
    unsettled_ = std::max(0, unsettled_ - 1);
    handle_keys({.walkthrough = view.count > 0,
                 .deck = view.in_deck,
                 .slide = false,
                 .message = !view.message.empty(),
                 .filled = view.filled},
                [this](Action a) { actions_.push_back(a); });
    ImGui::PushFont(fonts_.normal);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    controls_.clear();
    {
        const FixedPanel panel("Presenter", {0, 0, display.x, display.y}, ImGuiWindowFlags_NoScrollbar);
        const PresenterPage page{fonts_, theme, scale_, controls_, &next, renderer_.get()};
        obey(draw_presenter(page, view, {time_of_day(), elapsed(now), clock_paused()}, busy), now);
    }
    ImGui::PopFont();
    const Size size = context_->framebuffer_size();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.width, size.height);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    gui_->end_frame();
    context_->present();
    ++frames_;
}

std::vector<Action> PresenterWindow::take_actions() { return std::exchange(actions_, {}); }

}  // namespace pliant::viewer
