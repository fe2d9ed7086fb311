// The largest eigenvalue of a symmetric operator that is known by its products alone.
#pragma once
#include <pliant/math/types.h>

#include <functional>

namespace pliant {

// By Lanczos' method from a fixed start [Golub2013 §10.1]: `steps` products, from below. apply: y = A x; x and y have the size n.
// 0 for n = 0.
Real largest_eigenvalue(Index n, const std::function<void(const VecX& x, VecX& y)>& apply, Index steps);

}  // namespace pliant
