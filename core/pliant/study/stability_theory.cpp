#include <pliant/study/stability_theory.h>

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

// Where every step or none is stable the logarithm is infinite; this is far on either side.
constexpr Real far = 50;

Real clamped_log(Real ratio) { return ratio <= 0 ? -far : std::clamp(std::log(ratio), -far, far); }

// Logarithms of the ratios at the centres, with one more line around them, half a cell out, by carrying on what is inside.
class LogRatios {
public:
    explicit LogRatios(const StabilityMap& map) : map_(map), nx_(map.columns()), ny_(map.rows()) {}

    // i and j from -1 to the number of cells. Empty where theory says nothing.
    std::optional<Real> at(Index i, Index j) const {
        if (i < 0) return beyond(at(0, j), at(1, j));
        if (i >= nx_) return beyond(at(nx_ - 1, j), at(nx_ - 2, j));
        if (j < 0) return beyond(at(i, 0), at(i, 1));
        if (j >= ny_) return beyond(at(i, ny_ - 1), at(i, ny_ - 2));
        const auto ratio = map_.at(i, j).theory;
        return ratio ? std::optional(clamped_log(*ratio)) : std::nullopt;
    }
    Real across(Index i) const { return std::clamp(static_cast<Real>(i), Real{-0.5}, static_cast<Real>(nx_) - 0.5); }
    Real up(Index j) const { return std::clamp(static_cast<Real>(j), Real{-0.5}, static_cast<Real>(ny_) - 0.5); }

private:
    static std::optional<Real> beyond(std::optional<Real> edge, std::optional<Real> inner) {
        if (!edge || !inner) return std::nullopt;
        return std::abs(*edge) == far || std::abs(*inner) == far ? *edge : *edge + 0.5 * (*edge - *inner);
    }
    const StabilityMap& map_;
    const Index nx_, ny_;
};

struct Corner {
    MapPlace at;
    Real value;
};

MapPlace zero_between(const Corner& a, const Corner& b) {
    const Real s = a.value / (a.value - b.value);
    return {a.at.across + s * (b.at.across - a.at.across), a.at.up + s * (b.at.up - a.at.up)};
}

// The straight bound within a triangle.
void cut(const std::array<Corner, 3>& triangle, std::vector<std::array<MapPlace, 2>>& segments) {
    std::vector<MapPlace> ends;
    for (std::size_t k = 0; k < 3; ++k) {
        const Corner &a = triangle[k], &b = triangle[(k + 1) % 3];
        if ((a.value <= 0) != (b.value <= 0)) ends.push_back(zero_between(a, b));
    }
    if (ends.size() == 2) segments.push_back({ends[0], ends[1]});
}

// Four triangles about the middle, so that no direction is preferred.
void cut_square(const LogRatios& logs, Index i, Index j, std::vector<std::array<MapPlace, 2>>& segments) {
    std::array<Corner, 4> corners;
    Corner middle{{0, 0}, 0};
    constexpr std::array<std::array<Index, 2>, 4> around{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t k = 0; k < 4; ++k) {
        const Index ci = i + around[k][0], cj = j + around[k][1];
        const auto value = logs.at(ci, cj);
        if (!value) return;
        corners[k] = {{logs.across(ci), logs.up(cj)}, *value};
        middle.at.across += corners[k].at.across / 4, middle.at.up += corners[k].at.up / 4, middle.value += *value / 4;
    }
    for (std::size_t k = 0; k < 4; ++k) cut({corners[k], corners[(k + 1) % 4], middle}, segments);
}

// Options stand beside one another: the bound crosses each of their rows or columns by itself.
void cut_line(const LogRatios& logs, Index i, Index j, bool along_x, std::vector<std::array<MapPlace, 2>>& segments) {
    const auto a = logs.at(i, j), b = along_x ? logs.at(i + 1, j) : logs.at(i, j + 1);
    if (!a || !b || (*a <= 0) == (*b <= 0)) return;
    const Real s = *a / (*a - *b);
    if (along_x) {
        const Real x = logs.across(i) + s * (logs.across(i + 1) - logs.across(i)), y = static_cast<Real>(j);
        segments.push_back({MapPlace{x, y - 0.5}, MapPlace{x, y + 0.5}});
    } else {
        const Real y = logs.up(j) + s * (logs.up(j + 1) - logs.up(j)), x = static_cast<Real>(i);
        segments.push_back({MapPlace{x - 0.5, y}, MapPlace{x + 0.5, y}});
    }
}

