// The XML format of VTK [VTK2006 §14].
#include <pliant/math/error.h>
#include <pliant/mesh_file/mesh_source.h>
#include <pliant/mesh_file/vtk.h>
#include <pliant/mesh_file/vtk_cells.h>
#include <pliant/text/base64_stream.h>
#include <zlib.h>

#include <fmt/format.h>
#include <pugixml.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

namespace pliant {
namespace {

struct VtuNumberType {
    std::string_view name;
    std::size_t bytes;
    bool is_real, is_signed;
};
constexpr std::array<VtuNumberType, 10> vtu_number_types{{{"Int8", 1, false, true},
                                                          {"UInt8", 1, false, false},
                                                          {"Int16", 2, false, true},
                                                          {"UInt16", 2, false, false},
                                                          {"Int32", 4, false, true},
                                                          {"UInt32", 4, false, false},
                                                          {"Int64", 8, false, true},
                                                          {"UInt64", 8, false, false},
                                                          {"Float32", 4, true, true},
                                                          {"Float64", 8, true, true}}};
constexpr Real largest_vtu_whole = 9e15;
constexpr std::size_t most_array_bytes = std::size_t{1} << 30;

class VtuReader {
public:
    VtuReader(std::string_view bytes, std::string_view path) : path_(path) {
        // Raw bytes are no XML: they are cut off first, and so is base64, which nobody needs to look through.
        const std::size_t appended = bytes.find("<AppendedData");
        std::string text(bytes.substr(0, appended));
        if (appended != std::string_view::npos) {
            const std::string_view rest = bytes.substr(appended);
            const std::size_t head = rest.find('>'), mark = rest.find('_', head == std::string_view::npos ? rest.size() : head);
            if (mark == std::string_view::npos) refuse("<AppendedData> has no '_', with which its numbers begin");
            raw_ = rest.substr(0, head).find("\"raw\"") != std::string_view::npos;
            appended_ = rest.substr(mark + 1);
            text += "</VTKFile>";
        }
        const pugi::xml_parse_result read = document_.load_buffer(text.data(), text.size());
        if (!read) refuse(fmt::format("this is no XML: {} at byte {}", read.description(), read.offset));
    }

    MeshFile read() {
        const pugi::xml_node root = document_.child("VTKFile");
        if (!root) refuse("a file .vtu begins with <VTKFile>");
        const std::string_view kind = root.attribute("type").value();
        if (kind != "UnstructuredGrid")
            refuse(fmt::format("a file of the type '{}' is not read: UnstructuredGrid is", clean(kind)));
        swapped_ =
            (root.attribute("byte_order").value() == std::string_view("BigEndian")) != (std::endian::native == std::endian::big);
        header_bytes_ = root.attribute("header_type").value() == std::string_view("UInt64") ? 8 : 4;
        const std::string_view compressor = root.attribute("compressor").value();
        if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
            refuse(fmt::format("numbers packed by {} are not read: save the file with zlib, or unpacked", clean(compressor)));
        compressed_ = !compressor.empty();
        const pugi::xml_node grid = root.child("UnstructuredGrid"), piece = grid.child("Piece");
        if (!piece) refuse("<UnstructuredGrid> has no <Piece>");
        if (piece.next_sibling("Piece")) refuse("a grid in several pieces is not read: save it as one");
        return read_piece(piece);
    }

private:
    [[noreturn]] void refuse(const std::string& what) const { throw Refused(fmt::format("{}: {}", path_, what)); }
    static std::string clean(std::string_view text) { return MeshSource::printable(text); }

    Index count_at(const pugi::xml_node& piece, const char* name) const {
        const Index count = piece.attribute(name).as_llong(-1);
        if (count < 0 || count > std::numeric_limits<int>::max()) refuse(fmt::format("{} of <Piece> is no number of them", name));
        return count;
    }

