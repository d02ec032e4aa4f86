// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Cable: construction, energy, force and tangent. Include <ancf/element/cable/cable.hpp>.

#pragma once

#include <ancf/element/cable/cable.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ancf {

namespace detail {

/// Returns EI of a section that a line of centroids may have; in space it must be the same about
/// every axis.
/// @throws InvalidArgument else.
template <int Dimension>
[[nodiscard]] double line_bending_stiffness(const Material& material, const Section& section) {
    material.validate();
    const Moments& m = section.moments();
    const double radius = std::sqrt(m.polar() / m.area);
    const double offset = (Dimension == 3 ? std::hypot(m.y, m.z) : std::abs(m.y)) / m.area;
    require(offset <= 1e-9 * radius,
            "a cable runs through the centroid of its section, got one at a distance of ", offset,
            " m");
    if constexpr (Dimension == 2) return material.young * m.yy;
    const double most = 1e-6 * m.polar();
    require(std::abs(m.yy - m.zz) <= most && std::abs(m.yz) <= most,
            "a cable in space has no directors and needs a section that bends equally in all "
            "directions, got int y^2 dA ",
            m.yy, ", int z^2 dA ", m.zz, " and int y z dA ", m.yz, " m^4");
    return 0.5 * material.young * m.polar();
}

/// Returns the unit vector normal to two tangents; where they are parallel, that along `kappa`.
[[nodiscard]] inline Vector<double, 3> common_normal(const Vector<double, 3>& first,
                                                     const Vector<double, 3>& second,
                                                     const Vector<double, 3>& kappa) {
    constexpr double nearly_parallel = 1e-8;  // so that the product keeps half of its digits
    const Vector<double, 3> n = cross(first, second);
    if (n.norm() > nearly_parallel) return n.normalized();
    const Vector<double, 3> t = (first + second).normalized();
    return (kappa - kappa.dot(t) * t).normalized();
}

}  // namespace detail

template <int Dimension, class Measure>
Cable<Dimension, Measure>::Cable(const Material& material, const Section& section, double length,
                                 const CableOptions& options)
    : Cable(material, section,
            ReferenceLine<Dimension>((detail::require_positive("length", length), length)),
            straight(length), options) {}

template <int Dimension, class Measure>
Cable<Dimension, Measure>::Cable(const Material& material, const Section& section,
                                 const Coordinates& reference, double length,
                                 const CableOptions& options)
    : Cable(
          material, section,
          ReferenceLine<Dimension>((detail::require_positive("length", length), length), reference),
          reference, options) {}

template <int Dimension, class Measure>
Cable<Dimension, Measure>::Cable(const Material& material, const Section& section,
                                 const ReferenceLine<Dimension>& line, const Coordinates& reference,
                                 const CableOptions& options)
    : line_(line),
      reference_(reference),
      options_(options),
      young_(material.young),
      axial_stiffness_(material.young * section.moments().area),
      bending_stiffness_(detail::line_bending_stiffness<Dimension>(material, section)),
      mass_weights_(line.template mass<2>(material.density, section.mass_moments())) {
    detail::require(options.compression >= 0.0 && options.compression <= 1.0,
                    "compression must lie in [0, 1], got ", options.compression);
    detail::require(detail::all_finite(reference),
                    "the reference coordinates of a cable must be finite, got ",
                    detail::components(reference));
    detail::require_points(options.rule, StrainGroup::axial, "axial", 3);
    detail::require_points(options.rule, StrainGroup::bending, "bending", 2);
    set_stations();
    detail::require(admissible(reference),
                    "the reference coordinates of a cable must have slopes r_x of about 1, got ",
                    detail::components(reference));
    set_natural();
}

template <int Dimension, class Measure>
typename Cable<Dimension, Measure>::Coordinates Cable<Dimension, Measure>::straight(double length) {
    Coordinates e = Coordinates::Zero();
    e[2 * Dimension] = length;
    e[Dimension] = e[3 * Dimension] = 1.0;
    return e;
}

