// What follows from an explanation once the numbers of its inputs are known.
#pragma once
#include <pliant/lesson/explanation.h>
#include <pliant/run/why.h>

namespace pliant {

// Fills formula, substituted, evaluated, conditioning, latex and unit_check of the answer, and the sensitivity of each of its
// inputs, which stand there with their values, units and conditioning; or `trouble`, of a formula that cannot be read.
void evaluate(Answer& a, const Explanation& e);

}  // namespace pliant
