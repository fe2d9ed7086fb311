#include <pliant/math/error.h>
#include <pliant/mesh_file/mesh_source.h>
#include <pliant/mesh_file/surface_files.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <map>

namespace pliant {
namespace {

// Triangles as they are read, with their points merged.
class SurfaceMaker {
public:
    // Its number; of an equal point before it, that one's.
    int point(const Vec<3>& x, FileNumber number) {
        const std::array<Real, 3> key{x[0] + 0.0, x[1] + 0.0, x[2] + 0.0};  // −0 is 0
        const auto [place, is_new] = known_.try_emplace(key, static_cast<int>(points_.size()));
        if (is_new) points_.push_back(x), numbers_.push_back(number);
        return place->second;
    }
    void triangle(const std::array<int, 3>& corners, FileNumber number) {
        corners_.insert(corners_.end(), corners.begin(), corners.end());
        triangle_numbers_.push_back(number);
    }
    Index count() const { return static_cast<Index>(triangle_numbers_.size()); }

    MeshFile make(std::vector<MeshGroup> groups) {
        MeshFile file;
        file.points.resize(3, static_cast<Index>(points_.size()));
        for (std::size_t p = 0; p < points_.size(); ++p) file.points.col(static_cast<Index>(p)) = points_[p];
        file.point_numbers = std::move(numbers_);
        file.elements[2].nodes = Eigen::Map<const Eigen::MatrixXi>(corners_.data(), 3, count());
        file.elements[2].numbers = std::move(triangle_numbers_);
        file.groups = std::move(groups);
        return file;
    }

private:
    std::map<std::array<Real, 3>, int> known_;
    std::vector<Vec<3>> points_;
    std::vector<FileNumber> numbers_, triangle_numbers_;
    std::vector<int> corners_;
};

void require_finite_point(const MeshSource& source, const Vec<3>& x) {
    if (!x.allFinite()) source.refuse(fmt::format("a point at ({}, {}, {}) is not finite", x[0], x[1], x[2]));
}

class ObjReader {
public:
    ObjReader(std::string_view bytes, std::string_view path) : source_(bytes, path) {}

    MeshFile read() {
        while (!source_.at_end()) {
            const std::string_view text = source_.peek_line();
            MeshSource line(text, "");
            const auto word = line.peek_word();
            if (word) {
                line.word();
                if (*word == "v") read_point(line);
                if (*word == "f") read_face(line);
                if (*word == "g" || *word == "o") name_ = line.line();
            }
            source_.line();
        }
        if (maker_.count() == 0) source_.refuse("no face (f) is there: a surface of triangles is asked for");
        return maker_.make(std::move(groups_));
    }

private:
    template <class Read>
    auto here(Read read) -> decltype(read()) {
        try {
            return read();
        } catch (const Refused& e) {
            const std::string_view what = e.what();  // ":1: what", without the path that the line has not
            source_.refuse(what.substr(what.find(": ") + 2));
        }
    }

    void read_point(MeshSource& line) {
        Vec<3> x;
        for (int i = 0; i < 3; ++i) x[i] = here([&] { return line.real_word(); });
        require_finite_point(source_, x);
        points_.push_back(maker_.point(x, static_cast<FileNumber>(points_.size()) + 1));
    }

    // "7", "7/1", "7//3", "7/1/3"; −1 is the latest point.
    int corner(std::string_view text) {
        const std::string_view number = text.substr(0, text.find('/'));
        const Index given = here([&] { return MeshSource(number.empty() ? "?" : number, "").whole_word(); });
        const auto count = static_cast<Index>(points_.size());
        if (given == 0 || given > count || given < -count)
            source_.refuse(fmt::format("face {} names point {}, and there are {} so far", faces_, given, count));
        return points_[static_cast<std::size_t>(given > 0 ? given - 1 : count + given)];
    }

