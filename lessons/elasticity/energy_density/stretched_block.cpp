#include "stretched_block.h"

#include <pliant/math/error.h>

namespace pliant::energies {
namespace {

SimplexMesh<3> make_block() {
    BlockShape<3> block;
    block.size = {1, StretchedBlock::width_at_rest, StretchedBlock::width_at_rest};
    block.cells = {4, 2, 2};
    return block_mesh<3>(block);
}

// Glued ends keep their places across; sliding ones have rollers on the lower faces.
DisplacementConstraints<3> make_supports(const SimplexMesh<3>& mesh, Ends ends, Real stretch) {
    DisplacementConstraints<3> supports(mesh.node_count());
    supports.prescribe(mesh.nodes("x_min"), 0, 0);
    supports.prescribe(mesh.nodes("x_max"), 0, stretch - 1);
    if (ends == Ends::glued) {
        for (const char* end : {"x_min", "x_max"})
            for (const int across : {1, 2}) supports.prescribe(mesh.nodes(end), across, 0);
    } else {
        supports.prescribe(mesh.nodes("y_min"), 1, 0);
        supports.prescribe(mesh.nodes("z_min"), 2, 0);
    }
    return supports;
}

}  // namespace

StretchedBlock::StretchedBlock(Energy energy, const Lame& material, Ends ends, Real stretch)
    : mesh_(make_block()),
      body_(mesh_, energy, material),
      supports_(make_supports(mesh_, ends, stretch)),
      newton_(body_, supports_, {.tolerance = 1e-9, .max_iterations = 100}),
      before_(Points<3>::Zero(3, mesh_.node_count())),
      nothing_(before_) {}

void StretchedBlock::begin() {
    before_.setZero(3, mesh_.node_count());
    newton_.begin(before_, Points<3>::Zero(3, mesh_.node_count()), supports_);
    step_length_ = 0;
    failed_ = false;
}

void StretchedBlock::iterate() {
    before_ = newton_.displacement();
    const Index iterations = newton_.iterations();
    try {
        newton_.iterate();
    } catch (const Diverged&) {
        failed_ = true;
    }
    step_length_ = newton_.iterations() > iterations ? newton_.step_length() : 0;
}

Real StretchedBlock::stress(const Points<3>& u) const {
    Points<3> force = Points<3>::Zero(3, mesh_.node_count());
    body_.internal_force(u, force);
    Real pull = 0;
    for (const Index n : mesh_.nodes("x_max")) pull += force(0, n);
    return pull / (width_at_rest * width_at_rest);
}

std::vector<Index> StretchedBlock::middle(bool upper) const {
    std::vector<Index> nodes;
    for (const Index n : mesh_.nodes(upper ? "z_max" : "z_min"))
        if (mesh_.points()(0, n) == 0.5) nodes.push_back(n);
    return nodes;
}

Real StretchedBlock::width(const Points<3>& u) const {
    const auto mean = [&](bool upper) {
        Real sum = 0;
        const auto nodes = middle(upper);
        for (const Index n : nodes) sum += u(2, n);
        return sum / static_cast<Real>(nodes.size());
    };
    return 1 + (mean(true) - mean(false)) / width_at_rest;
}

}  // namespace pliant::energies
