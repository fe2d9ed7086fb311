// Texts that lie beside the lessons in the sources (walkthroughs, claims, presets), compiled into the program.
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pliant {

struct TextRegistration {
    explicit TextRegistration(std::vector<std::pair<std::string_view, std::string_view>> texts);
};

// "mesh/mass_spring/walkthrough.md"; empty when there is none.
std::string_view find_text(std::string_view path);

// The paths of all texts of this name, "claims.md", sorted.
std::vector<std::string_view> texts_called(std::string_view name);

// The paths of all texts in this folder, "lectures", sorted.
std::vector<std::string_view> texts_in(std::string_view folder);

// The names of the presets of a lesson: its files presets/NAME.json.
std::vector<std::string> preset_names(std::string_view lesson_id);
std::string_view preset_text(std::string_view lesson_id, std::string_view name);

}  // namespace pliant
