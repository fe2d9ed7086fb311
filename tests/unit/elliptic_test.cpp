// Elliptic functions against values of a computation with sixty digits, up to moduli next to 1.
#include <pliant/math/elliptic.h>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>
#include <numbers>

using namespace pliant;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("elliptic integrals keep their digits next to k = 1", "[elliptic]") {
    for (const auto& [complement, quarter] : {std::pair{1., std::numbers::pi / 2},
                                              {0.5, 2.1565156474996432},
                                              {1e-3, 8.29405146361544},
                                              {1e-8, 19.806975105072257},
                                              {1e-15, 35.925070756030576}}) {
        CHECK_THAT(complete_elliptic_integral(complement), WithinRel(quarter, 1e-14));
        CHECK_THAT(elliptic_integral(1, 0, complement), WithinRel(quarter, 1e-14));
    }
    CHECK(std::isinf(complete_elliptic_integral(0)));
    const Real cosine = std::sqrt(1 - 0.3 * 0.3);
    CHECK_THAT(elliptic_integral(0.3, cosine, std::hypot(cosine, 0.5 * 0.3)), WithinRel(0.30827392023666693, 1e-14));
}

TEST_CASE("Jacobi's functions keep their digits next to k = 1", "[elliptic]") {
    const struct {
        Real u, complement, sn, cn, dn;
    } known[] = {{0.7, 0.5, 0.61436324748449435, 0.78902332040333633, 0.84671031061705482},
                 {5, 1e-3, 0.99990945384100706, 0.013456749956024896, 0.013493848164806682},
                 {18, 1e-8, 0.99999999999999956, 2.9639209875208633e-8, 3.1280709103641894e-8},
                 {20, 1e-8, 1, -1.9422576977452583e-9, 1.0186872187499493e-8},
                 {30, 1e-12, 1, -1.1486568633137542e-12, 1.5229617820673612e-12}};
    for (const auto& [u, complement, sn, cn, dn] : known) {
        INFO("u = " << u << ", k' = " << complement);
        const EllipticFunctions now = elliptic_functions(u, complement);
        CHECK_THAT(now.sn, WithinAbs(sn, 1e-15));
        CHECK_THAT(now.cn, WithinAbs(cn, 1e-15));
        CHECK_THAT(now.dn, WithinAbs(dn, 1e-15));
        CHECK_THAT(std::sin(now.am), WithinAbs(sn, 1e-15));
    }
    // Without a modulus they are sine and cosine; each lap of 4 K comes back.
    CHECK_THAT(elliptic_functions(2.5, 1).sn, WithinAbs(std::sin(2.5), 1e-15));
    const Real lap = 4 * complete_elliptic_integral(1e-4);
    CHECK_THAT(elliptic_functions(1.3 + lap, 1e-4).cn, WithinAbs(elliptic_functions(1.3, 1e-4).cn, 1e-13));
}