    MeshFile read_piece(const pugi::xml_node& piece) {
        const Index points = count_at(piece, "NumberOfPoints"), cells = count_at(piece, "NumberOfCells");
        const std::vector<Real> x = rows_of(piece.child("Points").child("DataArray"), "points", points, 3);
        VtkCells all(Eigen::Map<const Points<3>>(x.data(), 3, points), [this](const std::string& what) { refuse(what); });
        const auto array = [&](std::string_view name) {
            for (const pugi::xml_node& a : piece.child("Cells").children("DataArray"))
                if (a.attribute("Name").value() == name) return a;
            refuse(fmt::format("<Cells> has no array '{}'", name));
        };
        const auto ends = wholes(rows_of(array("offsets"), "offsets", cells, 1), "offsets"),
                   types = wholes(rows_of(array("types"), "types", cells, 1), "types"),
                   nodes =
                       wholes(rows_of(array("connectivity"), "connectivity", ends.empty() ? 0 : ends.back(), 1), "connectivity");
        for (std::size_t c = 0; c < ends.size(); ++c) {
            const std::int64_t begin = c == 0 ? 0 : ends[c - 1];
            if (begin < 0 || ends[c] < begin || ends[c] > static_cast<std::int64_t>(nodes.size()))
                refuse(fmt::format("cell {} ends at {}, where the one before it ends at {}", c, ends[c], begin));
            all.add(types[c],
                    std::span(nodes).subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(ends[c] - begin)));
        }
        for (const pugi::xml_node& a : piece.child("PointData").children("DataArray"))
            if (auto flags = flags_of(a, points)) all.name_points(*flags);
        for (const pugi::xml_node& a : piece.child("CellData").children("DataArray"))
            if (auto flags = flags_of(a, cells)) all.name_cells(*flags);
        return all.finish();
    }

    // Of one component; others name no sets.
    std::optional<VtkArray> flags_of(const pugi::xml_node& array, Index rows) const {
        if (array.attribute("NumberOfComponents").as_llong(1) != 1 ||
            array.attribute("type").value() == std::string_view("String"))
            return std::nullopt;
        const std::string name = array.attribute("Name").value();
        return VtkArray{.name = name, .components = 1, .values = rows_of(array, name, rows, 1)};
    }

    std::vector<std::int64_t> wholes(const std::vector<Real>& values, std::string_view what) const {
        std::vector<std::int64_t> list;
        for (const Real v : values) {
            if (!(std::abs(v) < largest_vtu_whole) || v != std::floor(v)) refuse(fmt::format("{} among the {}", v, what));
            list.push_back(static_cast<std::int64_t>(v));
        }
        return list;
    }

    // -------------------------------------------------------------------------------------------------------- numbers

    std::vector<Real> rows_of(const pugi::xml_node& array, std::string_view what, Index rows, Index components) const {
        if (!array) refuse(fmt::format("the array of the {} is missing", clean(what)));
        const std::string_view type = array.attribute("type").value(), format = array.attribute("format").value();
        const auto known = std::ranges::find(vtu_number_types, type, &VtuNumberType::name);
        if (known == vtu_number_types.end()) refuse(fmt::format("'{}' has numbers of the type '{}'", clean(what), clean(type)));
        if (rows < 0) refuse(fmt::format("'{}' has {} rows", clean(what), rows));
        const std::size_t count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(components);
        const std::string_view text = array.child_value();
        std::vector<Real> values;
        if (format == "ascii" || format.empty()) {
            const std::string place = fmt::format("{}, array '{}'", path_, clean(what));
            MeshSource source(text, place);
            while (source.peek_word()) values.push_back(source.real_word());
        } else if (format == "binary") {
            values = numbers_in(bytes_of_base64(text, count * known->bytes), *known);
        } else if (format == "appended") {
            const std::size_t offset = array.attribute("offset").as_ullong(std::numeric_limits<unsigned long long>::max());
            if (offset > appended_.size()) refuse(fmt::format("the offset of '{}' is behind the end of the file", clean(what)));
            const std::string_view there = appended_.substr(offset);
            values = numbers_in(raw_ ? bytes_of_raw(there, count * known->bytes) : bytes_of_base64(there, count * known->bytes),
                                *known);
        } else {
            refuse(fmt::format("the format '{}' of '{}' is not read", clean(format), clean(what)));
        }
        if (values.size() != count)
            refuse(fmt::format("'{}' has {} numbers where {} are announced", clean(what), values.size(), count));
        return values;
    }

