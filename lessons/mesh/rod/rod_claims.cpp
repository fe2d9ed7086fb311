// What the lecture says of the rod, measured.
#include <pliant/math/line_fit.h>
#include <pliant/run/runner.h>
#include <pliant/study/claims_report.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace pliant::rod {
namespace {

constexpr std::array<Index, 6> resolutions{5, 10, 20, 40, 80, 160};
constexpr Real order_band = 0.02, rounding = 1e-9;

struct Measured {
    Real tip, continuum, frequency, continuum_frequency;
};

// One rod of the lesson: how far it hangs down, and its lowest frequency.
Measured measured_rod(const char* rule, Index n) {
    const Runner::Assignments rod{{"spring_rule", rule}, {"segments", std::to_string(n)}};
    Runner hanging(find_lesson("mesh/rod"), rod), swinging(find_lesson("mesh/rod"), rod);
    swinging.assign({{"scene", "wave"}});
    hanging.step();
    return {hanging.value("tip_displacement"), hanging.exact(hanging.lesson().probe("tip_displacement")).value(),
            swinging.value("frequency_chain"), swinging.value("frequency_continuum")};
}

// d log y/d log N.
Real slope(const std::vector<Real>& y) {
    std::vector<Real> log_n, log_y;
    for (std::size_t k = 0; k < y.size(); ++k) {
        log_n.push_back(std::log(static_cast<Real>(resolutions[k])));
        log_y.push_back(std::log(y[k]));
    }
    return fit_line(log_n, log_y)->slope;
}

Finding consistency() {
    std::vector<Real> error, frequency_error, picked, picked_frequency;
    Real off = 0;
    for (const Index n : resolutions) {
        const Measured derived = measured_rod("derived", n), by_hand = measured_rod("constant", n);
        const auto N = static_cast<Real>(n);
        error.push_back(derived.tip / derived.continuum - 1);
        off = std::max(off, std::abs(N * error.back() - 1));
        frequency_error.push_back(1 - derived.frequency / derived.continuum_frequency);
        picked.push_back(by_hand.tip / by_hand.continuum);
        picked_frequency.push_back(by_hand.frequency / by_hand.continuum_frequency);
    }
    const Real order = -slope(error);
    const bool agrees = std::abs(order - 1) <= order_band && off <= rounding;
    const bool differs = picked.back() > 10 * picked.front();
    return {
        .figure = order,
        .verdict = agrees && differs ? Verdict::reproduced : Verdict::refuted,
        .text = fmt::format(
            "Derived springs hang (N + 1)/N times as far as the continuum, to {}: 20 % too far at N = 5, {:.3g} % at N = 160, "
            "order {:.2f} in 1/N; their lowest frequency tends to that of the rod with order {:.2f}. Springs of a fixed k "
            "hang {:.2f} times as far at N = 5 and {:.2f} times at N = 160, with {:.2f} and {:.2f} times its frequency.",
            steady_figure(off), 100 * error.back(), order, -slope(frequency_error), picked.front(), picked.back(),
            picked_frequency.front(), picked_frequency.back())};
}

const ClaimRegistration m8{"M8", consistency};

}  // namespace
}  // namespace pliant::rod
