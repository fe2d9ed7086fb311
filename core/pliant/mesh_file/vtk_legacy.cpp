// The older format of VTK: words, and numbers as text or as bytes with the most significant one first [VTK2006 §14].
#include <pliant/mesh_file/mesh_source.h>
#include <pliant/mesh_file/vtk.h>
#include <pliant/mesh_file/vtk_cells.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>

namespace pliant {
namespace {

struct VtkNumberType {
    std::string_view name;
    std::size_t bytes;
};
constexpr std::array<VtkNumberType, 20> vtk_number_types{
    {{"bit", 0},           {"unsigned_char", 1}, {"char", 1},          {"unsigned_short", 2}, {"short", 2},
     {"unsigned_int", 4},  {"int", 4},           {"unsigned_long", 8}, {"long", 8},           {"vtkidtype", 4},
     {"vtktypeint8", 1},   {"vtktypeuint8", 1},  {"vtktypeint16", 2},  {"vtktypeuint16", 2},  {"vtktypeint32", 4},
     {"vtktypeuint32", 4}, {"vtktypeint64", 8},  {"vtktypeuint64", 8}, {"float", 4},          {"double", 8}}};

constexpr Real largest_whole = 9e15;  // that a Real holds exactly

std::string in_small_letters(std::string_view text) {
    std::string small(text);
    std::ranges::transform(small, small.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return small;
}

class VtkLegacyReader {
public:
    VtkLegacyReader(std::string_view bytes, std::string_view path) : source_(bytes, path) {}

    MeshFile read() {
        if (!source_.line().starts_with("# vtk DataFile Version"))
            source_.refuse("a VTK file begins with # vtk DataFile Version");
        source_.line();  // its title
        const std::string coding = in_small_letters(source_.line());
        if (coding != "ascii" && coding != "binary") source_.refuse("the third line is neither ASCII nor BINARY");
        binary_ = coding == "binary";
        if (in_small_letters(source_.word()) != "dataset") source_.refuse("the fourth line begins with DATASET");
        const std::string kind = in_small_letters(source_.word());
        if (kind != "unstructured_grid" && kind != "polydata")
            source_.refuse(fmt::format("a data set of the kind {} is not read: UNSTRUCTURED_GRID and POLYDATA are",
                                       MeshSource::printable(kind)));
        while (source_.peek_word()) read_part(in_small_letters(source_.word()));
        if (!points_) source_.refuse("POINTS are missing");
        return make();
    }

private:
    struct Cells {
        std::vector<std::int64_t> offsets{0}, nodes;
        Index count() const { return static_cast<Index>(offsets.size()) - 1; }
    };

    void read_part(const std::string& name) {
        if (name == "points") {
            const Index count = source_.whole_word();
            const std::vector<Real> x = numbers(count, 3, source_.word(), "points");
            points_ = Eigen::Map<const Points<3>>(x.data(), 3, count);
        } else if (name == "cells") {
            cells_ = read_cells();
        } else if (name == "polygons") {
            cells_ = read_cells();
            types_.assign(static_cast<std::size_t>(cells_.count()), 5);
        } else if (name == "cell_types") {
            types_ = wholes(source_.whole_word(), "int", "types of cells");
        } else if (name == "point_data" || name == "cell_data") {
            rows_ = source_.whole_word(), arrays_ = name == "point_data" ? &point_arrays_ : &cell_arrays_;
        } else if (name == "metadata") {
            while (!source_.at_end() && !source_.line().empty()) {
            }
        } else if (!read_array(name)) {
            source_.refuse(fmt::format("'{}' is not read here", MeshSource::printable(name)));
        }
    }

    // Of version 4 "CELLS n size": n times a count and as many points. Of version 5 "CELLS n+1 size", OFFSETS and CONNECTIVITY.
    Cells read_cells() {
        const Index first = source_.whole_word(), size = source_.whole_word();
        Cells cells;
        if (const auto word = source_.peek_word(); word && in_small_letters(*word) == "offsets") {
            source_.word();
            cells.offsets = wholes(first, source_.word(), "offsets");
            if (in_small_letters(source_.word()) != "connectivity") source_.refuse("CONNECTIVITY is missing");
            cells.nodes = wholes(size, source_.word(), "nodes of cells");
            if (cells.offsets.empty() || cells.offsets.front() != 0 || cells.offsets.back() != size ||
                !std::ranges::is_sorted(cells.offsets))
                source_.refuse("the offsets of the cells do not go from 0 to their number of points");
            return cells;
        }
        const std::vector<std::int64_t> all = wholes(size, "int", "numbers of cells");
        for (std::size_t at = 0; at < all.size();) {
            const std::int64_t count = all[at++];
            if (count < 0 || static_cast<std::size_t>(count) > all.size() - at)
                source_.refuse(fmt::format("cell {} has {} points", cells.count(), count));
            for (std::int64_t k = 0; k < count; ++k) cells.nodes.push_back(all[at++]);
            cells.offsets.push_back(static_cast<std::int64_t>(cells.nodes.size()));
        }
        if (cells.count() != first) source_.refuse(fmt::format("{} cells are announced, but {} are there", first, cells.count()));
        return cells;
    }

    void take(std::string name, Index components, Index rows, std::string_view type, bool begin_here = false) {
        VtkArray array{
            .name = std::move(name), .components = components, .values = numbers(rows, components, type, "numbers", begin_here)};
        if (arrays_) arrays_->push_back(std::move(array));
    }

    bool read_array(const std::string& kind) {
        if (kind == "field") return read_field_arrays(), true;
        if (!arrays_) return false;
        if (kind == "scalars") {
            const std::string name(source_.word()), type(source_.word());
            const auto rest = source_.line();
            const Index components = rest.empty() ? 1 : MeshSource(rest, "").whole_word();
            if (const auto word = source_.peek_word(); word && in_small_letters(*word) == "lookup_table") source_.line();
            return take(name, components, rows_, type, true), true;
        }
        const Index components = kind == "vectors" || kind == "normals" ? 3 : kind == "tensors" ? 9 : 0;
        if (components > 0) {
            const std::string name(source_.word()), type(source_.word());
            return take(name, components, rows_, type), true;
        }
        if (kind != "texture_coordinates") return false;
        const std::string name(source_.word());
        const Index count = source_.whole_word();
        return take(name, count, rows_, source_.word()), true;
    }

    void read_field_arrays() {
        source_.word();  // the name of all of them
        const Index count = source_.checked_count(source_.whole_word(), "arrays", 4);
        for (Index k = 0; k < count; ++k) {
            std::string name(source_.word());
            if (in_small_letters(name) == "metadata") {
                while (!source_.at_end() && !source_.line().empty()) {
                }
                name = source_.word();
            }
            const Index components = source_.whole_word(), rows = source_.whole_word();
            take(std::move(name), components, rows, source_.word());
        }
    }

    // They begin here, or behind this line.
    std::vector<Real> numbers(Index rows, Index components, std::string_view type, std::string_view what,
                              bool begin_here = false) {
        const std::string wanted = in_small_letters(type);
        const auto known = std::ranges::find(vtk_number_types, wanted, &VtkNumberType::name);
        if (known == vtk_number_types.end() || (binary_ && known->bytes == 0))
            source_.refuse(fmt::format("numbers of the type {} are not read", MeshSource::printable(wanted)));
        if (rows < 0 || components < 0 || components > 1000 || rows > (Index{1} << 40))
            source_.refuse(fmt::format("{} × {} {} are more than can be read", rows, components, what));
        const Index count = source_.checked_count(rows * components, what, binary_ ? known->bytes : 2);
        std::vector<Real> values(static_cast<std::size_t>(count));
        if (!binary_) {
            for (Real& v : values) v = source_.real_word();
            return values;
        }
        if (!begin_here) source_.line();
        source_.be_binary(std::endian::native == std::endian::little);
        const bool is_real = wanted == "float" || wanted == "double",
                   is_signed = !wanted.starts_with("unsigned") && !wanted.starts_with("vtktypeu");
        for (Real& v : values) v = source_.number_of(known->bytes, is_real, is_signed);
        source_.be_text();
        return values;
    }

    std::vector<std::int64_t> wholes(Index count, std::string_view type, std::string_view what) {
        std::vector<std::int64_t> list;
        for (const Real v : numbers(count, 1, type, what)) {
            if (!(std::abs(v) < largest_whole) || v != std::floor(v)) source_.refuse(fmt::format("{} among the {}", v, what));
            list.push_back(static_cast<std::int64_t>(v));
        }
        return list;
    }

    MeshFile make() {
        if (cells_.count() != static_cast<Index>(types_.size()))
            source_.refuse(fmt::format("{} cells have {} types", cells_.count(), types_.size()));
        VtkCells cells(std::move(*points_), [this](const std::string& what) { source_.refuse(what); });
        for (std::size_t c = 0; c < types_.size(); ++c) {
            const auto begin = static_cast<std::size_t>(cells_.offsets[c]), end = static_cast<std::size_t>(cells_.offsets[c + 1]);
            cells.add(types_[c], std::span(cells_.nodes).subspan(begin, end - begin));
        }
        for (const VtkArray& a : point_arrays_) cells.name_points(a);
        for (const VtkArray& a : cell_arrays_) cells.name_cells(a);
        return cells.finish();
    }

    MeshSource source_;
    bool binary_ = false;
    std::optional<Points<3>> points_;
    Cells cells_;
    std::vector<std::int64_t> types_;
    Index rows_ = 0;
    std::vector<VtkArray> point_arrays_, cell_arrays_, *arrays_ = nullptr;
};

}  // namespace

MeshFile parse_vtk_legacy(std::string_view bytes, std::string_view path) { return VtkLegacyReader(bytes, path).read(); }

}  // namespace pliant
