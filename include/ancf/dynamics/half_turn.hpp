// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Half of a turn, which brings both ends of a step to its middle.
///
/// The turn y = 2 tan(theta/2) n of a change belongs to the angle theta about n. Its half is
///
///     R = S + X,   S = (I + y y^T/(4 (1 + a)))/a,   X = [y]x/(2 a),   a = sqrt(1 + y.y/4):
///
/// S is cos(theta/2) across n and 1 along it. docs/theory-dynamics.md, "Energy-momentum".

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/types.hpp>

namespace ancf::detail {

/// The parts of half a turn and their derivatives, as they act on a vector.
class HalfTurn {
public:
    /// @param turn  y, rad for small ones.
    explicit HalfTurn(const Vector<double, 3>& turn);

    /// Returns S v.
    [[nodiscard]] Vector<double, 3> symmetric(const Vector<double, 3>& v) const {
        return over_ * v + stretch_ * half_.dot(v) * half_;
    }
    /// Returns X v.
    [[nodiscard]] Vector<double, 3> skew(const Vector<double, 3>& v) const {
        return cross(half_, v);
    }
    /// Writes S x - X d, the mean of R (x - d) and R^T (x + d), and X times their difference,
    /// 2 X (S d - X x).
    void middle(const Vector<double, 3>& x, const Vector<double, 3>& d, Vector<double, 3>& mean,
                Vector<double, 3>& arm) const {
        const Vector<double, 3> back = cross(half_, d);
        const double along = half_.dot(x);
        mean = over_ * x + stretch_ * along * half_ - back;
        arm = 2.0 * (over_ * back + half_.dot(half_) * x - along * half_);
    }
    /// Returns dS/dy_b v.
    [[nodiscard]] Vector<double, 3> symmetric_rate(int b, const Vector<double, 3>& v) const;
    /// Returns dX/dy_b v.
    [[nodiscard]] Vector<double, 3> skew_rate(int b, const Vector<double, 3>& v) const;

private:
    Vector<double, 3> half_;  // y/(2 a)
    double a_, over_;         // and its inverse
    double stretch_;          // a/(1 + a)
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/half_turn.ipp>  // IWYU pragma: export
#endif
