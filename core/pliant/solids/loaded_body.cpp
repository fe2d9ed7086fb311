#include <pliant/solids/loaded_body.h>

#include <pliant/mesh/block_mesh.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant {
namespace {

SimplexMesh<3> loaded_block_mesh(const Vec<3>& size, int across, int axis) {
    const int other = axis == 0 ? 1 : 0;
    BlockShape<3> shape;
    shape.size = size;
    shape.cells.fill(across);
    const Real cells = std::round(across * size[axis] / size[other]);
    shape.cells[static_cast<std::size_t>(axis)] = static_cast<int>(std::clamp<Real>(cells, 1, 4.0 * across));
    return block_mesh<3>(shape);
}

// Squares about the middle become circles about it; their corners stay in their directions.
Vec<2> round_off(const Vec<2>& p) {
    const Real half = p.cwiseAbs().maxCoeff();
    if (half == 0) return p;
    const bool beside = std::abs(p[0]) >= std::abs(p[1]);
    const Real angle = std::numbers::pi / 4 * (beside ? p[1] / p[0] : p[0] / p[1]);
    const Real along = std::copysign(half * std::cos(angle), beside ? p[0] : p[1]);
    const Real across = std::copysign(half, beside ? p[0] : p[1]) * std::sin(angle);
    return beside ? Vec<2>(along, across) : Vec<2>(across, along);
}

Real face_area(const SimplexMesh<3>& mesh, const std::string& face) {
    Real area = 0;
    for (const Index f : mesh.facets(face)) area += mesh.facet_areas().col(f).norm();
    return area;
}

// A post whose cross-section is a polygon with exactly the area of the disc.
SimplexMesh<3> post_mesh(Real radius, Real height, int across) {
    const SimplexMesh<3> square = loaded_block_mesh({2 * radius, height, 2 * radius}, across, 1);
    Points<3> points = square.points();
    for (auto p : points.colwise()) {
        const Vec<2> on_disc = round_off({p[0] - radius, p[2] - radius});
        p[0] = on_disc[0], p[2] = on_disc[1];
    }
    const SimplexMesh<3> inscribed = square.with_points(points);
    const Real scale = std::sqrt(std::numbers::pi / face_area(inscribed, "y_min")) * radius;
    points.row(0) *= scale, points.row(2) *= scale;
    return square.with_points(points);
}

SimplexMesh<3> loaded_body_mesh(LoadCase load, const LoadedBodySize& size) {
    return load == LoadCase::disc ? post_mesh(size.radius, size.length, size.resolution)
                                  : loaded_block_mesh({size.length, size.width, size.width}, size.resolution, 0);
}

Index nearest_node(const SimplexMesh<3>& mesh, const SimplexMesh<3>::Set& nodes, const Vec<3>& place) {
    return *std::ranges::min_element(nodes, {}, [&](Index n) { return (mesh.points().col(n) - place).squaredNorm(); });
}

// A face that is held slides on a plane: its middle stays where it is, and a second node keeps it from turning. The block is held
// at three nodes of one of its faces, which takes no force from them since its loads balance.
DisplacementConstraints<3> loaded_body_supports(LoadCase load, const SimplexMesh<3>& mesh) {
    DisplacementConstraints<3> supports(mesh.node_count());
    const int along = load == LoadCase::disc ? 1 : 0, side = load == LoadCase::disc ? 0 : 1;
    const auto& face = mesh.nodes(load == LoadCase::disc ? "y_min" : "x_min");
    Vec<3> middle = Vec<3>::Zero();
    for (const Index n : face) middle += mesh.points().col(n) / static_cast<Real>(face.size());
    const Index centre = nearest_node(mesh, face, middle);
    const Index rim = *std::ranges::max_element(
        face, {}, [&](Index n) { return mesh.points()(side, n) - std::abs(mesh.points()(2, n) - mesh.points()(2, centre)); });
    if (load != LoadCase::cut) {
        supports.prescribe(face, along, 0);
    } else {
        const Index third = *std::ranges::max_element(face, {}, [&](Index n) {
            return mesh.points()(2, n) - std::abs(mesh.points()(side, n) - mesh.points()(side, centre));
        });
        for (const Index n : {centre, rim, third}) supports.prescribe(n, along, 0);
    }
    supports.prescribe(centre, side, 0);
    supports.prescribe(centre, 2, 0);
    supports.prescribe(rim, 2, 0);
    return supports;
}

Points<3> share_area(LoadCase load, const SimplexMesh<3>& mesh) {
    Points<3> share = Points<3>::Zero(3, mesh.node_count());
    const auto add = [&](Index f) {
        for (int a = 0; a < 3; ++a) share.col(mesh.facets()(a, f)) += mesh.facet_areas().col(f) / 3;
    };
    if (load == LoadCase::cut)
        for (Index f = 0; f < mesh.facet_count(); ++f) add(f);
    else
        for (const Index f : mesh.facets(load == LoadCase::disc ? "y_max" : "x_max")) add(f);
    return share;
}

}  // namespace

LoadedBody::LoadedBody(LoadCase load, const IsotropicModuli& material, const LoadedBodySize& size)
    : load_(load),
      mesh_(loaded_body_mesh(load, size)),
      body_(mesh_, material.lame()),
      problem_(body_, loaded_body_supports(load, mesh_)),
      loaded_area_(share_area(load, mesh_)) {}

Real LoadedBody::support_area() const { return face_area(mesh_, held_face()); }

Real LoadedBody::support_force(const Points<3>& reaction) const {
    Real force = 0;
    for (const Index n : mesh_.nodes(held_face())) force -= reaction(axis(), n);
    return force;
}

Real LoadedBody::lengthening(const Points<3>& u) const {
    Real sum = 0, area = 0;
    for (const Index f : mesh_.facets(loaded_face())) {
        const Real facet = mesh_.facet_areas().col(f).norm();
        for (int a = 0; a < 3; ++a) sum += facet / 3 * u(axis(), mesh_.facets()(a, f));
        area += facet;
    }
    return sum / area;
}

Real LoadedBody::transverse_strain(const Points<3>& u) const {
    Real sum = 0;
    for (Index e = 0; e < mesh_.simplex_count(); ++e) sum += mesh_.volumes()[e] * mesh_.field_gradient(e, u)(2, 2);
    return sum / mesh_.volume();
}

Mat<3> LoadedBody::mean(const Tensors<3>& tensors) const {
    Mat<3> sum = Mat<3>::Zero();
    for (Index e = 0; e < mesh_.simplex_count(); ++e) sum += mesh_.volumes()[e] * tensor<3>(tensors, e);
    return sum / mesh_.volume();
}

}  // namespace pliant
