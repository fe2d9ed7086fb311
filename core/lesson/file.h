// Whole files in and out.
#pragma once
#include <string>
#include <string_view>

namespace pliant {

// Throws Refused naming the path and the reason.
std::string read_file(const std::string& path);

// Writes beside the file and renames, so that nothing half-written is ever left under the name; a link stays a link, and a pipe
// or a device is written to. Throws Refused likewise.
void write_file(const std::string& path, std::string_view contents);

// Throws Refused where write_file would refuse the path; changes nothing.
void check_writable(const std::string& path);

}  // namespace pliant
