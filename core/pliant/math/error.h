// Errors meant for people. Each says what was given, what is accepted and what to do, and knows the exit code of the program.
#pragma once
#include <pliant/math/types.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace pliant {

enum class ExitCode { done = 0, check_failed = 1, refused = 2, diverged = 3, machine_lacks = 4 };

class Error : public std::runtime_error {
public:
    Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    ExitCode code() const { return code_; }

private:
    ExitCode code_;
};

// A claim or an expectation that did not hold.
struct CheckFailed : Error {
    explicit CheckFailed(const std::string& message) : Error(ExitCode::check_failed, message) {}
};

// Bad input, found before the first step.
struct Refused : Error {
    explicit Refused(const std::string& message) : Error(ExitCode::refused, message) {}
    // "poisson_ratio = 0.6 (dimensionless) is outside (-1, 0.5)": name, value, unit ("" for none) and what is accepted.
    Refused(std::string_view name, Real value, std::string_view unit, std::string_view accepted);
};

// This machine has no display, no GL or the like; the message says what to do instead.
struct MachineLacks : Error {
    explicit MachineLacks(const std::string& message) : Error(ExitCode::machine_lacks, message) {}
};

// blew_up: numbers grew beyond what the method can bear. not_converged: an iteration or a factorisation gave up.
enum class FailureKind { blew_up, not_converged };

// A method that could not go on: an iteration that does not converge, an energy that is infinite. A solver fills in what
// it knows; the runner adds the stage and the step.
struct Failure {
    std::string stage, field;
    Index index = -1;
    Index step = -1;
    Real time = 0;      // s
    std::string what;   // what went wrong, with the numbers
    std::string limit;  // the limit that was exceeded and by how much; empty when none is known
    // The number itself and what it may be at most, in the unit of the field; empty where there is none or it is not finite.
    std::optional<Real> value{}, bound{};
    FailureKind kind = FailureKind::blew_up;  // solvers that give up say so
};

struct Diverged : Error {
    explicit Diverged(Failure failure);
    Failure failure;
};

}  // namespace pliant
