#include "body_meshes.h"

#include <pliant/continuum/deformation.h>
#include <pliant/mesh/element_mass.h>
#include <pliant/mesh/simplex_quadrature.h>
#include <pliant/solids/fem_loads.h>
#include <pliant/solids/hyperelastic_fem.h>
#include <pliant/solids/newton_equilibrium.h>

#include <cmath>
#include <limits>
#include <optional>

namespace pliant::solid_mesh {
namespace {

constexpr int load_degree = 6;  // of the rule for loads and errors that vary

Energy energy_of(Law law) {
    switch (law) {
        case Law::corotational:
            return Energy::corotated;
        case Law::stvk:
            return Energy::stvk;
        case Law::neo_hookean:
            return Energy::neo_hookean;
        case Law::linear:
            break;
    }
    return Energy::linear;
}

template <int Dim>
Lame material_of(const BodySettings& s) {
    const IsotropicModuli moduli = IsotropicModuli::from_young_poisson(s.youngs_modulus, s.poisson_ratio);
    return Dim == 2 && s.plane == Plane::stress ? moduli.plane_stress_lame() : moduli.lame();
}

template <int Dim, int Order>
class SolidOf final : public Solid {
    using Elements = SimplexElements<Dim, Order>;
    static constexpr int nodes = Elements::nodes;

public:
    SolidOf(const BodySettings& given, SimplexMesh<Dim> mesh)
        : Solid(given), mesh_(std::move(mesh)), body_(mesh_, energy_of(given.law), material_of<Dim>(given)) {
        const Elements& e = body_.elements();
        dim_ = Dim;
        lame_ = material_of<Dim>(given);
        rest_ = e.positions(), elements_ = e.elements(), facets_ = e.facets();
        volumes_ = mesh_.volumes(), facet_areas_ = mesh_.facet_areas();
        for (Index f = 0; f < mesh_.facet_count(); ++f) facet_elements_.push_back(mesh_.facet_simplex(f));
        fixed_facets_ = mesh_.facets("fixed"), loaded_facets_ = mesh_.facets("loaded");
        fixed_nodes_ = e.nodes_of_facets("fixed"), loaded_nodes_ = e.nodes_of_facets("loaded");
        share_loaded_area();
        about_.resize(static_cast<std::size_t>(node_count()));
        for (Index k = 0; k < element_count(); ++k)
            for (int a = 0; a < nodes; ++a) about_[static_cast<std::size_t>(elements_(a, k))].push_back({k, a});
        held_.assign(static_cast<std::size_t>(node_count()), 0);
    }

    MatX slopes(Index element) const override {
        typename Elements::Gradients sum = body_.elements().gradients(element, 0);
        for (int q = 1; q < Elements::points; ++q) sum += body_.elements().gradients(element, q);
        return sum / Elements::points;
    }
    Small deformation(Index element, const MatX& u) const override {
        if constexpr (Order == 1) return body_.deformation_gradient(element, u);
        Mat<Dim> F = Mat<Dim>::Identity();
        const MatX g = slopes(element);
        for (int a = 0; a < nodes; ++a) F += u.col(elements_(a, element)) * g.col(a).transpose();
        return F;
    }
    Small strain(const Small& given) const override {
        const Mat<Dim> F = given, H = F - Mat<Dim>::Identity();
        if (settings_.law == Law::linear) return cauchy_strain<Dim>(H);
        if (settings_.law != Law::corotational) return green_strain<Dim>(H);
        return polar_decomposition<Dim>(F).S - Mat<Dim>::Identity();
    }
    Small rotation(const Small& F) const override { return nearest_rotation<Dim>(Mat<Dim>(F)); }
    Small stress(const Small& F) const override { return body_.density(0).P(Mat<Dim>(F)); }
    Real von_mises(const Small& F) const override;
    MatX element_stiffness(Index element, const MatX& u) const override { return body_.element_stiffness(element, u, false); }

    Real energy(const MatX& u) const override { return body_.energy(u); }
    void internal_force(const MatX& u, MatX& force) const override {
        Points<Dim> f;
        body_.internal_force(u, f);
        force = f;
    }
    const SparseMatrix& pattern() const override { return body_.pattern(); }
    SparseMatrix stiffness(const MatX& u, bool definite) const override {
        SparseMatrix K = body_.pattern();
        body_.stiffness(u, definite, K);
        return K;
    }
    const ElasticBody<2>* plane_body() const override {
        if constexpr (Dim == 2) return &body_;
        return nullptr;
    }
    const ElasticBody<3>* space_body() const override {
        if constexpr (Dim == 3) return &body_;
        return nullptr;
    }
    const SimplexMesh<2>* plane_mesh() const override {
        if constexpr (Dim == 2) return &mesh_;
        return nullptr;
    }
    const SimplexMesh<3>* space_mesh() const override {
        if constexpr (Dim == 3) return &mesh_;
        return nullptr;
    }

