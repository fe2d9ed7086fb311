// Whole files in and out.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace pliant {

// Throws Refused naming the path and the reason.
std::string read_file(const std::string& path);

// Writes a file of a name of its own beside the target, gives it the mode of the file that it replaces, and renames it, so that
// nothing half-written is ever left under the name and no other file is touched. A link stays a link: what it leads to, which
// need not be there yet, is written. A pipe or a device is written to, and so is a file that is not to be replaced: one with
// several names, one of another owner, one in a folder that takes no new files. Throws Refused likewise.
void write_file(const std::string& path, std::string_view contents);

// Throws Refused where write_file would refuse the path; changes nothing.
void check_writable(const std::string& path);

// A pipe or a device.
bool is_special_file(const std::string& path);

// Renames a file to its name with `ending` and, where that is taken, a number behind it; never replaces another file. Empty when
// it cannot be renamed.
std::filesystem::path set_aside(const std::filesystem::path& path, std::string_view ending);

}  // namespace pliant
