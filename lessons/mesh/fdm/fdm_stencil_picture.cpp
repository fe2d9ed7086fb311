// The difference formula at one node: its neighbours lit in the body, and beside it the weights with which their displacements
// enter the force per volume along x.
#include "fdm.h"

#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pliant::fdm {
namespace {

struct Board {
    Vec<2> centre;  // m
    Real spacing;   // m between its nodes
    int of;         // axis of the displacements that enter
    std::string title;
};

Position on_board(const Board& board, int right, int up) { return position<2>(board.centre + board.spacing * Vec<2>(right, up)); }

void draw_board(const FdmLesson& l, Scene& picture, const Board& board, Real unit, int rows) {
    LineMarks net{.ends = {}, .ink = Ink::rest, .width = 1};
    for (int k = -1; k <= 1; ++k) {
        if (std::abs(k) <= rows) net.ends.push_back(on_board(board, -1, k)), net.ends.push_back(on_board(board, 1, k));
        if (rows > 0) net.ends.push_back(on_board(board, k, -1)), net.ends.push_back(on_board(board, k, 1));
    }
    picture.lines.push_back(std::move(net));
    PointMarks pulls{.at = {}, .ink = Ink::accent, .radius = 7}, none{.at = {}, .ink = Ink::rest, .radius = 4};
    for (int up = -rows; up <= rows; ++up)
        for (int right = -1; right <= 1; ++right) {
            const Real w = l.stencil_weight(0, right, up, board.of) / unit;
            const bool counts = std::abs(w) > 1e-9;
            (counts ? pulls : none).at.push_back(on_board(board, right, up));
            if (counts && picture.show_labels)
                picture.label(on_board(board, right, up), format_quantity(w, "", 3), Ink::text, 0, -16);
        }
    picture.points.push_back(std::move(pulls));
    picture.points.push_back(std::move(none));
    if (picture.show_labels)
        picture.label(position<2>(board.centre + Vec<2>(0, (rows > 0 ? 1.35 : 0.55) * board.spacing)), board.title, Ink::text, 0,
                      -14);
}

}  // namespace

Real FdmLesson::stencil_weight(int component, int right, int up, int of) const {
    const Index here = point();
    const auto [i, j] = grid().place_of(here);
    // A rod's rows move alike: what stands in them adds up.
    Real weight = 0;
    for (int row = is(GridShape::rod) ? -1 : up; row <= (is(GridShape::rod) ? 1 : up); ++row) {
        const Index there = grid().node_at({i + right, j + row});
        if (there < 0) continue;
        // What a small displacement there does to the force here.
        const Mat<2> block = stiffness_block(here, there);
        weight -= block(component, of) / grid().volumes()[here];
    }
    return weight;
}

// Second derivative of the energy of the samples that both nodes belong to, as the body is deformed now.
Mat<2> FdmLesson::stiffness_block(Index a, Index b) const {
    Mat<2> block = Mat<2>::Zero();
    const EnergyDensity<2> energy = body().density();
    const Real weight = spacing() * spacing() / 4;
    for (Index s = 0; s < grid().sample_count(); ++s) {
        const auto slope = [&](Index node) {
            Vec<2> g = Vec<2>::Zero();
            for (int axis = 0; axis < 2; ++axis) {
                if (grid().neighbour_of(s, axis) == node) g[axis] += 1 / grid().step_of(s, axis);
                if (grid().node_of(s) == node) g[axis] -= 1 / grid().step_of(s, axis);
            }
            return g;
        };
        const Vec<2> of_a = slope(a), of_b = slope(b);
        if (of_a.isZero(0) || of_b.isZero(0)) continue;
        const Mat<4> T = energy.tangent(Mat<2>::Identity() + grid().gradient(s, displacement_));
        for (int j = 0; j < 2; ++j)
            for (int m = 0; m < 2; ++m) block += weight * of_a[j] * of_b[m] * T.block<2, 2>(2 * j, 2 * m);
    }
    return block;
}

void FdmLesson::draw_stencil(Scene& picture) const {
    const Index here = point();
    const auto [i, j] = grid().place_of(here);
    const bool rod = is(GridShape::rod);
    // In the body: the node and all that enter.
    PointMarks lit{.at = {}, .ink = Ink::accent, .radius = grid().node_count() > 400 ? 3.0f : 4.5f};
    LineMarks ways{.ends = {}, .ink = Ink::accent, .width = 1.5f};
    for (int up = -1; up <= 1; ++up)
        for (int right = -1; right <= 1; ++right) {
            const Index there = grid().node_at({i + right, j + up});
            if (there < 0) continue;
            lit.at.push_back(node_place(there));
            if (there != here) ways.ends.push_back(node_place(here)), ways.ends.push_back(node_place(there));
        }
    picture.lines.push_back(std::move(ways));
    picture.points.push_back(std::move(lit));

    const Real L = length;
    const Real unit = (rod ? Real{youngs_modulus} : material().mu) / (spacing() * spacing());
    if (rod) {
        draw_board(*this, picture, {{0.5 * L, -0.6 * L}, 0.22 * L, 0, "u in f,  × Y/Δx²"}, unit, 0);
        return;
    }
    const bool disc = is(GridShape::disc);
    const Real x = disc ? 1.8 * L : 1.47 * L, s = disc ? 0.36 * L : 0.18 * L;
    const Real high = disc ? 0.5 * L : 0.78 * L, low = disc ? -0.72 * L : 0.22 * L;
    draw_board(*this, picture, {{x, high}, s, 0, "u_x in f_x,  × μ/Δx²"}, unit, 1);
    draw_board(*this, picture, {{x, low}, s, 1, "u_y in f_x,  × μ/Δx²"}, unit, 1);
}

}  // namespace pliant::fdm
