// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What keeps a joint from standing half a turn off: sines that have no second root.
///
/// sin psi is zero at psi = pi too. Joints hold F sin psi instead, F a function of c = cos psi:
///
///     F = 1 + w (psi/sin psi - 1),    w = x^3 (10 - 15 x + 6 x^2),    x = (1/2 - c)/(3/2)
///
/// where c < 1/2, else 1: up to pi/3 it is the sine, at pi the angle, between them it grows.
/// docs/theory-dynamics.md, "Turns".

#pragma once

#include <cmath>
#include <complex>

namespace ancf::detail {

/// F, and its derivatives with respect to the cosine.
template <class Scalar>
struct TurnFactor {
    Scalar value{1.0}, first{0.0}, second{0.0};
    bool varies = false;  ///< else it is 1
};

/// Returns F at an angle of -pi to pi rad; not finite where the sine is 0 and the cosine -1: no
/// axis tells then which way to turn.
[[nodiscard]] inline TurnFactor<double> turn_factor(double sine, double cosine) {
    TurnFactor<double> f;
    if (cosine >= 0.5) return f;
    // A = psi/sin psi: (1 - c^2) A' = c A - 1, (1 - c^2) A'' = 3 c A' + A
    const double square = sine * sine;
    const double a = std::atan2(sine, cosine) / sine;
    const double a_first = (cosine * a - 1.0) / square;
    const double a_second = (3.0 * cosine * a_first + a) / square;
    const double slope = -2.0 / 3.0;  // dx/dc
    const double x = slope * (cosine - 0.5);
    const double w = x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);
    const double w_first = slope * 30.0 * x * x * (1.0 - x) * (1.0 - x);
    const double w_second = slope * slope * 60.0 * x * (1.0 - x) * (1.0 - 2.0 * x);
    f.value = 1.0 + w * (a - 1.0);
    f.first = w_first * (a - 1.0) + w * a_first;
    f.second = w_second * (a - 1.0) + 2.0 * w_first * a_first + w * a_second;
    f.varies = true;
    return f;
}

/// The same, continued into the complex plane by its derivative; the second one is its real part.
/// @param sine  its real part.
[[nodiscard]] inline TurnFactor<std::complex<double>> turn_factor(
    double sine, const std::complex<double>& cosine) {
    const TurnFactor<double> f = turn_factor(sine, cosine.real());
    return {{f.value, f.first * cosine.imag()},
            {f.first, f.second * cosine.imag()},
            {f.second, 0.0},
            f.varies};
}

}  // namespace ancf::detail
