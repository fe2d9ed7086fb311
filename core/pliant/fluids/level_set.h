// A free surface as the zero of a signed distance [OsherSethian1988; Bridson2007 §6].
#pragma once
#include <pliant/fluids/advection.h>
#include <pliant/fluids/extrapolation.h>

namespace pliant {

// The signed distance to the surface at every cell centre, m: negative in the fluid, positive in the air. Walls and solids are
// met at a right angle.
template <int Dim>
class LevelSet {
public:
    // On the cells of a grid, whatever their types.
    explicit LevelSet(const StaggeredGrid<Dim>& grid);

    // One type per cell, or none; what is not solid makes no difference.
    void set_solids(std::vector<CellType> solids) { solids_ = std::move(solids); }

    const StaggeredGrid<Dim>& box() const { return box_; }               // of all cells, without solids
    const SemiLagrangian<Dim>& advection() const { return advection_; }  // the latest that carried the surface

    VecX& distance() { return distance_; }
    const VecX& distance() const { return distance_; }

    // Carries the surface along a velocity that is known everywhere, see VelocityExtrapolation, for dt seconds.
    void advect(const FaceField<Dim>& velocity, Real dt);
    // Makes it a distance again, |∇φ| = 1, by fast sweeping [Zhao2005]. The cells beside the surface keep φ, and with it the
    // place of the surface, while their slope is between flattest and steepest; else it is divided by the slope [RussoSmereka2000
    // §3]. Into the solids the surface is continued.
    void redistance();
    static constexpr Real flattest = 0.7, steepest = 1.5;
    // Of the latest redistancing: was the cell beside the surface?
    bool beside_surface(Index cell) const { return fixed_[cell] != 0 && !solid(cell); }
    // The cell one step (-1 or +1) along an axis; beyond a wall or in a solid the cell itself, since φ has no gradient there.
    Index beside(const Counts<Dim>& at, int axis, int step) const;
    // In which layer a solid cell got its distance, see Extrapolation; 0 in other cells.
    int layer(Index cell) const { return solids_.empty() ? 0 : extrapolation_.layers()[cell]; }
    bool solid(Index cell) const { return !solids_.empty() && solids_[cell] == CellType::solid; }

    // Volume of the fluid outside the solids, m^Dim: every cell counts as far as a plane through it at φ = 0 leaves it filled.
    Real volume() const;
    // Moves the surface along its normal by the same way everywhere so that the volume becomes `target`; nothing happens where
    // there is no surface.
    // Returns that way, m.
    Real shift_to_volume(Real target);

    // fluid where φ < 0, air elsewhere, and the solids.
    void classify(std::vector<CellType>& types) const;

private:
    void measure_beside_surface();
    bool sweep(int direction);

    // A cell that the surface may cross: the distance in its middle and its slopes over a cell.
    struct Crossed {
        Real middle;
        GridPlace<Dim> slopes;
    };
    // Cells that are full, whatever shift of up to a cell; collects the others that are not empty.
    Index full_cells(std::vector<Crossed>& crossed) const;
    void extend_into_solids();

    StaggeredGrid<Dim> box_;  // without types: the distance is known in all cells
    std::vector<CellType> solids_;
    SemiLagrangian<Dim> advection_;
    VecX distance_, old_;
    mutable std::vector<Crossed> crossed_;
    std::vector<std::uint8_t> fixed_;
    Extrapolation<Dim> extrapolation_;
    std::vector<Known> known_;
};

// Part of a unit box on the side φ < 0 of a plane: φ in the middle of the box, slopes per box edge. In [0, 1].
template <int Dim>
Real filled_fraction(Real middle, const GridPlace<Dim>& slopes);

// Of the surface faces of a grid, for the signed distance at its cell centres.
template <int Dim>
SurfaceFractions<Dim> surface_fractions(const StaggeredGrid<Dim>& grid, const VecX& distance);

// Where the surface crosses the way from the centre of a cell of fluid to that of its neighbour of air, as a part of that way
// [Gibou2002 §2]: in [smallest, 1].
Real surface_crossing(Real distance_in_fluid, Real distance_in_air, Real smallest = 0.01);

extern template class LevelSet<2>;
extern template class LevelSet<3>;
extern template SurfaceFractions<2> surface_fractions(const StaggeredGrid<2>&, const VecX&);
extern template SurfaceFractions<3> surface_fractions(const StaggeredGrid<3>&, const VecX&);
extern template Real filled_fraction<2>(Real, const GridPlace<2>&);
extern template Real filled_fraction<3>(Real, const GridPlace<3>&);

}  // namespace pliant
