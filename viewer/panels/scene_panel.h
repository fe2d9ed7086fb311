// The picture of the run, and what the mouse does in it.
#pragma once
#include "panels/panel_context.h"
#include "render/picking.h"
#include "render/scene_renderer.h"

#include <cstddef>
#include <memory>
#include <optional>

namespace pliant::viewer {

// The type of the words in a picture.
struct LabelType {
    int run = -1;
    Layout layout = Layout::lab;
    float width = 0, height = 0, scale = 0;  // of the picture, px; of the lab
    std::size_t smaller = 0;                 // sizes below the largest
    bool same_picture(const LabelType& o) const {
        return run == o.run && layout == o.layout && width == o.width && height == o.height && scale == o.scale;
    }
};

// The strip above a picture that its notes stand in.
struct NotesStrip {
    int run = -1;
    Layout layout = Layout::lab;
    float width = 0, room = 0, scale = 0;  // of one picture and of the panel's height, px; of the lab
    bool small = false;                    // their type
    float height = 0;                      // the greatest that was asked for, px
    bool same_place(const NotesStrip& o) const {
        return run == o.run && layout == o.layout && width == o.width && room == o.room && scale == o.scale;
    }
};

struct ScenePanelState {
    std::optional<Picked> hovered{};
    std::optional<Pull> pulling{};
    bool turning = false, clicked_only = false;  // has the pointer stayed where it was pressed?
    bool hints_shown = true;
    LabelType label_type{};
    NotesStrip notes_strip{};
    std::unique_ptr<SceneRenderer> renderer_beside{};  // of run B, or of before
    std::optional<int> focused_card{};                 // the run and step whose autopsy has had the focus
};

void draw_scene(PanelContext& lab, ScenePanelState& panel, SceneRenderer& renderer);
// Over the picture, at most a third of it: why the run stopped, and what to do.
void draw_autopsy(PanelContext& lab, ScenePanelState& panel, const Rectangle& picture);

}  // namespace pliant::viewer
