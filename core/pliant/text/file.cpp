#include <fcntl.h>
#include <pliant/math/error.h>
#include <pliant/text/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

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

bool is_special_file(const std::string& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

namespace {

constexpr mode_t as_usual = 0666, mode_bits = 07777;

[[noreturn]] void cannot_write(const std::string& path, const std::string& reason) {
    throw Refused(
        fmt::format("{} cannot be written: {}; give a path in a folder that exists and can be written to", path, reason));
}

[[noreturn]] void cannot_write(const std::string& path) { cannot_write(path, std::strerror(errno)); }

// Where the links that begin at the path lead to; it need not be there.
fs::path end_of_links(const std::string& path) {
    if (path.empty()) throw Refused("a file needs a name");
    constexpr int most_links = 40;  // as many as the system follows
    fs::path target(path);
    std::error_code ignored;
    for (int links = 0; fs::is_symlink(target, ignored); ++links) {
        if (links == most_links) cannot_write(path, "it is a symbolic link that leads back to itself");
        target = target.parent_path() / fs::read_symlink(target, ignored);
    }
    return target;
}

struct Target {
    fs::path file;
    std::optional<mode_t> mode;  // of the file that is there
    bool in_place = false;       // the file is written to rather than replaced
    int output = -1;             // the standard descriptor that leads to the same file, if one does
};

bool same_file(const struct stat& a, const struct stat& b) { return a.st_dev == b.st_dev && a.st_ino == b.st_ino; }

// Standard output and error, where they lead to this file: "/dev/stdout", or what the shell has opened.
int output_into(const struct stat& file) {
    for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO})
        if (struct stat found{}; fstat(descriptor, &found) == 0 && S_ISREG(found.st_mode) && same_file(found, file))
            return descriptor;
    return -1;
}

Target target_of(const std::string& path) {
    Target target{path, std::nullopt};
    struct stat found {};
    const bool there = stat(path.c_str(), &found) == 0;
    if (there && S_ISDIR(found.st_mode)) throw Refused(fmt::format("{} is a folder: give the name of a file to write", path));
    if (there && access(path.c_str(), W_OK) != 0) cannot_write(path);
    target.in_place = there && !S_ISREG(found.st_mode);
    if (target.in_place) return target;
    target.file = end_of_links(path);
    if (!there) return target;
    target.mode = found.st_mode & mode_bits;
    target.output = output_into(found);
    const fs::path folder = target.file.has_parent_path() ? target.file.parent_path() : ".";
    target.in_place =
        target.output >= 0 || found.st_nlink > 1 || found.st_uid != geteuid() || access(folder.c_str(), W_OK | X_OK) != 0;
    return target;
}

// A file that is open for writing, until it is closed.
class OpenFile {
public:
    OpenFile() = default;
    explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
    OpenFile(const fs::path& name, int flags) : descriptor_(open(name.c_str(), O_WRONLY | O_CLOEXEC | flags, as_usual)) {}
    OpenFile(OpenFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    OpenFile& operator=(OpenFile&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }
    ~OpenFile() { close(); }

    bool is_open() const { return descriptor_ >= 0; }
    // Each false, and errno tells why, when it cannot be done.
    bool set_mode(mode_t mode) const { return fchmod(descriptor_, mode) == 0; }
    bool put(std::string_view contents) const {
        while (!contents.empty()) {
            const ssize_t written = ::write(descriptor_, contents.data(), contents.size());
            if (written < 0 && errno != EINTR) return false;
            contents.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
        }
        return true;
    }
    bool close() { return descriptor_ < 0 || ::close(std::exchange(descriptor_, -1)) == 0; }

private:
    int descriptor_ = -1;
};

// A file beside the target whose name nobody else has. It goes away unless it is kept.
class Part {
public:
    Part(const Target& target, const std::string& path) {
        static std::atomic<unsigned> count{0};
        do {
            name_ = target.file.parent_path() / fmt::format(".pliant-{}-{}.part", getpid(), count++);
            file_ = OpenFile(name_, O_CREAT | O_EXCL);
        } while (!file_.is_open() && errno == EEXIST);
        if (!file_.is_open()) cannot_write(path);
        if (target.mode) file_.set_mode(*target.mode);  // a file system without modes has none to keep
    }
    ~Part() {
        std::error_code ignored;
        if (!kept_) fs::remove(name_, ignored);
    }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

    bool put(std::string_view contents) { return file_.put(contents) && file_.close(); }
    bool keep_as(const fs::path& target) { return kept_ = std::rename(name_.c_str(), target.c_str()) == 0; }

private:
    fs::path name_;
    OpenFile file_;
    bool kept_ = false;
};

}  // namespace

void check_writable(const std::string& path) {
    const Target target = target_of(path);
    if (!target.in_place) Part(target, path);
}

void write_file(const std::string& path, std::string_view contents) {
    const Target target = target_of(path);
    if (target.in_place) {
        OpenFile file = target.output >= 0 ? OpenFile(dup(target.output)) : OpenFile(target.file, O_TRUNC);
        if (!file.is_open() || !file.put(contents) || !file.close()) cannot_write(path);
        return;
    }
    Part part(target, path);
    if (!part.put(contents) || !part.keep_as(target.file)) cannot_write(path);
}

fs::path set_aside(const fs::path& path, std::string_view ending) {
    for (int number = 1; number < 1000; ++number) {
        fs::path aside = path;
        aside += number == 1 ? std::string(ending) : fmt::format("{}{}", ending, number);
        std::error_code error;
        if (fs::symlink_status(aside, error).type() != fs::file_type::not_found) continue;
        fs::rename(path, aside, error);
        return error ? fs::path() : aside;
    }
    return {};
}

}  // namespace pliant
