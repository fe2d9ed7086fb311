// Stiffness and damping matrices of a spring net: first derivatives of its forces.
#pragma once
#include <pliant/solids/springs.h>

namespace pliant {

// Which second derivatives of the spring energy to take: as they are, or with each spring's negative curvature (across a
// compressed spring, 1 - l/|x_ij| < 0) set to zero, which makes the sum positive semidefinite [Choi2002].
enum class SpringCurvature { exact, positive };

// A sparse symmetric matrix with a Dim x Dim block for every node and every spring. The pattern is analysed once; filling
// allocates nothing. Both triangles are stored.
template <int Dim>
class SpringMatrix {
public:
    explicit SpringMatrix(const Springs& springs);

    const SparseMatrix& matrix() const { return matrix_; }
    void set_zero() { matrix_.coeffs().setZero(); }

    // Adds K = -df/dx of add_spring_forces, N/m: each spring gives k (n n^T + (1 - l/|x_ij|)(I - n n^T)), n = x_ij/|x_ij|, to the
    // blocks of its nodes and its negative between them [Baraff1998]. A spring of length 0 gives k I for l = 0, else 0.
    void add_stiffness(const Springs& springs, PointsIn<Dim> x, SpringCurvature curvature);

    // Adds factor C, where -C v is what add_damping_forces adds; C is in N s/m.
    void add_damping(const Springs& springs, SpringDamping mode, PointsIn<Dim> x, Real factor);

    // Adds a block to a node's diagonal block.
    void add_at_node(Index node, const Mat<Dim>& block);

private:
    // Places of the blocks (i,i), (j,j), (i,j), (j,i) of a spring, as the row rank inside the block column.
    struct Places {
        std::int32_t ii, jj, ij, ji;
    };
    void add_spring(Index s, Index i, Index j, const Mat<Dim>& block);
    void add_block(Index column_node, std::int32_t rank, const Mat<Dim>& block);

    SparseMatrix matrix_;
    std::vector<Places> places_;
    std::vector<std::int32_t> diagonal_;  // of each node
};

}  // namespace pliant
