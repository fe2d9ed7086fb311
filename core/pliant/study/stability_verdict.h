// Is a run stable? The energy that was watched in its steps tells, without knowing the method.
#pragma once
#include <pliant/math/types.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

enum class Stability {
    stable,         // the energy stays bounded, and keeps up with the exact one
    dissipative,    // stays bounded, and loses noticeably more than the exact solution does
    diverged,       // grows from part to part of the run, or beyond a bound
    not_converged,  // a solver gave up before the numbers grew
    refused         // the lesson accepts no such parameters
};
inline constexpr int stability_kinds = 5;
std::string_view name_of(Stability kind);

struct StabilityVerdict {
    Stability kind = Stability::stable;
    // Factor per step by which the amplitude of the motion grows, measured: the root of that of the energy. Empty where nothing
    // was measured.
    std::optional<Real> growth{};
    std::string reason{};  // in words
    bool settled = true;   // false: the energy rises, but the run is too short to tell a growth from a slow oscillation
};

// The criterion. The energy E is sampled in every step, from the start; where its exact course X is known, what the exact
// solution gains is taken off first: e = E − max(0, X − X₀). The run is cut into four equal parts; M₁ to M₄ are the largest e of
// each and S is the largest |e| of the first.
//
//   diverged     M₁ < M₂ < M₃ < M₄, by more than 10⁻³ S in all and by at least half of what e swings within a part. A bounded
//                oscillation of the energy, however wide (semi-implicit Euler near its limit), does not raise the largest value
//                part by part; a growth by a tiny factor per step does. A rise counts once the motion has come round, when it
//                exceeds 3 S, or when the run is as long as it may get. Until then one that rises from part to part, or
//                in all, is not settled: the run has to go on.
//   dissipative  bounded, and on average below 95 % of X, or of the energy at the start where there is no X; in steps in which X
//                has less than 1 % of S left it tells nothing. Where X lasts to the end, E has to stay below 95 % of it
//                throughout the last quarter as well: one that swings far below X and comes back to it loses nothing.
//   stable       bounded otherwise.
//
// The growth is ((M₄ − F) / (M₁ − F))^(1 / 2 n) with n the steps between the two values and F the lowest energy, or 0 when
// none is negative: the zero of an energy that gravity offsets is arbitrary.
class StabilityWatch {
public:
    // Forgets everything, but not its memory.
    void clear();
    // The energy after one more step, first that of the start. Empty where it is not defined: the step is left out.
    void add(std::optional<Real> energy, std::optional<Real> exact);

    std::size_t samples() const { return excess_.size(); }
    // Has the energy grown by a factor that leaves no doubt? Then the run may end.
    bool exploded() const;
    // came_round: the motion has turned through more than a period. last: the run will not go on, so decide.
    StabilityVerdict verdict(bool came_round, bool last) const;
    // The growth from the first to the last sample, for a run that broke down.
    std::optional<Real> overall_growth() const;

private:
    struct Parts;
    Parts parts() const;
    // The leading samples in which the exact solution still moves.
    std::size_t live_samples(const Parts& p) const;
    Real reference(std::size_t n) const { return exact_.size() == samples() ? exact_[n] : energy_.front(); }
    Real average_kept(const Parts& p) const;
    bool loses(const Parts& p) const;
    std::string kept(const Parts& p) const;

    std::vector<Real> excess_, energy_, exact_;  // J, or the unit of the probe; `exact_` as long, or empty
    Real start_exact_ = 0;
};

// How far a motion has turned: the angle between successive changes of an array of the state, summed up; the largest of all
// arrays, rad. A harmonic motion turns by 2π in a period.
class TurnMeter {
public:
    void clear(std::size_t arrays);
    void add(std::size_t array, std::span<const Real> now);
    Real turned() const;

private:
    struct Track {
        std::vector<Real> last, change;
        Real change_squared = 0, turned = 0;
        bool begun = false;
    };
    std::vector<Track> tracks_;
};

}  // namespace pliant
