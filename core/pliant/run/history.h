// The stored past of a run: the state at the starts of steps, in a ring with a memory cap.
#pragma once
#include <pliant/lesson/lesson.h>

#include <deque>
#include <optional>
#include <vector>

namespace pliant {

// What a conserved quantity was when its law began to hold, and what it may be off by.
struct LawStart {
    Real value = 0, tolerance = 0;
};

// All that a run needs to go on from the start of a step.
struct Snapshot {
    Index step = 0;
    Real base_time = 0, base_dt = 0;
    Index base_step = 0;
    std::vector<Real> parameters;
    std::optional<Pull> pull;
    std::vector<std::optional<LawStart>> law_starts;
    std::vector<Real> state;  // every state array, one after the other

    std::size_t bytes() const {
        return sizeof(Snapshot) + sizeof(Real) * (state.size() + parameters.size() + 3 * law_starts.size());
    }
};

class History {
public:
    explicit History(std::size_t cap_bytes) : cap_(cap_bytes) {}

    // A snapshot to fill in for this step, at the end of the ring. It forgets what was stored for this and later steps, and as
    // many of the oldest as the cap demands, whose memory it uses again.
    Snapshot& add(Index step);
    // The snapshot is full: counts its memory.
    void added();
    const Snapshot* find(Index step) const;
    const Snapshot* last() const { return ring_.empty() ? nullptr : &ring_.back(); }
    void clear();

    Index first_step() const { return ring_.empty() ? 0 : ring_.front().step; }
    std::size_t size() const { return ring_.size(); }
    std::size_t bytes() const { return bytes_; }
    std::size_t cap() const { return cap_; }

private:
    std::deque<Snapshot> ring_;
    std::size_t cap_, bytes_ = 0;
};

// Copies between the state arrays of a lesson and one contiguous buffer.
void save_state(const Lesson& lesson, std::vector<Real>& buffer);
void load_state(const Lesson& lesson, const std::vector<Real>& buffer);  // throws std::logic_error when the sizes differ

// A hash of every bit of the state, for comparing runs.
std::uint64_t state_hash(const Lesson& lesson);

}  // namespace pliant
