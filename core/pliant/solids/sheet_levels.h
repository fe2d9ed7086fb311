// A multilevel preconditioner for springs on a rectangular sheet of nodes.
#pragma once
#include <pliant/math/types.h>

#include <array>
#include <vector>

namespace pliant {

// Symmetric 3 x 3 block.
struct SymmetricBlock {
    Real xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
};

// Sheets of ever fewer nodes over the same square, joined by bilinear interpolation P: z = sum over levels of P_l D_l^-1 P_l^T r,
// where D_l are the diagonal blocks of P_l^T H P_l (additive multigrid with one Jacobi step on each level) [Bramble1990]. What
// takes block Jacobi alone as many iterations as there are nodes along the sheet, the tension that crosses it, the coarse levels
// carry at once.
class SheetLevels {
public:
    // nodes along both axes, the first running fastest. Sheets of fewer than 4 nodes along an axis have no coarse level.
    SheetLevels(Index nodes_x, Index nodes_y);

    // springs: for each node the sum of the blocks of springs that begin there, each times the square of its rest length in
    // cells; own: what acts on the node alone. D_l follows by interpolation of both: exact where they vary little within a coarse
    // cell.
    void prepare(const std::vector<SymmetricBlock>& springs, const std::vector<SymmetricBlock>& own);

    // z += the coarse levels' corrections for r.
    void add_corrections(const VecX& r, VecX& z) const;

private:
    struct Axis {
        Index fine = 0, coarse = 0;
        std::vector<Index> left;   // coarse node on the left of each fine one
        std::vector<Real> weight;  // of the one on its right
    };
    struct Level {
        Axis x, y;  // from the level before
        std::vector<SymmetricBlock> springs, own, inverse;
        mutable std::vector<Real> half, residual, correction;  // half: interpolated along x alone
    };
    static Axis halved(Index fine);
    template <int Count>
    static void restrict_to(const Level& level, const Real* fine, std::vector<Real>& half, Real* coarse);
    static void prolong(const Level& level, const Real* coarse, Real* fine);

    std::vector<Level> levels_;
    std::vector<Real> half_blocks_;
};

// Inverse by factors, L D L^T; false unless the block is positive definite and finite.
bool invert(const SymmetricBlock& block, SymmetricBlock& inverse);

inline void add_product(const SymmetricBlock& b, const Real* in, Real* out) {
    out[0] += b.xx * in[0] + b.xy * in[1] + b.xz * in[2];
    out[1] += b.xy * in[0] + b.yy * in[1] + b.yz * in[2];
    out[2] += b.xz * in[0] + b.yz * in[1] + b.zz * in[2];
}

}  // namespace pliant
