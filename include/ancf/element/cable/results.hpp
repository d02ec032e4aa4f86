// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Cable: kinematics, strain, moment and section forces. Include <ancf/element/cable/cable.hpp>.

#pragma once

#include <ancf/element/cable/cable.hpp>

#include <array>
#include <cmath>

namespace ancf {

namespace detail {

/// Adds m dp/de, D x 4 D, to a Jacobian; p is the vector of the line with these weights, m D x D.
template <int D>
void add_line_jacobian(const Matrix<double, D>& m, const LineWeights<double>& weights,
                       Matrix<double, D, 4 * D>& jacobian) noexcept {
    const double of_node[] = {-weights[0], weights[1], weights[0], weights[2]};
    for (int j = 0; j < 4 * D; ++j)
        for (int i = 0; i < D; ++i) jacobian(i, j) += of_node[j / D] * m(i, j % D);
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
    const auto stretched = [](const Point& p) { return detail::product(p, p) > 1e-12; };
    for (const auto& at : kernel_.axial)
        if (!stretched(detail::interpolated<Dimension>(at.p, line))) return false;
    for (const auto& at : kernel_.bending)
        if (!stretched(detail::interpolated<Dimension>(at.p, line))) return false;
    const Point first = line.template segment<Dimension>(Dimension),
                last = line.template tail<Dimension>();
    const Point control =
        3.0 / line_.parameter_length() * line.template head<Dimension>() - first - last;
    const auto polar = [&](double a, double b) -> Point {
        const double of_first = (1.0 - a) * (1.0 - b), of_last = a * b;
        return of_first * first + (1.0 - of_first - of_last) * control + of_last * last;
    };
    Point start = first;
    for (int k = 0; k < detail::line_parts; ++k) {
        const double a = static_cast<double>(k) / detail::line_parts,
                     b = static_cast<double>(k + 1) / detail::line_parts;
        const Point middle = polar(a, b), end = polar(b, b);
        if (!(detail::product(start, middle) > 0.0 && detail::product(middle, end) > 0.0 &&
              detail::product(start, end) > 0.0))
            return false;
        start = end;
    }
    return stretched(first) && stretched(last);
}

/// (t, n) in the plane, (t, n, c) in space.
template <int Dimension, class Measure>
template <class Scalar>
auto Cable<Dimension, Measure>::section_frame(const Vector<Scalar, Dimension>& t) noexcept
    -> std::array<Vector<Scalar, Dimension>, Dimension> {
    if constexpr (Dimension == 2) {
        return {t, {-t[1], t[0]}};
    } else {
        const Scalar side = detail::frame_side(t[0]);
        const Scalar ratio = t[1] / (1.0 + side * t[0]);
        const Vector<Scalar, 3> n(-t[1], side * (1.0 - ratio * t[1]), -side * ratio * t[2]);
        return {t, n, cross(t, n)};
    }
}

template <int Dimension, class Measure>
template <class Scalar>
Vector<Scalar, Dimension> Cable<Dimension, Measure>::position(const Vector<Scalar, dofs>& e,
                                                              double xi, double y,
                                                              double z) const noexcept {
    Vector<Scalar, Dimension> place = line_.point(e, xi);
    if (y == 0.0 && z == 0.0) return place;
    const auto frame = section_frame<Scalar>(tangent(e, xi));
    place += Scalar(y) * frame[1];
    if constexpr (Dimension == 3) place += Scalar(z) * frame[2];
    return place;
}

template <int Dimension, class Measure>
typename Cable<Dimension, Measure>::Jacobian Cable<Dimension, Measure>::position_jacobian(
    const Coordinates& e, double xi, double y, double z) const noexcept {
    Jacobian jacobian = Jacobian::Zero();
    line_.add_point_jacobian(xi, jacobian);
    if (y == 0.0 && z == 0.0) return jacobian;
    const auto weights = station(xi).p;
    const Matrix<double, Dimension> by_p = tangent_by_slope(along(weights, e));
    Matrix<double, Dimension> turning;  // of y n + z c by p
    if constexpr (Dimension == 2) {
        for (int j = 0; j < 2; ++j) turning.col(j) = Point(-y * by_p(1, j), y * by_p(0, j));
    } else {
        const Point t = tangent(e, xi);
        const double side = detail::frame_side(t[0]);
        const double inverse = 1.0 / (1.0 + side * t[0]), ratio = t[1] * inverse;
        const Point n = section_frame<double>(t)[1];
        for (int j = 0; j < 3; ++j) {
            const Point change = by_p.col(j);
            const double of_ratio = (change[1] - ratio * side * change[0]) * inverse;
            const Point of_n(-change[1], -side * (of_ratio * t[1] + ratio * change[1]),
                             -side * (of_ratio * t[2] + ratio * change[2]));
            turning.col(j) = y * of_n + z * (cross(change, n) + cross(t, of_n));
        }
    }
    detail::add_line_jacobian<Dimension>(turning, weights, jacobian);
    return jacobian;
}

template <int Dimension, class Measure>
Matrix<double, Dimension> Cable<Dimension, Measure>::tangent_by_slope(const Point& p) noexcept {
    const double inverse = 1.0 / std::sqrt(detail::product(p, p));
    Matrix<double, Dimension> result;
    for (int j = 0; j < Dimension; ++j)
        for (int i = 0; i < Dimension; ++i)
            result(i, j) = inverse * ((i == j ? 1.0 : 0.0) - inverse * inverse * p[i] * p[j]);
    return result;
}

template <int Dimension, class Measure>
double Cable<Dimension, Measure>::axial_strain(const Coordinates& e, double xi) const noexcept {
    const Point p = along(station(xi).p, e);
    return Measure::strain(detail::product(p, p));
}

template <int Dimension, class Measure>
typename Cable<Dimension, Measure>::Curvature Cable<Dimension, Measure>::curvature(
    const Coordinates& e, double xi) const noexcept {
    const Station at = station(xi);
    return curvature(along(at.p, e), along(at.v, e));
}

template <int Dimension, class Measure>
typename Cable<Dimension, Measure>::Curvature Cable<Dimension, Measure>::curvature(
    const Point& p, const Point& v) noexcept {
    const double square = detail::product(p, p), over = 1.0 / (square * std::sqrt(square));
    if constexpr (Dimension == 2)
        return Curvature(over * (p[0] * v[1] - p[1] * v[0]));
    else
        return over * cross(p, v);
}

/// The curvature of the reference: in space its parts along n and across it, n the resultant's
/// direction projected on the normal plane, are carried from the reference to the present state.
template <int Dimension, class Measure>
typename Cable<Dimension, Measure>::Curvature Cable<Dimension, Measure>::natural_curvature(
    const Coordinates& e, double xi) const noexcept {
    Curvature curved = Curvature::Zero();
    if (kernel_.natural.empty()) return curved;
    curved = curvature(reference_, xi);
    if constexpr (Dimension == 3) {
        const auto normal = [&](const Coordinates& at, const Point& t) -> Point {
            const Point n = detail::natural_resultant(kernel_.natural.front(), kernel_.bending,
                                                      detail::line_of<3>(at));
            return (n - detail::product(n, t) * t).normalized();
        };
        const Point t0 = tangent(reference_, xi), n0 = normal(reference_, t0);
        const Point t = tangent(e, xi), n = normal(e, t);
        curved =
            detail::product(curved, n0) * n + detail::product(curved, cross(t0, n0)) * cross(t, n);
    }
    return curved;
}

template <int Dimension, class Measure>
typename Cable<Dimension, Measure>::Curvature Cable<Dimension, Measure>::moment(
    const Coordinates& e, double xi) const noexcept {
    const Point p = along(station(xi).p, e);
    const double factor = bending_stiffness_ / std::sqrt(detail::product(p, p));
    return factor * (curvature(e, xi) - natural_curvature(e, xi));
}

template <int Dimension, class Measure>
SectionForces Cable<Dimension, Measure>::section_forces(const Coordinates& e,
                                                        double xi) const noexcept {
    const Point p = along(station(xi).p, e);
    const double square = detail::product(p, p), strain = Measure::strain(square);
    const auto axial = detail::axial_response(axial_stiffness_, kernel_.softening, strain);
    double n = 0.0, k = 0.0;
    Measure::resultants(axial.force, axial.stiffness, square, strain, n, k);
    const Curvature bent = moment(e, xi);
    SectionForces result;
    result.axial = n * std::sqrt(square) - bent.dot(curvature(e, xi));
    if constexpr (Dimension == 2) {
        result.moment_z = bent[0];
    } else {
        const auto frame = section_frame<double>(tangent(e, xi));
        result.moment_y = detail::product(bent, frame[1]);
        result.moment_z = detail::product(bent, frame[2]);
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
        const auto frame = section_frame<double>(tangent(e, xi));
        stress += young_ *
                  (z * detail::product(change, frame[1]) - y * detail::product(change, frame[2]));
    }
    return Vector<double, 1>(stress);
}

}  // namespace ancf
