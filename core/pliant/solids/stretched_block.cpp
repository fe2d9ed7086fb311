#include <pliant/solids/stretched_block.h>

#include <pliant/math/error.h>

#include <cmath>

namespace pliant {
namespace {

SimplexMesh<3> stretched_block_mesh() {
    BlockShape<3> block;
    block.size = {1, StretchedBlock::width_at_rest, StretchedBlock::width_at_rest};
    block.cells = {4, 2, 2};
    return block_mesh<3>(block);
}

// Glued ends keep their places across; sliding ones have rollers on the lower faces.
DisplacementConstraints<3> stretched_block_supports(const SimplexMesh<3>& mesh, BlockEnds ends, Real stretch) {
    DisplacementConstraints<3> supports(mesh.node_count());
    supports.prescribe(mesh.nodes("x_min"), 0, 0);
    supports.prescribe(mesh.nodes("x_max"), 0, stretch - 1);
    if (ends == BlockEnds::glued) {
        for (const char* end : {"x_min", "x_max"})
            for (const int across : {1, 2}) supports.prescribe(mesh.nodes(end), across, 0);
    } else {
        supports.prescribe(mesh.nodes("y_min"), 1, 0);
        supports.prescribe(mesh.nodes("z_min"), 2, 0);
    }
    return supports;
}

}  // namespace

StretchedBlock::StretchedBlock(Energy energy, const Lame& material, BlockEnds ends, Real stretch)
    : mesh_(stretched_block_mesh()),
      body_(mesh_, energy, material),
      supports_(stretched_block_supports(mesh_, ends, stretch)),
      newton_(body_, supports_, {.tolerance = 1e-9, .max_iterations = 100}),
      nothing_(Points<3>::Zero(3, mesh_.node_count())) {
    begin();
}

void StretchedBlock::begin() {
    before_ = displacement_ = unbalanced_ = nothing_;
    newton_.begin(before_, nothing_, supports_);
    step_length_ = 0, residual_ = 1;
    failed_ = false;
}

void StretchedBlock::iterate() {
    before_ = displacement_;
    const Index iterations = newton_.iterations();
    try {
        newton_.iterate();
        failed_ = !is_sound();
    } catch (const Diverged&) {
        failed_ = true;
    }
    step_length_ = !failed_ && newton_.iterations() > iterations ? newton_.step_length() : 0;
    if (!failed_) advance();
}

void StretchedBlock::advance() {
    displacement_ = newton_.displacement();
    unbalanced_ = newton_.residual_force();
    residual_ = supports_.distance_from(displacement_) == 0 ? newton_.residual() : 1;
}

bool StretchedBlock::is_sound() const {
    const auto within = [](const Points<3>& numbers, Real most) {
        return numbers.allFinite() && numbers.cwiseAbs().maxCoeff() <= most;
    };
    const Lame material = body_.density(0).material();
    return within(newton_.displacement(), farthest) && within(newton_.step(), farthest) &&
           within(newton_.residual_force(), strongest * (material.mu + std::abs(material.lambda)));
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

}  // namespace pliant
