// Pictures as `pliant shot` makes them.
#pragma once
#include <pliant/lesson/registry.h>

#include "command_line/options.h"
#include "platform/image.h"
#include "platform/png_file.h"

#include <unistd.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace pliant::test {

namespace fs = std::filesystem;
using viewer::Image;
using viewer::PictureOptions;

struct Shot {
    std::string lesson;
    std::vector<std::string> settings{};  // "key=value"
    std::optional<Index> steps{};
    PictureOptions picture{};
};

// A file of this process alone, gone with its owner.
class PictureFile {
public:
    PictureFile() : path_(fs::temp_directory_path() / ("pliant_shot_" + std::to_string(getpid()) + ".png")) {}
    ~PictureFile() {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    PictureFile(const PictureFile&) = delete;
    PictureFile& operator=(const PictureFile&) = delete;
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

// Writes the picture to `path`. Throws as the command does.
inline void take(const Shot& shot, const fs::path& path) {
    viewer::RunOptions run;
    run.lesson = shot.lesson;
    run.settings = shot.settings;
    run.steps = shot.steps;
    PictureOptions picture = shot.picture;
    picture.out = path.string();
    viewer::shot(run, picture);
}

inline Image picture_of(const Shot& shot) {
    const PictureFile file;
    take(shot, file.path());
    return viewer::read_png(file.path());
}

inline std::size_t distinct_colours(const Image& image) {
    std::set<std::uint32_t> colours;
    for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3)
        colours.insert(image.rgb[i] << 16 | image.rgb[i + 1] << 8 | image.rgb[i + 2]);
    return colours.size();
}

}  // namespace pliant::test
