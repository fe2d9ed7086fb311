// What every lesson with a flow on a staggered grid shows and measures in the same words.
#pragma once
#include "grid_why.h"

#include <pliant/fluids/flow_fields.h>
#include <pliant/lesson/lesson.h>

namespace pliant::grid2d {

// Of the velocity at the cell centres, and its length. `why` is asked when a person asks.
Field velocity_field(const FlowFields& flow, std::function<GridWhy()> why, std::string_view help);
Field speed_field(const FlowFields& flow, std::function<GridWhy()> why);
// The component of the velocity that is stored on the faces across an axis; beyond `largest`, m/s, the run is stopped.
Field stored_velocity(int axis, std::function<const FaceField<2>&()> velocity, Real largest);

// The largest magnitude in a field of the cells.
Probe largest_probe(std::string_view name, std::string_view symbol, std::string_view unit, std::string_view help,
                    const VecX& values, std::string_view field);

// Values at the centres of a row of n cells; the curve ends before the first that is not known.
void sample_centres(Curve& curve, Index n, Real dx, const std::function<std::optional<Real>(Index)>& value);

}  // namespace pliant::grid2d
