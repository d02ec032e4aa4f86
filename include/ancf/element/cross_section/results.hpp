// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Results of a cross-section beam at a place: strains, stresses, section forces, positions,
/// directors.
///
/// Included by beam.hpp; written for clarity, not for speed.

#pragma once

#include <ancf/element/cross_section/beam.hpp>

namespace ancf {

template <int Dimension, class Directors, class Shear, class Measure, class Line>
template <class S>
struct CrossSectionBeam<Dimension, Directors, Shear, Measure, Line>::Place {
    StationShape<double, Line::vectors> shape;
    detail::NodalVectors<S, Line::vectors> vectors;
    detail::Vec3<S> p;  ///< r0'
    typename Formulation::template Nodes<S> nodes;
    typename Formulation::template State<S> state;
    detail::Vec3<S> t, n, c;  ///< frame of the y director

    /// Returns the normal part of a director, 0 for y and 1 for z: n, or n turned by phi.
    [[nodiscard]] detail::Vec3<S> normal(int director) const noexcept {
        return director == 0 ? n : state.w.C * n + state.w.S_ * c;
    }
    /// Returns t x normal(director).
    [[nodiscard]] detail::Vec3<S> binormal(int director) const noexcept {
        return director == 0 ? c : state.w.C * c - state.w.S_ * n;
    }
    [[nodiscard]] S shear(int director) const noexcept {
        return director == 0 ? state.w.s : state.w.q;
    }

    /// Returns the factor of the normal: 1, or what makes the director a unit vector.
    [[nodiscard]] S cosine(int director) const noexcept {
        using std::sqrt;
        return Measure::engineering ? S(sqrt(S(1.0 - shear(director) * shear(director)))) : S(1.0);
    }

    /// Returns d = n + s t, or D = cos n + s t of the engineering measure.
    [[nodiscard]] detail::Vec3<S> director(int director) const noexcept {
        return cosine(director) * normal(director) + shear(director) * t;
    }

