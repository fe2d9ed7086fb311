// The physics of the virtual material tests: a block of linear elastic tetrahedra, its supports and loads, and what an instrument
// would read off it. Every test has a uniform solution, which linear elements reproduce exactly on any mesh.
#pragma once
#include <pliant/mesh/block_mesh.h>
#include <pliant/solids/linear_fem_static.h>

#include <map>

namespace pliant {

enum class MaterialTest { tension, shear, pressure };

struct SpecimenSize {
    Real length, width;  // m; the block is length × width × width
    int resolution;      // cells across the width
};

class Specimen {
public:
    Specimen(MaterialTest test, const IsotropicModuli& material, const SpecimenSize& size);
    Specimen(const Specimen&) = delete;
    Specimen& operator=(const Specimen&) = delete;

    MaterialTest test() const { return test_; }
    const SimplexMesh<3>& mesh() const { return mesh_; }
    const LinearFem<3>& body() const { return body_; }
    const StaticProblem<3>& problem() const { return problem_; }
    // Forces on the nodes [N] for a stress of 1 Pa: pull, shear or pressure.
    const Points<3>& unit_load() const { return unit_load_; }

    // The face that the supports hold, along which or on which the force is measured.
    const char* support_face() const { return test_ == MaterialTest::shear ? "y_min" : "x_min"; }
    // The mean over the area of a face as a sum over its nodes: weights that add up to 1.
    std::map<Index, Real> mean_weights(const char* face) const;

    // --- read off the solution ---
    // Force on the face that the support holds: along the pull, along the shear, or against the pressure [N].
    Real support_force(const Points<3>& reaction) const;
    // Area of that face [m^2].
    Real area() const;
    // Fractional deformation: dL/L of the length, sideways shift over height, or dV/V of the volume.
    Real strain(const Points<3>& displacement) const;
    // Widening over width.
    Real transverse_strain(const Points<3>& displacement) const;
    // Mean of the trace of the strain: dV/V for small strains.
    Real volume_change(const Points<3>& displacement) const;

    // --- closed forms, at a given stress [Pa] ---
    Real exact_modulus() const;  // Y, G or B [Pa]
    Real exact_area() const, exact_strain(Real stress) const, exact_transverse_strain(Real stress) const,
        exact_volume_change(Real stress) const;
    Vec<3> exact_displacement(Real stress, const Vec<3>& X) const;
    Real exact_energy(Real stress) const;  // J

private:
    Real mean_on_face(const char* face, int component, const Points<3>& displacement) const;

    MaterialTest test_;
    IsotropicModuli material_;
    SpecimenSize size_;
    SimplexMesh<3> mesh_;
    LinearFem<3> body_;
    StaticProblem<3> problem_;
    Points<3> unit_load_;
};

}  // namespace pliant
