#include <pliant/fluids/helmholtz.h>
#include <pliant/fluids/pressure_gradient.h>
#include <pliant/fluids/projection.h>
#include <pliant/math/error.h>

namespace pliant {

template <int Dim>
HelmholtzParts<Dim> helmholtz_parts(const StaggeredGrid<Dim>& grid, const FaceField<Dim>& velocity,
                                    const ProjectionSettings& settings) {
    PressureProjection<Dim> projection(grid, settings);
    projection.begin(velocity, 1);
    while (!projection.converged()) projection.iterate();
    return helmholtz_parts(grid, velocity, projection.pressure());
}

template <int Dim>
HelmholtzParts<Dim> helmholtz_parts(const StaggeredGrid<Dim>& grid, const FaceField<Dim>& velocity, VecX potential) {
    if (grid.has_air())
        throw Refused("a velocity with a free surface has no Helmholtz parts here: take a grid without cells of air");
    HelmholtzParts<Dim> parts;
    parts.potential = std::move(potential);
    parts.gradient = grid.zero_velocity();
    subtract_gradient(grid, parts.potential, -1, parts.gradient);
    for (int a = 0; a < Dim; ++a) {
        parts.solenoidal[a] = velocity[a] - parts.gradient[a];
        if (!grid.periodic(a) || grid.has_gaps()) continue;
        parts.drift[a] = parts.solenoidal[a].mean();
        parts.solenoidal[a].array() -= parts.drift[a];
    }
    return parts;
}

template HelmholtzParts<2> helmholtz_parts(const StaggeredGrid<2>&, const FaceField<2>&, const ProjectionSettings&);
template HelmholtzParts<3> helmholtz_parts(const StaggeredGrid<3>&, const FaceField<3>&, const ProjectionSettings&);
template HelmholtzParts<2> helmholtz_parts(const StaggeredGrid<2>&, const FaceField<2>&, VecX);
template HelmholtzParts<3> helmholtz_parts(const StaggeredGrid<3>&, const FaceField<3>&, VecX);

}  // namespace pliant