    std::vector<Real> numbers_in(const std::string& bytes, const VtuNumberType& type) const {
        MeshSource source(bytes, path_);
        source.be_binary(swapped_);
        std::vector<Real> values(bytes.size() / type.bytes);
        for (Real& v : values) v = source.number_of(type.bytes, type.is_real, type.is_signed);
        return values;
    }

    // A number of a header.
    std::size_t header(std::string_view bytes) const {
        MeshSource source(bytes, path_);
        source.be_binary(swapped_);
        const Real value = source.number_of(header_bytes_, false, false);
        if (value > static_cast<Real>(most_array_bytes)) refuse(fmt::format("an array of {} bytes is too large", value));
        return static_cast<std::size_t>(value);
    }

    // `take` gives the next so many bytes. Unpacked: their number, and they. Packed: how many blocks, the size of each and of the
    // last, the packed size of each, and the blocks.
    template <class Take>
    std::string unpacked(Take take, std::size_t expected) const {
        if (!compressed_) {
            const std::size_t size = header(take(header_bytes_));
            if (size > expected) refuse(fmt::format("an array has {} bytes where {} are announced", size, expected));
            return take(size);
        }
        const std::size_t blocks = header(take(header_bytes_)), size = header(take(header_bytes_)),
                          last = header(take(header_bytes_));
        if (blocks == 0) return "";
        const std::size_t all = (blocks - (last > 0 ? 1 : 0)) * size + last;
        if (blocks > expected || all > expected)
            refuse(fmt::format("an array has {} bytes where {} are announced", all, expected));
        std::vector<std::size_t> packed;
        for (std::size_t b = 0; b < blocks; ++b) packed.push_back(header(take(header_bytes_)));
        std::string bytes;
        for (std::size_t b = 0; b < blocks; ++b) {
            const std::string block = take(packed[b]);
            std::string room(b + 1 == blocks && last > 0 ? last : size, '\0');
            uLongf got = static_cast<uLongf>(room.size());
            if (uncompress(reinterpret_cast<Bytef*>(room.data()), &got, reinterpret_cast<const Bytef*>(block.data()),
                           static_cast<uLong>(block.size())) != Z_OK ||
                got != room.size())
                refuse("packed numbers cannot be unpacked");
            bytes += room;
        }
        return bytes;
    }

    std::string bytes_of_raw(std::string_view there, std::size_t expected) const {
        return unpacked(
            [&](std::size_t count) {
                if (count > there.size()) refuse("the file ends in the middle of an array");
                const std::string part(there.substr(0, count));
                there.remove_prefix(count);
                return part;
            },
            expected);
    }

    std::string bytes_of_base64(std::string_view text, std::size_t expected) const {
        Base64Stream stream(text);
        return unpacked(
            [&](std::size_t count) {
                const auto part = stream.read(count);
                if (!part) refuse("base64 is cut off, or holds a character that does not belong");
                return *part;
            },
            expected);
    }

    std::string path_;
    pugi::xml_document document_;
    std::string_view appended_;
    bool raw_ = false, swapped_ = false, compressed_ = false;
    std::size_t header_bytes_ = 4;
};

}  // namespace

MeshFile parse_vtu(std::string_view bytes, std::string_view path) { return VtuReader(bytes, path).read(); }

}  // namespace pliant
