#include <pliant/text/texts.h>

#include <map>

namespace pliant {
namespace {

std::map<std::string_view, std::string_view>& all_texts() {
    static std::map<std::string_view, std::string_view> texts;
    return texts;
}

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

std::vector<std::string_view> texts_in(std::string_view folder) {
    const std::string begin = std::string(folder) + "/";
    std::vector<std::string_view> paths;
    for (const auto& [path, text] : all_texts())
        if (path.starts_with(begin)) paths.push_back(path);
    return paths;
}

std::vector<std::string> preset_names(std::string_view lesson_id) {
    constexpr std::string_view ending = ".json";
    std::vector<std::string> names;
    for (const std::string_view path : texts_in(std::string(lesson_id) + "/presets"))
        if (path.ends_with(ending)) {
            const std::string_view name = path.substr(path.rfind('/') + 1);
            names.emplace_back(name.substr(0, name.size() - ending.size()));
        }
    return names;
}

std::string_view preset_text(std::string_view lesson_id, std::string_view name) {
    return find_text(std::string(lesson_id) + "/presets/" + std::string(name) + ".json");
}

}  // namespace pliant
