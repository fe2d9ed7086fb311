// The figure: the block at rest as an outline, the deformed one coloured by a field, its supports, loads and measures.
#include "kits/linear_body/linear_body_picture.h"
#include "moduli.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::moduli {
namespace {

// A bar that is longer than this many widths is drawn thicker than it is, a plate longer, so that it can be seen.
constexpr Real drawn_slenderness = 6;

Position at(const Vec<3>& x) { return position<3>(x); }

}  // namespace

// So that the full load is drawn as a strain of about 0.12 to 0.3, and every load of a test alike.
Real ModuliLesson::drawn_magnification() const {
    if (magnification > 0) return magnification;
    const Vec<3> u = specimen_->exact_displacement(load, {length, width, width});
    const Vec<3> along(test == Test::shear ? width : length, width, width);
    const Real full = u.cwiseQuotient(along).cwiseAbs().maxCoeff();
    return linear_body::magnification_for(full);
}

// Scale of the drawn block along each axis; 1 unless the block is very long or very flat. In shear it would change the angle.
Vec<3> ModuliLesson::drawn_stretch() const {
    if (test == Test::shear) return Vec<3>::Ones();
    const Real slender = length / width / drawn_slenderness, flat = width / length / drawn_slenderness;
    const Real across = std::max<Real>(1, slender);
    return {std::max<Real>(1, flat), across, across};
}

// The block is drawn about its middle, as textbooks do: a narrowing shows on both sides of it, and not only on those that are not
// on rollers. That moves the whole block, so that no strain changes.
Vec<3> ModuliLesson::drawn(const Vec<3>& X, const Vec<3>& u) const {
    Vec<3> middle = Vec<3>::Zero();
    if (test != Test::shear) middle = specimen_->exact_displacement(applied(), 0.5 * Vec<3>(length, width, width));
    if (test == Test::tension) middle[0] = 0;
    return drawn_stretch().cwiseProduct(X + drawn_magnification() * (u - middle));
}

void ModuliLesson::draw(Scene& scene) const {
    draw_supports(scene);
    draw_body(scene);
    if (test == Test::tension) draw_tension(scene);
    if (test == Test::shear) draw_shear(scene);
    if (test == Test::pressure) draw_pressure(scene);
    write_notes(scene);
    const auto [L, w] = drawn_size();
    scene.frame(at({-0.25 * w, -0.3 * w, -0.1 * w}), at({L + 0.8 * w, 1.3 * w, 1.1 * w}));
}

void ModuliLesson::draw_body(Scene& scene) const {
    const SimplexMesh<3>& mesh = specimen_->mesh();
    linear_body::draw_surface(scene, *this, mesh, [&](Index n) { return drawn(mesh.points().col(n), displacement_.col(n)); });
    const auto [L, w] = drawn_size();
    scene.box(at(Vec<3>::Zero()), at({L, w, w}), Ink::rest, 2, true);
}

// A plate behind the face that is held.
void ModuliLesson::draw_supports(Scene& scene) const {
    if (test == Test::pressure) return;
    const auto [L, w] = drawn_size();
    const Real out = 0.2 * w, below = -0.004 * w;
    TriangleMarks plate{.corners = {}, .triangles = {{0, 1, 2}, {0, 2, 3}}, .ink = Ink::fixed, .opacity = 0.45f};
    if (test == Test::tension)
        plate.corners = {at({below, -out, -out}), at({below, w + out, -out}), at({below, w + out, w + out}),
                         at({below, -out, w + out})};
    else
        plate.corners = {at({-out, below, -out}), at({L + out, below, -out}), at({L + out, below, w + out}),
                         at({-out, below, w + out})};
    scene.triangles.push_back(std::move(plate));
}

