#include "command_line/output_paths.h"

#include <pliant/math/error.h>
#include <pliant/text/file.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

namespace pliant::viewer {
namespace {

// Endings that tell what a file is.
constexpr std::array<std::string_view, 24> telling{".avif", ".bmp",  ".csv", ".eps", ".gif",  ".html", ".jpeg", ".jpg",
                                                   ".json", ".md",   ".mp4", ".ods", ".pdf",  ".png",  ".ppm",  ".svg",
                                                   ".tif",  ".tiff", ".tsv", ".vtu", ".webm", ".webp", ".xlsx", ".xml"};

// What is no file of a name that was chosen for it: "/dev/stdout", a pipe.
bool needs_no_ending(const std::string& path) { return path.starts_with("/dev/") || is_special_file(path); }

bool tells(const std::string& ending) { return std::ranges::find(telling, ending) != telling.end(); }

}  // namespace

std::string ending_of(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

void require_ending(std::string_view option, const std::string& path, std::initializer_list<std::string_view> endings,
                    std::string_view what) {
    if (std::ranges::find(endings, ending_of(path)) != endings.end() || needs_no_ending(path)) return;
    throw Refused(
        fmt::format("{} {} is not accepted: {}; give a name that ends in {}", option, path, what, fmt::join(endings, " or ")));
}

void refuse_other_ending(std::string_view option, const std::string& path, std::string_view ending, std::string_view what) {
    const std::string given = ending_of(path);
    if (given == ending || !tells(given) || needs_no_ending(path)) return;
    throw Refused(fmt::format("{} {} is not accepted: {}; give a name that ends in {}", option, path, what, ending));
}

void refuse_file_ending(std::string_view option, const std::string& folder) {
    std::error_code ignored;
    if (!tells(ending_of(folder)) || std::filesystem::is_directory(folder, ignored)) return;
    throw Refused(fmt::format("{} {} is not accepted: several files are written into a folder; give its name, without an ending",
                              option, folder));
}

}  // namespace pliant::viewer
