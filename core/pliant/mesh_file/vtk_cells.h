// What files of VTK have in common, as text or XML: cells by their numbers in VTK, and arrays that name sets.
#pragma once
#include <pliant/mesh_file/mesh_file.h>

#include <cstdint>
#include <functional>
#include <span>

namespace pliant {

// An array of a file: so many numbers for each point or cell.
struct VtkArray {
    std::string name;
    Index components = 1;
    std::vector<Real> values;
};

// Makes a MeshFile of points and cells. All throw Refused through `refuse`, which is told what is wrong and adds the place.
class VtkCells {
public:
    using Refuse = std::function<void(const std::string&)>;
    // Points are numbered from 0, as in VTK.
    VtkCells(Points<3> points, Refuse refuse);

    // Vertices, lines, triangles and tetrahedra, of first or second order; what else there is in VTK is refused by its name.
    void add(Index type, std::span<const std::int64_t> nodes);
    Index count() const { return static_cast<Index>(places_.size()); }

    // Arrays that are 0 or 1 everywhere name a set: points of a body, or cells of each dimension ("fixed").
    void name_points(const VtkArray& array);
    void name_cells(const VtkArray& array);

    MeshFile finish();

private:
    struct Place {
        int dimension;
        Index element;
    };
    bool names_a_set(const VtkArray& array, Index count, std::string_view what) const;

    MeshFile file_;
    Refuse refuse_;
    std::array<std::vector<int>, 4> nodes_;
    std::array<int, 4> nodes_each_{};
    std::vector<Place> places_;  // of the cells
};

}  // namespace pliant