void ModuliLesson::draw_tension(Scene& scene) const {
    const auto [L, w] = drawn_size();
    const Real reach = 0.4 * w * std::abs(level_[0]) / static_cast<Real>(load_levels);
    const Vec<3> low = drawn_exact({length, 0, 0}), high = drawn_exact({length, width, width});

    // The pull on the free end. A push is drawn towards the face.
    if (level() > 0 && load != 0) {
        ArrowMarks pull{.from = {}, .to = {}};
        for (const Real y : {0.2, 0.5, 0.8})
            for (const Real z : {0.2, 0.5, 0.8}) {
                const Vec<3> on_face(high[0], low[1] + y * (high[1] - low[1]), low[2] + z * (high[2] - low[2]));
                const Vec<3> off_face = on_face + Vec<3>(reach, 0, 0);
                pull.from.push_back(at(load > 0 ? on_face : off_face));
                pull.to.push_back(at(load > 0 ? off_face : on_face));
            }
        scene.arrows.push_back(std::move(pull));
        // Above the arrows, so that it is clear of them also where the picture ends there.
        scene.label(at({high[0] + reach, high[1], 0.2 * w}),
                    fmt::format("F = {}", format_quantity(specimen_->support_force(reaction_), "N")), Ink::force, 20, -14);
    }

    // Length below the front edge, lengthening beyond it; width across the middle.
    const Real below = -0.2 * w, front = 1.02 * w;
    scene.dimension_line(at({0, below, w}), at({L, below, w}), fmt::format("L = {}", format_quantity(length, "m")), 0, 16);
    scene.line(at({L, 0, w}), at({L, 1.4 * below, w}), Ink::rest);
    if (const Real longer = specimen_->strain(displacement_) * length; longer != 0) {
        scene.line(at({high[0], below, w}), at({L, below, w}), Ink::accent, 4);
        scene.line(at({high[0], low[1], high[2]}), at({high[0], 1.4 * below, w}), Ink::accent);
        scene.label(at({0.5 * (L + high[0]), 1.4 * below, w}), fmt::format("ΔL = {}", format_quantity(longer, "m")), Ink::accent,
                    0, 14);
    }
    scene.dimension_line(at({0.5 * L, w, front}), at({0.5 * L, 0, front}), fmt::format("w = {}", format_quantity(width, "m")), 46,
                         0);
    scene.label(at({0, 1.2 * w, 0.5 * w}), fmt::format("A = {}", format_quantity(specimen_->area(), "m²")), Ink::fixed, 0, -26);
}

void ModuliLesson::draw_shear(Scene& scene) const {
    const auto [L, w] = drawn_size();
    const Real reach = std::min(0.5 * w, 0.26 * L) * level_[0] / static_cast<Real>(load_levels) * (load < 0 ? -1 : 1);
    const Vec<3> shift = drawn_exact({0, width, 0}) - Vec<3>(0, w, 0);

    // The shear along the top, and the support's answer below.
    if (reach != 0 && load != 0) {
        ArrowMarks top{.from = {}, .to = {}}, bottom{.from = {}, .to = {}, .ink = Ink::fixed};
        for (const Real x : {0.15, 0.5, 0.85})
            for (const Real z : {0.1, 0.9}) {
                const Vec<3> from = Vec<3>(x * L - 0.5 * reach, 1.12 * w, z * w) + shift;
                top.from.push_back(at(from));
                top.to.push_back(at(from + Vec<3>(reach, 0, 0)));
            }
        for (const Real x : {0.15, 0.5, 0.85}) {
            const Vec<3> from(x * L + 0.5 * reach, -0.03 * w, 1.12 * w);
            bottom.from.push_back(at(from));
            bottom.to.push_back(at(from - Vec<3>(reach, 0, 0)));
        }
        scene.arrows.push_back(std::move(top));
        scene.arrows.push_back(std::move(bottom));
        scene.label(at(Vec<3>(L + 0.2 * w, 1.12 * w, 0.5 * w) + shift),
                    fmt::format("F = {}", format_quantity(specimen_->support_force(reaction_), "N")), Ink::force, 30, -24);
    }

    // Sideways shift over height, on the front face.
    const Real front = 1.005 * w;
    scene.dimension_line(at({-0.1 * w, 0, w}), at({-0.1 * w, w, w}), fmt::format("L = {}", format_quantity(width, "m")), -46, 0);
    if (const Real shifted = specimen_->strain(displacement_) * width; shifted != 0) {
        scene.line(at({0, 1.04 * w, front}), at(Vec<3>(0, 1.04 * w, front) + shift), Ink::accent, 4);
        scene.line(at({0, 0, front}), at({0, w, front}), Ink::accent);
        scene.line(at({0, 0, front}), at(Vec<3>(0, w, front) + shift), Ink::accent, 2.5f);
        scene.label(at(Vec<3>(0, 1.04 * w, front) + 0.5 * shift), fmt::format("ΔL = {}", format_quantity(shifted, "m")),
                    Ink::accent, -40, -14);
    }
    scene.label(at({0.5 * L, 0, 1.2 * w}), fmt::format("A = {}", format_quantity(specimen_->area(), "m²")), Ink::fixed, 0, 30);
}

