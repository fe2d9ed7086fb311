#include <pliant/run/history.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

namespace pliant {

Snapshot& History::add(Index step) {
    while (!ring_.empty() && ring_.back().step >= step) {
        bytes_ -= ring_.back().bytes();
        ring_.pop_back();
    }
    // Room for one more of the same size. The one before it always stays, so that one step back is possible.
    const std::size_t next = ring_.empty() ? 0 : ring_.back().bytes();
    Snapshot recycled;
    while (ring_.size() > 1 && bytes_ + next > cap_) {
        bytes_ -= ring_.front().bytes();
        recycled = std::move(ring_.front());
        ring_.pop_front();
    }
    ring_.push_back(std::move(recycled));
    ring_.back().step = step;
    return ring_.back();
}

void History::added() { bytes_ += ring_.back().bytes(); }

const Snapshot* History::find(Index step) const {
    const auto found = std::ranges::lower_bound(ring_, step, {}, &Snapshot::step);
    return found != ring_.end() && found->step == step ? &*found : nullptr;
}

void History::clear() {
    ring_.clear();
    bytes_ = 0;
}

void save_state(const Lesson& lesson, std::vector<Real>& buffer) {
    std::size_t size = 0;
    for (const StateArray& a : lesson.state) size += a.view().size();
    buffer.resize(size);
    Real* to = buffer.data();
    for (const StateArray& a : lesson.state) to = std::ranges::copy(a.view(), to).out;
}

void load_state(const Lesson& lesson, const std::vector<Real>& buffer) {
    const Real* from = buffer.data();
    const Real* end = from + buffer.size();
    for (const StateArray& a : lesson.state) {
        const auto to = a.view();
        if (static_cast<std::size_t>(end - from) < to.size())
            throw std::logic_error("a state array changed its size between two resets");
        std::copy_n(from, to.size(), to.data());
        from += to.size();
    }
    if (from != end) throw std::logic_error("a state array changed its size between two resets");
}

std::uint64_t state_hash(const Lesson& lesson) {
    // FNV-1a, over 64-bit words.
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const StateArray& a : lesson.state)
        for (const Real x : a.view()) hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3u;
    return hash;
}

}  // namespace pliant
