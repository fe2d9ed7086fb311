#include <pliant/math/error.h>
#include <pliant/mesh_file/gmsh.h>
#include <pliant/mesh_file/mesh_source.h>

#include <fmt/format.h>

#include <cstdlib>
#include <map>
#include <unordered_map>
#include <utility>

namespace pliant {
namespace {

// An element type of Gmsh, in the numbering of its manual.
struct GmshType {
    int code;
    std::string_view name;
    int dimension;  // -1: not read
    int nodes;
};
constexpr std::array<GmshType, 13> gmsh_types{{{15, "point", 0, 1},
                                               {1, "edge", 1, 2},
                                               {8, "edge of second order", 1, 3},
                                               {2, "triangle", 2, 3},
                                               {9, "triangle of second order", 2, 6},
                                               {4, "tetrahedron", 3, 4},
                                               {11, "tetrahedron of second order", 3, 10},
                                               {3, "quadrangle", -1, 4},
                                               {10, "quadrangle of second order", -1, 9},
                                               {16, "quadrangle of second order", -1, 8},
                                               {5, "hexahedron", -1, 8},
                                               {6, "prism", -1, 6},
                                               {7, "pyramid", -1, 5}}};

using GroupKey = std::pair<int, int>;  // dimension, and the number of a group or of an entity

class GmshReader {
public:
    GmshReader(std::string_view bytes, std::string_view path) : source_(bytes, path) {}

    MeshFile read() {
        read_format();
        while (!source_.at_end()) read_section();
        if (!nodes_read_) source_.refuse("the section $Nodes is missing");
        if (!elements_read_) source_.refuse("the section $Elements is missing");
        for (std::size_t d = 0; d < lists_.size(); ++d) finish(d);
        return std::move(file_);
    }

private:
    // ------------------------------------------------------------------------------------------------------ sections

    void read_format() {
        if (source_.line() != "$MeshFormat") source_.refuse("a Gmsh file begins with $MeshFormat");
        const std::string_view version = source_.word();
        if (version != "2.2" && version != "4.1")
            source_.refuse(
                fmt::format("version {} is not read; save the mesh as version 4.1 or 2.2", MeshSource::printable(version)));
        newer_ = version == "4.1";
        const Index kind = source_.whole_word(), size = source_.whole_word();
        if (kind != 0 && kind != 1) source_.refuse("the file type is neither 0 (text) nor 1 (binary)");
        if (size != 8) source_.refuse(fmt::format("numbers of {} bytes are not read; save the mesh with 8", size));
        source_.line();
        if (kind == 1) {
            source_.be_binary(false);
            const std::int32_t one = source_.whole();
            if (one != 1 && one != 0x01000000) source_.refuse("the mark of the byte order is not 1");
            source_.be_binary(one != 1);
        }
        source_.expect("$EndMeshFormat");
    }

    void read_section() {
        const std::string_view name = source_.line();
        if (name.empty()) return;
        if (name == "$PhysicalNames") return read_names(), source_.expect("$EndPhysicalNames");
        if (name == "$Entities" && newer_) return read_entities(), source_.expect("$EndEntities");
        if (name == "$Nodes")
            return once(nodes_read_, name), newer_ ? read_nodes() : read_old_nodes(), source_.expect("$EndNodes");
        if (name == "$Elements") {
            if (!nodes_read_) source_.refuse("$Elements stands before $Nodes");
            return once(elements_read_, name), newer_ ? read_elements() : read_old_elements(), source_.expect("$EndElements");
        }
        if (name == "$PartitionedEntities") source_.refuse("a mesh in partitions is not read; save it as one");
        if (!name.starts_with('$'))
            source_.refuse(fmt::format("a section should begin here, not '{}'", MeshSource::printable(name)));
        source_.skip_past(fmt::format("$End{}", name.substr(1)));
    }

    void once(bool& read, std::string_view name) {
        if (std::exchange(read, true)) source_.refuse(fmt::format("a second section {}", name));
    }

    // Text, in binary files as well.
    void read_names() {
        const Index count = source_.checked_count(source_.whole_word(), "names", 6);
        for (Index k = 0; k < count; ++k) {
            const Index dimension = source_.whole_word(), tag = source_.whole_word();
            if (dimension < 0 || dimension > 3) source_.refuse(fmt::format("a group of dimension {}", dimension));
            names_[{static_cast<int>(dimension), static_cast<int>(tag)}] = source_.quoted();
        }
    }

