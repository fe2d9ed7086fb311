#include <pliant/text/texts.h>

#include <map>

namespace pliant {
namespace {

std::map<std::string_view, std::string_view>& all_texts() {
    static std::map<std::string_view, std::string_view> texts;
    return texts;
}

std::string preset_folder(std::string_view lesson_id) { return std::string(lesson_id) + "/presets/"; }

}  // namespace

TextRegistration::TextRegistration(std::vector<std::pair<std::string_view, std::string_view>> texts) {
    for (const auto& [path, text] : texts) all_texts()[path] = text;
}

std::string_view find_text(std::string_view path) {
    const auto found = all_texts().find(path);
    return found == all_texts().end() ? std::string_view{} : found->second;
}

std::vector<std::string_view> texts_called(std::string_view name) {
    const std::string end = "/" + std::string(name);
    std::vector<std::string_view> paths;
    for (const auto& [path, text] : all_texts())
        if (path.ends_with(end)) paths.push_back(path);
    return paths;
}

std::vector<std::string> preset_names(std::string_view lesson_id) {
    const std::string folder = preset_folder(lesson_id);
    std::vector<std::string> names;
    for (const auto& [path, text] : all_texts())
        if (path.starts_with(folder) && path.ends_with(".json"))
            names.emplace_back(path.substr(folder.size(), path.size() - folder.size() - std::string_view(".json").size()));
    return names;
}

std::string_view preset_text(std::string_view lesson_id, std::string_view name) {
    return find_text(preset_folder(lesson_id) + std::string(name) + ".json");
}

}  // namespace pliant
