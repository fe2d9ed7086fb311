#include <pliant/math/error.h>
#include <pliant/solids/springs.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant {
namespace {

std::string name(Index s, const Spring& spring) { return fmt::format("spring {} (nodes {} and {})", s, spring.i, spring.j); }

void require_not_negative(const std::string& of, const char* what, Real value, const char* unit) {
    if (!(value >= 0) || !std::isfinite(value)) throw Refused(of + ": " + what, value, unit, "a finite number >= 0");
}

void require_valid(Index s, const Spring& spring, Index node_count) {
    for (const Index node : {spring.i, spring.j})
        if (node < 0 || node >= node_count)
            throw Refused(fmt::format("{}: node {} does not exist, there are {} nodes", name(s, spring), node, node_count));
    if (spring.i == spring.j) throw Refused(name(s, spring) + ": joins a node to itself");
    require_not_negative(name(s, spring), "rest_length", spring.rest_length, "m");
    require_not_negative(name(s, spring), "stiffness", spring.stiffness, "N/m");
    require_not_negative(name(s, spring), "damping", spring.damping, "N s/m");
}

void require_no_duplicates(const std::vector<Spring>& springs) {
    std::vector<std::array<Index, 3>> sorted;  // smaller node, larger node, spring
    sorted.reserve(springs.size());
    for (const Spring& spring : springs)
        sorted.push_back({std::min(spring.i, spring.j), std::max(spring.i, spring.j), static_cast<Index>(sorted.size())});
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t n = 1; n < sorted.size(); ++n)
        if (sorted[n][0] == sorted[n - 1][0] && sorted[n][1] == sorted[n - 1][1])
            throw Refused(fmt::format("{}: joins the same nodes as spring {}",
                                      name(sorted[n][2], springs[static_cast<std::size_t>(sorted[n][2])]), sorted[n - 1][2]));
}

void require_run(Index first, Index count, Index size) {
    if (first < 0 || count < 0 || first > size - count)
        throw Refused(fmt::format("springs {} to {} do not exist: there are {} springs", first, first + count - 1, size));
}

}  // namespace

Springs::Springs(Index node_count, const std::vector<Spring>& springs)
    : node_count_(node_count), rest_length_(springs.size()), stiffness_(springs.size()), damping_(springs.size()) {
    nodes_.reserve(springs.size());
    for (Index s = 0; s < static_cast<Index>(springs.size()); ++s) {
        const Spring& spring = springs[static_cast<std::size_t>(s)];
        require_valid(s, spring, node_count);
        nodes_.push_back({static_cast<std::int32_t>(spring.i), static_cast<std::int32_t>(spring.j)});
        rest_length_[s] = spring.rest_length;
        stiffness_[s] = spring.stiffness;
        damping_[s] = spring.damping;
    }
    require_no_duplicates(springs);
}

void Springs::set_stiffness(Index first, Index count, Real stiffness) {
    require_run(first, count, size());
    require_not_negative("springs", "stiffness", stiffness, "N/m");
    stiffness_.segment(first, count).setConstant(stiffness);
}

void Springs::set_damping(Index first, Index count, Real damping) {
    require_run(first, count, size());
    require_not_negative("springs", "damping", damping, "N s/m");
    damping_.segment(first, count).setConstant(damping);
}

template <int Dim>
void append_springs(PointsIn<Dim> points, const std::vector<std::array<Index, 2>>& pairs, Real stiffness, Real damping,
                    std::vector<Spring>& springs) {
    springs.reserve(springs.size() + pairs.size());
    for (const auto& [i, j] : pairs) springs.push_back({i, j, (points.col(j) - points.col(i)).norm(), stiffness, damping});
}

// A vector as the processor holds it: x and y in one register, z (0 in 2D) in another.
struct Arrow {
    Eigen::Array2d xy;
    Real z;
};

template <int Dim>
inline Arrow difference(const Real* x, Index from, Index to) {
    const Real *a = x + Dim * from, *b = x + Dim * to;
    return {Eigen::Map<const Eigen::Array2d>(b) - Eigen::Map<const Eigen::Array2d>(a), Dim == 3 ? b[Dim - 1] - a[Dim - 1] : 0};
}

template <int Dim>
inline void add_at(Real* f, Index node, const Eigen::Array2d& xy, Real z) {
    Eigen::Map<Eigen::Array2d>(f + Dim * node) += xy;
    if (Dim == 3) f[Dim * node + Dim - 1] += z;
}

