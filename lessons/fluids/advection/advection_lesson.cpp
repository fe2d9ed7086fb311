#include "advection_lesson.h"

#include <pliant/fluids/diagnostics.h>
#include <pliant/text/format.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant::carrying {
namespace {

using std::numbers::pi;

const Registration<AdvectionLesson> registration{
    {.id = "fluids/advection",
     .title = "Advection",
     .summary = "A blob carried by a steady flow: the path back, the samples and their weights, and what each scheme loses.",
     .demo_steps = 60}};

}  // namespace

SteadyFlow AdvectionLesson::flow() const { return {field, direction * pi / 180}; }

// The translation starts in the middle; the others above it, where the flow is fast.
Blob AdvectionLesson::shape() const {
    const Vec<2> start = field == FlowKind::translation ? Vec<2>(0.5, 0.5) : Vec<2>(0.5, 0.75);
    return {blob, start, radius};
}

// ------------------------------------------------------------------------------------------------------ the initial state

void AdvectionLesson::reset() {
    StaggeredGridInfo<2> info;
    info.cells = {resolution, resolution};
    info.dx = dx();
    info.periodic.fill(flow().periodic());
    grid_ = std::make_unique<StaggeredGrid<2>>(info);
    velocity_ = face_velocity(*grid_, flow());
    advection_.reset();
    for (auto& rival : rivals_) rival.reset();
    const Index n = grid_->cells().size();
    origin_.resize(2, n);
    quantity_.resize(n);
    elapsed_.setZero();
    for (Index c = 0; c < n; ++c) {
        origin_.col(c) = centre_of(c);
        quantity_[c] = shape().value(centre_of(c));
    }
    for (VecX& q : rival_) q = compare ? quantity_ : VecX();
    previous_ = returned_ = exact_ = quantity_;
    error_ = way_ = VecX::Zero(n);
    middle_ = departure_ = origin_;
    cell_velocity(*grid_, velocity_, centre_velocity_);
    first_variance_ = variance(quantity_);
    first_moment_ = second_moment(quantity_);
    renew_advection();
}

// What carries follows from the parameters; a change of scheme begins with the next step.
void AdvectionLesson::renew_advection() {
    const auto renew = [this](std::unique_ptr<SemiLagrangian<2>>& advection, const AdvectionSettings& wanted) {
        if (advection && advection->settings() == wanted) return;
        advection = std::make_unique<SemiLagrangian<2>>(*grid_, wanted);
        VecX still = quantity_;
        advection->carry(still, velocity_, 0);
    };
    renew(advection_, grid2d::settings_of(scheme, back_trace));
    if (compare)
        for (std::size_t k = 0; k < 3; ++k) renew(rivals_[k], grid2d::settings_of(schemes[k], back_trace));
}

}  // namespace pliant::carrying
