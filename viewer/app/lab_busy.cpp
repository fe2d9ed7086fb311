// The lab while its worker has the run: the last picture stays, with a card that tells how far the work is and calls it off.
#include <pliant/text/spoken.h>

#include "app/lab.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant::viewer {
namespace {

bool contains(const Rectangle& r, const ImVec2& p) {
    return p.x >= r.x && p.x < r.x + r.width && p.y >= r.y && p.y < r.y + r.height;
}

}  // namespace

BusyWords busy_words(const Watch::Progress& p, Real seconds) {
    BusyWords text{.title = p.what.empty() ? "Computing" : words(p.what), .line = duration_words(seconds) + " so far"};
    if (p.total > 0)
        text.title += fmt::format(", {:.0f} %", 100 * *p.share());
    else if (p.done > 0)
        text.title += fmt::format(", pass {}", p.done + 1);
    if (const auto left = p.seconds_left()) text.line += fmt::format(", about {} left", duration_words(*left));
    return text;
}

void Lab::keep_pace(const Pace& pace) {
    pace_ = pace;
    state_.session.sliced = true;
}

void Lab::work_beside(const Pace& pace) {
    keep_pace(pace);
    worker_ = std::make_unique<Worker>();
}

void Lab::call_off() {
    if (!worker_) return;
    worker_->watch().cancel();
    try {
        while (!worker_->finished(100)) continue;
    } catch (const Error&) {
        // Nobody is left to tell.
    }
}

// At once without a worker.
void Lab::work(std::function<void()> job) { worker_ ? worker_->begin(std::move(job)) : job(); }

std::optional<Rectangle> Lab::cancel_button() const {
    return card_shows() && busy_card_.button.width > 0 ? std::optional(busy_card_.button) : std::nullopt;
}

bool Lab::card_shows() const { return busy() && worker_->seconds() >= pace_.card_after; }

// Inputs that come while the card covers the lab are for the card alone; where the mouse is, and what is let go, is kept.
void Lab::take_inputs_of_card() {
    ImGuiContext& g = *ImGui::GetCurrentContext();
    ImVec2 pointer = g.IO.MousePos;
    const Rectangle button = busy_card_.button;
    const auto for_card = [&](const ImGuiInputEvent& e) {
        switch (e.Type) {
            case ImGuiInputEventType_MousePos:
                pointer = {e.MousePos.PosX, e.MousePos.PosY};
                return false;
            case ImGuiInputEventType_MouseButton:
                if (e.MouseButton.Down && e.MouseButton.Button == 0 && contains(button, pointer)) worker_->watch().cancel();
                return e.MouseButton.Down;
            case ImGuiInputEventType_Key:
                if (e.Key.Down && e.Key.Key == ImGuiKey_Escape) worker_->watch().cancel();
                return e.Key.Down;
            case ImGuiInputEventType_MouseWheel:
            case ImGuiInputEventType_Text:
                return true;
            default:
                return false;
        }
    };
    ImVector<ImGuiInputEvent> kept;
    for (const ImGuiInputEvent& e : g.InputEventsQueue)
        if (!for_card(e)) kept.push_back(e);
    g.InputEventsQueue.swap(kept);
}

void Lab::lay_out_card(ImDrawList& draw, const ImVec2& display) {
    const Watch& watch = worker_->watch();
    const Watch::Progress progress = watch.progress();
    const BusyWords text = busy_words(progress, worker_->seconds());
    ImFont& font = *state_.fonts.normal;
    const float size = font.FontSize, pad = state_.px(14), line = 1.35f * size, width = state_.px(300),
                height = 2 * pad + 4.4f * line;
    const ImVec2 a{std::floor((display.x - width) / 2), std::floor((display.y - height) / 2)}, b{a.x + width, a.y + height};
    const auto colour = [](ImGuiCol c) { return ImGui::GetColorU32(c); };
    draw.AddRectFilled(a, b, colour(ImGuiCol_PopupBg) | IM_COL32_A_MASK, state_.px(6));
    draw.AddRect(a, b, state_.ink(Ink::accent), state_.px(6), 0, std::max(2.f, state_.px(2)));
    float y = a.y + pad;
    const auto write = [&](const std::string& words_of_line) {
        draw.AddText(&font, size, {a.x + pad, y}, colour(ImGuiCol_Text), words_of_line.c_str());
        y += line;
    };
    write(text.title);
    write(text.line);
    const ImVec2 bar{b.x - pad, y + 0.5f * size};
    draw.AddRectFilled({a.x + pad, y}, bar, colour(ImGuiCol_FrameBg), state_.px(3));
    if (const auto share = progress.share())
        draw.AddRectFilled({a.x + pad, y},
                           {a.x + pad + static_cast<float>(std::clamp(*share, Real{0}, Real{1})) * (width - 2 * pad), bar.y},
                           state_.ink(Ink::accent), state_.px(3));
    y += 0.8f * line;
    busy_card_ = {.card = {a.x, a.y, width, height}, .button = {}};
    if (watch.cancelling()) return write("Called off; it ends at the next place where it can.");
    if (!watch.cancellable()) return write("It cannot be left half way.");
    const std::string label = "Cancel (Escape)";
    const ImVec2 words_size = font.CalcTextSizeA(size, std::numeric_limits<float>::max(), 0, label.c_str());
    busy_card_.button = {a.x + pad, y, words_size.x + 2 * pad, 1.5f * line};
    const Rectangle& r = busy_card_.button;
    draw.AddRectFilled({r.x, r.y}, {r.x + r.width, r.y + r.height}, colour(ImGuiCol_Button), state_.px(4));
    draw.AddText(&font, size, {r.x + pad, r.y + (r.height - size) / 2}, colour(ImGuiCol_Text), label.c_str());
}

// ImGui sees no frame, so that a drag goes on where it was once the work is done.
bool Lab::draw_busy() {
    if (!card_shows() || !ImGui::GetDrawData()) return false;
    take_inputs_of_card();
    ImDrawList card(ImGui::GetDrawListSharedData());
    card._ResetForNewFrame();
    card.PushTextureID(ImGui::GetIO().Fonts->TexID);
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    card.PushClipRect({0, 0}, display);
    lay_out_card(card, display);
    if (state_.black) card.AddRectFilled({0, 0}, display, IM_COL32_BLACK);
    clear_window();
    gui_.draw_again(card);
    ++busy_frames_;
    return true;
}

}  // namespace pliant::viewer
