// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/dynamics/radau_tableau.hpp>

#include <support/catch.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <complex>

namespace radau_test {

using namespace ancf;

TEST_CASE("Radau IIA: the tables fulfil the conditions of order", "[dynamics][radau]") {
    const int s = GENERATE(1, 3, 5, 7);
    CAPTURE(s);
    const detail::RadauTableau table = detail::radau_tableau(s);
    REQUIRE(table.stages() == s);
    const MatrixX A = table.inverse.inverse();
    const auto c = [&](int i, int power) {
        return std::pow(table.nodes[static_cast<std::size_t>(i)], power);
    };
    // 2e-15 measured with seven stages
    constexpr double round_off = 1e-14;
    CHECK(table.nodes.back() == 1.0);
    for (int k = 1; k <= 2 * s - 1; ++k) {  // B(2s - 1): the last row of A is the quadrature
        double sum = 0.0;
        for (int j = 0; j < s; ++j) sum += A(s - 1, j) * c(j, k - 1);
        CHECK(std::abs(k * sum - 1.0) <= round_off);
    }
    for (int k = 1; k <= s; ++k)  // C(s)
        for (int i = 0; i < s; ++i) {
            double sum = 0.0;
            for (int j = 0; j < s; ++j) sum += A(i, j) * c(j, k - 1);
            CHECK(std::abs(k * sum - c(i, k)) <= round_off);
        }
    for (int k = 1; k <= s - 1; ++k)  // D(s - 1)
        for (int j = 0; j < s; ++j) {
            double sum = 0.0;
            for (int i = 0; i < s; ++i) sum += A(s - 1, i) * c(i, k - 1) * A(i, j);
            CHECK(std::abs(k * sum - A(s - 1, j) * (1.0 - c(j, k))) <= round_off);
        }
    CHECK((A * A - table.double_integral).cwiseAbs().maxCoeff() <= round_off);
    CHECK((table.inverse * table.inverse - table.square).cwiseAbs().maxCoeff() <=
          round_off * table.square.cwiseAbs().maxCoeff());
}

TEST_CASE("Radau IIA: the modes diagonalise the tables", "[dynamics][radau]") {
    const int s = GENERATE(1, 3, 5, 7);
    CAPTURE(s);
    const detail::RadauTableau table = detail::radau_tableau(s);
    REQUIRE(table.modes.size() == static_cast<std::size_t>(s + 1) / 2);
    CHECK(table.modes.front().eigenvalue.imag() == 0.0);
    // sum over modes of mu column row, pairs twice their real part, is W
    MatrixX sum = MatrixX::Zero(s, s);
    for (const detail::RadauMode& mode : table.modes) {
        const bool real = mode.eigenvalue.imag() == 0.0;
        for (int i = 0; i < s; ++i)
            for (int j = 0; j < s; ++j)
                sum(i, j) += (real ? 1.0 : 2.0) *
                             (mode.eigenvalue * mode.column[static_cast<std::size_t>(i)] *
                              mode.row[static_cast<std::size_t>(j)])
                                 .real();
    }
    // 6e-14 of 29 measured with seven stages
    CHECK((sum - table.inverse).cwiseAbs().maxCoeff() <=
          2e-14 * table.inverse.cwiseAbs().maxCoeff());
}

}  // namespace radau_test
