// The start and the stages.
#include "poisson.h"

namespace pliant::poisson {

// Each step narrows by nu times its strain, which must leave a width.
void PoissonLesson::check() const {
    const Real narrowing = poisson_ratio * axial_strain / static_cast<Real>(steps());
    if (bends() || narrowing < 1) return;
    throw Refused(
        fmt::format("axial_strain = {} with poisson_ratio = {}: {} would narrow the cube by {}, so that no width is left. "
                    "Give ν ΔL/L below {}{}",
                    format_quantity(axial_strain, ""), format_quantity(poisson_ratio, ""),
                    steps() == 1 ? "one linear step" : "the first step", format_quantity(narrowing, ""), steps(),
                    method == Method::linear ? ", or method=incremental" : ", or more increments"));
}

void PoissonLesson::reset() {
    cube_ = std::make_unique<StretchedCube>(poisson_ratio, length, bends() ? 1 : static_cast<int>(Index(resolution)));
    membrane_ = std::make_unique<CooksMembrane>(bends() ? 2 * static_cast<int>(Index(membrane_cells)) : 2);
    for (Points<3>* nodal : {&displacement_, &prescribed_, &increment_}) nodal->setZero(3, cube_->rest().node_count());
    element_volumes_ = VecX::Ones(cube_->rest().simplex_count());
    if (bends()) displacement_.setZero(3, membrane_->mesh().node_count());
    strains_ = contractions_ = VecX::Zero(rounds() + 1);
    volumes_ = VecX::Ones(rounds() + 1);
    deflections_ = VecX::Zero(rounds());
    done_[0] = 0;
}

void PoissonLesson::declare_stages() {
    const auto more = [this] { return advancing_ && done() < rounds(); };
    const auto why = [this](const Question& q) { return why_number(q); };
    formula_symbols = {{"s"}, {"V", "m³"}, {"K", "Pa"}, {"f", "N/m"}};
    stages = {stage_of("pull", "Δx = s L / N on the far face", "lecture: Poisson's ratio, the cube of size L",
                       [this] { stretch_cube(); })
                  .done_in("lessons/elasticity/poisson/poisson.cpp: stretch_cube")
                  .maps({}, {"prescribed"})
                  .when(stretched)
                  .because(why),
              stage_of("solve", "K(x) Δu = 0,  Δu = Δx on the far face",
                       "linear elasticity on the shape that was reached [Hughes2000 §2.9]", [this] { solve(); })
                  .done_in("core/pliant/solids/stretched_cube.cpp: StretchedCube::increment")
                  .maps({"prescribed", "displacement"}, {"increment"})
                  .when(stretched)
                  .because(why),
              stage_of("move", "u ← u + Δu", "lecture: the integral of dε_y = −ν dε_x, as a sum", [this] { move(); })
                  .done_in("lessons/elasticity/poisson/poisson.cpp: move")
                  .maps({"increment", "displacement"}, {"displacement"})
                  .when(stretched)
                  .because(why),
              stage_of("measure", "ΔL′/L,  V/V₀ = det(I + ∇u);  exact: 1 − (1 + ΔL/L)^(−ν)",
                       "lecture: Poisson's ratio, ν ≈ ΔL′/ΔL", [this] { measure(); })
                  .done_in("core/pliant/solids/stretched_cube.cpp: StretchedCube::volume_ratio")
                  .maps({"displacement"}, {"element_volume"})
                  .when(stretched)
                  .loops_from("pull", more)
                  .because(why),
              stage_of("bend", "K(ν) u = f in plane strain", "Cook's membrane [Cook1974], linear triangles [Hughes2000 §4.4]",
                       [this] { bend(); })
                  .done_in("core/pliant/solids/cooks_membrane.cpp: displacement")
                  .maps({}, {"displacement"})
                  .when(bent)
                  .because(why),
              stage_of("read_deflection", "u_y at the middle of the loaded edge",
                       "converged values of cubic triangles on 32 × 32 cells", [this] { read_deflection(); })
                  .done_in("lessons/elasticity/poisson/poisson.cpp: read_deflection")
                  .maps({"displacement"}, {"deflection"})
                  .when(bent)
                  .loops_from("bend", more)};
}

// The next step; after the last one nothing is left to do.
void PoissonLesson::stretch_cube() {
    advancing_ = !at_rest();
    if (!advancing_) return;
    const Real dx = axial_strain * length / static_cast<Real>(steps());
    for (Index n = 0; n < prescribed_.cols(); ++n) prescribed_(0, n) = cube_->pulled(n, 0) ? dx : 0;
}

void PoissonLesson::solve() {
    if (!advancing_) return;
    cube_->begin(displacement_);
    increment_ = cube_->increment(axial_strain * length / static_cast<Real>(steps()));
}

void PoissonLesson::move() {
    if (advancing_) displacement_ += increment_;
}

void PoissonLesson::measure() {
    if (!advancing_) return;
    done_[0] += 1;
    for (Index e = 0; e < element_volumes_.size(); ++e) element_volumes_[e] = cube_->element_volume_ratio(e, displacement_);
    strains_[done()] = cube_->axial_strain(displacement_);
    contractions_[done()] = cube_->contraction(displacement_);
    volumes_[done()] = cube_->volume_ratio(displacement_);
}

std::vector<Real> PoissonLesson::ratios() const {
    std::vector<Real> all{0.3, 0.4, 0.45, 0.48, 0.49, 0.495, 0.499, 0.4999};
    std::erase(all, Real(poisson_ratio));
    all.push_back(poisson_ratio);
    return all;
}

void PoissonLesson::bend() {
    advancing_ = !at_rest();
    if (!advancing_) return;
    const Lame material = IsotropicModuli::from_young_poisson(1, ratio_of_round(done())).lame();
    displacement_.topRows<2>() = membrane_->displacement(material, 1);
}

void PoissonLesson::read_deflection() {
    if (!advancing_) return;
    deflections_[done()] = displacement_(1, membrane_->tip());
    done_[0] += 1;
}

std::string PoissonLesson::blow_up_hint() const {
    return "The solve is linear and cannot blow up by itself; " +
           (poisson_ratio > 0.4
                ? fmt::format("ν = {} is close to ½, where λ is infinite: lower it", format_quantity(poisson_ratio, ""))
                : fmt::format("a strain of {} carries it too far: lower the axial strain", format_quantity(axial_strain, "")));
}

const Registration<PoissonLesson> registration{
    {.id = "elasticity/poisson",
     .title = "Poisson's ratio",
     .summary =
         "Stretch a cube and measure how much it narrows: in small steps, in one, and by the lecture's law; and see elements "
         "lock near ν = ½.",
     .demo_steps = 1}};

}  // namespace pliant::poisson
