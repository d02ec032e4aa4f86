// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The outer surface of deformed beams: polygons, with section results at their corners.
///
/// Each element is sampled at its own stations, so that results may jump from one element to the
/// next; a beam's two ends are closed by its outline. Polygons are counter-clockwise seen from
/// outside.

#pragma once

#include <ancf/element/section_forces.hpp>
#include <ancf/element/transmitted_forces.hpp>
#include <ancf/error.hpp>
#include <ancf/model/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/output/shape.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ancf {

/// Values at every point of a surface.
struct PointArray {
    std::string name;                     ///< the array's name in a file
    std::vector<std::string> components;  ///< their names; one entry for a scalar
    std::vector<double> values;           ///< point by point
};

/// A mesh of polygons. An array whose results an element does not offer is zero there.
class Surface {
public:
    /// The arrays, in this order.
    enum Array : std::size_t {
        place,         ///< reference length from the beam's start, m
        velocity,      ///< m/s
        force,         ///< N, Q_y, Q_z of transmitted_forces, N
        moment,        ///< T, M_y, M_z of transmitted_forces, N m
        axial_stress,  ///< second Piola-Kirchhoff stress S_xx at the point, Pa
        array_count
    };

    Surface();

    /// Adds a beam as its model stands now.
    /// @param section   whose outline is drawn.
    /// @param stations  per element, at least 2.
    /// @throws InvalidArgument for fewer stations, an outline of fewer than three corners, or a
    ///         beam without elements.
    template <class Element, class... Elements>
    void add(const Model<Elements...>& model, const Beam<Element>& beam, const Section& section,
             int stations = 9);

    /// Returns the points, m.
    [[nodiscard]] const std::vector<Vector<double, 3>>& points() const noexcept { return points_; }
    /// Returns the values at the points.
    [[nodiscard]] const std::array<PointArray, array_count>& arrays() const noexcept {
        return arrays_;
    }

    /// Returns the corners of all polygons, one after the other, as indices of points.
    [[nodiscard]] const std::vector<int>& corners() const noexcept { return corners_; }

    /// Returns where each polygon ends in corners().
    [[nodiscard]] const std::vector<int>& ends() const noexcept { return ends_; }

private:
    template <class Element>
    void add_points(const BeamStation<Element>& station, const Section& section);
    void add_polygon(const std::vector<int>& corners);
    void add_side(int first, int corner_count);
    void append(Array array, const Vector<double, 3>& value);

    std::vector<Vector<double, 3>> points_;
    std::array<PointArray, array_count> arrays_;
    std::vector<int> corners_;
    std::vector<int> ends_;
};

namespace detail {

template <class Element, class = void>
struct HasVelocity : std::false_type {};

template <class Element>
struct HasVelocity<Element,
                   std::void_t<decltype(std::declval<const Element&>().velocity(
                       std::declval<const typename Element::Coordinates&>(),
                       std::declval<const typename Element::Coordinates&>(), 0.0, 0.0, 0.0))>>
    : std::true_type {};

template <class Element, class = void>
struct HasStress : std::false_type {};

template <class Element>
struct HasStress<Element,
                 std::void_t<decltype(std::declval<const Element&>().stress(
                     std::declval<const typename Element::Coordinates&>(), 0.0, 0.0, 0.0))>>
    : std::true_type {};

}  // namespace detail

inline Surface::Surface() {
    arrays_[place] = {"place", {"s"}, {}};
    arrays_[velocity] = {"velocity", {"x", "y", "z"}, {}};
    arrays_[force] = {"section_force", {"N", "Q_y", "Q_z"}, {}};
    arrays_[moment] = {"section_moment", {"T", "M_y", "M_z"}, {}};
    arrays_[axial_stress] = {"axial_stress", {"S_xx"}, {}};
}

template <class Element, class... Elements>
void Surface::add(const Model<Elements...>& model, const Beam<Element>& beam,
                  const Section& section, int stations) {
    const int count = static_cast<int>(section.outline().size());
    detail::require(count >= 3, "Surface::add: an outline needs at least 3 corners, got ", count);
    detail::require(!beam.elements.empty(), "Surface::add: the beam has no elements");
    const int first = static_cast<int>(points_.size());
    for_each_station(model, beam, stations, [&](const BeamStation<Element>& station) {
        add_points(station, section);
        if (station.xi > 0.0) add_side(static_cast<int>(points_.size()) - 2 * count, count);
    });
    const int last = static_cast<int>(points_.size()) - count;
    std::vector<int> start;
    std::vector<int> end;
    for (int k = 0; k < count; ++k) {
        start.push_back(first + count - 1 - k);
        end.push_back(last + k);
    }
    add_polygon(start);
    add_polygon(end);
}

template <class Element>
void Surface::add_points(const BeamStation<Element>& station, const Section& section) {
    const SectionForces forces = transmitted_forces(station.element, station.e, station.xi);
    for (const SectionPoint& corner : section.outline()) {
        points_.push_back(station.position(corner.y, corner.z));
        append(place, {station.s, 0.0, 0.0});
        Vector<double, 3> speed = Vector<double, 3>::Zero();
        if constexpr (detail::HasVelocity<Element>::value)
            speed.head<Element::dimension>() =
                station.element.velocity(station.e, station.rate, station.xi, corner.y, corner.z);
        append(velocity, speed);
        append(force, {forces.axial, forces.shear_y, forces.shear_z});
        append(moment, {forces.torque, forces.moment_y, forces.moment_z});
        double stress = 0.0;
        if constexpr (detail::HasStress<Element>::value)
            stress = station.element.stress(station.e, station.xi, corner.y, corner.z)[0];
        append(axial_stress, {stress, 0.0, 0.0});
    }
}

inline void Surface::add_polygon(const std::vector<int>& corners) {
    corners_.insert(corners_.end(), corners.begin(), corners.end());
    ends_.push_back(static_cast<int>(corners_.size()));
}

// Quadrilaterals between the outline at `first` and the next one.
inline void Surface::add_side(int first, int corner_count) {
    for (int k = 0; k < corner_count; ++k) {
        const int next = (k + 1) % corner_count;
        add_polygon(
            {first + k, first + next, first + corner_count + next, first + corner_count + k});
    }
}

inline void Surface::append(Array array, const Vector<double, 3>& value) {
    PointArray& target = arrays_[array];
    for (std::size_t k = 0; k < target.components.size(); ++k)
        target.values.push_back(value[static_cast<Eigen::Index>(k)]);
}

}  // namespace ancf
