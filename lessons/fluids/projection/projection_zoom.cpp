// The cell that is selected, drawn large beside the field: where velocity and pressure are stored, and the numbers that add up to
// its divergence.
#include "projection.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pliant::projection {
namespace {

constexpr Real edge = 0.23;             // of a cell in the zoom, m of the picture
const Vec<2> lower_corner{1.11, 0.16};  // of three by three cells
constexpr Real longest = 0.12;          // of an arrow there

// Middle of a cell of the three by three, counted from the middle one.
Vec<2> middle_of(int i, int j) { return lower_corner + edge * Vec<2>(i + 1.5, j + 1.5); }

std::string three_digits(Real value) { return fmt::format("{:.3g}", value); }
// What is nothing beside the largest numbers is not written out.
std::string short_number(Real value, Real beside) {
    if (value != 0 && std::abs(value) < 1e-4 * beside) return "≈ 0";
    return fmt::format("{:.2g}", value);
}

}  // namespace

Projection::Beside Projection::beside_selected() const {
    const Index cell = selected_cell();
    const Counts<2> at = grid_->cells().coordinates(cell);
    Beside b{};
    for (int k = 0; k < 4; ++k) {
        const int axis = k / 2, side = k % 2;
        Real& u = b.u[static_cast<std::size_t>(k)];
        if (staggered()) {
            Counts<2> face = at;
            face[axis] = (face[axis] + side) % grid_->faces(axis).count[axis];
            u = velocity_[axis][grid_->faces(axis).index(face)];
        } else {
            const Index n = grid_->cells().neighbour(at, axis, side == 0 ? -1 : 1);
            u = n >= 0 ? centre_(axis, n) : -centre_(axis, cell);
        }
    }
    b.divergence = (b.u[1] - b.u[0] + b.u[3] - b.u[2]) / ((staggered() ? 1 : 2) * dx());
    return b;
}

// "cell (8, 14): ∇·u = (0.2 − 0.1 + 0.4 − 0.5) / Δx = 0 1/s"
std::string Projection::selected_sum() const {
    const Counts<2> at = grid_->cells().coordinates(selected_cell());
    if (!grid_->is_fluid(selected_cell())) return fmt::format("cell ({}, {}) is solid", at[0], at[1]);
    const Beside b = beside_selected();
    const auto rounded = [](Real x) { return as_factor(std::strtod(three_digits(x).c_str(), nullptr)); };
    return fmt::format("cell ({}, {}): ∇·u = ({} − {} + {} − {}) / {} = {}", at[0], at[1], rounded(b.u[1]), rounded(b.u[0]),
                       rounded(b.u[3]), rounded(b.u[2]), staggered() ? "Δx" : "(2 Δx)", format_quantity(b.divergence, "1/s", 3));
}

void Projection::draw_zoom(Scene& scene) const {
    zoom_cells(scene);
    const Vec<2> low = middle_of(0, 0) - Vec<2>::Constant(edge / 2), high = low + Vec<2>::Constant(edge);
    scene.box(position<2>(low), position<2>(high), Ink::accent, 4);
    if (grid_->is_fluid(selected_cell())) zoom_velocity(scene);
    if (!scene.show_labels) return;
    const Real middle = middle_of(0, 0)[0];
    scene.label(position(middle, middle_of(0, 1)[1] + edge / 2), staggered() ? "u on faces, p in cells" : "u and p in cells",
                Ink::text, 0, -14);
    if (!grid_->is_fluid(selected_cell())) return;
    scene.label(position(middle, middle_of(0, -1)[1] - edge / 2),
                fmt::format("∇·u = {}", format_quantity(beside_selected().divergence, "1/s", 3)), Ink::accent, 0, 16);
}

// The cell and those around it, with their pressures; what is no fluid is filled.
void Projection::zoom_cells(Scene& scene) const {
    const Counts<2> at = grid_->cells().coordinates(selected_cell());
    LineMarks mesh{.ends = {}, .ink = Ink::rest, .width = 2};
    TriangleMarks solid{.corners = {}, .triangles = {}, .ink = Ink::ground, .opacity = 0.7f};
    PointMarks centres{.at = {}, .ink = Ink::text, .radius = 3};
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            Index cell = i == 0 ? selected_cell() : grid_->cells().neighbour(at, 0, i);
            if (cell >= 0 && j != 0) cell = grid_->cells().neighbour(grid_->cells().coordinates(cell), 1, j);
            const Vec<2> middle = middle_of(i, j);
            const auto corner = [&](int x, int y) { return position<2>(middle + edge * Vec<2>(x - 0.5, y - 0.5)); };
            const std::array<Position, 4> around{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
            if (cell < 0 || !grid_->is_fluid(cell)) {
                const int first = static_cast<int>(solid.corners.size());
                solid.corners.insert(solid.corners.end(), around.begin(), around.end());
                solid.triangles.push_back({first, first + 1, first + 2});
                solid.triangles.push_back({first, first + 2, first + 3});
                continue;
            }
            for (std::size_t k = 0; k < 4; ++k) mesh.ends.push_back(around[k]), mesh.ends.push_back(around[(k + 1) % 4]);
            centres.at.push_back(position<2>(middle));
            if (!scene.show_labels || (i != 0 && j != 0)) continue;
            // Where no arrow is.
            const float down = i == 0 && j == 0 ? 10.f : i != 0 ? 14.f : !staggered() ? 20.f : j == 1 ? -13.f : 14.f;
            const Real largest = pressure_.lpNorm<Eigen::Infinity>();
            scene.label(position<2>(middle), scene.awaits("pressure") ? "—" : short_number(pressure_[cell], largest), Ink::text,
                        0, down);
        }
    }
    scene.triangles.push_back(std::move(solid));
    scene.lines.push_back(std::move(mesh));
    scene.points.push_back(std::move(centres));
}

// On the faces of the cell, or in the cells beside it: then its own velocity takes no part.
void Projection::zoom_velocity(Scene& scene) const {
    const Beside b = beside_selected();
    const Real given_speed = std::sqrt(2 * tally_[energy_given]);
    const Real fastest =
        std::max(std::abs(*std::ranges::max_element(b.u, {}, [](Real x) { return std::abs(x); })), 1e-4 * given_speed);
    for (int k = 0; k < 4; ++k) {
        const int axis = k / 2;
        const Real out = k % 2 == 0 ? -1 : 1, value = b.u[static_cast<std::size_t>(k)];
        const Vec<2> middle = middle_of(0, 0) + out * (staggered() ? 0.5 : 1) * edge * Vec<2>::Unit(axis);
        const Real length = fastest > 0 ? longest * value / fastest : 0;
        if (std::abs(length) > 0.02) {
            const Vec<2> half = 0.5 * length * Vec<2>::Unit(axis);
            scene.arrows.push_back(
                {.from = {position<2>(middle - half)}, .to = {position<2>(middle + half)}, .ink = Ink::velocity, .width = 3.5f});
        }
        if (!scene.show_labels) continue;
        // Outside the cell, beside the arrow; in the cells beside it above the arrow.
        const Vec<2> at = !staggered() ? Vec<2>(0, axis == 0 ? -16 : -22)
                          : axis == 0  ? Vec<2>(26 * out, -16)
                                       : Vec<2>(34, -12 * out);
        scene.label(position<2>(middle), short_number(value, given_speed), Ink::velocity, static_cast<float>(at[0]),
                    static_cast<float>(at[1]));
    }
}

}  // namespace pliant::projection
