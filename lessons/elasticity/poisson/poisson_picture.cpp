// The figure: the cube at rest as an outline and the stretched one with its measures, or the bent panel.
#include "poisson.h"

#include "kits/linear_body/linear_body_picture.h"

#include <pliant/continuum/contraction_law.h>
#include <pliant/solids/cooks_membrane_table.h>

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::poisson {
namespace {

Position at(const Vec<3>& x) { return position<3>(x); }

}  // namespace

void PoissonLesson::draw(Scene& scene) const {
    if (bends()) return draw_membrane(scene);
    draw_cube(scene);
    draw_pull(scene);
    draw_measures(scene);
    write_notes(scene);
    const Real L = length, end = std::max<Real>(1, 1 + axial_strain) * L;
    const Real wide = std::max<Real>(0, -exact_contraction(poisson_ratio, axial_strain)) * L;
    scene.frame(at({-0.35 * L, -0.35 * L - 0.5 * wide, -0.1 * L - 0.5 * wide}),
                at({end + 0.6 * L, 1.25 * L + 0.5 * wide, 1.15 * L + 0.5 * wide}));
}

// Drawn about its middle, as in the lecture's figure: it narrows on both sides.
void PoissonLesson::draw_cube(Scene& scene) const {
    const SimplexMesh<3>& mesh = cube_->rest();
    const Vec<3> aside = 0.5 * contractions_[done()] * length * Vec<3>(0, 1, 1);
    // A cube that widens hides its outline at rest.
    const float opacity = contractions_[done()] < 0 || axial_strain < 0 ? 0.8f : 1.0f;
    linear_body::draw_surface(
        scene, *this, mesh, [&](Index n) -> Vec<3> { return mesh.points().col(n) + displacement_.col(n) + aside; }, opacity);
    scene.box(at(Vec<3>::Zero()), at(Vec<3>::Constant(length)), Ink::rest, 2, true);
}

void PoissonLesson::draw_pull(Scene& scene) const {
    const Real L = length, s = strains_[done()], low = 0.5 * contractions_[done()] * L, high = L - low;
    if (s == 0) return;
    ArrowMarks pull{.from = {}, .to = {}};
    for (const Real y : {0.25, 0.75})
        for (const Real z : {0.25, 0.75}) {
            const Vec<3> on_face((1 + s) * L, low + y * (high - low), low + z * (high - low));
            const Vec<3> off_face = on_face + Vec<3>(0.3 * L, 0, 0);
            pull.from.push_back(at(s > 0 ? on_face : off_face));
            pull.to.push_back(at(s > 0 ? off_face : on_face));
        }
    scene.arrows.push_back(std::move(pull));
}

// Length and lengthening below the front edge, narrowing at the near end.
void PoissonLesson::draw_measures(Scene& scene) const {
    const Real L = length, s = strains_[done()], narrower = contractions_[done()] * L;
    const Real wider = std::max<Real>(0, -0.5 * narrower), below = -0.14 * L - wider, front = L + wider;
    scene.dimension_line(at({0, below, front}), at({L, below, front}), fmt::format("L = {}", format_quantity(L, "m")), 0, 16);
    if (s == 0) return;
    scene.line(at({L, 0, front}), at({L, 1.5 * below, front}), Ink::rest);
    scene.line(at({(1 + s) * L, 0.5 * narrower, front}), at({(1 + s) * L, 1.5 * below, front}), Ink::accent);
    scene.line(at({L, below, front}), at({(1 + s) * L, below, front}), Ink::accent, 4);
    scene.label(at({(1 + 0.5 * s) * L, 1.5 * below, front}), fmt::format("ΔL = {}", format_quantity(s * L, "m")), Ink::accent, 0,
                16);
    if (narrower == 0) return;
    // Half of the narrowing above, half below.
    scene.line(at({0, L, front}), at({0, L - 0.5 * narrower, front}), Ink::accent, 4);
    scene.line(at({0, 0, front}), at({0, 0.5 * narrower, front}), Ink::accent, 4);
    scene.label(at({0, std::max(L, L - 0.5 * narrower), front}),
                fmt::format("½ ΔL′ = {}", format_quantity(0.5 * narrower, "m", 3)), Ink::accent, -20, -14);
}

void PoissonLesson::write_notes(Scene& scene) const {
    if (done() == 0) return;
    const Real s = reached(), nu = poisson_ratio;
    const auto number = [](Real x) { return format_quantity(x, ""); };
    scene.notes.push_back(fmt::format("exact: ΔL′/L = 1 − (1 + {})^(−{}) = {}", format_quantity(s, ""), as_factor(nu),
                                      number(exact_contraction(nu, s))));
    scene.notes.push_back(
        fmt::format("estimate: ν ΔL/L = {} · {} = {}", format_quantity(nu, ""), as_factor(s), number(linear_contraction(nu, s))));
    scene.notes.push_back(fmt::format("finite elements, {} of {} steps: {}", done(), steps(), number(contractions_[done()])));
    scene.notes.push_back(fmt::format("V/V₀ = {}, exact {}", number(volumes_[done()]), number(exact_volume_ratio(nu, s))));
}

// Coordinates of the panel are metres; its deflection is drawn as it is.
void PoissonLesson::draw_membrane(Scene& scene) const {
    const SimplexMesh<2>& mesh = membrane_->mesh();
    const std::vector<float> on_nodes = scene.values(*this, On::node);
    TriangleMarks surface{.corners = {}, .triangles = {}, .ink = Ink::body, .edges = true};
    const auto place = [&](Index n) {
        const Vec<2> x = mesh.points().col(n) + displacement_.col(n).head<2>();
        return position<2>(x);
    };
    for (Index n = 0; n < mesh.node_count(); ++n) surface.corners.push_back(place(n));
    if (!on_nodes.empty()) surface.values = on_nodes;
    for (Index e = 0; e < mesh.simplex_count(); ++e)
        surface.triangles.push_back({mesh.simplices()(0, e), mesh.simplices()(1, e), mesh.simplices()(2, e)});
    scene.triangles.push_back(std::move(surface));

    const std::array<Position, 4> corner{position(0, 0), position(48, 44), position(48, 60), position(0, 44)};
    for (std::size_t k = 0; k < 4; ++k) scene.line(corner[k], corner[(k + 1) % 4], Ink::rest, 2, true);
    scene.line(position(0, -2), position(0, 46), Ink::fixed, 5);
    const Index tip = membrane_->tip();
    scene.points.push_back({.at = {place(tip)}, .ink = Ink::accent, .radius = 6});
    if (done() > 0) {
        const Position end = place(tip);
        scene.arrow(position(54, end[1] - 10), position(54, end[1]), Ink::force, "F = 1 N/m");
        const Real nu = ratios()[static_cast<std::size_t>(done() - 1)];
        scene.notes.push_back(fmt::format("ν = {}: u_y = {} on {} × {} cells", format_quantity(nu, "", 5),
                                          format_quantity(deflections_[done() - 1], "m"), 2 * Index(membrane_cells),
                                          2 * Index(membrane_cells)));
        if (const auto times = stiffness_ratio())
            scene.notes.push_back(fmt::format("converged u_y = {}: {} times too stiff",
                                              format_quantity(*converged_deflection(nu), "m"), format_quantity(*times, "", 3)));
        scene.line(position(48, 52), end, Ink::accent, 3);
    }
    scene.notes.push_back("plane strain, Y = 1 Pa, F = 1 N/m");
    scene.frame(position(-6, -4), position(62, 86));
}

}  // namespace pliant::poisson
