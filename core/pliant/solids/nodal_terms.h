// Forces on single nodes that hold for one implicit step: drag towards a velocity, and planes that nodes rest on. Their matrices
// are blocks of the diagonal, so that they may be as stiff as they like.
#pragma once
#include <pliant/solids/springs.h>

namespace pliant {

// A node held on the plane n . x = offset by a stiff spring across it, both ways: f = stiffness (offset - n . x) n.
template <int Dim>
struct NodePlane {
    Index node = -1;
    Vec<Dim> normal = Vec<Dim>::Zero();
    Real offset = 0;     // m
    Real stiffness = 0;  // N/m

    Real force(const Vec<Dim>& x) const { return stiffness * (offset - normal.dot(x)); }  // N, along the normal
};

template <int Dim>
struct NodalTerms {
    Points<Dim> force;           // N, one column per node, or none
    std::vector<Mat<Dim>> drag;  // C_i of f_i = -C_i v_i, N s/m, symmetric and positive semidefinite; one per node, or none
    std::vector<NodePlane<Dim>> planes;

    Real potential(PointsIn<Dim> x) const {
        Real energy = force.size() ? -force.cwiseProduct(x).sum() : Real{0};
        for (const NodePlane<Dim>& p : planes) energy += 0.5 * p.force(x.col(p.node)) * (p.offset - p.normal.dot(x.col(p.node)));
        return energy;
    }
    // v . C v, W
    Real drag_power(PointsIn<Dim> v) const {
        Real power = 0;
        for (std::size_t n = 0; n < drag.size(); ++n) {
            const auto at = v.col(static_cast<Index>(n));
            power += at.dot(drag[n] * at);
        }
        return power;
    }
    void add_forces(PointsIn<Dim> x, PointsIn<Dim> v, PointsOut<Dim> f) const {
        if (force.size()) f += force;
        for (std::size_t n = 0; n < drag.size(); ++n) f.col(static_cast<Index>(n)) -= drag[n] * v.col(static_cast<Index>(n));
        for (const NodePlane<Dim>& p : planes) f.col(p.node) += p.force(x.col(p.node)) * p.normal;
    }
    // add(node, block): adds the terms' second derivatives, N/m.
    template <class Add>
    void add_stiffness(Real velocity_rate, Add add) const {
        for (std::size_t n = 0; n < drag.size(); ++n) add(static_cast<Index>(n), Mat<Dim>(velocity_rate * drag[n]));
        for (const NodePlane<Dim>& p : planes) add(p.node, Mat<Dim>(p.stiffness * p.normal * p.normal.transpose()));
    }
};

}  // namespace pliant
