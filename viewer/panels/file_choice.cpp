#include "panels/file_choice.h"

#include <pliant/math/error.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace pliant::viewer {
namespace fs = std::filesystem;

void FileChoice::ask(Purpose purpose, std::string title, std::vector<std::string> endings, std::string first_name,
                     Chosen chosen) {
    purpose_ = purpose;
    title_ = std::move(title), endings_ = std::move(endings), name = std::move(first_name);
    chosen_ = std::move(chosen);
    asking_ = true, replacing_ = false, all_files_ = false;
    ++questions_;
    complaint_.clear();
    std::error_code error;
    if (folder_.empty() || !fs::is_directory(folder_, error)) folder_ = fs::current_path(error);
    list();
}

void FileChoice::show_all_files(bool all) {
    all_files_ = all;
    list();
}

bool FileChoice::ends_right(const std::string& file) const {
    return endings_.empty() || std::ranges::any_of(endings_, [&](const std::string& ending) { return file.ends_with(ending); });
}

std::string FileChoice::ending_words() const { return fmt::format("{}", fmt::join(endings_, " or ")); }

void FileChoice::list() {
    entries_.clear();
    std::error_code error;
    for (fs::directory_iterator at(folder_, fs::directory_options::skip_permission_denied, error), end; !error && at != end;
         at.increment(error)) {
        std::error_code ignored;
        const std::string entry = at->path().filename().string();
        const bool folder = at->is_directory(ignored);
        if (entry.starts_with('.') && !all_files_) continue;
        if (folder || all_files_ || ends_right(entry)) entries_.push_back({entry, folder});
    }
    if (error) complaint_ = fmt::format("{} cannot be read: {}", folder_.string(), error.message());
    std::ranges::sort(entries_, [](const Entry& a, const Entry& b) { return a.folder != b.folder ? a.folder : a.name < b.name; });
}

void FileChoice::go_to(const fs::path& folder) {
    replacing_ = false;
    complaint_.clear();
    std::error_code error;
    const fs::directory_iterator readable(folder, error);
    if (error) {
        complaint_ = fmt::format("{} cannot be read: {}", folder.string(), error.message());
        return;
    }
    const fs::path whole = fs::weakly_canonical(folder, error);
    folder_ = error ? folder : whole;
    list();
}

void FileChoice::go_up() {
    if (folder_.has_relative_path()) go_to(folder_.parent_path());
}

void FileChoice::move(int by) {
    if (entries_.empty()) return;
    replacing_ = false;
    const auto at = std::ranges::find(entries_, name, &Entry::name);
    const int count = static_cast<int>(entries_.size());
    const int next = at == entries_.end() ? (by > 0 ? 0 : count - 1) : static_cast<int>(at - entries_.begin()) + by;
    name = entries_[static_cast<std::size_t>(std::clamp(next, 0, count - 1))].name;
}

fs::path FileChoice::typed() const {
    if (name == "~" || name.starts_with("~/"))
        if (const char* home = std::getenv("HOME"))
            return fs::path(home) / fs::path(name.substr(std::min<std::size_t>(2, name.size())));
    return folder_ / name;  // a path from the root stands for itself
}

void FileChoice::accept() {
    complaint_.clear();
    if (replacing_) return replace();
    if (name.empty()) {
        complaint_ = purpose_ == Purpose::open ? "Type or choose the name of a file." : "Type a name for the file.";
        return;
    }
    fs::path path = typed();
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
        go_to(path);
        if (complaint_.empty()) name.clear();
        return;
    }
    const fs::path parent = path.parent_path();
    if (!fs::is_directory(parent, ignored)) {
        complaint_ = fmt::format("There is no folder {}.", parent.string());
        return;
    }
    if (purpose_ == Purpose::open) {
        if (fs::exists(path, ignored)) return finish(path);
        complaint_ = fmt::format("There is no file {} in {}.", path.filename().string(), parent.string());
        return;
    }
    const bool there = fs::exists(path, ignored);
    if (purpose_ == Purpose::add && there) return finish(path);
    if (!ends_right(path.filename().string())) path += endings_.front(), name += endings_.front();
    replacing_ = purpose_ == Purpose::save && fs::exists(path, ignored);
    if (!replacing_) finish(path);
}

void FileChoice::replace() {
    if (!std::exchange(replacing_, false)) return;
    finish(typed());
}

void FileChoice::finish(const fs::path& path) {
    const Chosen chosen = chosen_;
    try {
        asking_ = false;
        chosen(path.string());
        folder_ = path.parent_path();
    } catch (const Error& e) {
        asking_ = true;
        complaint_ = e.what();
    }
}

}  // namespace pliant::viewer