template <int Dim>
inline void take_at(Real* f, Index node, const Eigen::Array2d& xy, Real z) {
    Eigen::Map<Eigen::Array2d>(f + Dim * node) -= xy;
    if (Dim == 3) f[Dim * node + Dim - 1] -= z;
}

// Force per length of two springs, k (1 - l/|x_ij|), N/m; 0 at length 0. 1/|x_ij| is |x_ij| / |x_ij|^2, whose division need not
// wait for the root.
inline Eigen::Array2d force_per_length(const Eigen::Array2d& squared_length, const Real* rest_length, const Real* stiffness) {
    using In = Eigen::Map<const Eigen::Array2d>;
    const Eigen::Array2d length = squared_length.sqrt(), inverse = 1 / squared_length.max(std::numeric_limits<Real>::min());
    return In(stiffness) * (length - In(rest_length)) * (length * inverse);
}

// Sums the forces of springs that follow each other and share their first node, and adds them to it at once.
template <int Dim>
class FirstNode {
public:
    FirstNode(Real* force, Index node) : force_(force), node_(node) {}
    void add(Index node, const Eigen::Array2d& xy, Real z) {
        if (node != node_) {
            flush();
            node_ = node, xy_.setZero(), z_ = 0;
        }
        xy_ += xy, z_ += z;
    }
    void flush() { add_at<Dim>(force_, node_, xy_, z_); }

private:
    Real* force_;
    Index node_;
    Eigen::Array2d xy_ = Eigen::Array2d::Zero();
    Real z_ = 0;
};

// Two springs at a time: the processor takes two roots and two divisions, which bound the speed, for the price of one.
template <int Dim>
void add_spring_forces(const Springs& springs, PointsIn<Dim> x, PointsOut<Dim> f) {
    const Real *rest_length = springs.rest_length().data(), *stiffness = springs.stiffness().data(), *at = x.data();
    Real* force = f.data();
    const auto* nodes = springs.nodes();
    const Index count = springs.size();
    if (count == 0) return;
    FirstNode<Dim> first(force, nodes[0][0]);
    Index s = 0;
    for (; s + 1 < count; s += 2) {
        const Index i = nodes[s][0], j = nodes[s][1], k = nodes[s + 1][0], l = nodes[s + 1][1];
        const Arrow a = difference<Dim>(at, i, j), b = difference<Dim>(at, k, l);
        const Eigen::Array2d aa = a.xy * a.xy, bb = b.xy * b.xy, z(a.z, b.z);
        const Eigen::Array2d squared = Eigen::Array2d(aa[0], bb[0]) + Eigen::Array2d(aa[1], bb[1]) + z * z;
        const Eigen::Array2d pull = force_per_length(squared, rest_length + s, stiffness + s);
        const Eigen::Array2d fa = pull[0] * a.xy, fb = pull[1] * b.xy, fz = pull * z;
        first.add(i, fa, fz[0]);
        take_at<Dim>(force, j, fa, fz[0]);
        first.add(k, fb, fz[1]);
        take_at<Dim>(force, l, fb, fz[1]);
    }
    if (s < count) {
        const Arrow a = difference<Dim>(at, springs.i(s), springs.j(s));
        const Real squared = a.xy.matrix().squaredNorm() + a.z * a.z;
        const Real ends[2] = {rest_length[s], 0}, k[2] = {stiffness[s], 0};
        const Real pull = force_per_length({squared, 1}, ends, k)[0];
        first.add(springs.i(s), pull * a.xy, pull * a.z);
        take_at<Dim>(force, springs.j(s), pull * a.xy, pull * a.z);
    }
    first.flush();
}

template <int Dim>
Real spring_energy(const Springs& springs, PointsIn<Dim> x) {
    Real energy = 0;
    for (Index s = 0, count = springs.size(); s < count; ++s) {
        const Index i = springs.i(s), j = springs.j(s);
        const Real elongation = (x.col(j) - x.col(i)).norm() - springs.rest_length()[s];
        energy += 0.5 * springs.stiffness()[s] * elongation * elongation;
    }
    return energy;
}

