// The figure: the block at rest as an outline, the deformed one coloured by a field, its supports, loads and measures.
#include "moduli.h"

#include <pliant/lesson/format.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace pliant::moduli {
namespace {

// Largest of 1, 2, 5, 10, 20, ... (or 0.5, 0.2, ...) that is not above the value.
Real round_down(Real value) {
    const Real decade = std::pow(10.0, std::floor(std::log10(value)));
    const Real lead = value / decade;
    return decade * (lead >= 5 ? 5 : lead >= 2 ? 2 : 1);
}

// Moves a point of the box [0, size] outward along one axis where it lies on the box's far side.
Position corner(const Vec<3>& x) { return position<3>(x); }

}  // namespace

// So that the largest displacement of the full load is drawn as about a sixth of the block: the same in every step of a test.
Real ModuliLesson::drawn_magnification() const {
    if (magnification > 0) return magnification;
    const Vec<3> size(length, width, width);
    const Real full = specimen_->exact_displacement(load, size).cwiseQuotient(size).cwiseAbs().maxCoeff();
    if (full == 0) return 1;
    const Real wanted = round_down(0.2 / full);
    return wanted < 1 && full < 0.6 ? 1 : wanted;
}

void ModuliLesson::draw(Scene& scene) const {
    draw_supports(scene);
    draw_body(scene);
    switch (test) {
        case Test::tension:
            draw_tension(scene);
            break;
        case Test::shear:
            draw_shear(scene);
            break;
        case Test::pressure:
            draw_pressure(scene);
            break;
    }
    write_notes(scene);
    const Real w = width;
    scene.frame(corner({-0.25 * w, -0.3 * w, -0.1 * w}), corner({length + 0.6 * w, 1.3 * w, 1.1 * w}));
}

// The deformed surface; a field of elements colours each facet by the element that it bounds.
void ModuliLesson::draw_body(Scene& scene) const {
    const SimplexMesh<3>& mesh = specimen_->mesh();
    TriangleMarks surface{.corners = {}, .triangles = {}, .ink = Ink::body, .edges = true};
    const std::vector<float> on_nodes = scene.values(*this, On::node), on_elements = scene.values(*this, On::element);
    for (Index f = 0; f < mesh.facet_count(); ++f) {
        const int first = static_cast<int>(surface.corners.size());
        surface.triangles.push_back({first, first + 1, first + 2});
        for (int a = 0; a < 3; ++a) {
            const Index n = mesh.facets()(a, f);
            surface.corners.push_back(position<3>(drawn(mesh.points().col(n), displacement_.col(n))));
            if (!on_nodes.empty()) surface.values.push_back(on_nodes[static_cast<std::size_t>(n)]);
            if (!on_elements.empty()) surface.values.push_back(on_elements[static_cast<std::size_t>(mesh.facet_simplex(f))]);
        }
        surface.pick.ids.push_back(mesh.facet_simplex(f));
    }
    surface.pick.pickable = true;
    surface.pick.on = On::element;
    scene.triangles.push_back(std::move(surface));
    scene.box(corner(Vec<3>::Zero()), corner({length, width, width}), Ink::rest, 2, true);
}

// A plate behind the face that is held.
void ModuliLesson::draw_supports(Scene& scene) const {
    if (test == Test::pressure) return;
    const Real w = width, out = 0.2 * w, below = -0.004 * w;
    TriangleMarks plate{.corners = {}, .triangles = {{0, 1, 2}, {0, 2, 3}}, .ink = Ink::fixed, .opacity = 0.45f};
    if (test == Test::tension)
        plate.corners = {corner({below, -out, -out}), corner({below, w + out, -out}), corner({below, w + out, w + out}),
                         corner({below, -out, w + out})};
    else
        plate.corners = {corner({-out, below, -out}), corner({length + out, below, -out}), corner({length + out, below, w + out}),
                         corner({-out, below, w + out})};
    scene.triangles.push_back(std::move(plate));
}

