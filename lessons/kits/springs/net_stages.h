// Stages that nets of springs share, but for what the lesson runs and how it explains it.
#pragma once
#include <pliant/lesson/lesson.h>
#include <pliant/solids/springs.h>

namespace pliant::springs {

// Of the formulas of such a lesson: a spring's stiffness and length at rest, and masses.
inline std::vector<Symbol> symbols_and(std::vector<Symbol> own) {
    own.insert(own.end(), {{"k", "N/m"}, {"l", "m"}, {"m", "kg"}});
    return own;
}

using Why = decltype(Stage::explain);

inline Stage spring_forces_stage(std::function<void()> run, std::vector<std::string_view> writes, Why why,
                                 std::function<bool()> active = {}) {
    return stage_of("spring_forces", "fᵢ = k (|xᵢⱼ| − l) xᵢⱼ/|xᵢⱼ|,  xᵢⱼ = xⱼ − xᵢ",
                    "lecture: mass–spring system; [Nealen2006 §3]", std::move(run))
        .maps({"position"}, std::move(writes))
        .because(std::move(why))
        .when(std::move(active))
        .done_in("core/pliant/solids/springs.cpp: add_spring_forces");
}

inline Stage damping_forces_stage(std::function<void()> run, Why why, std::function<SpringDamping()> mode,
                                  std::function<bool()> active) {
    return stage_of("damping_forces", "naive: fᵢ = kᵈ vᵢⱼ;  projected: fᵢ = kᵈ (vᵢⱼ·xᵢⱼ / (xᵢⱼ·xᵢⱼ)) xᵢⱼ,  vᵢⱼ = vⱼ − vᵢ",
                    "lecture: mass–spring system; [Nealen2006 §3]", std::move(run))
        .maps({"position", "velocity"}, {"damping_force"})
        .because(std::move(why))
        .when(std::move(active))
        .done_in("core/pliant/solids/springs.cpp: add_damping_forces")
        .shows([mode] { return formula_of(mode()); });
}

inline Stage external_forces_stage(std::function<void()> run, Why why, std::function<bool()> active) {
    return stage_of("external_forces", "fᵢ = mᵢ g;  at a pulled node + kₕ (x_hand − xᵢ)", "gravity, and a spring to the pointer",
                    std::move(run))
        .maps({"position"}, {"external_force"})
        .because(std::move(why))
        .when(std::move(active))
        .done_in("core/pliant/solids/external_load.cpp: add_external_forces");
}

}  // namespace pliant::springs
