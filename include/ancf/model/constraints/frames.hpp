// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Bilinear forms of two frames (triad.hpp): what the equations of joints are made of.
/// docs/theory-dynamics.md derives them.

#pragma once

#include <ancf/model/triad.hpp>
#include <ancf/types.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace ancf::detail {

/// The bilinear form g = sum_ij C_ij A_i.B_j of the axes of two frames.
///
/// With X = B C^T (columns x_i = sum_j C_ij B_j) and the moment m = sum_i A_i x x_i, dg = m.(w_A -
/// w_B).
template <class Scalar>
struct FrameForm {
    Scalar value;
    Vector<Scalar, 3> moment;

    FrameForm(const Matrix<Scalar, 3>& coefficients, const Triad<Scalar>& a,
              const Triad<Scalar>& b) {
        value = Scalar(0.0);
        moment.setZero();
        for (int i = 0; i < 3; ++i) {
            const Vector<Scalar, 3> axis = a.axes.col(i);
            Vector<Scalar, 3> x;
            for (int k = 0; k < 3; ++k)
                x[k] = b.axes(k, 0) * coefficients(i, 0) + b.axes(k, 1) * coefficients(i, 1) +
                       b.axes(k, 2) * coefficients(i, 2);
            value += axis[0] * x[0] + axis[1] * x[1] + axis[2] * x[2];
            moment += cross(axis, x);
        }
    }

    /// Returns dg/d(slopes of A, slopes of B).
    [[nodiscard]] Vector<Scalar, 12> gradient(const Triad<Scalar>& a,
                                              const Triad<Scalar>& b) const {
        Vector<Scalar, 12> row = Vector<Scalar, 12>::Zero();
        const Vector<Scalar, 6> of_a = a.on_slopes(moment), of_b = b.on_slopes(moment);
        for (int k = 0; k < a.width; ++k) row[k] = of_a[k];
        for (int k = 0; k < b.width; ++k) row[a.width + k] = -of_b[k];
        return row;
    }
};

/// Returns the Hessian of a bilinear form; only the first rows and columns, as many as both sides
/// have slopes' components, are there.
///
///     H_AA = O_A^T S O_A + d(O_A^T m),  H_BB = O_B^T S^T O_B - d(O_B^T m),  H_AB = -O_A^T S^T O_B,
///     S = sum_i A_i x_i^T - (sum_i A_i.x_i) I
[[nodiscard]] inline Matrix<double, 12> frame_form_hessian(const Matrix<double, 3>& coefficients,
                                                           const Triad<double>& a,
                                                           const Triad<double>& b) {
    const FrameForm<double> form(coefficients, a, b);
    Matrix<double, 3> s;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            s(i, j) = i == j ? -form.value : 0.0;
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l)
                    s(i, j) += a.axes(i, k) * coefficients(k, l) * b.axes(j, l);
        }
    // O_X^T S O_Y, or with S^T
    const auto product = [&s](const Triad<double>& x, int i, const Triad<double>& y, int j,
                              bool transposed) {
        double sum = 0.0;
        for (int k = 0; k < 3; ++k)
            for (int l = 0; l < 3; ++l)
                sum += x.spin(k, i) * (transposed ? s(l, k) : s(k, l)) * y.spin(l, j);
        return sum;
    };
    Matrix<double, 12> h = Matrix<double, 12>::Zero();
    const Matrix<double, 6> by_a = spin_derivative(a, form.moment);
    const Matrix<double, 6> by_b = spin_derivative(b, form.moment);
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
[[nodiscard]] Matrix<Scalar, 3> rotation_about(const Matrix<double, 3>& k, const Scalar& angle) {
    using std::cos;
    using std::sin;
    const Scalar sine = sin(angle), versine = Scalar(1.0) - cos(angle);
    Matrix<Scalar, 3> turn;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double square = k(i, 0) * k(0, j) + k(i, 1) * k(1, j) + k(i, 2) * k(2, j);
            turn(i, j) = Scalar(i == j ? 1.0 : 0.0) + sine * k(i, j) + versine * square;
        }
    return turn;
}

/// Coefficients of the bilinear forms of a joint.
template <class Scalar>
struct Forms {
    std::vector<Matrix<Scalar, 3>> sines;
    Matrix<Scalar, 3> cosine = Matrix<Scalar, 3>::Zero();
};

/// Returns the forms whose values are the axis times the sine of the turn of R_A^T R_B against Q,
/// and its cosine + 1/2.
template <class Scalar>
[[nodiscard]] Forms<Scalar> turn_forms(const Matrix<Scalar, 3>& relative) {
    Forms<Scalar> forms;
    forms.sines.assign(3, Matrix<Scalar, 3>::Zero());
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 2) % 3;
        const int j = (k + 1) % 3;
        Matrix<Scalar, 3>& sine = forms.sines[static_cast<std::size_t>(k)];
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
    Vector<double, 12> gradient;
    Matrix<double, 12> hessian;
    double speed = 0.0, bend = 0.0;  ///< first and second

    /// Of coefficients at rest, with the slopes' rates v.
    FormCourse(const Matrix<double, 3>& coefficients, const Triad<double>& a,
               const Triad<double>& b, const Vector<double, 12>& v)
        : gradient(FrameForm<double>(coefficients, a, b).gradient(a, b)),
          hessian(frame_form_hessian(coefficients, a, b)) {
        for (int j = 0; j < 12; ++j) {
            speed += gradient[j] * v[j];
            for (int i = 0; i < 12; ++i) bend += v[i] * hessian(i, j) * v[j];
        }
    }

    /// Adds what moving coefficients make: g_t, and 2 (g_t)_q v + g_tt.
    void move(const Matrix<double, 3>& rate, const Matrix<double, 3>& acceleration,
              const Triad<double>& a, const Triad<double>& b, const Vector<double, 12>& v) {
        const FrameForm<double> form(rate, a, b);
        const Vector<double, 12> by_slopes = form.gradient(a, b);
        speed += form.value;
        for (int i = 0; i < 12; ++i) bend += 2.0 * by_slopes[i] * v[i];
        bend += FrameForm<double>(acceleration, a, b).value;
    }
};

}  // namespace ancf::detail
