#include "app/lecture_place.h"

#include <pliant/text/file.h>

#include <system_error>
#include <utility>

namespace pliant::viewer {
namespace fs = std::filesystem;

std::string with_whole_path(const std::string& lecture) {
    std::error_code error;
    if (!fs::is_regular_file(lecture, error)) return lecture;
    const fs::path whole = fs::absolute(lecture, error);
    return error ? lecture : whole.lexically_normal().string();
}

std::optional<SceneFile> LecturePlace::left(const Lecture& lecture) const {
    std::error_code error;
    if (path_.empty() || !fs::is_regular_file(path_, error)) return std::nullopt;
    try {
        SceneFile scene = read_scene(path_.string());
        const bool same = scene.slide && scene.slide->lecture == lecture.path && scene.slide->number <= lecture.slides.size();
        return same ? std::optional(std::move(scene)) : std::nullopt;
    } catch (const Refused&) {
        return std::nullopt;
    }
}

void LecturePlace::keep(const Lab& lab) {
    const auto now = lab.state().session.lecture_place();
    if (!now || kept_ == now) return;
    kept_ = now;
    write(lab);
}

void LecturePlace::finish(const Lab& lab) {
    if (lab.state().session.lecture()) write(lab);
}

// A folder that takes no files loses the place, and nothing else.
void LecturePlace::write(const Lab& lab) const {
    if (path_.empty()) return;
    try {
        std::error_code error;
        fs::create_directories(path_.parent_path(), error);
        SceneFile scene = lab.scene_file();
        scene.slide = lab.state().session.lecture_place();
        write_file(path_.string(), scene_text_for(scene, path_.string()));
    } catch (const Refused&) {
        return;
    }
}

}  // namespace pliant::viewer
