// The figure: the cube at rest as an outline and the stretched one with its measures, or the bent panel.
#include "poisson.h"

namespace pliant::poisson {

void PoissonLesson::draw(Scene& scene) const {
    if (bends()) return draw_panel(scene);
    draw_cube(scene);
    draw_pull(scene);
    draw_measures(scene);
    write_notes(scene);
    const Real L = length, end = std::max<Real>(1, 1 + axial_strain) * L;
    const Real wide = std::max<Real>(0, -exact_contraction(poisson_ratio, axial_strain)) * L;
    scene.frame(position(-0.35 * L, -0.35 * L - 0.5 * wide, -0.1 * L - 0.5 * wide),
                position(end + 0.6 * L, 1.25 * L + 0.5 * wide, 1.15 * L + 0.5 * wide));
}

// Drawn about its middle, as in the lecture's figure: it narrows on both sides.
void PoissonLesson::draw_cube(Scene& scene) const {
    const SimplexMesh<3>& mesh = cube_->rest();
    const Vec<3> aside = 0.5 * contractions_[done()] * length * Vec<3>(0, 1, 1);
    // A cube that widens hides its outline at rest.
    const float opacity = contractions_[done()] < 0 || axial_strain < 0 ? 0.8f : 1.0f;
    linear_body::draw_surface(
        scene, *this, mesh, [&](Index n) -> Vec<3> { return mesh.points().col(n) + displacement_.col(n) + aside; }, opacity);
    scene.box(position(0, 0, 0), position(length, length, length), Ink::rest, 2, true);
}

void PoissonLesson::draw_pull(Scene& scene) const {
    const Real L = length, s = strains_[done()], low = 0.5 * contractions_[done()] * L, high = L - low;
    if (s == 0) return;
    ArrowMarks pull{.from = {}, .to = {}};
    for (const Real y : {0.25, 0.75})
        for (const Real z : {0.25, 0.75}) {
            const Vec<3> on_face((1 + s) * L, low + y * (high - low), low + z * (high - low));
            (s > 0 ? pull.from : pull.to).push_back(position<3>(on_face));
            (s > 0 ? pull.to : pull.from).push_back(position<3>(on_face + Vec<3>(0.3 * L, 0, 0)));
        }
    scene.arrows.push_back(std::move(pull));
}

// Length and lengthening below the front edge, narrowing at the near end.
void PoissonLesson::draw_measures(Scene& scene) const {
    const Real L = length, s = strains_[done()], narrower = contractions_[done()] * L;
    const Real wider = std::max<Real>(0, -0.5 * narrower), below = -0.14 * L - wider, front = L + wider;
    const auto at = [front](Real x, Real y) { return position(x, y, front); };
    scene.dimension_line(at(0, below), at(L, below), fmt::format("L = {}", format_quantity(L, "m")), 0, 16);
    if (s == 0) return;
    scene.line(at(L, 0), at(L, 1.5 * below), Ink::rest);
    scene.line(at((1 + s) * L, 0.5 * narrower), at((1 + s) * L, 1.5 * below), Ink::accent);
    scene.line(at(L, below), at((1 + s) * L, below), Ink::accent, 4);
    scene.label(at((1 + 0.5 * s) * L, 1.5 * below), fmt::format("ΔL = {}", format_quantity(s * L, "m")), Ink::accent, 0, 16);
    if (narrower == 0) return;
    // Half of the narrowing above, half below.
    scene.line(at(0, L), at(0, L - 0.5 * narrower), Ink::accent, 4);
    scene.line(at(0, 0), at(0, 0.5 * narrower), Ink::accent, 4);
    scene.label(at(0, std::max(L, L - 0.5 * narrower)), fmt::format("½ ΔL′ = {}", format_quantity(0.5 * narrower, "m", 3)),
                Ink::accent, -20, -14);
}

void PoissonLesson::write_notes(Scene& scene) const {
    if (done() == 0) return;
    const Real s = reached(), nu = poisson_ratio;
    const auto number = [](Real x) { return format_quantity(x, ""); };
    scene.notes.push_back(
        fmt::format("exact: ΔL′/L = 1 − (1 + {})^(−{}) = {}", number(s), as_factor(nu), number(exact_contraction(nu, s))));
    scene.notes.push_back(
        fmt::format("estimate: ν ΔL/L = {} · {} = {}", number(nu), as_factor(s), number(linear_contraction(nu, s))));
    scene.notes.push_back(fmt::format("finite elements, {} of {} steps: {}", done(), steps(), number(contractions_[done()])));
    scene.notes.push_back(fmt::format("V/V₀ = {}, exact {}", number(volumes_[done()]), number(exact_volume_ratio(nu, s))));
}

// Coordinates of the panel are metres; its deflection is drawn as it is.
void PoissonLesson::draw_panel(Scene& scene) const {
    const SimplexMesh<2>& mesh = membrane_->mesh();
    TriangleMarks surface{.corners = {}, .triangles = {}, .values = scene.values(*this, On::node), .edges = true};
    for (Index n = 0; n < mesh.node_count(); ++n)
        surface.corners.push_back(position<2>(mesh.points().col(n) + displacement_.col(n).head<2>()));
    for (Index e = 0; e < mesh.simplex_count(); ++e)
        surface.triangles.push_back({mesh.simplices()(0, e), mesh.simplices()(1, e), mesh.simplices()(2, e)});
    const Position tip = surface.corners[static_cast<std::size_t>(membrane_->tip())];
    scene.triangles.push_back(std::move(surface));

    const std::array<Position, 4> corner{position(0, 0), position(48, 44), position(48, 60), position(0, 44)};
    for (std::size_t k = 0; k < 4; ++k) scene.line(corner[k], corner[(k + 1) % 4], Ink::rest, 2, true);
    scene.line(position(0, -2), position(0, 46), Ink::fixed, 5);
    scene.points.push_back({.at = {tip}, .ink = Ink::accent, .radius = 6});
    if (done() > 0) draw_deflection(scene, tip);
    scene.notes.push_back("plane strain, Y = 1 Pa, F = 1 N/m");
    scene.frame(position(-6, -4), position(62, 86));
}

void PoissonLesson::draw_deflection(Scene& scene, Position tip) const {
    scene.arrow(position(54, tip[1] - 10), position(54, tip[1]), Ink::force, "F = 1 N/m");
    scene.line(position(48, 52), tip, Ink::accent, 3);
    const Real nu = ratio_of_round(done() - 1);
    const Index cells = 2 * Index(membrane_cells);
    scene.notes.push_back(fmt::format("ν = {}: u_y = {} on {} × {} cells", format_quantity(nu, "", 5),
                                      format_quantity(deflections_[done() - 1], "m"), cells, cells));
    if (const auto times = probe("times_too_stiff").value())
        scene.notes.push_back(fmt::format("converged u_y = {}: {} times too stiff",
                                          format_quantity(*converged_deflection(nu), "m"), format_quantity(*times, "", 3)));
}

std::optional<UnstructuredGrid> PoissonLesson::unstructured_grid() const {
    if (bends()) return linear_body::grid_of_body(membrane_->mesh(), displacement_);
    return linear_body::grid_of_body(cube_->rest(), displacement_);
}

}  // namespace pliant::poisson
