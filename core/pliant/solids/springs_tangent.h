// The linearised forces of a spring net in 3D as an operator: one symmetric 3 x 3 block for each spring, none assembled.
#pragma once
#include <pliant/solids/sheet_levels.h>
#include <pliant/solids/springs_matrix.h>
#include <pliant/time/linearised_system.h>

#include <optional>
#include <utility>

namespace pliant {

// Of each spring the block K_s that SpringMatrix adds with positive curvature and damping, six numbers beside each other; a
// product adds K_s (d_j - d_i) to both ends. Half as much memory passes as with blocks in rows, and no search is needed to fill
// it. The preconditioner inverts the diagonal blocks (block Jacobi): what acts on one node alone, however stiff, is solved
// exactly.
class SpringTangent final : public LinearisedSystem {
public:
    // springs: must outlive this; their values may change, their nodes not.
    explicit SpringTangent(const Springs& springs);
    // The nodes are a sheet of so many nodes along both axes, the first running fastest. Throws Refused when the numbers differ.
    void set_sheet(Index nodes_x, Index nodes_y);

    // Springs at x, with the dampers' directions at `start` and their damping times velocity_rate; clears what was added to
    // nodes.
    void fill(PointsIn<3> x, PointsIn<3> start, SpringDamping mode, Real velocity_rate);
    void add_at_node(Index node, const Mat<3>& block);
    // Inverts the diagonal blocks, after all has been added. Throws Diverged, naming the node, where one is not positive
    // definite.
    void prepare();

    void multiply(const VecX& d, VecX& Hd) const override;
    void precondition(const VecX& r, VecX& z) const override;
    Real diagonal(Index dof) const override;

    // Entries of a row other than the diagonal one, as (degree of freedom, N/m).
    std::vector<std::pair<Index, Real>> row(Index dof) const;

private:
    const Springs& springs_;
    std::vector<SymmetricBlock> blocks_;  // of the springs
    std::vector<SymmetricBlock> own_, whole_, inverse_,
        beginning_;  // of the nodes: what is added to them, the diagonal blocks, their
                     // inverses, and the springs that begin there for the levels
    std::optional<SheetLevels> levels_;
    VecX cells_squared_;  // square of each spring's rest length in cells
};

}  // namespace pliant
