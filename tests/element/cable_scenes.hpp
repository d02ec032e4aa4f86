// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Chains of cables in scenes whose equilibrium is known.

#pragma once

#include <ancf/constants.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/section/section.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/statics.hpp>

#include <cmath>
#include <vector>

namespace ancf::test {

using ancf::pi;

/// A cable of unit length and E I = 1 with a square section of this height, so that E A = 12/h^2.
struct SlenderCable {
    double height;

    [[nodiscard]] Material material() const {
        return Material::isotropic(12.0 / std::pow(height, 4), 0.3, 1.0);
    }
    [[nodiscard]] Section section() const { return rectangle(height, height); }
    [[nodiscard]] double axial_stiffness() const { return 12.0 / (height * height); }
};

/// Holds a node's position and the direction of its slope, which points along `axis`, but not the
/// slope's length.
template <int Dimension>
void clamp_direction(BasicModel<Dimension>& model, NodeId node, int axis = 0) {
    model.pin(node);
    for (int component = 0; component < Dimension; ++component)
        if (component != axis) model.fix(node, Field::r_x, component);
}

/// A straight cantilever along X.
template <class Element>
Beam<Element> cantilever(BasicModel<Element::dimension>& model, const SlenderCable& cable,
                         int elements, const CableOptions& options = {}) {
    using Point = typename BasicModel<Element::dimension>::Point;
    const auto beam =
        straight_beam<Element>(model, cable.material(), cable.section(), Point(Point::Zero()),
                               Point(Point::Unit(0)), elements, options);
    clamp_direction(model, beam.first());
    return beam;
}

/// A cantilever of unit length that is stress-free as an arc from the origin, along X at its start.
template <class Element>
Beam<Element> curved_cantilever(BasicModel<Element::dimension>& model, const SlenderCable& cable,
                                double angle, int elements) {
    using Point = typename BasicModel<Element::dimension>::Point;
    const auto beam = arc<Element>(model, cable.material(), cable.section(), Point(Point::Zero()),
                                   Point(Point::Unit(0)), 1.0 / angle, angle, elements);
    clamp_direction(model, beam.first());
    return beam;
}

/// Returns log2 of the ratio of the errors of a mesh and of one twice as fine.
inline double order(double coarse, double fine) { return std::log2(coarse / fine); }

}  // namespace ancf::test