/// The weights of r' and r'' per arc length s of the reference; `stiffness` is ds/dxi.
template <int Dimension, class Measure>
typename Cable<Dimension, Measure>::Station Cable<Dimension, Measure>::station(
    double xi) const noexcept {
    const StationShape<double> shape = line_.shape(xi);
    return {{{shape.p[0], shape.p[1], shape.p[2]}},
            {{shape.p1[0], shape.p1[1], shape.p1[2]}},
            line_.metric(xi) * line_.parameter_length()};
}

template <int Dimension, class Measure>
void Cable<Dimension, Measure>::set_stations() {
    for (const RuleStation& place : options_.rule.stations()) {
        const double axial = place.weight(StrainGroup::axial);
        const double bending = place.weight(StrainGroup::bending);
        Station here = station(place.xi);
        const double arc = here.stiffness;
        detail::require(std::isfinite(arc) && arc > 1e-6 * line_.parameter_length(),
                        "the reference coordinates of a cable must be a line of slope r_x about 1, "
                        "got |r_x| = ",
                        arc / line_.parameter_length(), " at xi = ", place.xi);
        if (axial != 0.0) axial_.push_back({here.p, axial_stiffness_ * axial * arc});
        here.stiffness = bending_stiffness_ * bending * arc;
        if (bending != 0.0) bending_.push_back(here);
    }
}

template <int Dimension, class Measure>
void Cable<Dimension, Measure>::set_natural() {
    const std::size_t count = bending_.size();
    if constexpr (Dimension == 3) {
        for (std::size_t k = 0; 2 * k < count; ++k) add_pair(k, count - 1 - k);
    } else {
        for (std::size_t k = 0; k < count; ++k) add_pair(k, k);
    }
}

/// Lets the natural curvatures of two stations (or of one, first = second) turn together.
template <int Dimension, class Measure>
void Cable<Dimension, Measure>::add_pair(std::size_t first, std::size_t second) {
    // kappa0 l below this is the round-off of a straight reference; in space, where the spin of a
    // curved line costs nothing, that of coordinates from a table
    constexpr double straight = Dimension == 2 ? 1e-13 : detail::straight_curvature;
    const auto line = detail::line_of<Dimension>(reference_);
    detail::NaturalCurvature natural{first == second ? 1 : 2, {first, second}, {}, {}, 0.0};
    Point tangent[2];
    Curvature kappa[2];
    for (int g = 0; g < 2; ++g) {
        const Station& at = bending_[natural.station[g]];
        tangent[g] = detail::interpolated<Dimension>(at.p, line);
        kappa[g] = curvature(tangent[g], detail::interpolated<Dimension>(at.v, line));
    }
    const Curvature larger = kappa[kappa[0].norm() >= kappa[1].norm() ? 0 : 1];
    if (!(larger.norm() * line_.parameter_length() > straight)) return;
    for (int g = 0; g < natural.count; ++g) {
        const double stiffness = bending_[natural.station[g]].stiffness;
        natural_energy_ += 0.5 * stiffness * kappa[g].squaredNorm();
        if constexpr (Dimension == 2) {
            natural.along[g] = stiffness * kappa[g][0];
        } else {
            const Point n = detail::common_normal(tangent[0], tangent[1], larger);
            natural.along[g] = stiffness * kappa[g].dot(n);
            natural.across[g] = stiffness * kappa[g].dot(cross(n, tangent[g]));
            natural.floor += 1e-8 * stiffness * kappa[g].squaredNorm();
        }
    }
    natural_.push_back(natural);
}

