// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The centre line of the stress-free state: a straight segment, or any Hermite curve.
///
/// An element's parameter x runs from 0 to its parameter length l; strains and integrals use the
/// arc length s of this line, ds = |r0'| dx. Derivatives by s follow from those by x:
///
///     dr/ds = r'/J,    d2r/ds2 = r''/J^2 - (J'/J^3) r',    J = |r0'|,  J' = r0'.r0''/J.
///
/// Derivation: docs/theory-references.md.

#pragma once

#include <ancf/element/hermite.hpp>
#include <ancf/element/mass.hpp>
#include <ancf/element/quadrature.hpp>
#include <ancf/element/station_data.hpp>
#include <ancf/section/moments.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

namespace ancf {

/// 1/sqrt(3), the stretch lam below which the axial force EA (lam^2 - 1) lam/2 of Green's measure
/// falls as lam does; that of engineering strains never does.
inline constexpr double softening_stretch = 0.57735026918962576;

/// The line through two nodes with given positions and slopes r_x; straight unless they say
/// otherwise.
/// @tparam Line  CubicLine or QuinticLine
template <int Dimension, class Line = CubicLine>
class ReferenceLine {
public:
    using Point = Vector<double, Dimension>;  ///< a vector of space

    ReferenceLine() = default;

    /// A straight line of the given length, m.
    explicit ReferenceLine(double length) : parameter_length_(length), length_(length) {}

    /// A curve over the parameter range [0, length].
    /// @param reference  coordinates of both nodes; r and r_x are the first of a node's vectors,
    ///                   r_xx of a quintic is the last
    template <int Dofs>
    ReferenceLine(double length, const Vector<double, Dofs>& reference)
        : parameter_length_(length), curved_(true), vectors_(line_vectors(reference)) {
        for (const QuadraturePoint& point : gauss_quadrature(integration_points))
            length_ += point.weight * parameter_length_ * metric(point.xi);
    }

    /// Tells whether it is a curve.
    [[nodiscard]] bool curved() const noexcept { return curved_; }

    /// Returns the arc length, m.
    [[nodiscard]] double length() const noexcept { return length_; }

    /// Returns the arc length from the first node to xi, m.
    [[nodiscard]] double length(double xi) const {
        if (!curved_) return xi * length_;
        double sum = 0.0;
        for (const QuadraturePoint& point : gauss_quadrature(integration_points))
            sum += xi * point.weight * parameter_length_ * metric(xi * point.xi);
        return sum;
    }

    /// Returns the range of the parameter x, m.
    [[nodiscard]] double parameter_length() const noexcept { return parameter_length_; }

    /// Returns J = ds/dx.
    [[nodiscard]] double metric(double xi) const noexcept {
        if (!curved_) return 1.0;
        const Point p = derivative(straight_shape<Line>(xi, parameter_length_).p, vectors_);
        return std::sqrt(detail::product(p, p));
    }

    /// Returns the least stretch |dr/ds| of the line with the given coordinates, at its ends and at
    /// six places between them.
    /// @param e  as of the constructor
    template <int Dofs>
    [[nodiscard]] double least_stretch(const Vector<double, Dofs>& e) const noexcept {
        const Vectors vectors = line_vectors(e);
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k <= detail::line_parts; ++k) {
            const auto at = shape(static_cast<double>(k) / detail::line_parts);
            const Point p = derivative(at.p, vectors);
            least = std::min(least, std::sqrt(detail::product(p, p)));
        }
        return least;
    }

    /// Returns the weights of a station for derivatives by the arc length.
    [[nodiscard]] StationShape<double, Line::vectors> shape(double xi) const noexcept {
        auto shape = straight_shape<Line>(xi, parameter_length_);
        if (!curved_) return shape;
        const Point p = derivative(shape.p, vectors_);
        const double J = std::sqrt(detail::product(p, p));
        const double growth = detail::product(p, derivative(shape.p1, vectors_)) / (J * J);  // J'/J
        for (int k = 0; k < Line::vectors; ++k) {
            shape.p1[k] = (shape.p1[k] - growth * shape.p[k]) / (J * J);
            shape.p[k] /= J;
        }
        shape.n2_x /= J;
        return shape;
    }

    /// Returns the point at xi of the line with the given coordinates, m.
    /// @param e  as of the constructor
    template <class S, int Dofs>
    [[nodiscard]] Vector<S, Dimension> point(const Vector<S, Dofs>& e, double xi) const noexcept {
        const auto weights = Line::value(xi, parameter_length_);
        Vector<S, Dimension> r;
        for (int k = 0; k < Dimension; ++k) {
            r[k] = e[k] + weights[0] * (e[Dofs / 2 + k] - e[k]);
            for (std::size_t x = 1; x < weights.size(); ++x)
                r[k] += weights[x] * e[start<Dofs>[x] + k];
        }
        return r;
    }

