// The names that a person gives to what is written: their endings have to tell the truth.
#pragma once
#include <initializer_list>
#include <string>
#include <string_view>

namespace pliant::viewer {

// ".png" of "a/Picture.PNG"; "" where there is none.
std::string ending_of(const std::string& path);

// Throws Refused unless the name has one of these endings (".png"), which a pipe or a device need not; `what` is written there:
// "a picture is written as PNG".
void require_ending(std::string_view option, const std::string& path, std::initializer_list<std::string_view> endings,
                    std::string_view what);
// Throws Refused for a name with the ending of another kind of file: a table called ".png". Endings that tell nothing are good.
void refuse_other_ending(std::string_view option, const std::string& path, std::string_view ending, std::string_view what);
// Throws Refused for the name of a folder that ends as files do.
void refuse_file_ending(std::string_view option, const std::string& folder);

}  // namespace pliant::viewer
