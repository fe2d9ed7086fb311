// An elastic body of finite elements, in the plane or in space and of first or second order, as lessons show it: one interface
// for all four, with numbers laid out as fields have them.
#pragma once
#include <pliant/continuum/moduli.h>
#include <pliant/lesson/unstructured_grid.h>
#include <pliant/math/types.h>
#include <pliant/mesh/simplex_mesh.h>
#include <pliant/mesh_file/mesh_file.h>
#include <pliant/solids/elastic_body.h>
#include <pliant/time/mass.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace pliant::solid_mesh {

enum class Law { linear, corotational, stvk, neo_hookean };
enum class Plane { stress, strain };
enum class Shape { beam, cook, square, file, panel };

struct BodySettings {
    Shape shape = Shape::beam;
    Law law = Law::linear;
    Plane plane = Plane::strain;  // of bodies in the plane
    int order = 1;
    Real youngs_modulus = 1, poisson_ratio = 0;
    Vec<3> size = Vec<3>::Ones();  // m, of a beam
    std::array<int, 3> cells{1, 1, 1};
    std::shared_ptr<const MeshFile> file{};
    std::string file_name{};
};

using Small = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;  // dim × dim

// Nodal numbers are dim × nodes, tensors dim² × elements, each row by row; in the plane per metre of thickness. The nodes of the
// mesh come first, then the middles of edges where the order is 2.
class Solid {
public:
    virtual ~Solid() = default;
    Solid(const Solid&) = delete;
    Solid& operator=(const Solid&) = delete;

    const BodySettings& settings() const { return settings_; }
    int dim() const { return dim_; }
    Index node_count() const { return rest_.cols(); }
    Index element_count() const { return elements_.cols(); }
    int nodes_of_element() const { return static_cast<int>(elements_.rows()); }
    const MatX& rest() const { return rest_; }  // m
    Vec<3> rest(Index node) const;
    // Where a node is drawn: u times the magnification away from its place at rest.
    Vec<3> place(Index node, const MatX& u, Real magnification = 1) const;
    Index node(Index element, int a) const { return elements_(a, element); }
    const Eigen::MatrixXi& elements() const { return elements_; }  // corners first
    const VecX& volumes() const { return volumes_; }               // m³, of elements
    Real volume() const { return volumes_.sum(); }
    // Elements that a node belongs to, and as which of their nodes.
    struct Membership {
        Index element;
        int a;
    };
    const std::vector<Membership>& elements_about(Index node) const { return about_[static_cast<std::size_t>(node)]; }

    // The boundary: corners of each facet (2 or 3), then the middles of its edges; the element that it bounds; its area vector.
    const Eigen::MatrixXi& facets() const { return facets_; }
    const std::vector<Index>& facet_elements() const { return facet_elements_; }
    const MatX& facet_areas() const { return facet_areas_; }
    const std::vector<Index>& fixed_facets() const { return fixed_facets_; }
    const std::vector<Index>& loaded_facets() const { return loaded_facets_; }
    const std::vector<Index>& fixed_nodes() const { return fixed_nodes_; }
    const std::vector<Index>& loaded_nodes() const { return loaded_nodes_; }
    // The share of each node in the loaded area [m²]: an even traction F/A puts F share / A on it.
    const VecX& loaded_area() const { return loaded_area_; }

    // --- one element ---
    // Slopes of the shape functions in the middle of an element, a column per node [1/m].
    virtual MatX slopes(Index element) const = 0;
    // F there; with elements of first order everywhere.
    virtual Small deformation(Index element, const MatX& u) const = 0;
    // R of F = R S.
    virtual Small rotation(const Small& F) const = 0;
    // The strain that the law is made of: ε, S − I of F = R S, or E; and P(F) [Pa], of all elements alike.
    virtual Small strain(const Small& F) const = 0;
    virtual Small stress(const Small& F) const = 0;
    // Von Mises' stress [Pa] of Cauchy's stress P Fᵀ/J, of P itself in the linear law; 0 where F has no volume.
    virtual Real von_mises(const Small& F) const = 0;
    // Second derivative of the element's energy [N/m].
    virtual MatX element_stiffness(Index element, const MatX& u) const = 0;

