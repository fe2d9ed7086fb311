#include "panels/slide_picture.h"

#include <pliant/math/error.h>

#include "panels/typeset_text.h"
#include "platform/png_file.h"

#include <algorithm>
#include <utility>

namespace pliant::viewer {
namespace {

SlidePictureState::Kept loaded(const std::string& path) {
    SlidePictureState::Kept kept;
    try {
        const Image image = read_png(path);
        kept.width = image.width, kept.height = image.height;
        kept.texture = make_texture();
        glBindTexture(GL_TEXTURE_2D, kept.texture);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, image.width, image.height, 0, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    } catch (const Refused& e) {
        kept.trouble = e.what();
    }
    return kept;
}

}  // namespace

void draw_slide_picture(PanelContext& lab, SlidePictureState& panel, const std::string& path) {
    auto at = panel.kept.find(path);
    if (at == panel.kept.end()) at = panel.kept.emplace(path, loaded(path)).first;
    const SlidePictureState::Kept& p = at->second;
    if (!p.trouble.empty()) return sentence_item(lab, p.trouble);
    const ImVec2 room = ImGui::GetContentRegionAvail(), from = ImGui::GetCursorPos();
    const float fit = std::min(room.x / static_cast<float>(p.width), room.y / static_cast<float>(p.height));
    const ImVec2 size{fit * static_cast<float>(p.width), fit * static_cast<float>(p.height)};
    ImGui::SetCursorPos({from.x + (room.x - size.x) / 2, from.y + (room.y - size.y) / 2});
    ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(static_cast<GLuint>(p.texture))), size);
    lab.note_control("slide picture");
}

}  // namespace pliant::viewer
