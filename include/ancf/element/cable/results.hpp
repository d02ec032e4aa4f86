// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Cable: kinematics, strain, moment and section forces. Include <ancf/element/cable/cable.hpp>.

#pragma once

#include <ancf/element/cable/cable.hpp>

#include <cmath>

namespace ancf {

namespace detail {

/// Returns the matrix of the weights of (r_j - r_i, r_x i, r_x j) on the nodal coordinates.
template <int D>
[[nodiscard]] inline Matrix<double, D, 4 * D> line_jacobian(
    const LineWeights<double>& weights) noexcept {
    const Matrix<double, D> identity = Matrix<double, D>::Identity();
    Matrix<double, D, 4 * D> jacobian;
    jacobian << -weights[0] * identity, weights[1] * identity, weights[0] * identity,
        weights[2] * identity;
    return jacobian;
}

/// Returns 1, or -1 where the tangent's X component is below -0.9: which side of X a frame starts
/// from.
template <class Scalar>
[[nodiscard]] inline Scalar frame_side(const Scalar& x) noexcept {
    return 2.0 * taut(Scalar(x + 0.9)) - 1.0;
}

}  // namespace detail

/// Between the stations by the polar form of the quadratic r'(xi): docs/theory-cable.md, "Folds".
template <int Dimension, class Measure>
bool Cable<Dimension, Measure>::admissible(const Coordinates& e) const noexcept {
    if (!detail::all_finite(e)) return false;
    const auto line = detail::line_of<Dimension>(e);
    const auto stretched = [](const Point& p) { return p.squaredNorm() > 1e-12; };
    for (const auto& at : kernel_.axial)
        if (!stretched(detail::interpolated<Dimension>(at.p, line))) return false;
    for (const auto& at : kernel_.bending)
        if (!stretched(detail::interpolated<Dimension>(at.p, line))) return false;
    const Point first = line.template segment<Dimension>(Dimension),
                last = line.template tail<Dimension>(),
                control =
                    3.0 / line_.parameter_length() * line.template head<Dimension>() - first - last;
    const auto polar = [&](double a, double b) -> Point {
        return (1.0 - a) * (1.0 - b) * first + (a + b - 2.0 * a * b) * control + a * b * last;
    };
    for (int k = 0; k < detail::line_parts; ++k) {
        const double a = static_cast<double>(k) / detail::line_parts,
                     b = static_cast<double>(k + 1) / detail::line_parts;
        const Point start = polar(a, a), middle = polar(a, b), end = polar(b, b);
        if (!(start.dot(middle) > 0.0 && middle.dot(end) > 0.0 && start.dot(end) > 0.0))
            return false;
    }
    return stretched(first) && stretched(last);
}

/// (t, n) in the plane, (t, n, c) in space, columns.
template <int Dimension, class Measure>
template <class Scalar>
Matrix<Scalar, Dimension> Cable<Dimension, Measure>::section_frame(
    const Vector<Scalar, Dimension>& t) noexcept {
    Matrix<Scalar, Dimension> frame;
    frame.col(0) = t;
    if constexpr (Dimension == 2) {
        frame.col(1) = Vector<Scalar, 2>(-t[1], t[0]);
    } else {
        const Scalar side = detail::frame_side(t[0]);
        const Scalar ratio = t[1] / (1.0 + side * t[0]);
        const Vector<Scalar, 3> n(-ratio * (side + t[0]), 1.0 - ratio * t[1], -ratio * t[2]);
        frame.col(1) = side * n;
        frame.col(2) = cross(t, Vector<Scalar, 3>(frame.col(1)));
    }
    return frame;
}

template <int Dimension, class Measure>
template <class Scalar>
Vector<Scalar, Dimension> Cable<Dimension, Measure>::position(const Vector<Scalar, dofs>& e,
                                                              double xi, double y,
                                                              double z) const noexcept {
    Vector<Scalar, Dimension> place = line_.point(e, xi);
    if (y == 0.0 && z == 0.0) return place;
    const Matrix<Scalar, Dimension> frame = section_frame<Scalar>(tangent(e, xi));
    place += Scalar(y) * frame.col(1);
    if constexpr (Dimension == 3) place += Scalar(z) * frame.col(2);
    return place;
}

template <int Dimension, class Measure>
typename Cable<Dimension, Measure>::Jacobian Cable<Dimension, Measure>::position_jacobian(
    const Coordinates& e, double xi, double y, double z) const noexcept {
    Jacobian jacobian = Jacobian::Zero();
    line_.add_point_jacobian(xi, jacobian);
    if (y == 0.0 && z == 0.0) return jacobian;
    const Point t = tangent(e, xi);
    Matrix<double, Dimension> turning;  // of y n + z c by t
    if constexpr (Dimension == 2) {
        turning << 0.0, -y, y, 0.0;
    } else {
        const double side = detail::frame_side(t[0]);
        const Point start = side * Point::UnitX();
        const Point sum = start + t, n = section_frame<double>(t).col(1);
        const double inverse = 1.0 / (1.0 + start.dot(t)), ratio = t[1] * inverse;
        const Matrix<double, 3> n_by_t =
            -side * (inverse * sum * (Point::UnitY() - ratio * start).transpose() +
                     ratio * Matrix<double, 3>::Identity());
        turning = y * n_by_t + z * (cross_matrix(t) * n_by_t - cross_matrix(n));
    }
    return jacobian + turning * tangent_jacobian(e, xi);
}

template <int Dimension, class Measure>
typename Cable<Dimension, Measure>::Jacobian Cable<Dimension, Measure>::tangent_jacobian(
    const Coordinates& e, double xi) const noexcept {
    const Jacobian line = detail::line_jacobian<Dimension>(station(xi).p);
    const Point p = line * e;
    const double stretch = p.norm();
    const Point t = p / stretch;
    return (line - t * (t.transpose() * line)) / stretch;
}

template <int Dimension, class Measure>
double Cable<Dimension, Measure>::axial_strain(const Coordinates& e, double xi) const noexcept {
    return Measure::strain(
        Point(detail::line_jacobian<Dimension>(station(xi).p) * e).squaredNorm());
}

template <int Dimension, class Measure>
typename Cable<Dimension, Measure>::Curvature Cable<Dimension, Measure>::curvature(
    const Coordinates& e, double xi) const noexcept {
    const Station at = station(xi);
    const Point p = detail::line_jacobian<Dimension>(at.p) * e,
                v = detail::line_jacobian<Dimension>(at.v) * e;
    return curvature(p, v);
}

template <int Dimension, class Measure>
typename Cable<Dimension, Measure>::Curvature Cable<Dimension, Measure>::curvature(
    const Point& p, const Point& v) noexcept {
    const double stretch = p.norm(), cube = stretch * stretch * stretch;
    if constexpr (Dimension == 2)
        return Curvature((p[0] * v[1] - p[1] * v[0]) / cube);
    else
        return cross(p, v) / cube;
}

/// The curvature of the reference: in space its parts along n and across it, n the resultant's
/// direction projected on the normal plane, are carried from the frame of the reference to the
/// present one.
template <int Dimension, class Measure>
typename Cable<Dimension, Measure>::Curvature Cable<Dimension, Measure>::natural_curvature(
    const Coordinates& e, double xi) const noexcept {
    Curvature curved = Curvature::Zero();
    if (kernel_.natural.empty()) return curved;
    curved = curvature(reference_, xi);
    if constexpr (Dimension == 3) {
        const auto frame = [&](const Coordinates& at) {
            const Point t = tangent(at, xi);
            const Point n = detail::natural_resultant(kernel_.natural.front(), kernel_.bending,
                                                      detail::line_of<3>(at));
            Matrix<double, 3> axes;
            axes << t, (n - n.dot(t) * t).normalized(), Point::Zero();
            axes.col(2) = cross(t, Point(axes.col(1)));
            return axes;
        };
        curved = frame(e) * (frame(reference_).transpose() * curved);
    }
    return curved;
}

template <int Dimension, class Measure>
typename Cable<Dimension, Measure>::Curvature Cable<Dimension, Measure>::moment(
    const Coordinates& e, double xi) const noexcept {
    const double stretch = Point(detail::line_jacobian<Dimension>(station(xi).p) * e).norm();
    return bending_stiffness_ / stretch * (curvature(e, xi) - natural_curvature(e, xi));
}

template <int Dimension, class Measure>
SectionForces Cable<Dimension, Measure>::section_forces(const Coordinates& e,
                                                        double xi) const noexcept {
    const Point p = detail::line_jacobian<Dimension>(station(xi).p) * e;
    const double square = p.squaredNorm(), strain = Measure::strain(square);
    const auto axial = detail::axial_response(axial_stiffness_, kernel_.softening, strain);
    double n = 0.0, k = 0.0;
    Measure::resultants(axial.force, axial.stiffness, square, strain, n, k);
    const Curvature bent = moment(e, xi);
    SectionForces result;
    result.axial = n * std::sqrt(square) - bent.dot(curvature(e, xi));
    if constexpr (Dimension == 2) {
        result.moment_z = bent[0];
    } else {
        const Matrix<double, 3> frame = section_frame<double>(tangent(e, xi));
        result.moment_y = bent.dot(frame.col(1));
        result.moment_z = bent.dot(frame.col(2));
    }
    return result;
}

template <int Dimension, class Measure>
Vector<double, 1> Cable<Dimension, Measure>::stress(const Coordinates& e, double xi, double y,
                                                    double z) const noexcept {
    const double strain = axial_strain(e, xi);
    const Curvature change = curvature(e, xi) - natural_curvature(e, xi);
    double stress = detail::axial_response(young_, kernel_.softening, strain).force;
    if constexpr (Dimension == 2) {
        stress -= young_ * y * change[0];
    } else {
        const Matrix<double, 3> frame = section_frame<double>(tangent(e, xi));
        stress += young_ * (z * change.dot(frame.col(1)) - y * change.dot(frame.col(2)));
    }
    return Vector<double, 1>(stress);
}

}  // namespace ancf
