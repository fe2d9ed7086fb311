#include "app/map_picture.h"

#include <pliant/text/format.h>

#include <imgui.h>

#include "panels/companion_panel.h"
#include "panels/plot_panel.h"
#include "platform/gl.h"
#include "platform/gui.h"
#include "plot/imgui_canvas.h"
#include "plot/map_plot.h"

#include <fmt/format.h>

#include <algorithm>

namespace pliant::viewer {
namespace {

void clear(Rgba8 background) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glClearColor(background.r / 255.f, background.g / 255.f, background.b / 255.f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

// A line of words in a font; the height that it took, px.
float line(Canvas& canvas, ImFont* font, Point at, float width, Rgba8 colour, const std::string& words) {
    ImGui::PushFont(font);
    canvas.text(at, colour, shortened(canvas, words, width));
    const float height = canvas.line_height();
    ImGui::PopFont();
    return height;
}

void draw_page(Canvas& canvas, Size size, const StabilityMap& map, const PlotStyle& style, const Fonts& fonts) {
    const float edge = style.px(22), width = static_cast<float>(size.width) - 2 * edge;
    float y = style.px(14);
    y += line(canvas, fonts.medium, {edge, y}, width, style.text,
              fmt::format("Where is it stable? {}", map.order.lesson->info.title));
    y += line(canvas, fonts.normal, {edge, y + style.px(2)}, width, style.faint_text, map_conditions(map)) + style.px(14);
    const float bottom = static_cast<float>(size.height) - style.px(40);
    draw_map(canvas, {{edge, y}, {edge + width, bottom}}, MapPicture(map), style, true);
    line(canvas, fonts.normal, {edge, bottom + style.px(8)}, width, style.faint_text, agreement_text(map));
}

}  // namespace

std::string map_conditions(const StabilityMap& map) {
    const auto lesson = map.order.lesson->make();
    for (const auto& [key, text] : map.order.settings) {
        Parameter& p = lesson->parameter(key);
        p.set(p.parse(text));
    }
    const auto is_knob = [&](const Parameter& p) { return p.info.key == map.order.across.key || p.info.key == map.order.up.key; };
    const auto is_set = [&](const Parameter& p) {
        return std::ranges::any_of(map.order.settings, [&](const auto& s) { return s.first == p.info.key; });
    };
    // What runs beside a scheme for comparison changes nothing in the cells.
    const auto matters = [](const Parameter& p) { return p.info.kind == Kind::choice && p.info.key != "compare"; };
    std::string text;
    for (const bool chosen : {true, false})
        for (const Parameter* p : lesson->parameters)
            if (!is_knob(*p) && p->used() && matters(*p) == chosen && (chosen || is_set(*p)))
                text += setting_text(*p, p->value()) + " · ";
    return text + (map.order.time ? fmt::format("{} in each cell", format_quantity(*map.order.time, "s"))
                                  : fmt::format("{} steps or more in each cell", map.order.steps));
}

Image map_image(const StabilityMap& map, Size size, Theme theme, float ui_scale) {
    const auto context = open_headless(size);
    Gui gui(*context);
    const Fonts fonts = load_fonts(ui_scale);
    apply_theme(theme, ui_scale);
    const PlotStyle style = plot_style(plot_theme(theme), ui_scale);
    // The first frame makes the textures of the type.
    for (int frame = 0; frame < 2; ++frame) {
        clear(style.background);
        gui.begin_frame(1.0 / 60);
        ImGui::PushFont(fonts.normal);
        ImguiCanvas canvas(*ImGui::GetBackgroundDrawList(), &fonts.mathematics);
        draw_page(canvas, size, map, style, fonts);
        ImGui::PopFont();
        gui.end_frame();
        if (frame == 0) context->present();
    }
    return read_pixels(*context);
}

}  // namespace pliant::viewer