std::string_view formula_of(SpringDamping mode) {
    switch (mode) {
        case SpringDamping::naive:
            return "fᵢ = kᵈ vᵢⱼ,  vᵢⱼ = vⱼ − vᵢ";
        case SpringDamping::projected:
            return "fᵢ = kᵈ (vᵢⱼ·xᵢⱼ / (xᵢⱼ·xᵢⱼ)) xᵢⱼ,  vᵢⱼ = vⱼ − vᵢ";
        case SpringDamping::none:
            break;
    }
    return "";
}

template <int Dim>
Real spring_energy_rounding(const Springs& springs, PointsIn<Dim> x, Real extent) {
    const Real place = 1e4 * std::numeric_limits<Real>::epsilon() * (x.cwiseAbs().maxCoeff() + extent);
    return 0.5 * springs.stiffness().sum() * place * place;
}

template <int Dim>
void add_damping_forces(const Springs& springs, SpringDamping mode, PointsIn<Dim> x, PointsIn<Dim> v, PointsOut<Dim> f) {
    if (mode == SpringDamping::none) return;
    for (Index s = 0, count = springs.size(); s < count; ++s) {
        const Index i = springs.i(s), j = springs.j(s);
        Vec<Dim> force = springs.damping()[s] * (v.col(j) - v.col(i));
        if (mode == SpringDamping::projected) {
            const Vec<Dim> x_ij = x.col(j) - x.col(i);
            const Real length_squared = x_ij.squaredNorm();
            force = (length_squared > 0 ? force.dot(x_ij) / length_squared : 0) * x_ij;
        }
        f.col(i) += force;
        f.col(j) -= force;
    }
}

template <int Dim>
Real damping_power(const Springs& springs, SpringDamping mode, PointsIn<Dim> x, PointsIn<Dim> v) {
    if (mode == SpringDamping::none) return 0;
    Real power = 0;
    for (Index s = 0, count = springs.size(); s < count; ++s) {
        const Index i = springs.i(s), j = springs.j(s);
        const Vec<Dim> v_ij = v.col(j) - v.col(i);
        Real speed_squared = v_ij.squaredNorm();
        if (mode == SpringDamping::projected) {
            const Vec<Dim> x_ij = x.col(j) - x.col(i);
            const Real length_squared = x_ij.squaredNorm(), along = v_ij.dot(x_ij);
            speed_squared = length_squared > 0 ? along * along / length_squared : 0;
        }
        power += springs.damping()[s] * speed_squared;
    }
    return power;
}

template <int Dim>
void spring_tension(const Springs& springs, PointsIn<Dim> x, Eigen::Ref<VecX> tension) {
    for (Index s = 0, count = springs.size(); s < count; ++s) {
        const Index i = springs.i(s), j = springs.j(s);
        tension[s] = springs.stiffness()[s] * ((x.col(j) - x.col(i)).norm() - springs.rest_length()[s]);
    }
}

template <int Dim>
void spring_strain(const Springs& springs, PointsIn<Dim> x, Eigen::Ref<VecX> strain) {
    for (Index s = 0, count = springs.size(); s < count; ++s) {
        const Index i = springs.i(s), j = springs.j(s);
        const Real rest = springs.rest_length()[s];
        strain[s] = rest > 0 ? ((x.col(j) - x.col(i)).norm() - rest) / rest : 0;
    }
}

#define PLIANT_INSTANTIATE(Dim)                                                                                         \
    template void append_springs<Dim>(PointsIn<Dim>, const std::vector<std::array<Index, 2>>&, Real, Real,              \
                                      std::vector<Spring>&);                                                            \
    template void add_spring_forces<Dim>(const Springs&, PointsIn<Dim>, PointsOut<Dim>);                                \
    template Real spring_energy<Dim>(const Springs&, PointsIn<Dim>);                                                    \
    template Real spring_energy_rounding<Dim>(const Springs&, PointsIn<Dim>, Real);                                     \
    template void add_damping_forces<Dim>(const Springs&, SpringDamping, PointsIn<Dim>, PointsIn<Dim>, PointsOut<Dim>); \
    template Real damping_power<Dim>(const Springs&, SpringDamping, PointsIn<Dim>, PointsIn<Dim>);                      \
    template void spring_tension<Dim>(const Springs&, PointsIn<Dim>, Eigen::Ref<VecX>);                                 \
    template void spring_strain<Dim>(const Springs&, PointsIn<Dim>, Eigen::Ref<VecX>);

PLIANT_INSTANTIATE(2)
PLIANT_INSTANTIATE(3)
#undef PLIANT_INSTANTIATE

}  // namespace pliant
