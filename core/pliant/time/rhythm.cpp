#include <pliant/time/rhythm.h>

#include <algorithm>

namespace pliant {

void Rhythm::note(Real time, Real value, Real least) {
    if (least > 0 && value < -least) memory_[armed] = 1;
    if (memory_[armed] == 1 && value >= 0) {
        const Real before = memory_[latest_value];
        const Real part = value > before ? -before / (value - before) : 1;
        auto crossings = memory_.tail(most_periods + 1);
        std::shift_right(crossings.begin(), crossings.end(), 1);
        crossings[0] = memory_[latest_time] + part * (time - memory_[latest_time]);
        memory_[count] = std::min(memory_[count] + 1, static_cast<Real>(most_periods + 1));
        memory_[armed] = 0;
    }
    memory_[latest_time] = time;
    memory_[latest_value] = value;
}

std::optional<Real> Rhythm::period() const {
    const auto crossings = static_cast<Index>(memory_[count]);
    if (crossings < 2) return std::nullopt;
    return (memory_[first_crossing] - memory_[first_crossing + crossings - 1]) / static_cast<Real>(crossings - 1);
}

}  // namespace pliant
