// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// ContinuumBeam: kinematics, strain, stress and section forces.
///
/// Part of <ancf/element/continuum/beam.hpp>, which is the header to include.

#pragma once

#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/line_element.hpp>

namespace ancf {

namespace detail::continuum {

/// Returns [e_xx, e_yy, e_zz, 2e_yz, 2e_xz, 2e_xy] (in the plane [e_xx, e_yy, 2e_xy]) at a point.
template <int Dimension>
[[nodiscard]] inline Vector<double, Dimension == 3 ? 6 : 3> strain_at(
    const Strain<double, Dimension>& s, double y, double z) noexcept {
    if constexpr (Dimension == 3) {
        const Vector<double, 3> phi(1.0, y, z);
        const Vector<double, 2> shear = s.shear.transpose() * phi;
        Vector<double, 6> strain;
        strain << s.axial(0) + y * (s.axial(1) + y * s.axial(3) + z * s.axial(4)) +
                      z * (s.axial(2) + z * s.axial(5)),
            s.normal(0), s.normal(1), s.transverse, shear(1), shear(0);
        return strain;
    } else {
        return {s.axial(0) + y * (s.axial(1) + y * s.axial(2)), s.normal(0),
                s.shear(0, 0) + y * s.shear(1, 0)};
    }
}

/// Returns the stress of a strain, both in the order of strain_at().
template <int Components>
[[nodiscard]] inline Vector<double, Components> stress_of(
    const PointStiffness& stiffness, const Vector<double, Components>& strain) noexcept {
    constexpr int normals = Components == 6 ? 3 : 2;
    Vector<double, Components> stress;
    stress.template head<normals>() =
        (stiffness.normal - stiffness.coupling) * strain.template head<normals>();
    stress.template head<normals>().array() +=
        stiffness.coupling * strain.template head<normals>().sum();
    if constexpr (Components == 6) {
        stress(3) = stiffness.transverse_shear * strain(3);
        stress(4) = stiffness.shear[1] * strain(4);
    }
    stress(Components - 1) = stiffness.shear[0] * strain(Components - 1);
    return stress;
}

}  // namespace detail::continuum

template <int Dimension>
typename ContinuumBeam<Dimension>::Strain ContinuumBeam<Dimension>::strain_at(
    const Coordinates& e, double xi) const noexcept {
    Strain strain = detail::continuum::strain_coefficients(vectors_at(e, xi));
    if (line_.curved()) {
        const Strain rest = detail::continuum::strain_coefficients(vectors_at(reference_, xi));
        strain.axial -= rest.axial;
        strain.shear -= rest.shear;
        strain.normal -= rest.normal;
        strain.transverse -= rest.transverse;
    } else {
        strain.axial(0) -= 0.5;
        strain.normal.array() -= 0.5;
    }
    return strain;
}

template <int Dimension>
typename ContinuumBeam<Dimension>::Jacobian ContinuumBeam<Dimension>::position_jacobian(
    const Coordinates& /*e*/, double xi, double y, double z) const noexcept {
    const double place[2] = {y, z};
    Jacobian jacobian = Jacobian::Zero();
    line_.add_point_jacobian(xi, jacobian);
    for (int c = 0; c < slopes; ++c)
        for (int k = 0; k < Dimension; ++k) {
            const int slope = Dimension * (2 + c) + k;
            jacobian(k, slope) = (1.0 - xi) * place[c];
            jacobian(k, node_dofs + slope) = xi * place[c];
        }
    return jacobian;
}

template <int Dimension>
Vector<double, ContinuumBeam<Dimension>::strains> ContinuumBeam<Dimension>::green_strain(
    const Coordinates& e, double xi, double y, double z) const noexcept {
    return detail::continuum::strain_at<Dimension>(strain_at(e, xi), y, z);
}

template <int Dimension>
Vector<double, ContinuumBeam<Dimension>::strains> ContinuumBeam<Dimension>::stress(
    const Coordinates& e, double xi, double y, double z) const noexcept {
    const auto coefficients = strain_at(e, xi);
    return detail::continuum::stress_of<strains>(
               point_, detail::continuum::strain_at<Dimension>(coefficients, y, z)) +
           detail::continuum::stress_of<strains>(
               axis_,
               detail::continuum::strain_at<Dimension>(coefficients, centroid_y_, centroid_z_));
}

template <int Dimension>
SectionForces ContinuumBeam<Dimension>::section_forces(const Coordinates& e,
                                                       double xi) const noexcept {
    const Vectors v = vectors_at(e, xi);
    const Vectors force =
        detail::continuum::local_force(detail::continuum::resultants(law_, strain_at(e, xi)), v);
    const Point resultant = force.col(0);
    const Point t = v.col(0).normalized();
    if constexpr (Dimension == 3) {
        const Point a = v.col(3), b = v.col(4);
        const Point n_y = (a - t.dot(a) * t).normalized();
        const Point n_z = (b - t.dot(b) * t).normalized();
        const Point n = (n_y + cross(n_z, t)).normalized();
        const Point c = cross(t, n);
        const Point moment = cross(a, Point(force.col(1))) + cross(b, Point(force.col(2)));
        return {resultant.dot(t), resultant.dot(n), resultant.dot(c),
                moment.dot(t),    moment.dot(n),    moment.dot(c)};
    } else {
        const Point a = v.col(2), couple = force.col(1);
        const double moment = a(0) * couple(1) - a(1) * couple(0);
        return {resultant.dot(t), resultant.dot(Point(-t(1), t(0))), 0.0, 0.0, 0.0, moment};
    }
}

}  // namespace ancf
