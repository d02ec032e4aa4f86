// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Sides of joints and bilinear forms of two frames (triad.hpp): what joints are made of.
/// docs/theory-dynamics.md derives them.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/error.hpp>
#include <ancf/model/node.hpp>
#include <ancf/model/slope.hpp>
#include <ancf/model/triad.hpp>
#include <ancf/types.hpp>

#include <cmath>
#include <string>

namespace ancf {

/// A frame at a node.
///
/// By default that of its section: between r_y and r_z, so that a torque divides as the torsion of
/// the node's elements does (Layout::torsion_share), or, where a node has no r_z, t along r_x and n
/// the part of r_y normal to it. What a joint transmits then enters through the section.
/// Two slopes make the frame t along the first, n the part of the second normal to t: with r_x and
/// r_y the joint turns the tangent, and one element's shear alone passes the moment on, which is
/// too soft by 3 M/(k G A l) whatever the mesh.
struct FrameAt {
    NodeId node;                ///< where
    bool of_section = true;     ///< the default; the slopes do not count then
    Field first = Field::r_x;   ///< along the axis t
    Field second = Field::r_y;  ///< in the plane of t and n

    /// The frame of a node's section.
    FrameAt(NodeId at) : node(at) {}  // NOLINT: a node has a frame

    /// @throws InvalidArgument unless both are of r_x, r_y, r_z and differ.
    FrameAt(NodeId at, Field along, Field across)
        : node(at), of_section(false), first(along), second(across) {
        detail::require_slope<3>("FrameAt", along);
        detail::require_slope<3>("FrameAt", across);
        detail::require(along != across, "FrameAt: a frame needs two different slopes, got ",
                        to_string(along), " twice");
    }
};

namespace detail {

/// What a joint holds on one side.
enum class SideKind {
    space,    ///< a frame that rests
    frame,    ///< two slopes of a node
    section,  ///< r_y and r_z of a node
    tangent   ///< one slope of a node
};

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

}  // namespace detail
}  // namespace ancf
