// Where a lecture was left, in a file beside the settings, so that it goes on there after a restart.
#pragma once
#include "app/lab.h"

#include <filesystem>
#include <optional>
#include <string>

namespace pliant::viewer {

// A path from the root where the file is there; any other name stays as it is.
std::string with_whole_path(const std::string& lecture);

class LecturePlace {
public:
    // An empty path: nothing is read and nothing written.
    explicit LecturePlace(std::filesystem::path path) : path_(std::move(path)) {}

    // The scene in which this lecture was left; empty when another one was, or when the file cannot be understood.
    std::optional<SceneFile> left(const Lecture& lecture) const;
    // Call in every frame that may look at the lab: writes when another slide, or an answer, has come up.
    void keep(const Lab& lab);
    // At the end: writes what was done on the slide.
    void finish(const Lab& lab);

private:
    void write(const Lab& lab) const;

    std::filesystem::path path_;
    std::optional<SceneSlide> kept_{};
};

}  // namespace pliant::viewer
