#include "given_field.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>

namespace pliant::projection {
namespace {

using std::numbers::pi;

Vec<2> metres(const Lattice<2>& lattice, Real dx, Index index) {
    const GridPlace<2> place = lattice.place(lattice.coordinates(index));
    return dx * Vec<2>(place[0], place[1]);
}

// A gradient whose normal part is 0 on the walls of the unit square, and which central and staggered differences find to be one.
Real wave(int axis, const Vec<2>& x) { return std::sin(2 * pi * x[axis]) * std::cos(2 * pi * x[1 - axis]); }

Real parity(const Lattice<2>& lattice, Index index) {
    const Counts<2> at = lattice.coordinates(index);
    return (at[0] + at[1]) % 2 == 0 ? 1 : -1;
}

}  // namespace

GivenField::GivenField(Given kind, Real speed, Input speed_input, bool periodic, std::vector<Push> pushes)
    : kind_(kind), speed_(speed), speed_input_(std::move(speed_input)), periodic_(periodic), pushes_(std::move(pushes)) {}

Vec<2> GivenField::way_from(const Push& push, const Vec<2>& x) const {
    Vec<2> d = x - push.middle;
    if (periodic_)
        for (Real& component : d) component -= std::round(component);
    return d;
}

Vec<2> GivenField::heading(const Push& push, const Vec<2>& x) const {
    const Vec<2> d = way_from(push, x);
    if (push.shape == Push::Shape::toward) return -d;
    return push.shape == Push::Shape::around ? Vec<2>(-d[1], d[0]) : d;
}

Real GivenField::pushed(const Push& push, int axis, const Vec<2>& x) const {
    const Vec<2> d = heading(push, x) / push.radius;
    const Real s = push.value[axis];
    if (push.shape == Push::Shape::along) return s * std::exp(-0.5 * d.squaredNorm());
    return s * d[axis] * std::exp(0.5 - 0.5 * d.squaredNorm());
}

void GivenField::fill(int axis, const Lattice<2>& lattice, Real dx, std::uint64_t seed, VecX& out) const {
    out.setZero(lattice.size());
    std::mt19937_64 noise(2 * seed + static_cast<std::uint64_t>(axis));
    for (Index i = 0; i < out.size(); ++i) {
        const Vec<2> x = metres(lattice, dx, i);
        if (kind_ == Given::random)
            out[i] = speed_ * (std::ldexp(static_cast<Real>(noise() >> 11), -52) - 1);  // in [−1, 1)
        else if (kind_ == Given::checkerboard)
            out[i] = speed_ * parity(lattice, i);
        else if (kind_ == Given::gradient)
            out[i] = speed_ * wave(axis, x);
        for (const Push& push : pushes_) out[i] += pushed(push, axis, x);
    }
}

Explanation GivenField::why_pushed(const std::string& left, const Push& push, int axis, const Vec<2>& x) const {
    const auto ax = static_cast<std::size_t>(axis);
    Explanation why{left, {push.speed[ax]}, {}};
    why.inputs.push_back(Input::constant("r", way_from(push, x).norm(), "m", "distance from the middle of the push"));
    why.inputs.push_back(Input::constant("ρ", push.radius, "m", "radius of the push"));
    if (push.shape == Push::Shape::along) {
        why.formula += " = s exp(−½ (r/ρ)²)";
        return why;
    }
    const char* meaning = push.shape == Push::Shape::around   ? "across the way from the middle, turned to the left"
                          : push.shape == Push::Shape::toward ? "way toward the middle"
                                                              : "way from the middle";
    why.inputs.push_back(Input::constant("d", heading(push, x)[axis], "m", meaning));
    why.formula += " = s (d / ρ) exp(½ − ½ (r/ρ)²)";
    return why;
}

Explanation GivenField::why(const std::string& left, int axis, const Lattice<2>& lattice, Real dx, Index index,
                            Real value) const {
    const Vec<2> x = metres(lattice, dx, index);
    if (kind_ == Given::random)
        return {left + " = U q",
                {speed_input_, Input::constant("q", speed_ == 0 ? 0 : value / speed_, "", "number from the seed")}};
    if (kind_ == Given::checkerboard)
        return {left + " = U q",
                {speed_input_, Input::constant("q", parity(lattice, index), "", "+1 and −1 in turn, along x and along y")}};
    if (kind_ == Given::gradient) {
        const char* along = axis == 0 ? "x" : "y";
        const char* across = axis == 0 ? "y" : "x";
        return {fmt::format("{} = U sin(2π {} / L) cos(2π {} / L)", left, along, across),
                {speed_input_, Input::constant(along, x[axis], "m", "of the place"),
                 Input::constant(across, x[1 - axis], "m", "of the place"), Input::constant("L", 1, "m", "side of the square")}};
    }
    if (kind_ == Given::through_flow) return fixed_value(left + " = 0   (at rest before the inflow is felt)");
    std::vector<Input> terms;
    for (std::size_t k = 0; k < pushes_.size(); ++k) {
        const std::string symbol = fmt::format("f{}", k + 1);
        terms.push_back(Input::part(symbol, "m/s", why_pushed(symbol, pushes_[k], axis, x)));
    }
    std::string sum = left + " = f1";
    for (std::size_t k = 1; k < terms.size(); ++k) sum += " + " + terms[k].symbol;
    return {sum, std::move(terms)};
}

}  // namespace pliant::projection