void ModuliLesson::draw_tension(Scene& scene) const {
    const Real L = length, w = width, reach = 0.4 * w * level_[0] / static_cast<Real>(load_levels) * (load < 0 ? -1 : 1);
    const Vec<3> end = drawn_exact({L, w, w});

    // The pull on the free end. A push is drawn towards the face.
    ArrowMarks pull{.from = {}, .to = {}};
    for (const Real y : {0.2, 0.5, 0.8})
        for (const Real z : {0.2, 0.5, 0.8}) {
            const Vec<3> on_face(end[0], y * end[1], z * end[2]), off = on_face + Vec<3>(std::abs(reach), 0, 0);
            pull.from.push_back(corner(reach > 0 ? on_face : off));
            pull.to.push_back(corner(reach > 0 ? off : on_face));
        }
    if (reach != 0) {
        scene.arrows.push_back(std::move(pull));
        scene.label(corner(Vec<3>(end[0] + std::abs(reach), 0.5 * end[1], 0.5 * end[2])),
                    fmt::format("F = {}", format_quantity(specimen_->support_force(reaction_), "N")), Ink::force, 14, -24);
    }

    // Length below the front edge, lengthening beyond it; width at the end.
    const Real below = -0.14 * w;
    scene.dimension_line(corner({0, below, w}), corner({L, below, w}), fmt::format("L = {}", format_quantity(L, "m")), 0, 16);
    scene.line(corner({L, 0, w}), corner({L, 1.6 * below, w}), Ink::rest);
    if (const Real longer = specimen_->strain(displacement_) * L; longer != 0) {
        scene.line(corner({end[0], below, w}), corner({L, below, w}), Ink::accent, 4);
        scene.line(corner({end[0], 0, end[2]}), corner({end[0], 1.6 * below, w}), Ink::accent);
        scene.label(corner({0.5 * (L + end[0]), 1.6 * below, w}), fmt::format("ΔL = {}", format_quantity(longer, "m")),
                    Ink::accent, 0, 14);
    }
    scene.dimension_line(corner({0.5 * L, 1.0 * w, 1.12 * w}), corner({0.5 * L, 0, 1.12 * w}),
                         fmt::format("w = {}", format_quantity(w, "m")), 46, 0);
    scene.label(corner({0.02 * L, w, 0}), fmt::format("A = {}", format_quantity(specimen_->area(), "m²")), Ink::fixed, 0, -14);
}

void ModuliLesson::draw_shear(Scene& scene) const {
    const Real L = length, w = width, reach = 0.5 * w * level_[0] / static_cast<Real>(load_levels) * (load < 0 ? -1 : 1);
    const Vec<3> shift = drawn_exact({0, w, 0}) - Vec<3>(0, w, 0);

    // The shear on the top, and the support's answer below.
    if (reach != 0) {
        ArrowMarks top{.from = {}, .to = {}}, bottom{.from = {}, .to = {}, .ink = Ink::fixed};
        for (const Real x : {0.15, 0.5, 0.85})
            for (const Real z : {0.25, 0.75}) {
                const Vec<3> at = Vec<3>(x * L - 0.5 * reach, 1.03 * w, z * w) + shift;
                top.from.push_back(corner(at));
                top.to.push_back(corner(at + Vec<3>(reach, 0, 0)));
            }
        for (const Real x : {0.25, 0.75}) {
            const Vec<3> at(x * L + 0.5 * reach, -0.05 * w, 1.05 * w);
            bottom.from.push_back(corner(at));
            bottom.to.push_back(corner(at - Vec<3>(reach, 0, 0)));
        }
        scene.arrows.push_back(std::move(top));
        scene.arrows.push_back(std::move(bottom));
        scene.label(corner(Vec<3>(L, 1.03 * w, 0.5 * w) + shift),
                    fmt::format("F = {}", format_quantity(specimen_->support_force(reaction_), "N")), Ink::force, 40, -20);
    }

    // Sideways shift over height, on the front face.
    scene.dimension_line(corner({-0.1 * w, 0, w}), corner({-0.1 * w, w, w}), fmt::format("L = {}", format_quantity(w, "m")), -46,
                         0);
    if (const Real shifted = specimen_->strain(displacement_) * w; shifted != 0) {
        scene.line(corner({0, w, w}), corner(Vec<3>(0, w, w) + shift), Ink::accent, 4);
        scene.line(corner({0, 0, w}), corner({0, w, w}), Ink::accent);
        scene.line(corner({0, 0, w}), corner(Vec<3>(0, w, w) + shift), Ink::accent);
        scene.label(corner(Vec<3>(0, w, w) + 0.5 * shift), fmt::format("ΔL = {}", format_quantity(shifted, "m")), Ink::accent, -6,
                    -16);
    }
    scene.label(corner({0.5 * L, 0, w}), fmt::format("A = {}", format_quantity(specimen_->area(), "m²")), Ink::fixed, 0, 26);
}

