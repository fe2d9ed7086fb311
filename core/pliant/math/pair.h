// Two numbers that are handled at once, in one register where the compiler offers vectors of numbers. Entry by entry the
// arithmetic is that of Real, so that results do not depend on the machine.
#pragma once
#include <pliant/math/types.h>

#include <cstring>

namespace pliant {

#if defined(__GNUC__)

// Pairs add, subtract and multiply entry by entry, with each other and with numbers; p[0] and p[1] are the entries.
using Pair = Real __attribute__((vector_size(2 * sizeof(Real))));

// Entry by entry; what is not a number loses against q.
inline Pair smaller(Pair p, Pair q) { return p < q ? p : q; }
inline Pair larger(Pair p, Pair q) { return p > q ? p : q; }

#else

struct Pair {
    Real entries[2];
    Real operator[](int k) const { return entries[k]; }
};
inline Pair operator+(Pair p, Pair q) { return {p[0] + q[0], p[1] + q[1]}; }
inline Pair operator-(Pair p, Pair q) { return {p[0] - q[0], p[1] - q[1]}; }
inline Pair operator*(Pair p, Pair q) { return {p[0] * q[0], p[1] * q[1]}; }
inline Pair operator+(Pair p, Real x) { return {p[0] + x, p[1] + x}; }
inline Pair operator-(Pair p, Real x) { return {p[0] - x, p[1] - x}; }
inline Pair operator*(Real x, Pair p) { return {x * p[0], x * p[1]}; }
inline Pair smaller(Pair p, Pair q) { return {p[0] < q[0] ? p[0] : q[0], p[1] < q[1] ? p[1] : q[1]}; }
inline Pair larger(Pair p, Pair q) { return {p[0] > q[0] ? p[0] : q[0], p[1] > q[1] ? p[1] : q[1]}; }

#endif

// The same of plain numbers.
inline Real smaller(Real p, Real q) { return p < q ? p : q; }
inline Real larger(Real p, Real q) { return p > q ? p : q; }

// The entries, drawn to the nearest end of [low, high]; what is not a number becomes low.
inline Pair clamped(Pair p, Real low, Real high) { return smaller(larger(p, Pair{low, low}), Pair{high, high}); }

// Two neighbours in memory, at any alignment.
inline Pair load_pair(const Real* from) {
    Pair p;
    std::memcpy(&p, from, sizeof p);
    return p;
}
inline void store_pair(Real* to, Pair p) { std::memcpy(to, &p, sizeof p); }

}  // namespace pliant