    // Which groups the points, curves, surfaces and volumes belong to.
    void read_entities() {
        std::array<Index, 4> counts{};
        for (Index& n : counts) n = source_.count("entities", 8);
        for (int d = 0; d < 4; ++d)
            for (Index k = 0; k < counts[static_cast<std::size_t>(d)]; ++k) read_entity(d);
    }
    void read_entity(int dimension) {
        const int tag = source_.whole();
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) source_.real();  // where it lies
        auto& groups = groups_of_entity_[{dimension, tag}];
        const Index count = source_.count("groups", 4);
        for (Index k = 0; k < count; ++k) groups.push_back(std::abs(source_.whole()));
        if (dimension == 0) return;
        const Index bounding = source_.count("bounding entities", 4);
        for (Index k = 0; k < bounding; ++k) source_.whole();
    }

    // --------------------------------------------------------------------------------------------------------- nodes

    void begin_nodes(Index count) {
        file_.points.resize(3, count);
        file_.point_numbers.reserve(static_cast<std::size_t>(count));
        index_.reserve(static_cast<std::size_t>(count));
    }
    void add_node(FileNumber number) {
        const auto n = static_cast<Index>(file_.point_numbers.size());
        if (n == file_.points.cols()) source_.refuse(fmt::format("more nodes than the {} that are announced", n));
        if (!index_.emplace(number, static_cast<int>(n)).second) source_.refuse(fmt::format("node {} is given twice", number));
        file_.point_numbers.push_back(number);
    }
    void end_nodes() {
        if (static_cast<Index>(file_.point_numbers.size()) != file_.points.cols())
            source_.refuse(
                fmt::format("{} nodes are announced, but {} are there", file_.points.cols(), file_.point_numbers.size()));
    }

    void read_nodes() {
        const Index blocks = source_.count("blocks of nodes", 20), all = source_.count("nodes", 32);
        source_.number(), source_.number();  // the least and the largest number
        begin_nodes(all);
        for (Index b = 0; b < blocks; ++b) {
            const int dimension = source_.whole();
            source_.whole();  // its entity
            const bool parametric = source_.whole() != 0;
            if (dimension < 0 || dimension > 3)
                source_.refuse(fmt::format("a block of nodes on an entity of dimension {}", dimension));
            const Index count = source_.count("nodes", 32), first = static_cast<Index>(file_.point_numbers.size());
            for (Index k = 0; k < count; ++k) add_node(source_.number());
            for (Index k = 0; k < count; ++k) {
                for (int i = 0; i < 3; ++i) file_.points(i, first + k) = source_.real();
                for (int i = 0; parametric && i < dimension; ++i) source_.real();
            }
        }
        end_nodes();
    }

    void read_old_nodes() {
        begin_nodes(source_.checked_count(source_.whole_word(), "nodes", source_.binary() ? 28 : 8));
        source_.line();
        for (Index n = 0; n < file_.points.cols(); ++n) {
            add_node(static_cast<FileNumber>(source_.whole()));
            for (int i = 0; i < 3; ++i) file_.points(i, n) = source_.real();
        }
    }

    // ------------------------------------------------------------------------------------------------------ elements

    struct List {
        int nodes_each = 0;
        std::vector<int> nodes;
        std::vector<FileNumber> numbers;
    };

    const GmshType& type_of(int code) const {
        for (const GmshType& t : gmsh_types)
            if (t.code == code) {
                if (t.dimension < 0)
                    source_.refuse(fmt::format("a {} is not read: mesh the body with triangles or tetrahedra", t.name));
                return t;
            }
        source_.refuse(
            fmt::format("element type {} is not known: points, edges, triangles and tetrahedra of first or second "
                        "order are read",
                        code));
    }

    List& list_for(const GmshType& type, FileNumber number) {
        List& list = lists_[static_cast<std::size_t>(type.dimension)];
        if (list.nodes_each != 0 && list.nodes_each != type.nodes)
            source_.refuse(
                fmt::format("element {} is of another order than those before it: elements of one order are read", number));
        list.nodes_each = type.nodes;
        return list;
    }