void ModuliLesson::draw_pressure(Scene& scene) const {
    const auto [L, w] = drawn_size();
    const Real gap = 0.03 * w, reach = 0.35 * w * level_[0] / static_cast<Real>(load_levels);
    const Vec<3> low = drawn_exact(Vec<3>::Zero()), high = drawn_exact({length, width, width});

    // Arrows onto the three faces that can be seen (off them under a negative pressure).
    if (level() > 0 && load != 0) {
        ArrowMarks push{.from = {}, .to = {}};
        const auto arrow = [&](const Vec<3>& share, int axis) {
            Vec<3> near = low + share.cwiseProduct(high - low);
            near[axis] += gap;
            const Vec<3> far = near + reach * Vec<3>::Unit(axis);
            push.from.push_back(at(load > 0 ? far : near));
            push.to.push_back(at(load > 0 ? near : far));
        };
        for (const Real b : {0.25, 0.75}) {
            for (const Real a : {0.25, 0.75}) arrow({1, a, b}, 0);
            for (const Real x : {0.15, 0.5, 0.85}) {
                arrow({x, 1, b}, 1);
                arrow({x, b, 1}, 2);
            }
        }
        scene.arrows.push_back(std::move(push));
        scene.label(at({high[0] + gap + reach, 0.75 * w, 0.25 * w}),
                    fmt::format("ΔP = {}", format_quantity(stresses_[measured_level()], "Pa")), Ink::force, 40, -20);
        scene.label(at({0.5 * L, high[1] + reach, 0.5 * w}),
                    fmt::format("ΔV/V = {}", format_quantity(strains_[measured_level()], "")), Ink::accent, 0, -34);
    }
    scene.dimension_line(at({0, -0.14 * w, w}), at({L, -0.14 * w, w}), fmt::format("L = {}", format_quantity(length, "m")), 0,
                         16);
}

void ModuliLesson::write_notes(Scene& scene) const {
    scene.notes.push_back(fmt::format("deformation drawn ×{}", format_quantity(drawn_magnification(), "")));
    const Vec<3> stretch = drawn_stretch();
    if (stretch[1] > 1) scene.notes.push_back(fmt::format("width drawn ×{}", format_quantity(stretch[1], "", 2)));
    if (stretch[0] > 1) scene.notes.push_back(fmt::format("length drawn ×{}", format_quantity(stretch[0], "", 2)));
    const std::optional<Real> modulus = measured_modulus();
    if (!modulus) return;
    const std::string stress = format_quantity(stresses_[measured_level()], "Pa"),
                      strain = format_quantity(strains_[measured_level()], ""), result = format_quantity(*modulus, "Pa");
    scene.notes.push_back(test == Test::pressure ? fmt::format("B = −ΔP / (ΔV/V) = −{} / ({}) = {}", stress, strain, result)
                                                 : fmt::format("{} = (F/A) / (ΔL/L) = {} / {} = {}",
                                                               test == Test::tension ? "Y" : "G", stress, strain, result));
}

std::optional<UnstructuredGrid> ModuliLesson::unstructured_grid() const {
    return linear_body::grid_of_body(specimen_->mesh(), displacement_);
}

}  // namespace pliant::moduli
