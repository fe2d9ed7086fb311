#include <pliant/math/error.h>
#include <pliant/text/file.h>
#include <pliant/text/sha256.h>
#include <pliant/text/stored_file.h>
#include <pliant/text/suggest.h>
#include <pliant/text/texts.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <deque>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>

namespace pliant {

namespace {

std::string small_letters(std::string_view text) {
    std::string small(text);
    std::ranges::transform(small, small.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return small;
}

}  // namespace

bool takes_ending(std::string_view name, std::span<const std::string_view> endings) {
    const std::string small = small_letters(name);
    return std::ranges::any_of(endings, [&](std::string_view ending) { return small.ends_with(ending); });
}

namespace {

using Endings = std::span<const std::string_view>;
constexpr std::string_view bodies_folder = "meshes";
constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 30;

// All files so far. What is in it never moves.
struct FileTable {
    std::mutex mutex;
    std::deque<StoredFile> files{StoredFile{}};
    std::deque<std::string> bytes;
    std::map<std::string, Index, std::less<>> latest;  // by path
};

FileTable& file_table() {
    static FileTable table;
    return table;
}

[[noreturn]] void refuse_file(std::string_view text, std::string_view what, Endings endings) {
    throw Refused(fmt::format("{} {}: give a file that ends in {}", text, what, accepted_files(endings)));
}

// The embedded text that a name means, "meshes/hook_coarse.msh"; "" for none.
std::string bundled_path(std::string_view text, Endings endings) {
    const std::filesystem::path given(text);
    const std::string folder = given.parent_path().string();
    if (!folder.empty() && folder != bodies_folder && !folder.ends_with("assets/meshes")) return "";
    for (const std::string_view path : texts_in(bodies_folder)) {
        const std::filesystem::path known(path);
        if (takes_ending(path, endings) && (known.stem() == given.filename() || known.filename() == given.filename()))
            return std::string(path);
    }
    return "";
}

Index add_file(FileTable& table, StoredFile file) {
    const auto number = static_cast<Index>(table.files.size());
    table.latest[file.path] = number;
    table.files.push_back(std::move(file));
    return number;
}

std::optional<Index> known_number(FileTable& table, const std::string& path) {
    const std::scoped_lock lock(table.mutex);
    const auto found = table.latest.find(path);
    return found == table.latest.end() ? std::nullopt : std::optional(found->second);
}

Index store_bundled(const std::string& text_path) {
    FileTable& table = file_table();
    const std::filesystem::path known(text_path);
    const std::string name = known.stem().string();
    if (const auto number = known_number(table, name)) return *number;
    const std::string_view bytes = find_text(text_path);
    StoredFile file{.path = name, .name = known.filename().string(), .bytes = bytes, .sha256 = sha256(bytes), .bundled = true};
    const std::scoped_lock lock(table.mutex);
    if (const auto found = table.latest.find(name); found != table.latest.end()) return found->second;
    return add_file(table, std::move(file));
}

Index store_read(const std::string& path) {
    FileTable& table = file_table();
    std::string bytes = read_file(path);
    std::string hash = sha256(bytes);
    const std::scoped_lock lock(table.mutex);
    if (const auto found = table.latest.find(path);
        found != table.latest.end() && table.files[static_cast<std::size_t>(found->second)].sha256 == hash)
        return found->second;
    table.bytes.push_back(std::move(bytes));
    return add_file(table, {.path = path, .name = path, .bytes = table.bytes.back(), .sha256 = std::move(hash)});
}

void require_usual_file(const std::filesystem::path& path, std::string_view text, Endings endings) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (std::filesystem::is_directory(status)) refuse_file(text, "is a folder", endings);
    if (!std::filesystem::is_regular_file(status)) refuse_file(text, "is no file with a content of its own", endings);
    if (!takes_ending(path.string(), endings)) {
        const std::string ending = path.extension().string();
        refuse_file(text, ending.empty() ? "has no ending" : fmt::format("ends in {}", ending), endings);
    }
    if (const auto size = std::filesystem::file_size(path, error); !error && size > most_bytes)
        refuse_file(text, fmt::format("has {} bytes, more than the {} that are read", size, most_bytes), endings);
}

}  // namespace

std::vector<std::string> bundled_bodies(Endings endings) {
    std::vector<std::string> names;
    for (const std::string_view path : texts_in(bodies_folder))
        if (takes_ending(path, endings)) names.push_back(std::filesystem::path(path).stem().string());
    return names;
}

std::string accepted_files(Endings endings) {
    const auto bodies = bundled_bodies(endings);
    std::string list;
    for (std::size_t i = 0; i < endings.size(); ++i)
        list += fmt::format("{}{}", i == 0 ? "" : i + 1 < endings.size() ? ", " : " or ", endings[i]);
    return bodies.empty() ? list
                          : fmt::format("{}, or one of the bodies that come with Pliant: {}", list, fmt::join(bodies, ", "));
}

Index store_file(std::string_view text, Endings endings, Reading reading, const std::string& folder) {
    namespace fs = std::filesystem;
    if (text.empty() || text == "none") return 0;
    if (text.find('\0') != text.npos) refuse_file("a path with a zero byte", "is no name of a file", endings);
    const std::string bundled = bundled_path(text, endings);
    const fs::path given(text);
    if (!bundled.empty() && !given.has_extension()) return store_bundled(bundled);
    std::error_code error;
    const fs::path path = fs::absolute(fs::path(folder) / given, error).lexically_normal();
    if (reading == Reading::if_new)
        if (const auto number = known_number(file_table(), path.string()); number && is_stored(*number, endings)) return *number;
    if (!fs::exists(path, error)) {
        if (!bundled.empty()) return store_bundled(bundled);
        refuse_file(fmt::format("'{}'", text),
                    fmt::format("is not there{}", did_you_mean(given.stem().string(), bundled_bodies(endings))), endings);
    }
    require_usual_file(path, fmt::format("'{}'", text), endings);
    return store_read(path.string());
}

bool is_stored(Index number, Endings endings) {
    FileTable& table = file_table();
    const std::scoped_lock lock(table.mutex);
    if (number <= 0 || number >= static_cast<Index>(table.files.size())) return number == 0;
    return takes_ending(table.files[static_cast<std::size_t>(number)].name, endings);
}

const StoredFile& stored_file(Index number) {
    FileTable& table = file_table();
    const std::scoped_lock lock(table.mutex);
    return table.files.at(static_cast<std::size_t>(number));
}

}  // namespace pliant
