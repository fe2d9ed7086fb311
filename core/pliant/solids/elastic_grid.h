// Elastic bodies on a regular grid of nodes by finite differences. At every corner of every cell the neighbours along the axes
// give F by one-sided differences, and the body's energy is the sum of dx^Dim / 2^Dim psi(F) over all corners. Its derivative at
// a node inside is the difference formula of the field equation:
//   linear energy    Navier–Lamé, mu ∇²u + (lambda + mu) ∇(∇·u), with second differences along the axes and the 4-point cross
//   derivative
//                    (u(+,+) - u(+,-) - u(-,+) + u(-,-)) / (4 dx²)
//   StVK             the difference of the metric tensors G = F^T F of the deformed and the undeformed shape [Terzopoulos1987 §4]
// and at a boundary node the same with no traction from outside.
#pragma once
#include <pliant/continuum/energy_density.h>
#include <pliant/continuum/strain.h>
#include <pliant/math/element_assembly.h>
#include <pliant/solids/elastic_body.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace pliant {

template <int Dim>
class ElasticGrid final : public ElasticBody<Dim> {
public:
    using Cells = std::array<int, Dim>;

    // A box of cells of the size dx [m] from `origin` on, of which those stay that `inside` accepts by their centre [m]. Throws
    // Refused for a size that is not positive, less than one cell along an axis, or no cell left.
    ElasticGrid(const Cells& cells, Real dx, const Vec<Dim>& origin, const std::function<bool(const Vec<Dim>&)>& inside,
                Energy energy, const Lame& material);

    Real spacing() const { return dx_; }
    const Cells& cells() const { return cells_; }
    // Nodes of the cells that stayed, counted fastest along x.
    Index node_count() const override { return positions_.cols(); }
    const Points<Dim>& positions() const { return positions_; }  // m, at rest
    Index node_at(const Cells& place) const;                     // -1 where there is none
    Cells place_of(Index node) const { return places_[static_cast<std::size_t>(node)]; }
    Index cell_count() const { return cell_count_; }
    // Volume that a node stands for [m^Dim]: of each cell an equal part.
    const VecX& volumes() const { return volumes_; }
    // Has the node all cells around it?
    bool inside(Index node) const { return volumes_[node] > full_share_ * spacing_power(); }

    void check_support(const DisplacementConstraints<Dim>& constraints) const override;
    bool is_linear() const override { return density_.energy() == Energy::linear; }
    Real energy(const Points<Dim>& displacement) const override;
    void internal_force(const Points<Dim>& displacement, Points<Dim>& force) const override;
    void stiffness(const Points<Dim>& displacement, bool definite, SparseMatrix& matrix) const override;
    const SparseMatrix& pattern() const override { return assembly_->pattern(); }
    Real admissible_share(const Points<Dim>& displacement, const Points<Dim>& change) const override;

    // --- the samples: one at every corner of every cell, cell by cell, each with an equal part of its cell's volume ---
    Index sample_count() const { return corners_.cols(); }
    // The node at the corner, or its neighbour in the cell along an axis.
    Index node_of(Index sample) const { return corners_(0, sample); }
    Index neighbour_of(Index sample, int axis) const { return corners_(axis + 1, sample); }
    // From the corner to that neighbour along the axis: dx or -dx [m].
    Real step_of(Index sample, int axis) const { return dx_ * signs(static_cast<int>(sample % corners_of_cell))[axis]; }
    // One-sided differences H(i, j) = d(values_i)/dX_j at the corner.
    Mat<Dim> gradient(Index sample, const Points<Dim>& values) const;
    // Tensors of the samples, a column each, row by row: xx, xy, yx, yy.
    using Tensors = Eigen::Matrix<Real, Dim * Dim, Eigen::Dynamic>;
    // Adds the part d(P e_axis)/dX_axis of the force per volume [N/m^3] that stresses P [Pa] of the samples put on the nodes,
    // with no traction from outside. Summed over the axes it is -internal_force / volumes.
    void add_divergence(int axis, const Tensors& stress, Points<Dim>& force_density) const;

    // Longest stable step of the explicit scheme for waves inside: dx / sqrt(c_p² + (Dim - 1) c_s²), exact for the linear energy
    // by the Fourier symbol.
    Real stable_time_step(Real density) const;

private:
    static constexpr int corners_of_cell = 1 << Dim;
    using Corner = Eigen::Matrix<int, Dim + 1, Eigen::Dynamic>;  // the node at the corner, then its neighbours along the axes
    Real spacing_power() const;
    // Signs of the steps from corner `k` of a cell to its neighbours.
    static Vec<Dim> signs(int k);
    Mat<Dim> deformation_gradient(Index corner, const Points<Dim>& displacement) const;
    Real weight() const { return spacing_power() / corners_of_cell; }

    static constexpr Real full_share_ = 1 - 0.5 / (1 << Dim);
    Cells cells_;
    Real dx_;
    EnergyDensity<Dim> density_;
    std::vector<Index> node_of_place_;
    std::vector<Cells> places_;
    Points<Dim> positions_;
    VecX volumes_;
    Corner corners_;
    Index cell_count_ = 0;
    std::vector<std::vector<Index>> parts_;  // nodes of each disconnected part
    std::shared_ptr<const ElementAssembly<Dim, Dim + 1>> assembly_;
};

}  // namespace pliant
