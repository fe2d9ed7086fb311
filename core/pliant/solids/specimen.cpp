#include <pliant/solids/specimen.h>

#include <pliant/solids/fem_loads.h>

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

// Cells are about cubes; a long thin bar has stretched ones, so that it stays cheap.
SimplexMesh<3> specimen_mesh(const SpecimenSize& size) {
    const Real along = std::clamp(std::round(size.resolution * size.length / size.width), 1.0, 4.0 * size.resolution);
    BlockShape<3> block;
    block.size = {size.length, size.width, size.width};
    block.cells = {static_cast<int>(along), size.resolution, size.resolution};
    return block_mesh<3>(block);
}

// Shear: the bottom is glued down. Otherwise the three lower faces slide on rollers, so that the block may widen freely.
DisplacementConstraints<3> specimen_supports(MaterialTest test, const SimplexMesh<3>& mesh) {
    DisplacementConstraints<3> supports(mesh.node_count());
    if (test == MaterialTest::shear) {
        supports.prescribe(mesh.nodes("y_min"), Vec<3>::Zero());
        return supports;
    }
    supports.prescribe(mesh.nodes("x_min"), 0, 0);
    supports.prescribe(mesh.nodes("y_min"), 1, 0);
    supports.prescribe(mesh.nodes("z_min"), 2, 0);
    return supports;
}

Points<3> specimen_unit_load(MaterialTest test, const SimplexMesh<3>& mesh) {
    Points<3> force = Points<3>::Zero(3, mesh.node_count());
    switch (test) {
        case MaterialTest::tension:
            add_traction<3>(mesh, mesh.facets("x_max"), Vec<3>::UnitX(), force);
            break;
        case MaterialTest::shear: {
            // Shear stress acts in pairs: without the pull on the ends the block would tilt.
            Mat<3> stress = Mat<3>::Zero();
            stress(0, 1) = stress(1, 0) = 1;
            for (const char* face : {"y_max", "x_min", "x_max"}) add_boundary_stress<3>(mesh, mesh.facets(face), stress, force);
            break;
        }
        case MaterialTest::pressure:
            for (const char* face : {"x_max", "y_max", "z_max"}) add_pressure<3>(mesh, mesh.facets(face), 1, force);
            break;
    }
    return force;
}

}  // namespace

Specimen::Specimen(MaterialTest test, const IsotropicModuli& material, const SpecimenSize& size)
    : test_(test),
      material_(material),
      size_(size),
      mesh_(specimen_mesh(size)),
      body_(mesh_, material.lame()),
      problem_(body_, specimen_supports(test, mesh_)),
      unit_load_(specimen_unit_load(test, mesh_)) {}

Real Specimen::support_force(const Points<3>& reaction) const {
    Real along_x = 0;
    for (const Index n : mesh_.nodes(support_face())) along_x += reaction(0, n);
    return test_ == MaterialTest::pressure ? along_x : -along_x;
}

Real Specimen::area() const {
    Real area = 0;
    for (const Index f : mesh_.facets(support_face())) area += mesh_.facet_areas().col(f).norm();
    return area;
}

std::map<Index, Real> Specimen::mean_weights(const char* face) const {
    std::map<Index, Real> weights;
    Real area = 0;
    for (const Index f : mesh_.facets(face)) {
        const Real facet = mesh_.facet_areas().col(f).norm();
        for (int a = 0; a < 3; ++a) weights[mesh_.facets()(a, f)] += facet / 3;
        area += facet;
    }
    for (auto& [node, weight] : weights) weight /= area;
    return weights;
}

// Mean over the area of a face, of a displacement that is linear in each facet.
Real Specimen::mean_on_face(const char* face, int component, const Points<3>& displacement) const {
    Real sum = 0, area = 0;
    for (const Index f : mesh_.facets(face)) {
        const Real facet = mesh_.facet_areas().col(f).norm();
        for (int a = 0; a < 3; ++a) sum += facet / 3 * displacement(component, mesh_.facets()(a, f));
        area += facet;
    }
    return sum / area;
}

Real Specimen::strain(const Points<3>& u) const {
    switch (test_) {
        case MaterialTest::tension:
            return (mean_on_face("x_max", 0, u) - mean_on_face("x_min", 0, u)) / size_.length;
        case MaterialTest::shear:
            return (mean_on_face("y_max", 0, u) - mean_on_face("y_min", 0, u)) / size_.width;
        case MaterialTest::pressure:
            return volume_change(u);
    }
    return 0;
}

Real Specimen::transverse_strain(const Points<3>& u) const {
    return (mean_on_face("z_max", 2, u) - mean_on_face("z_min", 2, u)) / size_.width;
}

Real Specimen::volume_change(const Points<3>& u) const {
    Real change = 0;
    for (Index e = 0; e < mesh_.simplex_count(); ++e) change += mesh_.volumes()[e] * mesh_.field_gradient(e, u).trace();
    return change / mesh_.volume();
}

Real Specimen::exact_modulus() const {
    switch (test_) {
        case MaterialTest::tension:
            return material_.youngs_modulus();
        case MaterialTest::shear:
            return material_.shear_modulus();
        case MaterialTest::pressure:
            return material_.bulk_modulus();
    }
    return 0;
}

Real Specimen::exact_area() const { return (test_ == MaterialTest::shear ? size_.length : size_.width) * size_.width; }

Real Specimen::exact_strain(Real stress) const { return (test_ == MaterialTest::pressure ? -stress : stress) / exact_modulus(); }

Real Specimen::exact_transverse_strain(Real stress) const {
    switch (test_) {
        case MaterialTest::tension:
            return -material_.poisson_ratio() * exact_strain(stress);
        case MaterialTest::shear:
            return 0;
        case MaterialTest::pressure:
            return exact_strain(stress) / 3;
    }
    return 0;
}

Real Specimen::exact_volume_change(Real stress) const {
    switch (test_) {
        case MaterialTest::tension:
            return (1 - 2 * material_.poisson_ratio()) * exact_strain(stress);
        case MaterialTest::shear:
            return 0;
        case MaterialTest::pressure:
            return exact_strain(stress);
    }
    return 0;
}

Vec<3> Specimen::exact_displacement(Real stress, const Vec<3>& X) const {
    const Real strain = exact_strain(stress), across = exact_transverse_strain(stress);
    switch (test_) {
        case MaterialTest::tension:
            return {strain * X[0], across * X[1], across * X[2]};
        case MaterialTest::shear:
            return {strain * X[1], 0, 0};
        case MaterialTest::pressure:
            return strain / 3 * X;
    }
    return Vec<3>::Zero();
}

Real Specimen::exact_energy(Real stress) const {
    return 0.5 * stress * stress / exact_modulus() * size_.length * size_.width * size_.width;
}

}  // namespace pliant
