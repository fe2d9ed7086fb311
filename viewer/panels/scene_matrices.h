// Matrices of the picture, in brackets.
#pragma once
#include "panels/panel_context.h"

#include <vector>

namespace pliant::viewer {

// Side by side along the lower edge of a picture, from the left, in rows that pile up; at most as many as fit into its lower
// half. Large and small numbers have a power of ten in common.
void draw_matrices(PanelContext& lab, const std::vector<MatrixMark>& matrices, const Rectangle& place);

}  // namespace pliant::viewer
