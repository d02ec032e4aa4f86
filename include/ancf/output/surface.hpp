// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The outer surface of deformed beams: polygons, with section results at their corners.
///
/// Each element is sampled at its own stations, so that results may jump from one element to the
/// next; a beam's two ends are closed by its outline. Polygons are counter-clockwise seen from
/// outside.

#pragma once

#include <ancf/element/evaluation.hpp>
#include <ancf/element/transmitted_forces.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/output/shape.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

#include <array>
#include <cstddef>
#include <string>
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
    /// @param start     reference length before the beam, m: of a part of a longer one.
    /// @throws InvalidArgument for fewer stations, an outline of fewer than three corners, or a
    ///         beam without elements.
    template <class Element>
    void add(const Scene& model, const Beam<Element>& beam, const Section& section,
             int stations = 9, double start = 0.0) {
        begin_beam(beam, section);
        std::vector<Corner> corners;
        const auto show = [&](const BeamStation<Element>& at) {
            corners.clear();
            for (const auto& [y, z] : section.outline())
                corners.push_back({at.position(y, z), at.velocity(y, z), at.axial_stress(y, z)});
            add_station(at.s, transmitted_forces(at.element, at.e, at.xi), corners, at.xi > 0.0);
        };
        for_each_station(model, beam, stations, show, start);
        end_beam();
    }

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
    // What a corner of the section shows at a station.
    struct Corner {
        Vector<double, 3> position;
        Vector<double, 3> velocity;
        double stress;
    };

    void begin_beam(const Chain& beam, const Section& section);
    void add_station(double s, const SectionForces& forces, const std::vector<Corner>& corners,
                     bool joined);
    void end_beam();
    void add_polygon(const std::vector<int>& corners) {
        corners_.insert(corners_.end(), corners.begin(), corners.end());
        ends_.push_back(static_cast<int>(corners_.size()));
    }
    void append(Array array, const Vector<double, 3>& value) {
        PointArray& target = arrays_[array];
        for (std::size_t k = 0; k < target.components.size(); ++k)
            target.values.push_back(value[static_cast<Eigen::Index>(k)]);
    }

    std::vector<Vector<double, 3>> points_;
    std::array<PointArray, array_count> arrays_;
    std::vector<int> corners_;
    std::vector<int> ends_;
    int first_ = 0;  // point of the beam
    int count_ = 0;  // corners of its outline
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/output/surface.ipp>  // IWYU pragma: export
#endif
