#include <pliant/lesson/lesson.h>
#include <pliant/lesson/scene.h>

#include <algorithm>

namespace pliant {

void Scene::clear() {
    grids.clear();
    triangles.clear();
    lines.clear();
    points.clear();
    arrows.clear();
    labels.clear();
    matrices.clear();
    notes.clear();
}

std::vector<float> Scene::values(const Lesson& lesson, On on) const {
    const Field* field = lesson.find_field(colour_by.field);
    if (!field || field->on != on || !field->in_use()) return {};
    // A field is looked at once: its numbers may be computed when they are asked for.
    std::vector<Real> own;
    row_values(*field, colour_by.component, own);
    const std::vector<Real>& shown = override_values && override_values->size() == own.size() ? *override_values : own;
    std::vector<float> numbers(shown.size());
    std::ranges::transform(shown, numbers.begin(), [](Real x) { return static_cast<float>(x); });
    return numbers;
}

bool Scene::awaits(std::string_view field) const { return std::ranges::find(awaited, field) != awaited.end(); }

void Scene::frame(const Position& lower_corner, const Position& upper_corner) { lower = lower_corner, upper = upper_corner; }

void Scene::arrow(const Position& from, const Position& to, Ink ink, std::string text) {
    arrows.push_back({.from = {from}, .to = {to}, .ink = ink});
    if (!text.empty()) labels.push_back({.at = to, .text = std::move(text), .ink = ink, .away_from = from});
}

void Scene::line(const Position& from, const Position& to, Ink ink, float width, bool dashed) {
    lines.push_back({.ends = {from, to}, .ink = ink, .width = width, .dashed = dashed});
}

void Scene::label(const Position& at, std::string text, Ink ink, float offset_x, float offset_y) {
    labels.push_back({at, std::move(text), ink, offset_x, offset_y});
}

void Scene::dimension_line(const Position& from, const Position& to, std::string text, float offset_x, float offset_y) {
    arrows.push_back({.from = {from, to}, .to = {to, from}, .ink = Ink::text, .width = 1.5f});
    const Position middle{(from[0] + to[0]) / 2, (from[1] + to[1]) / 2, (from[2] + to[2]) / 2};
    label(middle, std::move(text), Ink::text, offset_x, offset_y);
}

void Scene::box(const Position& a, const Position& b, Ink ink, float width, bool dashed) {
    const auto corner = [&](int i) { return Position{i & 1 ? b[0] : a[0], i & 2 ? b[1] : a[1], i & 4 ? b[2] : a[2]}; };
    LineMarks marks{.ends = {}, .ink = ink, .width = width, .dashed = dashed};
    const int corners = a[2] == b[2] ? 4 : 8;
    for (int i = 0; i < corners; ++i)
        for (int axis = 1; axis < corners; axis *= 2)
            if (!(i & axis)) marks.ends.push_back(corner(i)), marks.ends.push_back(corner(i | axis));
    lines.push_back(std::move(marks));
}

}  // namespace pliant