    void read_face(MeshSource& line) {
        ++faces_;
        std::vector<int> corners;
        while (line.peek_word()) corners.push_back(corner(line.word()));
        if (corners.size() < 3) source_.refuse(fmt::format("face {} has {} corners", faces_, corners.size()));
        for (std::size_t k = 2; k < corners.size(); ++k) {
            if (!name_.empty()) group().elements.push_back(maker_.count());
            maker_.triangle({corners[0], corners[k - 1], corners[k]}, faces_);
        }
    }

    MeshGroup& group() {
        const auto known = std::ranges::find(groups_, name_, &MeshGroup::name);
        return known != groups_.end() ? *known : groups_.emplace_back(MeshGroup{std::string(name_), 2, {}});
    }

    MeshSource source_;
    SurfaceMaker maker_;
    std::vector<int> points_;
    FileNumber faces_ = 0;
    std::string_view name_;
    std::vector<MeshGroup> groups_;
};

constexpr std::size_t stl_head = 80, stl_triangle = 50;

// A binary file may begin with "solid" as well: what tells is its length.
bool is_binary_stl(std::string_view bytes) {
    if (bytes.size() < stl_head + 4) return false;
    std::uint64_t count = 0;
    for (std::size_t k = 0; k < 4; ++k) count |= std::uint64_t{static_cast<unsigned char>(bytes[stl_head + k])} << (8 * k);
    return bytes.size() == stl_head + 4 + stl_triangle * count || !bytes.starts_with("solid");
}

MeshFile read_binary_stl(std::string_view bytes, std::string_view path) {
    MeshSource source(bytes, path);
    source.skip(stl_head);
    source.be_binary(std::endian::native == std::endian::big);
    const Index count = source.checked_count(static_cast<Index>(source.number_of(4, false, false)), "triangles", stl_triangle);
    SurfaceMaker maker;
    FileNumber corner = 0;
    for (Index t = 0; t < count; ++t) {
        for (int i = 0; i < 3; ++i) source.number_of(4, true, true);  // the normal
        std::array<int, 3> corners{};
        for (int& c : corners) {
            Vec<3> x;
            for (int i = 0; i < 3; ++i) x[i] = source.number_of(4, true, true);
            require_finite_point(source, x);
            c = maker.point(x, corner++);
        }
        source.number_of(2, false, false);  // what some programs write for a colour
        maker.triangle(corners, static_cast<FileNumber>(t));
    }
    if (count == 0) source.refuse("there is no triangle");
    return maker.make({});
}

MeshFile read_text_stl(std::string_view bytes, std::string_view path) {
    MeshSource source(bytes, path);
    if (!source.line().starts_with("solid")) source.refuse("a file .stl as text begins with solid");
    SurfaceMaker maker;
    FileNumber corner = 0, triangle = 0;
    const auto want = [&](std::string_view word) {
        if (const std::string_view there = source.word(); there != word)
            source.refuse(fmt::format("'{}' should stand here, not '{}'", word, MeshSource::printable(there)));
    };
    while (const auto word = source.peek_word()) {
        if (*word == "endsolid" || *word == "solid") {
            source.line();
            continue;
        }
        want("facet"), want("normal");
        for (int i = 0; i < 3; ++i) source.real_word();
        want("outer"), want("loop");
        std::array<int, 3> corners{};
        for (int& c : corners) {
            want("vertex");
            Vec<3> x;
            for (int i = 0; i < 3; ++i) x[i] = source.real_word();
            require_finite_point(source, x);
            c = maker.point(x, corner++);
        }
        want("endloop"), want("endfacet");
        maker.triangle(corners, triangle++);
    }
    if (triangle == 0) source.refuse("there is no triangle");
    return maker.make({});
}

}  // namespace

MeshFile parse_obj(std::string_view bytes, std::string_view path) { return ObjReader(bytes, path).read(); }

MeshFile parse_stl(std::string_view bytes, std::string_view path) {
    return is_binary_stl(bytes) ? read_binary_stl(bytes, path) : read_text_stl(bytes, path);
}

}  // namespace pliant
