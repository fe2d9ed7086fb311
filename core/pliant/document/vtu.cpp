#include <pliant/document/vtu.h>
#include <pliant/lesson/unstructured_grid.h>
#include <pliant/text/sha256.h>

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <type_traits>

namespace pliant {
namespace {

constexpr std::string_view vtk_byte_order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";

// Of the cell kinds, in their order.
constexpr std::array<int, 9> vtk_codes{1, 3, 5, 9, 10, 12, 21, 22, 24};

std::string xml_text(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        if (c == '&')
            safe += "&amp;";
        else if (c == '<')
            safe += "&lt;";
        else if (c == '"')
            safe += "&quot;";
        else
            safe += c;
    }
    return safe;
}

template <class T>
constexpr std::string_view vtk_type_name() {
    if constexpr (std::is_same_v<T, double>) return "Float64";
    if constexpr (std::is_same_v<T, std::int64_t>) return "Int64";
    return "UInt8";
}

// The number of bytes, and they, in one text.
template <class T>
std::string data_array(std::string_view name, std::string_view unit, Index components, const std::vector<T>& values,
                       std::string_view more = "") {
    const std::uint64_t size = values.size() * sizeof(T);
    std::string bytes(sizeof size + size, '\0');
    std::memcpy(bytes.data(), &size, sizeof size);
    if (size > 0) std::memcpy(bytes.data() + sizeof size, values.data(), size);
    const std::string columns = components == 1 ? "" : fmt::format(" NumberOfComponents=\"{}\"", components);
    return fmt::format("<DataArray type=\"{}\" Name=\"{}\"{}{}{} format=\"binary\">{}</DataArray>\n", vtk_type_name<T>(),
                       xml_text(name), unit.empty() ? "" : fmt::format(" unit=\"{}\"", xml_text(unit)), columns, more,
                       base64(bytes));
}

// A row as VTK expects it: vectors with three numbers, tensors with nine.
struct FieldRows {
    Index rows = 0, components = 1;
    std::vector<double> values;
};
FieldRows rows_of(const Field& f) {
    const auto view = f.view();
    const bool flat = f.rank != Rank::scalar && (f.components == 2 || f.components == 4);
    const int dim = f.rank == Rank::tensor ? (f.components == 4 ? 2 : 3) : f.components, lines = f.rank == Rank::tensor ? dim : 1;
    FieldRows all{.rows = f.size(), .components = flat ? (f.rank == Rank::tensor ? 9 : 3) : f.components, .values = {}};
    for (Index r = 0; r < all.rows; ++r)
        for (int line = 0; line < (flat && lines == 2 ? 3 : lines); ++line)
            for (int k = 0; k < (flat ? 3 : dim); ++k) {
                const bool there = line < lines && k < dim;
                const Real value = there ? view[static_cast<std::size_t>(r * f.components + line * dim + k)] : 0;
                if (!std::isfinite(value))
                    throw Refused(
                        fmt::format("{} of {} {} is not finite ({}): it is not written", f.name, name_of(f.on), r, value));
                all.values.push_back(value);
            }
    return all;
}

std::string cells_text(const UnstructuredGrid& grid) {
    std::vector<std::int64_t> nodes, ends;
    std::vector<std::uint8_t> codes;
    for (const CellBlock& block : grid.cells)
        for (Index c = 0; c < block.nodes.cols(); ++c) {
            for (Index a = 0; a < block.nodes.rows(); ++a) nodes.push_back(block.nodes(a, c));
            ends.push_back(static_cast<std::int64_t>(nodes.size()));
            codes.push_back(static_cast<std::uint8_t>(vtk_codes[static_cast<std::size_t>(block.kind)]));
        }
    return data_array("connectivity", "", 1, nodes) + data_array("offsets", "", 1, ends) + data_array("types", "", 1, codes);
}

std::string points_text(const UnstructuredGrid& grid) {
    std::vector<double> x(grid.points.data(), grid.points.data() + grid.points.size());
    for (const Real v : x)
        if (!std::isfinite(v)) throw Refused(fmt::format("a place of a point is not finite ({}): it is not written", v));
    return data_array("Points", "m", 3, x);
}

}  // namespace

void require_grid(const LessonEntry& entry, const Lesson& lesson) {
    if (!lesson.unstructured_grid())
        throw Refused(
            fmt::format("{} has no body and no grid that could be written as VTU: --csv writes its probes, --json with "
                        "--fields its fields",
                        entry.info.id));
}

std::string vtu_text(const LessonEntry& entry, const Lesson& lesson, Real time) {
    require_grid(entry, lesson);
    const UnstructuredGrid grid = *lesson.unstructured_grid();
    std::string of_points, of_cells;
    std::string apart = data_array("TimeValue", "", 1, std::vector<double>{time}, " NumberOfTuples=\"1\"");
    for (const Field& f : lesson.fields) {
        if (!f.in_use()) continue;
        const FieldRows all = rows_of(f);
        const std::string tuples = fmt::format(" NumberOfTuples=\"{}\"", all.rows);
        if (grid.of_points(f.on, all.rows))
            of_points += data_array(f.name, f.unit, all.components, all.values);
        else if (grid.of_cells(f.on, all.rows))
            of_cells += data_array(f.name, f.unit, all.components, all.values);
        else
            apart += data_array(f.name, f.unit, all.components, all.values, tuples);
    }
    return fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\">\n"
        "<UnstructuredGrid>\n<FieldData>\n{}</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n"
        "<Points>\n{}</Points>\n<Cells>\n{}</Cells>\n<PointData>\n{}</PointData>\n<CellData>\n{}</CellData>\n"
        "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n",
        vtk_byte_order, apart, grid.points.cols(), grid.cell_count(), points_text(grid), cells_text(grid), of_points, of_cells);
}

std::string pvd_text(const std::vector<VtuFrame>& frames) {
    std::string list;
    for (const VtuFrame& f : frames)
        list += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", f.time, xml_text(f.path));
    return fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"{}\">\n<Collection>\n{}"
        "</Collection>\n</VTKFile>\n",
        vtk_byte_order, list);
}

}  // namespace pliant
