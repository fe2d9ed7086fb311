#include <pliant/fluids/flow_fields.h>

namespace pliant {

void FlowFields::reset(const StaggeredGrid<2>& grid, const FaceField<2>& velocity) {
    grid_ = &grid;
    velocity_ = &velocity;
    flow_.emplace(grid);
    renew();
}

const Points<2>& FlowFields::centre_velocity() const {
    if (!centre_known_) cell_velocity(*grid_, *velocity_, centre_);
    centre_known_ = true;
    return centre_;
}

const VecX& FlowFields::speed() const {
    if (!speed_known_) speed_ = centre_velocity().colwise().norm();
    speed_known_ = true;
    return speed_;
}

const VecX& FlowFields::vorticity() const {
    if (!vorticity_known_) pliant::vorticity(*grid_, flow(), vorticity_);
    vorticity_known_ = true;
    return vorticity_;
}

const VelocitySampler<2>& FlowFields::flow() const {
    if (!flow_known_) flow_->set(*velocity_);
    flow_known_ = true;
    return *flow_;
}

}  // namespace pliant
