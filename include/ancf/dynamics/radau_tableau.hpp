// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Coefficients of the Radau IIA methods for an odd number of stages, made at set-up.
///
/// Equations (4) and (5) of docs/theory-radau.md.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/types.hpp>

#include <complex>
#include <vector>

namespace ancf::detail {

/// An eigenvalue of W with its column of T and its row of T^-1, W = T diag(mu) T^-1.
struct RadauMode {
    std::complex<double> eigenvalue;
    std::vector<std::complex<double>> column;
    std::vector<std::complex<double>> row;
};

/// A method of s stages.
struct RadauTableau {
    std::vector<double> nodes;     ///< c, ascending, the last one 1
    MatrixX inverse;               ///< W = A^-1, s x s
    MatrixX square;                ///< W^2
    MatrixX double_integral;       ///< A^2
    std::vector<RadauMode> modes;  ///< the real one, then one of each conjugate pair

    [[nodiscard]] int stages() const noexcept { return static_cast<int>(nodes.size()); }
};

/// Returns the method of an odd number of stages from 1 to 9.
[[nodiscard]] RadauTableau radau_tableau(int stages);

/// Returns the values at x of the Lagrange polynomials on the nodes.
[[nodiscard]] std::vector<double> lagrange_weights(const std::vector<double>& nodes, double x);

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/radau_tableau.ipp>  // IWYU pragma: export
#endif
