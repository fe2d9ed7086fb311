#include <pliant/lesson/array.h>

#include <cmath>

namespace pliant {

std::string_view name_of(On on) {
    switch (on) {
        case On::node:
            return "node";
        case On::edge:
            return "edge";
        case On::face:
            return "face";
        case On::cell:
            return "cell";
        case On::element:
            return "element";
        case On::particle:
            return "particle";
        case On::x_face:
            return "x_face";
        case On::y_face:
            return "y_face";
        case On::handle:
            return "handle";
    }
    return "";
}

std::string_view name_of(Rank rank) {
    switch (rank) {
        case Rank::scalar:
            return "scalar";
        case Rank::vector:
            return "vector";
        case Rank::tensor:
            return "tensor";
    }
    return "";
}

std::vector<std::string> component_names(const Field& field) {
    constexpr std::string_view axes = "xyz";
    if (field.rank == Rank::scalar) return {""};
    std::vector<std::string> names;
    if (field.rank == Rank::vector) {
        for (int c = 0; c < field.components; ++c) names.emplace_back(1, axes[static_cast<std::size_t>(c)]);
        return names;
    }
    const int dim = field.components == 4 ? 2 : 3;
    for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j) names.push_back({axes[static_cast<std::size_t>(i)], axes[static_cast<std::size_t>(j)]});
    return names;
}

namespace {
Real reduce(const Real* row, int components, int component) {
    if (component >= 0) return row[component];
    if (components == 1) return row[0];
    Real sum = 0;
    for (int c = 0; c < components; ++c) sum += row[c] * row[c];
    return std::sqrt(sum);
}
}  // namespace

void row_values(const Field& field, int component, std::vector<Real>& values) {
    row_values(field, field.view(), component, values);
}

void row_values(const Field& field, std::span<const Real> numbers, int component, std::vector<Real>& values) {
    const std::size_t width = static_cast<std::size_t>(field.components);
    values.resize(numbers.size() / width);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = reduce(numbers.data() + i * width, field.components, component);
}

Real row_value(const Field& field, Index row, int component) {
    return reduce(field.view().data() + row * field.components, field.components, component);
}

}  // namespace pliant