    void add_element(const GmshType& type, FileNumber number, const std::vector<FileNumber>& nodes,
                     const std::vector<int>& groups) {
        List& list = list_for(type, number);
        for (const FileNumber n : nodes) {
            const auto found = index_.find(n);
            if (found == index_.end()) source_.refuse(fmt::format("element {} names node {}, which is not there", number, n));
            list.nodes.push_back(found->second);
        }
        for (const int g : groups) group(type.dimension, g).elements.push_back(static_cast<Index>(list.numbers.size()));
        list.numbers.push_back(number);
    }

    MeshGroup& group(int dimension, int tag) {
        const auto [place, is_new] = group_index_.try_emplace({dimension, tag}, file_.groups.size());
        if (is_new) {
            const auto named = names_.find({dimension, tag});
            file_.groups.push_back({named == names_.end() ? fmt::format("group {}", tag) : named->second, dimension, {}});
        }
        return file_.groups[place->second];
    }

    void read_elements() {
        const Index blocks = source_.count("blocks of elements", 20);
        const Index all = source_.count("elements", 16);
        source_.number(), source_.number();  // the least and the largest number
        Index read = 0;
        std::vector<FileNumber> nodes;
        for (Index b = 0; b < blocks; ++b) {
            const int dimension = source_.whole(), entity = source_.whole();
            const GmshType& type = type_of(source_.whole());
            if (type.dimension != dimension)
                source_.refuse(fmt::format("a block of elements of type {} on an entity of dimension {}", type.code, dimension));
            const Index count = source_.count("elements", 16);
            const auto& groups = groups_of_entity_[{dimension, entity}];
            nodes.resize(static_cast<std::size_t>(type.nodes));
            for (Index k = 0; k < count; ++k) {
                const FileNumber number = source_.number();
                for (FileNumber& n : nodes) n = source_.number();
                add_element(type, number, nodes, groups);
            }
            read += count;
        }
        if (read != all) source_.refuse(fmt::format("{} elements are announced, but {} are there", all, read));
    }

    void read_old_elements() {
        const Index all = source_.checked_count(source_.whole_word(), "elements", 4);
        source_.line();
        for (Index read = 0; read < all;) {
            if (!source_.binary()) {
                const auto number = static_cast<FileNumber>(source_.whole());
                const GmshType& type = type_of(source_.whole());
                read_old_element(type, number, source_.count_of_ints("tags", 4)), ++read;
                continue;
            }
            const GmshType& type = type_of(source_.whole());
            const Index count = source_.count_of_ints("elements", 8), tags = source_.count_of_ints("tags", 4);
            if (count < 1 || count > all - read)
                source_.refuse(fmt::format("a block of {} elements where {} are left", count, all - read));
            for (Index k = 0; k < count; ++k) read_old_element(type, static_cast<FileNumber>(source_.whole()), tags);
            read += count;
        }
    }
    // The first tag is the group, 0 for none.
    void read_old_element(const GmshType& type, FileNumber number, Index tags) {
        std::vector<int> groups;
        for (Index k = 0; k < tags; ++k)
            if (const int tag = source_.whole(); k == 0 && tag != 0) groups.push_back(std::abs(tag));
        std::vector<FileNumber> nodes(static_cast<std::size_t>(type.nodes));
        for (FileNumber& n : nodes) n = static_cast<FileNumber>(source_.whole());
        add_element(type, number, nodes, groups);
    }

    void finish(std::size_t dimension) {
        List& list = lists_[dimension];
        MeshFileElements& elements = file_.elements[dimension];
        elements.nodes =
            Eigen::Map<const Eigen::MatrixXi>(list.nodes.data(), list.nodes_each, static_cast<Index>(list.numbers.size()));
        elements.numbers = std::move(list.numbers);
    }

    MeshSource source_;
    MeshFile file_;
    bool newer_ = false, nodes_read_ = false, elements_read_ = false;
    std::map<GroupKey, std::string> names_;
    std::map<GroupKey, std::vector<int>> groups_of_entity_;
    std::map<GroupKey, std::size_t> group_index_;
    std::unordered_map<FileNumber, int> index_;
    std::array<List, 4> lists_;
};

}  // namespace

MeshFile parse_gmsh(std::string_view bytes, std::string_view path) { return GmshReader(bytes, path).read(); }

}  // namespace pliant
