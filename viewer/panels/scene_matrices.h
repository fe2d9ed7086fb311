// Matrices of the picture, in brackets.
#pragma once
#include "panels/panel_context.h"

#include <vector>

namespace pliant::viewer {

// Side by side along the lower edge of a picture, from the left, in rows that pile up; at most as many as fit into its lower
// half. Large and small numbers have a power of ten in common.
void draw_matrices(PanelContext& lab, const std::vector<MatrixMark>& matrices, const Rectangle& place);
// All that the picture has, in the largest type that fits into the room that is left in the window; a line where it has none.
void draw_filled_matrices(PanelContext& lab);

}  // namespace pliant::viewer
