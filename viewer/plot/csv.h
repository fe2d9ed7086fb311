// The samples of a plot as text that a spreadsheet reads.
#pragma once
#include <pliant/math/types.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pliant::viewer {

struct CsvSeries {
    std::string_view name;
    std::span<const Real> xs, ys;
};

// Comma-separated values (RFC 4180) with units in the header: "time t [s],kinetic [J],total [J]". Series with the same x share
// its column; others bring their own. Numbers read back exactly; one that is not finite leaves its cell empty.
std::string to_csv(std::string_view x_label, std::string_view x_unit, std::string_view y_unit, std::span<const CsvSeries> series);

// Values of cells, the one of column i and row j at i + nx * j: one line per cell, with its middle.
std::string grid_to_csv(std::string_view x_header, std::string_view y_header, std::string_view value_header,
                        std::span<const Real> xs, std::span<const Real> ys, std::span<const Real> values);

// "energy [J]"; the name alone when dimensionless.
std::string with_unit(std::string_view name, std::string_view unit);

}  // namespace pliant::viewer