bool is_named(const StabilityMap& map, const Knob& knob) {
    if (knob.spacing != Spacing::list) return false;
    const auto lesson = map.order.lesson->make();
    return lesson->parameter(knob.key).info.has_options();
}

bool measured(const MapCell& c) {
    return c.theory && c.verdict.kind != Stability::refused && c.verdict.kind != Stability::not_converged;
}

bool contradicts(const MapCell& c) { return measured(c) && c.predicted_stable() == (c.verdict.kind == Stability::diverged); }

// Has a cell at most one away the other prediction?
bool beside_bound(const StabilityMap& map, Index i, Index j) {
    const bool here = map.at(i, j).predicted_stable();
    for (Index b = std::max<Index>(0, j - 1); b <= std::min(map.rows() - 1, j + 1); ++b)
        for (Index a = std::max<Index>(0, i - 1); a <= std::min(map.columns() - 1, i + 1); ++a)
            if (map.at(a, b).theory && map.at(a, b).predicted_stable() != here) return true;
    return false;
}

}  // namespace

std::vector<std::array<MapPlace, 2>> theory_bound(const StabilityMap& map) {
    std::vector<std::array<MapPlace, 2>> segments;
    if (map.cells.empty()) return segments;
    const LogRatios logs(map);
    const bool names_across = is_named(map, map.order.across), names_up = is_named(map, map.order.up);
    if (names_across && names_up) return segments;
    for (Index j = names_up ? 0 : -1; j < map.rows(); ++j)
        for (Index i = names_across ? 0 : -1; i < map.columns(); ++i)
            names_across || names_up ? cut_line(logs, i, j, names_up, segments) : cut_square(logs, i, j, segments);
    return segments;
}

bool contradicts_theory(const StabilityMap& map, Index i, Index j) {
    return contradicts(map.at(i, j)) && !beside_bound(map, i, j);
}

std::optional<Agreement> agreement(const StabilityMap& map) {
    Agreement found;
    bool theory = false;
    for (Index j = 0; j < map.rows(); ++j)
        for (Index i = 0; i < map.columns(); ++i) {
            const MapCell& c = map.at(i, j);
            theory = theory || c.theory;
            if (!measured(c)) continue;
            ++found.compared;
            if (contradicts(c)) ++(beside_bound(map, i, j) ? found.at_bound : found.contradicts);
        }
    return theory ? std::optional(found) : std::nullopt;
}

Real knob_value(const Knob& knob, Real place) {
    const auto last = static_cast<Real>(knob.values.size()) - 1;
    const Real a = knob.values.front(), b = knob.values.back();
    if (knob.spacing == Spacing::log) return a * std::pow(b / a, place / last);
    if (knob.spacing == Spacing::linear) return a + (b - a) * place / last;
    return knob.values[static_cast<std::size_t>(std::clamp(std::round(place), Real{0}, last))];
}

std::optional<Real> knob_place(const Knob& knob, Real value) {
    const auto last = static_cast<Real>(knob.values.size()) - 1;
    const Real a = knob.values.front(), b = knob.values.back();
    Real place = -1;
    if (knob.spacing == Spacing::list) {
        const auto found = std::ranges::find(knob.values, value);
        if (found == knob.values.end()) return std::nullopt;
        place = static_cast<Real>(found - knob.values.begin());
    } else if (knob.spacing == Spacing::log) {
        place = value > 0 ? last * std::log(value / a) / std::log(b / a) : -1;
    } else {
        place = last * (value - a) / (b - a);
    }
    if (!(place >= -0.5 && place <= last + 0.5)) return std::nullopt;
    return place;
}

}  // namespace pliant
