// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Bilinear forms of two frames (triad.hpp) and their factor: what the equations of joints are made
/// of.
/// docs/theory-dynamics.md derives them.

#pragma once

#include <ancf/element/vec3.hpp>
#include <ancf/list.hpp>
#include <ancf/model/triad.hpp>

#include <array>
#include <cmath>
#include <complex>

namespace ancf::detail {

/// What keeps a joint from standing half a turn off: the factor F of a sine, which then has no
/// second root, and its derivatives with respect to the cosine.
///
/// sin psi is zero at psi = pi too. Joints hold F sin psi instead, F a function of c = cos psi:
///
///     F = 1 + w (psi/sin psi - 1),    w = x^3 (10 - 15 x + 6 x^2),    x = (1/2 - c)/(3/2)
///
/// where c < 1/2, else 1: up to pi/3 it is the sine, at pi the angle, between them it grows.
/// docs/theory-dynamics.md, "Turns".
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

/// The bilinear form g = sum_ij C_ij A_i.B_j of the axes of two frames.
///
/// With X = B C^T (columns x_i = sum_j C_ij B_j) and the moment m = sum_i A_i x x_i, dg = m.(w_A -
/// w_B).
template <class Scalar>
struct FrameForm {
    Scalar value{};
    Vec3<Scalar> moment{};

    FrameForm(const Block<Scalar>& coefficients, const Triad<Scalar>& a, const Triad<Scalar>& b) {
        for (int i = 0; i < 3; ++i) {
            const Vec3<Scalar> x = coefficients(i, 0) * b.axes[0] + coefficients(i, 1) * b.axes[1] +
                                   coefficients(i, 2) * b.axes[2];
            value += dot(a.axes[i], x);
            moment = moment + cross(a.axes[i], x);
        }
    }

    /// Returns dg/d(slopes of A, slopes of B).
    [[nodiscard]] std::array<Scalar, 12> gradient(const Triad<Scalar>& a,
                                                  const Triad<Scalar>& b) const {
        std::array<Scalar, 12> row = {};
        for (int k = 0; k < a.width; ++k) row[k] = dot(a.spin[k], moment);
        for (int k = 0; k < b.width; ++k) row[a.width + k] = -dot(b.spin[k], moment);
        return row;
    }
};

/// Returns the Hessian of a bilinear form; only the first rows and columns, as many as both sides
/// have slopes' components, are there.
///
///     H_AA = O_A^T S O_A + d(O_A^T m),  H_BB = O_B^T S^T O_B - d(O_B^T m),  H_AB = -O_A^T S^T O_B,
///     S = sum_i A_i x_i^T - (sum_i A_i.x_i) I
[[nodiscard]] inline Block<double, 12> frame_form_hessian(const Block<double>& coefficients,
                                                          const Triad<double>& a,
                                                          const Triad<double>& b) {
    const FrameForm<double> form(coefficients, a, b);
    Block<double> s;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            s(i, j) = i == j ? -form.value : 0.0;
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l)
                    s(i, j) += a.axes[k][i] * coefficients(k, l) * b.axes[l][j];
        }
    // O_X^T S O_Y, or with S^T
    const auto product = [&s](const Triad<double>& x, int i, const Triad<double>& y, int j,
                              bool transposed) {
        double sum = 0.0;
        for (int k = 0; k < 3; ++k)
            for (int l = 0; l < 3; ++l)
                sum += x.spin[i][k] * (transposed ? s(l, k) : s(k, l)) * y.spin[j][l];
        return sum;
    };
    Block<double, 12> h = {};
    const Block<double, 6> by_a = spin_derivative(a, form.moment);
    const Block<double, 6> by_b = spin_derivative(b, form.moment);
    const int n = a.width;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) h(i, j) = product(a, i, a, j, false) + by_a(i, j);
    for (int j = 0; j < b.width; ++j) {
        for (int i = 0; i < b.width; ++i) h(n + i, n + j) = product(b, i, b, j, true) - by_b(i, j);
        for (int i = 0; i < n; ++i) h(i, n + j) = h(n + j, i) = -product(a, i, b, j, true);
    }
    return h;
}

/// Returns the rotation by an angle about the unit axis of k = [axis]x.
template <class Scalar>
[[nodiscard]] Block<Scalar> rotation_about(const Block<double>& k, const Scalar& angle) {
    using std::cos;
    using std::sin;
    const Scalar sine = sin(angle), versine = Scalar(1.0) - cos(angle);
    const Block<double> square = k * k;
    Block<Scalar> turn;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            turn(i, j) = Scalar(i == j ? 1.0 : 0.0) + sine * k(i, j) + versine * square(i, j);
    return turn;
}

/// Coefficients of the bilinear forms of a joint.
template <class Scalar>
struct Forms {
    List<Block<Scalar>> sines;
    Block<Scalar> cosine = {};
};

/// Returns the forms whose values are the axis times the sine of the turn of R_A^T R_B against Q,
/// and its cosine + 1/2.
template <class Scalar>
[[nodiscard]] Forms<Scalar> turn_forms(const Block<Scalar>& relative) {
    Forms<Scalar> forms;
    forms.sines.resize(3);
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 2) % 3;
        const int j = (k + 1) % 3;
        Block<Scalar>& sine = forms.sines[k];
        for (int l = 0; l < 3; ++l) {
            sine(i, l) = Scalar(0.5) * relative(j, l);
            sine(j, l) = Scalar(-0.5) * relative(i, l);
            forms.cosine(k, l) = Scalar(0.5) * relative(k, l);
        }
    }
    return forms;
}

/// Derivatives of a bilinear form: by the slopes, and by time without what accelerations make.
struct FormCourse {
    std::array<double, 12> gradient;
    Block<double, 12> hessian;
    double speed = 0.0, bend = 0.0;  ///< first and second

    /// Of coefficients at rest, with the slopes' rates v.
    FormCourse(const Block<double>& coefficients, const Triad<double>& a, const Triad<double>& b,
               const std::array<double, 12>& v)
        : gradient(FrameForm<double>(coefficients, a, b).gradient(a, b)),
          hessian(frame_form_hessian(coefficients, a, b)) {
        for (int j = 0; j < 12; ++j) {
            speed += gradient[j] * v[j];
            for (int i = 0; i < 12; ++i) bend += v[i] * hessian(i, j) * v[j];
        }
    }

    /// Adds what moving coefficients make: g_t, and 2 (g_t)_q v + g_tt.
    void move(const Block<double>& rate, const Block<double>& acceleration, const Triad<double>& a,
              const Triad<double>& b, const std::array<double, 12>& v) {
        const FrameForm<double> form(rate, a, b);
        const std::array<double, 12> by_slopes = form.gradient(a, b);
        speed += form.value;
        for (int i = 0; i < 12; ++i) bend += 2.0 * by_slopes[i] * v[i];
        bend += FrameForm<double>(acceleration, a, b).value;
    }
};

}  // namespace ancf::detail