template <int Dimension, class Measure>
template <class Scalar>
detail::LineGradient<Scalar, Dimension> Cable<Dimension, Measure>::gradient(
    const detail::LineVector<Scalar, Dimension>& line) const noexcept {
    detail::LineHessian<Scalar, Dimension>* const none = nullptr;
    const double softening = 1.0 - options_.compression;
    Gradient<Scalar> sum;
    for (const auto& at : axial_)
        detail::add_axial<false, Measure, Dimension>(at, softening, line, sum, none);
    if constexpr (detail::is_rate<Scalar>) {
        if constexpr (Dimension == 2) {
            for (const auto& at : bending_) detail::add_curvature_rate(at, line, sum);
        } else {
            const double floor = detail::straight_curvature / line_.length();
            for (const auto& at : bending_) detail::add_curvature_rate(at, floor, line, sum);
        }
    } else {
        for (const auto& at : bending_) detail::add_bending<false, Dimension>(at, line, sum, none);
        for (const auto& at : natural_) detail::add_natural<false>(at, bending_, line, sum, none);
    }
    return sum;
}

template <int Dimension, class Measure>
template <class Scalar>
Scalar Cable<Dimension, Measure>::energy(const Vector<Scalar, dofs>& e) const noexcept {
    return gradient<Scalar>(detail::line_of<Dimension>(e)).energy + natural_energy_;
}

template <int Dimension, class Measure>
template <class Scalar>
Vector<Scalar, Cable<Dimension, Measure>::dofs> Cable<Dimension, Measure>::force(
    const Vector<Scalar, dofs>& e) const noexcept {
    return detail::nodal_force<Dimension>(gradient<Scalar>(detail::line_of<Dimension>(e)).vector);
}

template <int Dimension, class Measure>
template <class Scalar>
detail::LineGradient<Scalar, Dimension> Cable<Dimension, Measure>::gradient(
    const detail::LineVector<Scalar, Dimension>& line,
    detail::LineHessian<Scalar, Dimension>& hessian) const noexcept {
    const double softening = 1.0 - options_.compression;
    Gradient<Scalar> sum;
    for (const auto& at : axial_)
        detail::add_axial<true, Measure, Dimension>(at, softening, line, sum, &hessian);
    for (const auto& at : bending_) detail::add_bending<true, Dimension>(at, line, sum, &hessian);
    for (const auto& at : natural_) detail::add_natural<true>(at, bending_, line, sum, &hessian);
    return sum;
}

template <int Dimension, class Measure>
template <class Scalar>
Evaluation<Scalar, Cable<Dimension, Measure>::dofs> Cable<Dimension, Measure>::evaluate(
    const Vector<Scalar, dofs>& e) const noexcept {
    detail::LineHessian<Scalar, Dimension> hessian;
    const Gradient<Scalar> sum = gradient(detail::line_of<Dimension>(e), hessian);
    Evaluation<Scalar, dofs> result;
    result.energy = sum.energy + natural_energy_;
    result.force = detail::nodal_force<Dimension>(sum.vector);
    detail::write_tangent<Dimension>(hessian, result.tangent);
    return result;
}

template <int Dimension, class Measure>
template <class Scalar>
MixedEvaluation<Scalar, Cable<Dimension, Measure>::dofs> Cable<Dimension, Measure>::evaluate(
    const Vector<Scalar, dofs>& e, const Vector<Scalar, dofs>& before,
    const Vector<Scalar, dofs>& change) const noexcept {
    const auto line = detail::line_of<Dimension>(e);
    const detail::EarlierLine<Scalar, Dimension> earlier{detail::line_of<Dimension>(before),
                                                         detail::line_of<Dimension>(change)};
    detail::LineHessian<Scalar, Dimension> hessian;
    const Gradient<Scalar> sum = gradient(line, hessian);
    Gradient<Scalar> gain;
    for (const auto& at : axial_)
        detail::foresee_axial<Measure, Dimension>(at, 1.0 - options_.compression, line, earlier,
                                                  gain, hessian);
    for (const auto& at : bending_)
        detail::foresee_bending<Dimension>(at, line, earlier, gain, hessian);
    MixedEvaluation<Scalar, dofs> result;
    result.energy = sum.energy + natural_energy_;
    result.force = detail::nodal_force<Dimension>(sum.vector);
    result.predicted = result.force + detail::nodal_force<Dimension>(gain.vector);
    detail::write_tangent<Dimension>(hessian, result.tangent);
    return result;
}

}  // namespace ancf
