// A liquid with a free surface in a tank: the level set, the velocity and the pressure together, one stage of a time step at a
// time.
#pragma once
#include <pliant/fluids/level_set.h>
#include <pliant/fluids/projection.h>

#include <functional>

namespace pliant {

// What is said of the pressure where the liquid meets air.
enum class SurfaceCondition {
    at_surface,      // p = 0 on the surface itself, between the cell centres: second order
    at_cell_centre,  // p = 0 in the middle of the first cell of air: off by up to a cell, first order
    closed           // u·n = 0, as if the air were a mould around the liquid
};

struct LiquidSettings {
    SurfaceCondition condition = SurfaceCondition::at_surface;
    bool keep_volume = true;  // step() shifts the surface so that the volume stays that of the start
    ProjectionSettings projection{};
};

// One step is add_force, advect, begin_projection with passes and end_projection, continue_velocity, advect_surface, redistance,
// restore_volume, classify; walls and solids let the liquid slide. The velocity is known everywhere, beyond the liquid as the
// continuation of that of its surface.
template <int Dim>
class Liquid {
public:
    // tank: its types say which cells are solid. Throws as StaggeredGrid and PressureProjection do.
    Liquid(StaggeredGridInfo<Dim> tank, LiquidSettings settings);
    // Its parts refer to its grid.
    Liquid(const Liquid&) = delete;
    Liquid& operator=(const Liquid&) = delete;

    // The liquid where the signed distance [m, at a place in m] is below 0, at rest.
    void fill(const std::function<Real(const Vec<Dim>&)>& signed_distance);

    // The solids have moved; solids: one type per cell, or none. Their velocity is what the tank's solid_velocity gives.
    void set_solids(std::vector<CellType> solids);
    // Finds from the distance which cells are liquid, and lays out the pressure equation.
    void classify();

    void add_force(const Vec<Dim>& acceleration, Real dt);
    void advect(Real dt);
    void begin_projection(Real dt);
    PressureProjection<Dim>& projection() { return projection_; }
    const PressureProjection<Dim>& projection() const { return projection_; }
    void end_projection();
    void continue_velocity();
    void advect_surface(Real dt);
    void redistance();
    // Shifts the surface so that the volume is kept_volume(). Returns the way of the shift, m.
    Real restore_volume();
    // All of these. Returns the passes of the pressure solver.
    Index step(const Vec<Dim>& acceleration, Real dt);

    const StaggeredGrid<Dim>& grid() const { return grid_; }
    FaceField<Dim>& velocity() { return velocity_; }
    const FaceField<Dim>& velocity() const { return velocity_; }
    VecX& distance() { return surface_.distance(); }
    const VecX& distance() const { return surface_.distance(); }
    const SurfaceFractions<Dim>& fractions() const { return fractions_; }
    const LevelSet<Dim>& surface() const { return surface_; }
    const VelocityExtrapolation<Dim>& extrapolation() const { return extrapolation_; }
    const SemiLagrangian<Dim>& advection() const { return advection_; }  // the latest that carried the velocity

    Real volume() const { return surface_.volume(); }  // m^Dim
    // The volume that is kept: that of the start, until it is set.
    Real& kept_volume() { return kept_volume_; }

private:
    LiquidSettings settings_;
    StaggeredGrid<Dim> grid_;
    LevelSet<Dim> surface_;
    SemiLagrangian<Dim> advection_;
    PressureProjection<Dim> projection_;
    VelocityExtrapolation<Dim> extrapolation_;
    std::vector<CellType> types_;
    FaceField<Dim> velocity_;
    SurfaceFractions<Dim> fractions_;
    Real kept_volume_ = 0;
};

extern template class Liquid<2>;
extern template class Liquid<3>;

}  // namespace pliant
