#include <pliant/lesson/file.h>
#include <pliant/math/error.h>

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace pliant {
namespace fs = std::filesystem;

std::string read_file(const std::string& path) {
    std::error_code error;
    if (fs::is_directory(path, error)) throw Refused(fmt::format("{} is a folder: give a file", path));
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    if (!in || !(text << in.rdbuf())) {
        if (in && in.peek() == std::ifstream::traits_type::eof()) return "";
        throw Refused(fmt::format("{} cannot be read: {}", path, std::strerror(errno)));
    }
    return text.str();
}

void write_file(const std::string& path, std::string_view contents) {
    const std::string part = path + ".part";
    std::error_code error;
    if (fs::is_directory(path, error)) throw Refused(fmt::format("{} is a folder: give the name of a file to write", path));
    {
        std::ofstream out(part, std::ios::binary | std::ios::trunc);
        if (!out) throw Refused(fmt::format("{} cannot be written: {}; give a path in a folder that exists and can be written to", path, std::strerror(errno)));
        out.write(contents.data(), static_cast<std::streamsize>(contents.size()));
        out.flush();
        if (!out) {
            out.close();
            fs::remove(part, error);
            throw Refused(fmt::format("{} cannot be written: {}", path, std::strerror(errno)));
        }
    }
    fs::rename(part, path, error);
    if (!error) return;
    const std::string reason = error.message();
    fs::remove(part, error);
    throw Refused(fmt::format("{} cannot be written: {}", path, reason));
}

}  // namespace pliant
