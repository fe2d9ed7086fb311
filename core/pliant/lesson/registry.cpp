#include <pliant/lesson/registry.h>
#include <pliant/text/suggest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pliant {
namespace {

// The order of the lectures.
constexpr std::array<std::string_view, 7> chapters{"elasticity", "time", "mesh", "meshfree", "reduced", "fluids", "compare"};

std::vector<LessonEntry>& entries() {
    static std::vector<LessonEntry> all;
    return all;
}

auto place(const LessonEntry& e) { return std::pair(std::ranges::find(chapters, e.chapter()) - chapters.begin(), e.info.id); }

}  // namespace

// Registration runs before main in whatever order the linker chose, so the list is kept sorted.
void register_lesson(const LessonEntry& entry) {
    auto& all = entries();
    all.insert(std::ranges::upper_bound(all, place(entry), {}, place), entry);
}

const std::vector<LessonEntry>& lessons() { return entries(); }

const LessonEntry& find_lesson(std::string_view name) {
    std::vector<std::string> known;
    for (const LessonEntry& e : entries()) {
        const std::string_view id = e.info.id;
        if (id == name || id.substr(id.find('/') + 1) == name) return e;
        known.emplace_back(id);
    }
    throw Refused(fmt::format("no lesson is called '{}'{}; `pliant list` shows them all", name, did_you_mean(name, known)));
}

}  // namespace pliant
