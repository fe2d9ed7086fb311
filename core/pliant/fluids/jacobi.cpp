#include <pliant/fluids/jacobi.h>

namespace pliant {

template <int Dim>
Jacobi<Dim>::Jacobi(const StaggeredGrid<Dim>& grid, const SurfaceFractions<Dim>& fractions)
    : inverse_diagonal_(pressure_diagonal(grid, fractions)) {
    for (Real& d : inverse_diagonal_) d = d > 0 ? 1 / d : 0;
}

template class Jacobi<2>;
template class Jacobi<3>;

}  // namespace pliant
