#include <pliant/fluids/forces.h>
#include <pliant/fluids/liquid.h>

#include <utility>

namespace pliant {
namespace {

template <int Dim>
StaggeredGridInfo<Dim> slippery(StaggeredGridInfo<Dim> tank) {
    tank.solid_slip = Slip::free;
    return tank;
}

}  // namespace

template <int Dim>
Liquid<Dim>::Liquid(StaggeredGridInfo<Dim> tank, LiquidSettings settings)
    : settings_(settings),
      grid_(slippery(tank)),
      surface_(grid_),
      advection_(grid_),
      projection_(grid_, settings.projection),
      velocity_(grid_.zero_velocity()) {
    surface_.set_solids(std::move(tank.types));
    surface_.distance().setOnes();
    classify();
}

template <int Dim>
void Liquid<Dim>::fill(const std::function<Real(const Vec<Dim>&)>& signed_distance) {
    const Lattice<Dim>& cells = grid_.cells();
    for (Index c = 0; c < cells.size(); ++c) {
        const GridPlace<Dim> place = cells.place(cells.coordinates(c));
        Vec<Dim> x;
        for (int a = 0; a < Dim; ++a) x[a] = place[a] * grid_.dx();
        surface_.distance()[c] = signed_distance(x);
    }
    surface_.redistance();
    velocity_ = grid_.zero_velocity();
    classify();
    projection_.pressure().setZero();
    kept_volume_ = volume();
}

template <int Dim>
void Liquid<Dim>::set_solids(std::vector<CellType> solids) {
    surface_.set_solids(std::move(solids));
    classify();
}

template <int Dim>
void Liquid<Dim>::classify() {
    surface_.classify(types_);
    if (settings_.condition == SurfaceCondition::closed)
        for (CellType& type : types_)
            if (type == CellType::air) type = CellType::solid;
    grid_.set_types(types_);
    fractions_ = surface_fractions(grid_, surface_.distance());
    if (settings_.condition == SurfaceCondition::at_cell_centre)
        for (VecX& fraction : fractions_.components) fraction.setOnes();
    projection_.domain_changed(fractions_);
    grid_.impose_walls(velocity_);
}

template <int Dim>
void Liquid<Dim>::add_force(const Vec<Dim>& acceleration, Real dt) {
    for (int a = 0; a < Dim; ++a)
        if (acceleration[a] != 0) velocity_[a].array() += dt * acceleration[a];
    grid_.impose_walls(velocity_);
}

template <int Dim>
void Liquid<Dim>::advect(Real dt) {
    advection_.advect(velocity_, dt);
}

template <int Dim>
void Liquid<Dim>::begin_projection(Real dt) {
    projection_.begin(velocity_, dt);
}

template <int Dim>
void Liquid<Dim>::end_projection() {
    projection_.apply(velocity_);
}

template <int Dim>
void Liquid<Dim>::continue_velocity() {
    extrapolation_.extrapolate(grid_, velocity_);
}

template <int Dim>
void Liquid<Dim>::advect_surface(Real dt) {
    surface_.advect(velocity_, dt);
}

template <int Dim>
void Liquid<Dim>::redistance() {
    surface_.redistance();
}

template <int Dim>
Real Liquid<Dim>::restore_volume() {
    return surface_.shift_to_volume(kept_volume_);
}

template <int Dim>
Index Liquid<Dim>::step(const Vec<Dim>& acceleration, Real dt) {
    add_force(acceleration, dt);
    advect(dt);
    begin_projection(dt);
    while (!projection_.converged()) projection_.iterate();
    end_projection();
    continue_velocity();
    advect_surface(dt);
    redistance();
    if (settings_.keep_volume) restore_volume();
    classify();
    return projection_.iterations();
}

template class Liquid<2>;
template class Liquid<3>;

}  // namespace pliant