    // --- the body ---
    virtual Real energy(const MatX& u) const = 0;                       // J
    virtual void internal_force(const MatX& u, MatX& force) const = 0;  // N
    virtual const SparseMatrix& pattern() const = 0;                    // of K
    // M of a density [kg/m³]: consistent, or with all of an element's mass on its nodes (a diagonal matrix). Held nodes are
    // fixed.
    virtual std::unique_ptr<Mass> mass(Real density, bool lumped) const = 0;
    virtual SparseMatrix stiffness(const MatX& u, bool definite) const = 0;  // N/m
    // The deformed body, for files that other programs read.
    UnstructuredGrid grid(const MatX& u) const;
    // Volume of the deformed body [m³].
    Real volume(const MatX& u) const;
    Lame lame() const { return lame_; }  // Pa, of the law: with plane stress taken in
    // One of these is null.
    virtual const ElasticBody<2>* plane_body() const { return nullptr; }
    virtual const ElasticBody<3>* space_body() const { return nullptr; }
    virtual const SimplexMesh<2>* plane_mesh() const { return nullptr; }
    virtual const SimplexMesh<3>* space_mesh() const { return nullptr; }

    // Integral of the shape functions with a body force [N/m³] that varies in the plane, exact to a degree.
    using PlaneFunction = Vec<2> (*)(const Vec<2>& X);
    virtual MatX plane_load(PlaneFunction force_density) const = 0;
    // Norms of u − exact and of its gradient over the body, in the plane.
    struct ErrorNorms {
        Real l2 = 0, h1 = 0;
    };
    virtual ErrorNorms plane_errors(const MatX& u, PlaneFunction exact, Mat<2> (*gradient)(const Vec<2>& X)) const = 0;

    // --- equilibrium, one iteration of Newton's method at a time ---
    // Holds all components of these nodes. Throws Refused "singular: k rigid modes unconstrained" where they let the body move
    // and it is to be solved for.
    virtual void hold(const std::vector<Index>& nodes, bool static_problem = true) = 0;
    bool held(Index node) const { return held_[static_cast<std::size_t>(node)] != 0; }
    // From displacements u on, under a load [N], with held nodes at `places` (dim × nodes, m).
    virtual void begin(const MatX& u, const MatX& load, const MatX& places) = 0;
    virtual void iterate() = 0;
    virtual bool running() const = 0;
    virtual bool converged() const = 0;
    // Throws Diverged, with the residual that was reached and its limit, unless balanced().
    void require_balance() const;
    virtual MatX displacement() const = 0;
    virtual MatX newton_step() const = 0;  // m, before the line search
    virtual Real step_length() const = 0;
    virtual bool tangent_was_definite() const = 0;
    virtual Real diagonal_shift() const = 0;
    // Largest force that nothing balances over the largest force; over what rounding makes of forces in such a body where a
    // rigid motion leaves no others.
    Real residual() const;
    bool balanced() const { return converged() || residual() <= 1e-9; }

protected:
    virtual void require_convergence() const = 0;
    virtual Real residual_force() const = 0;  // N, largest
    virtual Real largest_force() const = 0;   // N, of load and internal forces
    explicit Solid(BodySettings settings) : settings_(std::move(settings)) {}

    BodySettings settings_;
    int dim_ = 3;
    Lame lame_;
    MatX rest_, facet_areas_;
    Eigen::MatrixXi elements_, facets_;
    VecX volumes_, loaded_area_;
    std::vector<Index> facet_elements_, fixed_facets_, loaded_facets_, fixed_nodes_, loaded_nodes_;
    std::vector<std::vector<Membership>> about_;
    std::vector<char> held_;
};

// Throws Refused for a material, a size or a file that makes no body.
std::unique_ptr<Solid> make_solid(const BodySettings& settings);

}  // namespace pliant::solid_mesh
