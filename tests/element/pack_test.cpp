// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Packs of doubles, and what is not put into one; elements side by side stand in files beside.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/pack.hpp>

#include <element/cross_section_beam_samples.hpp>
#include <support/catch.hpp>

#include <cmath>

namespace pack_test {

using namespace ancf;

TEMPLATE_TEST_CASE_SIG("Pack: arithmetic acts lane by lane", "[element][pack]",
                       ((int Lanes), Lanes), 1, 2, 4, 8) {
    Pack<Lanes> a(3.0), b(-0.5);
    for (int k = 0; k < Lanes; ++k) {
        CHECK(a[k] == 3.0);
        a.set(k, 1.5 + k);
        b.set(k, 0.25 - 2.0 * k);
    }
    const Pack<Lanes> sum = a + b, difference = a - b, product = a * b, quotient = a / b;
    const Pack<Lanes> root = sqrt(a), negative = -a, mixed = 2.0 * a - 1.0;
    Pack<Lanes> chain = a;
    chain += b;
    chain *= a;
    chain -= b;
    chain /= a;
    double total = 0.0;
    for (int k = 0; k < Lanes; ++k) {
        const double x = 1.5 + k, y = 0.25 - 2.0 * k;
        CHECK(sum[k] == x + y);
        CHECK(difference[k] == x - y);
        CHECK(product[k] == x * y);
        CHECK(quotient[k] == x / y);
        CHECK(root[k] == std::sqrt(x));
        CHECK(negative[k] == -x);
        CHECK(mixed[k] == 2.0 * x - 1.0);
        CHECK(chain[k] == Approx(((x + y) * x - y) / x).epsilon(1e-15));
        CHECK(cos(a)[k] == std::cos(x));
        CHECK(sin(a)[k] == std::sin(x));
        CHECK(atan(a)[k] == std::atan(x));
        total += x;
    }
    CHECK(lane_sum(a) == total);
}

TEST_CASE("CrossSectionBeam: elements of different rules are not put together",
          "[element][cross-section][pack]") {
    const auto one = test::element_of(test::variants[0]), two = test::element_of(test::variants[1]);
    const auto three = test::element_of(test::variants[2]);
    CHECK_THROWS_WITH(test::Paper::together<2>({&one, &two}), ContainsSubstring("mixed"));
    CHECK_THROWS_WITH(test::Paper::together<2>({&one, &three}), ContainsSubstring("transverse"));
}

}  // namespace pack_test
