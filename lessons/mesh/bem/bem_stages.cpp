// The stages: from the outline over the two matrices to the stress inside.
#include "bem.h"

#include <algorithm>
#include <type_traits>

namespace pliant::bem {
namespace {

constexpr Index most_passes = 64;

template <class Elements>
constexpr int dimension_of = std::remove_cvref_t<Elements>::dimension;

}  // namespace

void BemLesson::declare_stages() {
    const auto why = [](auto answer) { return [answer](const Question& q) { return answer(q); }; };
    const auto more = [this] { return tally_[source] < static_cast<Real>(body_->node_count()); };
    formula_symbols = {
        {"x"},      {"N"},       {"ξ"},        {"U", "1/Pa"}, {"T", "1/m"}, {"ν′"},       {"n"}, {"e"},         {"δ_ij"},
        {"H"},      {"u", "m"},  {"t", "Pa"},  {"dS", "m"},   {"A"},        {"σ", "Pa"},  {"ε"}, {"D"},         {"S", "Pa/m"},
        {"b", "m"}, {"u∞", "m"}, {"σ∞", "Pa"}, {"L"},         {"R"},        {"P"},        {"c"}, {"t̄", "Pa"},   {"E′", "Pa"},
        {"κ"},      {"r", "m"},  {"d", "m"},   {"s", "1/Pa"}, {"K", "N/m"}, {"f", "N/m"}, {"Σ"}, {"G", "m/Pa"}, {"y", "m"}};
    stages = {
        stage_of("outline", "x(ξ) = Σ_a N_a(ξ) x_a,   n_x = dy / dl,   n_y = −dx / dl",
                 "Brebbia1984 §5.4; the lecture: a surface in place of a volume", [this] { lay_out(); })
            .done_in("core/pliant/solids/bem/boundary_curve.cpp: BoundaryCurve::add_loop, BoundaryElement::normal")
            .where({{"x", "m"}, {"dx", "m"}, {"dy", "m"}, {"dl", "m"}})
            .maps({}, {"normal", "element_size"})
            .because(why([this](const Question& q) { return std::optional(why_geometry(q)); })),
        stage_of("kernel",
                 "U_ij = s (e_i e_j − (3 − 4 ν′) δ_ij ln(r/d)),   T_ij = −(e_n (c δ_ij + 2 e_i e_j) − c (e_i n_j − e_j n_i)) / "
                 "(4 π (1 − ν′) r)",
                 "Kelvin's solution for a force at one point, in the plane; c = 1 − 2 ν′ [Brebbia1984 §5.3]",
                 [this] { place_source(); })
            .done_in("core/pliant/solids/bem/kelvin.cpp: displacement, traction")
            .maps({"normal"},
                  {"kernel_displacement", "kernel_traction", "kernel_displacement_in_space", "kernel_traction_in_space"})
            .because(why([this](const Question& q) { return why_kernel(q); })),
        stage_of("fill", "H_ij = ∫ T N_j dS,   G_ij = ∫ U N_j dS", "Somigliana's identity at every node [Brebbia1984 §5.5]",
                 [this] { fill_rows(); })
            .done_in("core/pliant/solids/bem/plane_boundary_elements.cpp: integrate_beside, integrate_own")
            .maps({"normal"}, {"H", "G"})
            .loops_from("kernel", more)
            .because(why([this](const Question& q) { return std::optional(why_entry(q)); })),
        stage_of("rigid_body", "H_ii = c − Σ_(j≠i) H_ij",
                 "a rigid translation needs no traction; c is 0 for a body, 1 around a hole [Brebbia1984 §5.5]",
                 [this] { close_rows(); })
            .done_in("core/pliant/solids/bem/boundary_system.cpp: end_rows")
            .where({{"c"}})
            .maps({"H"}, {"H"})
            .because(why([this](const Question& q) { return std::optional(why_own_block(q)); })),
        stage_of("conditions", "t = t̄,   u = 0",
                 "the traction where nothing holds, the displacement where something does [Brebbia1984 §5.5]",
                 [this] { condition(); })
            .done_in("lessons/mesh/bem/bem_stages.cpp: condition")
            .maps({"normal"}, {"given_traction"})
            .because(why([this](const Question& q) { return std::optional(why_traction(q)); })),
        stage_of("exchange", "H u = G t + u∞   ⇔   A x = b", "columns of what is known go to the right [Brebbia1984 §5.5]",
                 [this] { exchange(); })
            .done_in("core/pliant/solids/bem/boundary_system.cpp: solve")
            .where({{"x", "m"}})
            .maps({"H", "G", "given_traction"}, {"right_side"})
            .because(why([this](const Question& q) { return std::optional(why_right_side(q)); })),
        stage_of("solve", "A x = b,   P A = L R",
                 "the matrix is full and not symmetric: Gauss, row by row with pivots [Golub2013 §3.4]", [this] { solve(); })
            .done_in("core/pliant/math/dense_lu.cpp: DenseLu::DenseLu, DenseLu::factorize_panel")
            .where({{"x", "m"}})
            .maps({"H", "G", "right_side", "given_traction"}, {"displacement", "traction"})
            .because(why([this](const Question& q) { return std::optional(why_unknown(q)); })),
        stage_of("on_boundary", "σ_τ = E′ ε_τ + κ t_n,   ε_τ = du_τ / ds",
                 "from how the boundary stretches, and its traction [Brebbia1984 §5.6]", [this] { read_boundary(); })
            .done_in("core/pliant/solids/bem/plane_boundary_elements.cpp: boundary_stress")
            .where({{"du", "m"}, {"ds", "m"}})
            .maps({"displacement", "traction"}, {"boundary_stress"})
            .because(why([this](const Question& q) { return std::optional(why_boundary_stress(q)); })),
        stage_of("inside", "u(X) = u∞ + ∫ U t dS − ∫ T u dS,   σ(X) = σ∞ + ∫ D t dS − ∫ S u dS",
                 "Somigliana's identity, where it is asked for [Brebbia1984 §5.6]", [this] { find_inside(); })
            .done_in("core/pliant/solids/bem/plane_boundary_elements.cpp: inside_sums")
            .where({{"X", "m"}, {"D", "1/m"}, {"S", "Pa/m²"}})
            .maps({"displacement", "traction"}, {"inside_displacement", "inside_stress"})
            .because(why([this](const Question& q) { return std::optional(why_inside(q)); })),
        stage_of("compare", "n_fem = n (e_fem / e)^(1/q)",
                 "the lecture: a surface in place of a volume; linear triangles [Hughes2000 §2.7]", [this] { compare(); })
            .done_in("lessons/mesh/bem/comparison.cpp: finite_effort, compare_efforts")
            .where({{"n_fem"}, {"n"}, {"e_fem"}, {"e"}, {"q"}})
            .maps({"displacement"}, {"finite_element_unknowns", "finite_element_entries", "finite_element_operations"})
            .when([this] { return is(Setting::ring); })
            .because(why([this](const Question& q) { return why_effort(q); }))};
}

// Everything starts from nothing, so that a step does not depend on the one before.
void BemLesson::lay_out() {
    const Index nodes = body_->node_count(), slots = body_->slot_count(), n = body_->element_count();
    body_->set_point(point());
    body_->change([](auto& bem, auto&) { bem.clear(); });
    normal_ = body_->normals, size_ = body_->sizes;
    for (Points<3>* on_elements : {&kernel_displacement_, &kernel_traction_}) on_elements->setZero(3, n);
    const Index dim = body_->dimension();
    H_.setZero(shows_matrices() ? dim * nodes * dim * nodes : 0);
    G_.setZero(shows_matrices() ? dim * nodes * dim * slots : 0);
    for (Points<3>* on_slots : {&given_traction_, &traction_}) on_slots->setZero(3, slots);
    for (Points<3>* on_nodes : {&right_side_, &displacement_}) on_nodes->setZero(3, nodes);
    boundary_stress_.setZero(9, n);
    const auto particles = static_cast<Index>(body_->inside().particles.size());
    inside_displacement_.setZero(3, particles), inside_stress_.setZero(9, particles);
    tally_[source] = tally_[solved] = tally_[found_inside] = tally_[done] = 0;
}

Index BemLesson::rows_per_pass() const { return (body_->node_count() + most_passes - 1) / most_passes; }

// A unit force along x at the node whose rows are next, as it is felt in the middles of the elements.
void BemLesson::place_source() {
    const Vec<3> X = body_->nodes.col(static_cast<Index>(tally_[source]));
    body_->with([&](const auto& bem, const auto&) {
        constexpr int dim = dimension_of<decltype(bem)>;
        for (Index k = 0; k < body_->element_count(); ++k) {
            const Vec<3> way = body_->middles.col(k) - X;
            kernel_displacement_.col(k).setZero(), kernel_traction_.col(k).setZero();
            if (at_source(k)) continue;
            const Vec<dim> r = way.template head<dim>(), n = normal_.col(k).template head<dim>();
            kernel_displacement_.col(k) = in_three(Vec<dim>(bem.kelvin().displacement(r).row(0)));
            kernel_traction_.col(k) = in_three(Vec<dim>(bem.kelvin().traction(r, n).row(0)));
        }
    });
}

// Does the source lie in the middle of the element, where Kelvin's solution has no value?
bool BemLesson::at_source(Index element) const {
    const Vec<3> X = body_->nodes.col(static_cast<Index>(tally_[source]));
    return (body_->middles.col(element) - X).norm() < 1e-9 * (body_->in_space() ? std::sqrt(size_[element]) : size_[element]);
}

void BemLesson::fill_rows() {
    const Index first = static_cast<Index>(tally_[source]), last = std::min(first + rows_per_pass(), body_->node_count());
    body_->change([&](auto& bem, auto&) {
        for (Index node = first; node < last; ++node) bem.integrate(node);
        if (!shows_matrices()) return;
        constexpr int dim = dimension_of<decltype(bem)>;
        const MatX &H = bem.system().H(), &G = bem.system().G();
        H_.reshaped(H.cols(), H.rows()).middleCols(dim * first, dim * (last - first)) =
            H.middleRows(dim * first, dim * (last - first)).transpose();
        G_.reshaped(G.cols(), G.rows()).middleCols(dim * first, dim * (last - first)) =
            G.middleRows(dim * first, dim * (last - first)).transpose();
    });
    tally_[source] = static_cast<Real>(last);
}

void BemLesson::close_rows() {
    body_->change([&](auto& bem, auto&) {
        for (Index node = 0; node < body_->node_count(); ++node) bem.close(node);
        if (shows_matrices()) H_ = bem.system().H().transpose().reshaped();
    });
}

void BemLesson::condition() {
    for (Index k = 0; k < body_->element_count(); ++k)
        for (int a = 0; a < body_->nodes_per_element(); ++a) {
            const Index slot = body_->slot_of(k, a);
            const Vec<3> n = body_->slot_normals.col(slot);
            Vec<3> t = Vec<3>::Zero();
            if (body_->on_inner(k)) t = -pressure * n;
            if (pulled_edge(k)) t = {0, remote_stress * n.y(), 0};
            if (is(Setting::outline) && body_->arc(k) == Index(loaded_side) - 1) t = {load_x, load_y, 0};
            given_traction_.col(slot) = t;
        }
}

// The upper or the lower edge of the plate.
bool BemLesson::pulled_edge(Index element) const {
    return is(Setting::plate_with_hole) && !body_->on_inner(element) && body_->arc(element) % 2 == 0;
}

// Known displacements are all 0, so b = G t + u∞.
void BemLesson::exchange() {
    body_->change([&](auto& bem, auto&) {
        constexpr int dim = dimension_of<decltype(bem)>;
        const Points<dim> t = given_traction_.topRows<dim>();
        VecX b = bem.system().G() * flat(t);
        if (is(Setting::hole)) b += remote_displacements();
        right_side_.topRows<dim>() = b.reshaped(dim, body_->node_count());
    });
}

void BemLesson::solve() {
    body_->change([&](auto& bem, auto& solution) {
        constexpr int dim = dimension_of<decltype(bem)>;
        BoundaryConditions conditions = bem.system().free_boundary();
        for (Index s = 0; s < body_->slot_count(); ++s)
            conditions.value.segment<dim>(dim * s) = given_traction_.col(s).template head<dim>();
        if (is(Setting::hole)) conditions.remote = remote_displacements();
        for (Index k = 0; k < body_->element_count(); ++k)
            if (held(k))
                for (Index s = dim * bem.system().slot_of(k, 0);
                     s < dim * (bem.system().slot_of(k, 0) + body_->nodes_per_element()); ++s)
                    conditions.held[static_cast<std::size_t>(s)] = 1;
        solution = bem.system().solve(conditions);
        displacement_.topRows<dim>() = solution.displacement;
        traction_.topRows<dim>() = solution.traction;
    });
    tally_[solved] = 1;
}

VecX BemLesson::remote_displacements() const {
    const Points<2> u = exact_hole().remote_strain() * body_->nodes.topRows<2>();
    return flat(u);
}

void BemLesson::read_boundary() {
    body_->with([&](const auto& bem, const auto& solution) {
        for (Index k = 0; k < body_->element_count(); ++k) {
            if constexpr (dimension_of<decltype(bem)> == 2)
                tensor<3>(boundary_stress_, k) = in_three(bem.boundary_stress(solution, k, 0));
            else
                tensor<3>(boundary_stress_, k) = bem.boundary_stress(solution, k);
        }
    });
}

void BemLesson::find_at(Index particle) {
    const Vec<3> X = body_->inside().particles[static_cast<std::size_t>(particle)];
    inside_displacement_.col(particle).setZero(), inside_stress_.col(particle).setZero();
    if (!body_->contains(X)) return;
    body_->with([&](const auto& bem, const auto& solution) {
        constexpr int dim = dimension_of<decltype(bem)>;
        const auto sums = bem.inside_sums(X.head<dim>());
        inside_displacement_.col(particle) = in_three(sums.displacement(solution));
        tensor<3>(inside_stress_, particle) = in_three(sums.stress(solution));
    });
    if (!is(Setting::hole)) return;
    inside_displacement_.col(particle) += in_three(Vec<2>(exact_hole().remote_strain() * X.head<2>()));
    tensor<3>(inside_stress_, particle) += in_three(exact_hole().remote_stress());
}

void BemLesson::find_inside() {
    for (Index k = 0; k <= body_->point(); ++k) find_at(k);
    tally_[found_inside] = tally_[done] = 1;
}

}  // namespace pliant::bem
