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

namespace {

[[noreturn]] void cannot_write(const std::string& path, const std::string& reason) {
    throw Refused(
        fmt::format("{} cannot be written: {}; give a path in a folder that exists and can be written to", path, reason));
}

// Pipes and devices are written to, never replaced.
bool is_special(const std::string& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status);
}

// A link stays a link: the file it leads to, which need not be there yet, is replaced.
fs::path target_of(const std::string& path) {
    fs::path target(path);
    std::error_code ignored;
    for (int links = 0; links < 40 && fs::is_symlink(target, ignored); ++links)
        target = target.parent_path() / fs::read_symlink(target, ignored);
    return target;
}

void fill(const std::string& name, std::string_view contents, const std::string& path) {
    std::ofstream out(name, std::ios::binary | std::ios::trunc);
    if (!out) cannot_write(path, std::strerror(errno));
    out.write(contents.data(), static_cast<std::streamsize>(contents.size()));
    out.flush();
    if (!out) cannot_write(path, std::strerror(errno));
}

// Fills a file beside the target and removes it again when that fails.
std::string fill_part(const std::string& path, std::string_view contents) {
    const std::string part = target_of(path).string() + ".part";
    try {
        fill(part, contents, path);
    } catch (const Refused&) {
        std::error_code ignored;
        fs::remove(part, ignored);
        throw;
    }
    return part;
}

void refuse_folder(const std::string& path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) throw Refused(fmt::format("{} is a folder: give the name of a file to write", path));
}

}  // namespace

void check_writable(const std::string& path) {
    refuse_folder(path);
    std::error_code ignored;
    if (!is_special(path)) fs::remove(fill_part(path, ""), ignored);
}

void write_file(const std::string& path, std::string_view contents) {
    refuse_folder(path);
    if (is_special(path)) return fill(path, contents, path);
    const std::string part = fill_part(path, contents);
    std::error_code error, ignored;
    fs::rename(part, target_of(path), error);
    if (!error) return;
    fs::remove(part, ignored);
    cannot_write(path, error.message());
}

}  // namespace pliant
