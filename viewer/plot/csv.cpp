#include "plot/csv.h"

#include <pliant/text/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::viewer {
namespace {

std::string quoted(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"') result += '"';
        result += c;
    }
    return result + '"';
}

std::string cell(std::span<const Real> column, std::size_t row) {
    return row < column.size() && std::isfinite(column[row]) ? format_exact(column[row]) : "";
}

bool same(std::span<const Real> a, std::span<const Real> b) {
    return a.size() == b.size() && (a.data() == b.data() || std::equal(a.begin(), a.end(), b.begin()));
}

struct Column {
    std::string header;
    std::span<const Real> values;
};

std::string table(std::span<const Column> columns) {
    std::string text;
    std::size_t rows = 0;
    for (std::size_t c = 0; c < columns.size(); ++c) {
        text += (c > 0 ? "," : "") + quoted(columns[c].header);
        rows = std::max(rows, columns[c].values.size());
    }
    text += "\r\n";
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t c = 0; c < columns.size(); ++c) text += (c > 0 ? "," : "") + cell(columns[c].values, row);
        text += "\r\n";
    }
    return text;
}

}  // namespace

std::string with_unit(std::string_view name, std::string_view unit) {
    return unit.empty() ? std::string(name) : std::string(name) + (name.empty() ? "[" : " [") + std::string(unit) + "]";
}

std::string to_csv(std::string_view x_label, std::string_view x_unit, std::string_view y_unit,
                   std::span<const CsvSeries> series) {
    std::vector<Column> columns;
    std::span<const Real> shared;
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (i == 0 || !same(series[i].xs, shared)) {
            shared = series[i].xs;
            columns.push_back({with_unit(x_label, x_unit), shared});
        }
        columns.push_back({with_unit(series[i].name, y_unit), series[i].ys});
    }
    return table(columns);
}

std::string grid_to_csv(std::string_view x_header, std::string_view y_header, std::string_view value_header,
                        std::span<const Real> xs, std::span<const Real> ys, std::span<const Real> values) {
    std::string text = quoted(x_header) + "," + quoted(y_header) + "," + quoted(value_header) + "\r\n";
    for (std::size_t j = 0; j < ys.size(); ++j) {
        for (std::size_t i = 0; i < xs.size(); ++i)
            text += cell(xs, i) + "," + cell(ys, j) + "," + cell(values, i + xs.size() * j) + "\r\n";
    }
    return text;
}

}  // namespace pliant::viewer
