// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The deformed shape of a beam: points of the centre line and of the section's outline.
///
/// Points come from Element::position(e, xi, y, z), so that each element shows its own kinematics:
/// r0 + y d_y + z d_z of the cross-section element, r0 + y r_y + z r_z of the continuum element.

#pragma once

#include <ancf/error.hpp>
#include <ancf/model/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/output/csv.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace ancf {

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
};

/// Visits equally spaced stations of a beam, element by element, the ends of each included.
///
/// @param stations  per element, at least 2.
/// @param visit     called as visit(const BeamStation<Element>&).
/// @throws InvalidArgument for fewer stations.
template <class Element, class... Elements, class Visitor>
void for_each_station(const Model<Elements...>& model, const Beam<Element>& beam, int stations,
                      Visitor&& visit) {
    detail::require(stations >= 2, "for_each_station: at least 2 stations are needed, got ",
                    stations);
    double start = 0.0;
    for (std::size_t place = 0; place < beam.elements.size(); ++place) {
        const int index = beam.elements[place];
        const Element& element = model.template group<Element>().element(index);
        const auto e = model.template element_coordinates<Element>(index);
        const auto rate = model.template element_coordinates<Element>(index, model.state().v);
        for (int k = 0; k < stations; ++k) {
            const double xi = static_cast<double>(k) / (stations - 1);
            visit(BeamStation<Element>{element, e, rate, static_cast<int>(place), xi,
                                       start + xi * element.length()});
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
template <class Element, class... Elements>
[[nodiscard]] std::vector<ShapeStation> deformed_shape(const Model<Elements...>& model,
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
inline void write_shape(std::ostream& out, const std::vector<ShapeStation>& shape) {
    detail::require(!shape.empty(), "write_shape: the shape has no station");
    std::vector<std::string> columns = {"s", "x", "y", "z"};
    for (std::size_t k = 0; k < shape.front().outline.size(); ++k)
        for (const char* axis : {"x", "y", "z"}) columns.push_back(axis + std::to_string(k));
    CsvWriter csv(out, columns);
    for (const ShapeStation& station : shape) {
        std::vector<double> row = {station.s, station.centre[0], station.centre[1],
                                   station.centre[2]};
        for (const auto& point : station.outline) row.insert(row.end(), point.begin(), point.end());
        csv.row(row);
    }
}

}  // namespace ancf
