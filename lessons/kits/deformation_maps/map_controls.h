// The parameters of a chosen map x = phi(X), as several lessons offer them, and why a position or a gradient is what it is.
#pragma once
#include "gradient_entries.h"

#include <pliant/continuum/deformation_map.h>
#include <pliant/lesson/lesson.h>

#include <deque>

namespace pliant {

class MapControls {
public:
    enum class Offer { all, homogeneous };

    // The parameters join the lesson: map, angle (°), axis, stretch_x, stretch_y, stretch_z, shear, and where all maps are
    // offered bend_curvature (1/m), twist_rate (°/m), shift_x, shift_y, shift_z (m), whose initial values are given.
    MapControls(Lesson& owner, Offer offer, MapKind initial, const Vec<3>& shift);

    // The nine entries F11 ... F33 of the free map join here, so that a lesson may put its own parameters before them. To be
    // called once.
    void add_entries(Lesson& owner);

    DeformationMap map() const;
    MapKind kind() const { return kind_; }
    const GradientEntries& entries() const { return entries_; }

    // x_i of the material point X, whose coordinates are the given inputs with the symbols "X", "Y", "Z".
    Explanation why_position(int i, const std::array<Input, 3>& X) const;
    // du_i/dX_j there.
    Explanation why_gradient(int i, int j, const std::array<Input, 3>& X) const;

private:
    enum class Axis { z, x, y };

    int turning_axis() const;
    bool is(MapKind kind) const { return kind_ == kind; }
    Input turning_angle(const std::array<Input, 3>& X) const;
    Explanation why_moved(int i, std::string rest, std::vector<Input> inputs) const;
    Explanation why_free(int i, const std::array<Input, 3>& X) const;
    Explanation why_turned(int i, const std::array<Input, 3>& X) const;
    Explanation why_bent(int i, const std::array<Input, 3>& X) const;
    Explanation why_turned_gradient(int i, int j, int axis, const std::array<Input, 3>& X) const;
    Explanation why_bent_gradient(int i, int j, const std::array<Input, 3>& X) const;
    Explanation why_twisted_gradient(int i, int j, const std::array<Input, 3>& X) const;

    Choice<MapKind> kind_;
    Number angle_;
    Choice<Axis> axis_;
    std::deque<Number> stretches_;
    Number shear_;
    GradientEntries entries_;
    std::deque<Number> bending_;  // curvature and twist, where they are offered
    std::deque<Number> shift_;
};

}  // namespace pliant