    /// Adds the derivative of point() by the coordinates of both nodes.
    template <int Dofs>
    void add_point_jacobian(double xi, Matrix<double, Dimension, Dofs>& jacobian) const noexcept {
        const auto weights = Line::value(xi, parameter_length_);
        for (int k = 0; k < Dimension; ++k) {
            jacobian(k, k) += 1.0 - weights[0];
            for (std::size_t x = 0; x < weights.size(); ++x)
                jacobian(k, start<Dofs>[x] + k) += weights[x];
        }
    }

    /// Returns the stations of a rule along the line; reference strains are zero.
    ///
    /// A rule that gives the axial term points of its own takes eps^2 there. Where eps couples with
    /// curvature, at the points of bending, the energy could then be negative; the strain of the
    /// centroid takes the place of eps.
    /// @param own_axial  stations of the axial term alone are kept apart: its strain is Green's
    [[nodiscard]] StationTable<double, Line::vectors> stations(const Rule& rule,
                                                               const SectionStiffness& section,
                                                               bool own_axial = true) const {
        StationTable<double, Line::vectors> table;
        const auto& C = section.axial;
        const bool by_centroid =
            C(0, 1) * C(0, 1) + C(0, 2) * C(0, 2) > 1e-18 * C(0, 0) * (C(1, 1) + C(2, 2));
        for (const RuleStation& station : rule.stations()) {
            const auto at = shape(station.xi);
            const double length = parameter_length_ * metric(station.xi);
            SectionMatrix<double> stiffness = station_stiffness(section, station, length);
            const double excess =
                station.weight(StrainGroup::axial) - station.weight(StrainGroup::bending);
            if (by_centroid && excess != 0.0) {
                for (int i = 0; i < 6; ++i)
                    for (int j = i == 0 ? 1 : 0; j < 6; ++j)
                        stiffness.axial[i][j] += excess * length * C(0, i) * C(0, j) / C(0, 0);
            }
            if (own_axial && station.axial_only() && !by_centroid) {
                AxialStationData<double, Line::vectors> axial;
                std::copy(std::begin(at.p), std::end(at.p), std::begin(axial.p));
                axial.reference = 0.0;
                axial.stiffness = stiffness.axial[0][0];
                table.axial.push_back(axial);
            } else {
                table.full.push_back({at, {}, stiffness});
            }
        }
        return table;
    }

    /// Returns the mass weights of an element on this line, see mass_weights().
    template <int FieldsPerNode, bool Rates = false>
    [[nodiscard]] auto mass(double density, const Moments& moments) const {
        const int points = curved_ ? integration_points : Line::vectors + 1;
        return mass_weights<FieldsPerNode, Line, Rates>(density, moments, parameter_length_, points,
                                                        [this](double xi) { return metric(xi); });
    }

    /// Returns the nodal force of a dead force per arc length, N/m.
    template <int FieldsPerNode, bool Rates = false>
    [[nodiscard]] auto line_load(const Point& force) const {
        Moments line;  // a section of unit area on the axis alone
        line.area = 1.0;
        return gravity_force<Dimension>(mass<FieldsPerNode, Rates>(1.0, line), force);
    }

private:
    static constexpr int integration_points = 10;  // round-off for arcs of a radian

    /// (D, g_i, g_j), of a quintic then (k_i, k_j).
    using Vectors = std::array<Point, Line::vectors>;

    /// Where their coordinates start; those of D are those of r_j less those of r_i.
    template <int Dofs>
    static constexpr int start[] = {Dofs / 2, Dimension, Dofs / 2 + Dimension, Dofs / 2 - Dimension,
                                    Dofs - Dimension};

    template <int Dofs>
    [[nodiscard]] static Vectors line_vectors(const Vector<double, Dofs>& e) noexcept {
        Vectors vectors;
        for (std::size_t x = 0; x < vectors.size(); ++x)
            vectors[x] = e.template segment<Dimension>(start<Dofs>[x]);
        vectors[0] -= e.template head<Dimension>();
        return vectors;
    }

    [[nodiscard]] static Point derivative(const double (&weights)[Line::vectors],
                                          const Vectors& vectors) noexcept {
        Point sum = Point::Zero();
        for (std::size_t k = 0; k < vectors.size(); ++k) sum += weights[k] * vectors[k];
        return sum;
    }

    double parameter_length_ = 0.0;
    double length_ = 0.0;
    bool curved_ = false;
    Vectors vectors_;  // of a curve
};

}  // namespace ancf