    MatX plane_load(PlaneFunction density) const override;
    ErrorNorms plane_errors(const MatX& u, PlaneFunction exact, Mat<2> (*gradient)(const Vec<2>& X)) const override;

    std::unique_ptr<Mass> mass(Real density, bool lumped) const override {
        std::vector<char> flags(static_cast<std::size_t>(Dim * node_count()));
        for (std::size_t i = 0; i < flags.size(); ++i) flags[i] = held(static_cast<Index>(i) / Dim);
        if (!lumped) return std::make_unique<CoupledMass>(consistent_mass(body_.elements(), density), flags);
        return std::make_unique<DiagonalMass>(DiagonalMass::with_held(lumped_mass(body_.elements(), density), Dim, flags));
    }

    void hold(const std::vector<Index>& nodes_held, bool static_problem) override {
        held_.assign(held_.size(), 0);
        for (const Index n : nodes_held) held_[static_cast<std::size_t>(n)] = 1;
        supports_.reset();
        newton_.reset();
        if (static_problem)
            newton_.emplace(body_, constraints(MatX::Zero(Dim, node_count())),
                            typename NewtonEquilibrium<Dim>::Settings{.tolerance = 1e-9, .max_iterations = 200});
    }
    void begin(const MatX& u, const MatX& load, const MatX& places) override {
        supports_ = constraints(places);
        newton_->begin(u, load, *supports_);
    }
    void iterate() override { newton_->iterate(); }
    bool running() const override { return newton_ && newton_->running() && !(in_place() && balanced()); }
    bool converged() const override { return newton_->converged(); }
    MatX displacement() const override { return newton_->displacement(); }
    MatX newton_step() const override { return newton_->step(); }
    Real step_length() const override { return newton_->step_length(); }
    bool tangent_was_definite() const override { return newton_->tangent_was_definite(); }
    Real diagonal_shift() const override { return newton_->diagonal_shift(); }

private:
    void require_convergence() const override { newton_->require_convergence(); }
    Real residual_force() const override { return newton_->residual_force().cwiseAbs().maxCoeff(); }
    Real largest_force() const override {
        return residual_force() / std::max(newton_->residual(), std::numeric_limits<Real>::min());
    }
    DisplacementConstraints<Dim> constraints(const MatX& places) const {
        DisplacementConstraints<Dim> all(node_count());
        for (Index n = 0; n < node_count(); ++n)
            if (held(n))
                for (int c = 0; c < Dim; ++c) all.prescribe(n, c, places(c, n));
        return all;
    }
    void share_loaded_area() {
        loaded_area_ = VecX::Zero(node_count());
        const auto shares = facet_shares<Dim, Order>();
        for (const Index f : loaded_facets_)
            for (int a = 0; a < Elements::facet_nodes; ++a) loaded_area_[facets_(a, f)] += shares[a] * facet_areas_.col(f).norm();
    }

    bool in_place() const { return supports_ && supports_->distance_from(newton_->displacement()) == 0; }