void ModuliLesson::draw_pressure(Scene& scene) const {
    const Real L = length, w = width, share = level_[0] / static_cast<Real>(load_levels), gap = 0.03 * w;
    const Real reach = 0.35 * w * share * (load < 0 ? -1 : 1);
    const Vec<3> end = drawn_exact({L, w, w});

    // Arrows onto the three faces that can be seen (off them under a negative pressure).
    ArrowMarks push{.from = {}, .to = {}};
    const auto arrow = [&](const Vec<3>& on_face, const Vec<3>& outward) {
        const Vec<3> near = on_face + gap * outward, far = near + std::abs(reach) * outward;
        push.from.push_back(corner(reach > 0 ? far : near));
        push.to.push_back(corner(reach > 0 ? near : far));
    };
    for (const Real a : {0.25, 0.75})
        for (const Real b : {0.25, 0.75}) arrow({end[0], a * end[1], b * end[2]}, Vec<3>::UnitX());
    for (const Real x : {0.15, 0.5, 0.85})
        for (const Real b : {0.25, 0.75}) {
            arrow({x * end[0], end[1], b * end[2]}, Vec<3>::UnitY());
            arrow({x * end[0], b * end[1], end[2]}, Vec<3>::UnitZ());
        }
    if (reach != 0) {
        scene.arrows.push_back(std::move(push));
        scene.label(corner({end[0] + gap + std::abs(reach), 0.75 * end[1], 0.25 * end[2]}),
                    fmt::format("ΔP = {}", format_quantity(stresses_[level()], "Pa")), Ink::force, 10, -20);
    }
    scene.dimension_line(corner({0, -0.14 * w, w}), corner({L, -0.14 * w, w}), fmt::format("L = {}", format_quantity(L, "m")), 0,
                         16);
    scene.label(corner({0.5 * L, w, 0.5 * w}),
                fmt::format("ΔV = {}", format_quantity(specimen_->strain(displacement_) * specimen_->mesh().volume(), "m³")),
                Ink::accent, 0, -56);
}

void ModuliLesson::write_notes(Scene& scene) const {
    scene.notes.push_back(fmt::format("deformation drawn ×{}", format_quantity(drawn_magnification(), "")));
    const std::optional<Real> modulus = measured_modulus();
    if (!modulus) return;
    const std::string stress = format_quantity(stresses_[level()], "Pa"), strain = format_quantity(strains_[level()], ""),
                      result = format_quantity(*modulus, "Pa");
    switch (test) {
        case Test::tension:
            scene.notes.push_back(fmt::format("Y = (F/A) / (ΔL/L) = {} / {} = {}", stress, strain, result));
            break;
        case Test::shear:
            scene.notes.push_back(fmt::format("G = (F/A) / (ΔL/L) = {} / {} = {}", stress, strain, result));
            break;
        case Test::pressure:
            scene.notes.push_back(fmt::format("B = −ΔP / (ΔV/V) = −{} / ({}) = {}", stress, strain, result));
            break;
    }
}

}  // namespace pliant::moduli
