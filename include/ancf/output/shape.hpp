// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The deformed shape of a beam: points of the centre line and of the section's outline.
///
/// Points come from Element::position(e, xi, y, z), so that each element shows its own kinematics:
/// r0 + y d_y + z d_z of the cross-section element, r0 + y r_y + z r_z of the continuum element.

#pragma once

#include <ancf/error.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

#include <cstddef>
#include <iosfwd>
#include <vector>

namespace ancf {

namespace detail {

template <class Element>
using Velocity = decltype(some<Element>().velocity(
    some<typename Element::Coordinates>(), some<typename Element::Coordinates>(), 0.0, 0.0, 0.0));
template <class Element>
using Stress =
    decltype(some<Element>().stress(some<typename Element::Coordinates>(), 0.0, 0.0, 0.0));
template <class Element>
using LengthTo = decltype(double(some<Element>().length(0.0)));

/// Returns the stress-free length of an element up to xi, m; in proportion where it does not tell.
template <class Element>
[[nodiscard]] double length_to(const Element& element, double xi) {
    if constexpr (offers<LengthTo, Element>)
        return element.length(xi);
    else
        return xi * element.length();
}

}  // namespace detail

/// A place along a beam, where results are sampled.
template <class Element>
struct BeamStation {
    const Element& element;                     ///< where the station is
    const typename Element::Coordinates& e;     ///< nodal coordinates
    const typename Element::Coordinates& rate;  ///< their rates
    int place;                                  ///< of the element along the beam, from 0
    double xi;                                  ///< along the element, in [0, 1]
    double s;                                   ///< reference length from the beam's start, m

    /// Returns a point of the body; in the plane, the section's z stands normal to it. m.
    [[nodiscard]] Vector<double, 3> position(double y = 0.0, double z = 0.0) const {
        auto point = element.position(e, xi, y, z);
        if constexpr (Element::dimension == 3)
            return point;
        else
            return {point[0], point[1], z};
    }

    /// Returns the velocity of a point of the body, m/s; zero where the element does not tell.
    [[nodiscard]] Vector<double, 3> velocity(double y = 0.0, double z = 0.0) const {
        Vector<double, 3> speed = Vector<double, 3>::Zero();
        if constexpr (detail::offers<detail::Velocity, Element>)
            speed.template head<Element::dimension>() = element.velocity(e, rate, xi, y, z);
        return speed;
    }

    /// Returns the stress S_xx at a point of the body, Pa; zero where the element does not tell.
    [[nodiscard]] double axial_stress(double y = 0.0, double z = 0.0) const {
        if constexpr (detail::offers<detail::Stress, Element>)
            return element.stress(e, xi, y, z)[0];
        else
            return 0.0 * (y + z);
    }
};

/// Visits equally spaced stations of a beam, element by element, the ends of each included.
///
/// @param stations  per element, at least 2.
/// @param visit     called as visit(const BeamStation<Element>&).
/// @param start     reference length before the first element, m.
/// @throws InvalidArgument for fewer stations.
template <class Element, class Visitor>
void for_each_station(const Scene& model, const Beam<Element>& beam, int stations, Visitor&& visit,
                      double start = 0.0) {
    detail::require(stations >= 2, "for_each_station: at least 2 stations are needed, got ",
                    stations);
    const auto& group = model.group<Element>();
    for (std::size_t place = 0; place < beam.elements.size(); ++place) {
        const int index = beam.elements[place];
        const Element& element = group.element(index);
        const auto e = model.element_coordinates<Element>(index);
        const auto rate = model.element_coordinates<Element>(index, model.state().v);
        for (int k = 0; k < stations; ++k) {
            const double xi = static_cast<double>(k) / (stations - 1);
            visit(BeamStation<Element>{element, e, rate, static_cast<int>(place), xi,
                                       start + detail::length_to(element, xi)});
        }
        start += element.length();
    }
}

/// One station of a deformed shape.
struct ShapeStation {
    double s;                  ///< reference length from the beam's start, m
    Vector<double, 3> centre;  ///< m
    std::vector<Vector<double, 3>>
        outline;  ///< of the section, in the order of Section::outline, m
};

/// Returns the deformed shape of a beam as its model stands now.
/// @param stations  per element, at least 2; the last of an element and the first of the next
///                  are both listed.
template <class Element>
[[nodiscard]] std::vector<ShapeStation> deformed_shape(const Scene& model,
                                                       const Beam<Element>& beam,
                                                       const Section& section, int stations = 9) {
    std::vector<ShapeStation> shape;
    for_each_station(model, beam, stations, [&](const BeamStation<Element>& station) {
        ShapeStation& row = shape.emplace_back(ShapeStation{station.s, station.position(), {}});
        for (const SectionPoint& point : section.outline())
            row.outline.push_back(station.position(point.y, point.z));
    });
    return shape;
}

/// Writes a deformed shape as CSV: s,x,y,z of the centre line, then x0,y0,z0,x1,... of the outline.
/// @throws InvalidArgument for a shape without stations.
void write_shape(std::ostream& out, const std::vector<ShapeStation>& shape);

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/output/shape.ipp>  // IWYU pragma: export
#endif
