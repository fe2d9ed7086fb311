#include <pliant/continuum/strain_cost.h>

#include <pliant/continuum/strain.h>

namespace pliant {
namespace {

// A number that counts what is done with it.
struct Counted {
    Real value = 0;
    Counted() = default;
    explicit Counted(Real given) : value(given) {}
    static inline thread_local Index operations = 0;

    friend Counted operator+(Counted a, Counted b) { return ++operations, Counted(a.value + b.value); }
    friend Counted operator-(Counted a, Counted b) { return ++operations, Counted(a.value - b.value); }
    friend Counted operator*(Counted a, Counted b) { return ++operations, Counted(a.value * b.value); }
    Counted& operator+=(Counted b) { return *this = *this + b; }
    Counted& operator*=(Counted b) { return *this = *this * b; }
};

}  // namespace
}  // namespace pliant

namespace Eigen {
template <>
struct NumTraits<pliant::Counted> : GenericNumTraits<double> {
    using Real = pliant::Counted;
    using NonInteger = Real;
    using Nested = Real;
    using Literal = Real;
    enum { RequireInitialization = 1 };
};
}  // namespace Eigen

namespace pliant {

OperationCounts count_operations() {
    const Eigen::Matrix<Counted, 3, 3> H = Mat<3>::Identity().unaryExpr([](Real x) { return Counted(x); });
    const auto operations_of = [&H](auto measure) {
        Counted::operations = 0;
        const Eigen::Matrix<Counted, 3, 3> result = measure(H);
        return result.size() == 9 ? Counted::operations : 0;
    };
    return {.right_cauchy_green = operations_of([](const auto& F) { return pliant::right_cauchy_green<3, Counted>(F); }),
            .green = operations_of([](const auto& G) { return green_strain<3, Counted>(G); }),
            .cauchy = operations_of([](const auto& G) { return cauchy_strain<3, Counted>(G); })};
}

}  // namespace pliant
