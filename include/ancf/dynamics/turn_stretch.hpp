// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What gives the middle of a turn the size of its ends.
///
/// The mean of both ends of a turn by theta is their middle, smaller by cos(theta/2) across the
/// axis. With the turn y = 2 tan(theta/2) n of the change at the middle,
///
///     A = a I - y y^T/(4 (1 + a)),   a = sqrt(1 + y.y/4) = 1/cos(theta/2),
///
/// is 1 along n and 1/cos(theta/2) across it. docs/theory-dynamics.md, "Energy-momentum".

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/types.hpp>

namespace ancf::detail {

/// The stretch A of a turn, its inverse and the derivatives of both.
class TurnStretch {
public:
    /// @param turn  y, rad for small ones.
    explicit TurnStretch(const Vector<double, 3>& turn);

    /// Returns A - I.
    [[nodiscard]] const Matrix<double, 3>& excess() const noexcept { return excess_; }
    /// Returns A^-1.
    [[nodiscard]] const Matrix<double, 3>& inverse() const noexcept { return inverse_; }
    /// Returns dA/dy_a.
    [[nodiscard]] Matrix<double, 3> rate(int a) const;
    /// Returns d(A^-1)/dy_a.
    [[nodiscard]] Matrix<double, 3> inverse_rate(int a) const;

private:
    // d(y y^T/(4 (1 + a)))/dy_k
    [[nodiscard]] Matrix<double, 3> product_rate(int k) const;

    Vector<double, 3> turn_;
    double across_;  // a
    Matrix<double, 3> excess_, inverse_;
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/turn_stretch.ipp>  // IWYU pragma: export
#endif