    /// Returns d' = (s' - kap) t + s kap n + (om + s chi) c.
    [[nodiscard]] detail::Vec3<S> director_rate(int director) const noexcept {
        const detail::Invariants<S>& w = state.w;
        const S s = shear(director);
        const S s1 = director == 0 ? w.s1 : w.q1, kap = director == 0 ? w.kap : w.kap2;
        const S chi = director == 0 ? w.chi : w.chi2, om = director == 0 ? w.om : w.om2;
        return S(s1 - kap) * t + S(s * kap) * normal(director) +
               S(om + s * chi) * binormal(director);
    }
};

namespace detail {

/// Adds factor times a form of nodal vector x.
template <int Dofs>
inline void add_form(Eigen::Matrix<double, 1, Dofs>& row, int x, double factor,
                     const Vec3<double>& form) noexcept {
    row.template segment<3>(coordinate_start<Dofs>(x)) += factor * to_vector(form).transpose();
}

}  // namespace detail

template <int Dimension, class Directors, class Shear, class Measure, class Line>
template <class S>
auto CrossSectionBeam<Dimension, Directors, Shear, Measure, Line>::place(
    const Vector<S, dofs>& e, double xi, double shear_weight) const noexcept -> Place<S> {
    using namespace detail;
    Place<S> at;
    StationData<double, Line::vectors> station{};
    at.shape = line_.shape(xi);
    at.shape.n2_s = shear_weight;
    station.shape = at.shape;
    nodal_vectors(e, at.vectors);
    at.p = line_derivative(at.shape.p, at.vectors);
    typename Formulation::template Lanes<S> lanes{};
    Formulation::prepare(at.vectors, at.nodes, lanes);
    (void)Formulation::state(station, at.vectors, lanes, at.state);
    if constexpr (carries_directors<Directors>) {
        at.t = at.state.frame.t, at.n = at.state.frame.n, at.c = at.state.frame.c;
    } else {
        at.t = at.state.frames.y.t, at.n = at.state.frames.y.n, at.c = at.state.frames.y.c;
    }
    return at;
}

template <int Dimension, class Directors, class Shear, class Measure, class Line>
template <class S>
auto CrossSectionBeam<Dimension, Directors, Shear, Measure, Line>::strains(const Vector<S, dofs>& e,
                                                                           double xi) const noexcept
    -> Vector<S, 12> {
    return this->beyond_reference(e, [&](const auto& state) {
        const auto at = place(state, xi, shear_weight(xi));
        using Strains = Vector<typename std::decay_t<decltype(state)>::Scalar, 12>;
        return Strains(Eigen::Map<const Strains>(at.state.strain));
    });
}

template <int Dimension, class Directors, class Shear, class Measure, class Line>
template <class S>
auto CrossSectionBeam<Dimension, Directors, Shear, Measure, Line>::transverse_strains(
    const Vector<S, dofs>& e, double xi) const noexcept -> Vector<S, 3> {
    using namespace detail;
    return this->beyond_reference(e, [&](const auto& state) {
        using T = typename std::decay_t<decltype(state)>::Scalar;
        NodalVectors<T, Line::vectors> nodes;
        nodal_vectors(state, nodes);
        Vector<T, 3> strain = Vector<T, 3>::Zero();
        for (int node = 0; node < 2; ++node) {
            const double weight = node == 0 ? 1.0 - xi : xi;
            const Vec3<T>&a = nodes[n_a1 + node], &b = nodes[n_b1 + node];
            strain[0] += weight * stretch_strain(options_.transverse, a).value;
            strain[1] += weight * stretch_strain(options_.transverse, b).value;
            strain[2] += weight * dot(a, b);
        }
        return strain;
    });
}

template <int Dimension, class Directors, class Shear, class Measure, class Line>
Vector<double, 6> CrossSectionBeam<Dimension, Directors, Shear, Measure, Line>::green_strain(
    const Coordinates& e, double xi, double y, double z) const noexcept {
    const Vector<double, 12> s = strains(e, xi);
    const Vector<double, 3> transverse = transverse_strains(e, xi);
    Vector<double, 6> strain;
    strain << s[0] + y * s[1] + z * s[2] + y * y * s[3] + y * z * s[4] + z * z * s[5], transverse,
        s[9] + y * s[10] + z * s[11], s[6] + y * s[7] + z * s[8];
    return strain;
}

template <int Dimension, class Directors, class Shear, class Measure, class Line>
SectionForces CrossSectionBeam<Dimension, Directors, Shear, Measure, Line>::section_forces(
    const Coordinates& e, double xi) const noexcept {
    using namespace detail;
    const Place<double> at = place(e, xi);
    const Vector<double, 12> s = strains(e, xi);
    Vector<double, 12> f;
    f << section_.axial * s.head<6>(), section_.shear_y * s.segment<3>(6),
        section_.shear_z * s.tail<3>();

    const Vec3<double> d = at.director(0), h = at.director(1);
    // the engineering measure has the section's normal for r0', and no terms of second order
    const Vec3<double> p = Measure::engineering ? cross(d, h) : at.p;
    const Vec3<double> d1 = Measure::engineering ? Vec3<double>{} : at.director_rate(0),
                       h1 = Measure::engineering ? Vec3<double>{} : at.director_rate(1);
    const Vec3<double> force = f[0] * p + f[1] * d1 + f[2] * h1 + f[6] * d + f[9] * h;
    const Vec3<double> moment = cross(d, f[1] * p + f[3] * d1 + f[4] * h1 + f[10] * h) +
                                cross(h, f[2] * p + f[4] * d1 + f[5] * h1 + f[8] * d);
    // n as near to the y director as c = t x n is to the z director
    const Vec3<double>& t = at.t;
    const Vec3<double> middle = at.n + cross(at.normal(1), t);
    const Vec3<double> n = (1.0 / std::sqrt(dot(middle, middle))) * middle;
    const Vec3<double> c = cross(t, n);
    return {dot(force, t),  dot(force, n),  dot(force, c),
            dot(moment, t), dot(moment, n), dot(moment, c)};
}

template <int Dimension, class Directors, class Shear, class Measure, class Line>
auto CrossSectionBeam<Dimension, Directors, Shear, Measure, Line>::spin_row(
    const Place<double>& at, int director) const noexcept -> Row {
    using namespace detail;
    Row row = Row::Zero();
    const int a1 = n_a1 + 2 * director;
    Vec3<double> by_p{};  // of the tangent vector p
    if constexpr (carries_directors<Directors>) {
        // a mean of the carried nodes' spins: what the node turns, and what the way to the place
        // adds
        const double second = director == 0 ? shares(at.state.frame).y : shares(at.state.frame).z;
        const double share[2] = {1.0 - second, second};
        for (int node = 0; node < 2; ++node) {
            const auto& spin = at.nodes.spins[2 * director + node];
            const auto& way = at.state.frame.from[node];
            add_form(row, a1 + node, share[node], spin.da);
            add_form(row, n_g1 + node, share[node], spin.dg + way.sg);
            by_p = by_p + share[node] * way.sp;
        }
    } else {
        const DirectorFrame<double>& f = director == 0 ? at.state.frames.y : at.state.frames.z;
        const double share[2] = {1.0 - at.shape.n2, at.shape.n2};
        for (int node = 0; node < 2; ++node) add_form(row, a1 + node, share[node] * f.inv_nu, f.c);
        by_p = (-f.al * f.inv_lam) * f.c;
    }
    for (int x = 0; x < Line::vectors; ++x) add_form(row, line_vector(x), at.shape.p[x], by_p);
    row.template head<3>() = -at.shape.p[0] * to_vector(by_p).transpose();
    return row;
}

template <int Dimension, class Directors, class Shear, class Measure, class Line>
auto CrossSectionBeam<Dimension, Directors, Shear, Measure, Line>::shear_row(
    const Place<double>& at, int director) const noexcept -> Row {
    using namespace detail;
    Row row = Row::Zero();
    const int a1 = n_a1 + 2 * director;
    const double share[2] = {1.0 - at.shape.n2, at.shape.n2};
    if constexpr (Shear::nodal) {
        for (int node = 0; node < 2; ++node) {
            const NodalSine<double>& sine = at.nodes.sines[2 * director + node];
            add_form(row, a1 + node, share[node], sine.da);
            add_form(row, n_g1 + node, share[node], sine.dg);
        }
    } else {
        const Vec3<double> slope = share[0] * at.vectors[a1] + share[1] * at.vectors[a1 + 1];
        const NodalSine<double> sine = nodal_sine(slope, at.p);
        for (int node = 0; node < 2; ++node) add_form(row, a1 + node, share[node], sine.da);
        for (int x = 0; x < 3; ++x) add_form(row, n_D + x, at.shape.p[x], sine.dg);
        row.template head<3>() = -at.shape.p[0] * to_vector(sine.dg).transpose();
    }
    return row;
}

template <int Dimension, class Directors, class Shear, class Measure, class Line>
auto CrossSectionBeam<Dimension, Directors, Shear, Measure, Line>::director_jacobian(
    const Place<double>& at, int director) const noexcept -> Matrix<double, 3, dofs> {
    using namespace detail;
    // dt = (n u_n + c u_c), dn = th c - u_n t with u = R^T dp/lam and the spin th
    const double s = at.shear(director), cosine = at.cosine(director);
    const double inv_lam = 1.0 / at.state.w.lam;
    const Vector<double, 3> t = to_vector(at.t), n = to_vector(at.normal(director)),
                            c = to_vector(at.binormal(director));
    const Matrix<double, 3> by_p =
        inv_lam * ((s * n - cosine * t) * n.transpose() + s * c * c.transpose());
    const Vector<double, 3> by_shear = Measure::engineering ? t - s / cosine * n : t;
    Matrix<double, 3, dofs> jacobian =
        cosine * c * spin_row(at, director) + by_shear * shear_row(at, director);
    for (int x = 0; x < Line::vectors; ++x)
        jacobian.template middleCols<3>(coordinate_start<dofs>(line_vector(x))) +=
            at.shape.p[x] * by_p;
    jacobian.template leftCols<3>() -= at.shape.p[0] * by_p;
    return jacobian;
}

template <int Dimension, class Directors, class Shear, class Measure, class Line>
template <class S>
auto CrossSectionBeam<Dimension, Directors, Shear, Measure, Line>::position(
    const Vector<S, dofs>& e, double xi, double y, double z) const noexcept -> Vector<S, 3> {
    Vector<S, 3> r = line_.point(e, xi);
    if (y != 0.0 || z != 0.0) {
        const Matrix<S, 3, 2> d = directors(e, xi);
        r += y * d.col(0) + z * d.col(1);
    }
    return r;
}

template <int Dimension, class Directors, class Shear, class Measure, class Line>
auto CrossSectionBeam<Dimension, Directors, Shear, Measure, Line>::position_jacobian(
    const Coordinates& e, double xi, double y, double z) const noexcept -> Matrix<double, 3, dofs> {
    Matrix<double, 3, dofs> jacobian = Matrix<double, 3, dofs>::Zero();
    if (y != 0.0 || z != 0.0) {
        const Place<double> at = place(e, xi);
        jacobian = y * director_jacobian(at, 0) + z * director_jacobian(at, 1);
    }
    line_.add_point_jacobian(xi, jacobian);
    return jacobian;
}

}  // namespace ancf
