#include <pliant/text/suggest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace pliant {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({changed, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

// A lesson may be named without its chapter.
std::string_view last_part(std::string_view word) { return word.substr(word.rfind('/') + 1); }

}  // namespace

std::string nearest(std::string_view word, std::span<const std::string> known) {
    std::string best;
    std::size_t smallest = std::string::npos;
    for (const std::string& k : known) {
        const std::size_t d = std::min(edit_distance(word, k), edit_distance(word, last_part(k)));
        if (d < smallest) smallest = d, best = k;
    }
    return smallest <= std::max<std::size_t>(2, word.size() / 3) ? best : "";
}

std::string did_you_mean(std::string_view word, std::span<const std::string> known) {
    const std::string near = nearest(word, known);
    return near.empty() ? "" : " (did you mean '" + near + "'?)";
}

}  // namespace pliant