    SimplexMesh<Dim> mesh_;
    HyperelasticFem<Dim, Order> body_;
    std::optional<DisplacementConstraints<Dim>> supports_;
    std::optional<NewtonEquilibrium<Dim>> newton_;
};

// In plane strain the stress across the plane is that of F with 1 there; in plane stress there is none.
template <int Dim, int Order>
Real SolidOf<Dim, Order>::von_mises(const Small& given) const {
    Mat<3> F = Mat<3>::Identity(), P;
    F.topLeftCorner<Dim, Dim>() = given;
    if (Dim == 2 && settings_.plane == Plane::stress) {
        P.setZero();
        P.topLeftCorner<Dim, Dim>() = stress(given);
    } else {
        P = EnergyDensity<3>(energy_of(settings_.law), lame_).P(F);
    }
    Mat<3> s = P;
    if (settings_.law != Law::linear) {
        const Real J = F.determinant();
        if (!(std::abs(J) > 1e-12)) return 0;
        s = P * F.transpose() / J;
    }
    const Mat<3> deviator = s - s.trace() / 3 * Mat<3>::Identity();
    return std::sqrt(1.5) * deviator.norm();
}

template <int Dim, int Order>
MatX SolidOf<Dim, Order>::plane_load(PlaneFunction density) const {
    Points<Dim> force = Points<Dim>::Zero(Dim, node_count());
    if constexpr (Dim == 2) add_body_force<2, Order>(body_.elements(), density, load_degree, force);
    return force;
}

template <int Dim, int Order>
Solid::ErrorNorms SolidOf<Dim, Order>::plane_errors(const MatX& u, PlaneFunction exact,
                                                    Mat<2> (*gradient)(const Vec<2>& X)) const {
    ErrorNorms squares;
    if constexpr (Dim == 2) {
        const SimplexRule<2> rule = simplex_rule<2>(load_degree);
        for (Index e = 0; e < element_count(); ++e)
            for (Index q = 0; q < rule.weights.size(); ++q) {
                const Vec<3> l = rule.barycentric.col(q);
                const auto N = Elements::shape(l);
                const auto g = Elements::gradients_at(mesh_.gradients(e), l);
                Vec<2> X = Vec<2>::Zero(), v = Vec<2>::Zero();
                Mat<2> H = Mat<2>::Zero();
                for (int a = 0; a < nodes; ++a) {
                    const Index n = elements_(a, e);
                    X += N[a] * rest_.col(n), v += N[a] * u.col(n), H += u.col(n) * g.col(a).transpose();
                }
                const Real w = volumes_[e] * rule.weights[q];
                squares.l2 += w * (v - exact(X)).squaredNorm(), squares.h1 += w * (H - gradient(X)).squaredNorm();
            }
    }
    return {std::sqrt(squares.l2), std::sqrt(squares.h1)};
}

template <int Dim>
std::unique_ptr<Solid> of_order(const BodySettings& settings, SimplexMesh<Dim> mesh) {
    if (settings.order == 2) return std::make_unique<SolidOf<Dim, 2>>(settings, std::move(mesh));
    return std::make_unique<SolidOf<Dim, 1>>(settings, std::move(mesh));
}

template <int Dim>
std::unique_ptr<Solid> of_file(const BodySettings& settings) {
    SimplexMesh<Dim> mesh = simplex_mesh_of<Dim>(*settings.file, settings.file_name);
    require_facet_groups<Dim>(mesh, {"fixed", "loaded"}, settings.file_name);
    return of_order<Dim>(settings, std::move(mesh));
}

}  // namespace

std::unique_ptr<Solid> make_solid(const BodySettings& s) {
    switch (s.shape) {
        case Shape::beam:
            return of_order<3>(s, beam_mesh(s.size, s.cells));
        case Shape::panel:
            return of_order<2>(s, panel_mesh(s.size.head<2>(), s.cells[0], s.cells[1]));
        case Shape::cook:
            return of_order<2>(s, cook_mesh(s.cells[0], s.cells[1]));
        case Shape::square:
            return of_order<2>(s, square_mesh(s.cells[0], s.cells[1]));
        case Shape::file:
            break;
    }
    return s.file->dimension() == 2 ? of_file<2>(s) : of_file<3>(s);
}

Vec<3> Solid::rest(Index node) const {
    Vec<3> X = Vec<3>::Zero();
    X.head(dim_) = rest_.col(node);
    return X;
}

Vec<3> Solid::place(Index node, const MatX& u, Real magnification) const {
    Vec<3> x = rest(node);
    x.head(dim_) += magnification * u.col(node);
    return x;
}

// VTK has the middles of the last two edges of a tetrahedron the other way round.
UnstructuredGrid Solid::grid(const MatX& u) const {
    const bool second = settings_.order == 2;
    Eigen::MatrixXi cells = elements_;
    if (second && dim_ == 3) cells.row(8).swap(cells.row(9));
    const CellKind kind = dim_ == 2 ? (second ? CellKind::triangle6 : CellKind::triangle)
                                    : (second ? CellKind::tetrahedron10 : CellKind::tetrahedron);
    return grid_of(in_space(rest_ + u), kind, std::move(cells), {On::element});
}

// A stiffness entry of the body times its size, a small part: rounding leaves less than its billionth part.
Real Solid::residual() const {
    const Real size = (rest_.rowwise().maxCoeff() - rest_.rowwise().minCoeff()).norm();
    const Real least = 1e-5 * (std::abs(lame_.lambda) + lame_.mu) * volume() / size;
    const Real left = residual_force();
    return left > 0 ? left / std::max(largest_force(), least) : 0;
}

void Solid::require_balance() const {
    if (!balanced()) require_convergence();
}

Real Solid::volume(const MatX& u) const {
    Real sum = 0;
    for (Index e = 0; e < element_count(); ++e) sum += volumes_[e] * Small(deformation(e, u)).determinant();
    return sum;
}

}  // namespace pliant::solid_mesh
