// What a person looks at in a plane flow, made from the velocity on the faces when it is asked for.
#pragma once
#include <pliant/fluids/diagnostics.h>

#include <optional>
#include <span>

namespace pliant {

class FlowFields {
public:
    void reset(const StaggeredGrid<2>& grid, const FaceField<2>& velocity);
    // The velocity has changed.
    void renew() { centre_known_ = speed_known_ = vorticity_known_ = flow_known_ = false; }

    const Points<2>& centre_velocity() const;  // m/s, one column per cell
    const VecX& speed() const;                 // m/s, per cell
    const VecX& vorticity() const;             // 1/s, per cell
    const VelocitySampler<2>& flow() const;    // the velocity anywhere

private:
    const StaggeredGrid<2>* grid_ = nullptr;
    const FaceField<2>* velocity_ = nullptr;
    mutable Points<2> centre_;
    mutable VecX speed_, vorticity_;
    mutable std::optional<VelocitySampler<2>> flow_;
    mutable bool centre_known_ = false, speed_known_ = false, vorticity_known_ = false, flow_known_ = false;
};

// The numbers of a matrix, as the view of a field or of a state gives them.
template <class Matrix>
auto as_span(Matrix& m) {
    return std::span(m.data(), static_cast<std::size_t>(m.size()));
}

}  // namespace pliant
