// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Arms whose root a joint turns, in the plane and in space.

#pragma once

#include <ancf/constants.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/section.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ancf::test {

/// A turn by an angle within a second, at rest before and after: a - sin a with a = 2 pi t.
inline Motion smooth_turn(double angle) {
    const double w = 2.0 * pi, scale = angle / w;
    return {[=](double t) { return scale * (w * t - std::sin(w * t)); },
            [=](double t) { return scale * w * (1.0 - std::cos(w * t)); },
            [=](double t) { return scale * w * w * std::sin(w * t); }};
}

/// Half a metre of plastic in two elements, driven at its root: by a PlanarWeld, in space by a
/// DrivenRevolute about Z.
template <int Dimension>
struct Driven {
    using Element = CrossSectionBeam<Dimension>;
    using Scene = BasicModel<Element::dimension>;
    using Point = Vector<double, Dimension>;

    Scene model;
    Beam<Element> beam;

    explicit Driven(Motion angle)
        : beam(straight_beam<Element>(
              model, Material::isotropic(1e8, 0.3, 1000.0), rectangle(0.05, 0.05),
              Point(Point::Zero()), Point(0.5 * Point::UnitX()), 2, CrossSectionOptions::best())) {
        if constexpr (Dimension == 2)
            model.add(PlanarWeld(model, beam.first(), std::move(angle)));
        else
            model.add(DrivenRevolute(model, beam.first(), Vector<double, 3>(0.0, 0.0, 1.0),
                                     std::move(angle)));
    }

    /// Returns the angle about Z from one vector to another.
    [[nodiscard]] static double between(const Point& a, const Point& b) {
        return std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
    }

    /// Returns how far the root is off an angle, but for whole turns. A joint to space turns its
    /// node by the negative angle.
    [[nodiscard]] double off(double angle) const {
        Point wanted = Point::Zero();
        wanted[0] = std::sin(angle);
        wanted[1] = std::cos(angle);
        return std::abs(between(wanted, model.value(beam.first(), Field::r_y)));
    }

    /// Returns the largest angle between the sections of neighbours.
    [[nodiscard]] double wound() const {
        double most = 0.0;
        for (int k = 0; k < 2; ++k)
            most = std::max(most, std::abs(between(model.value(beam.node(k), Field::r_y),
                                                   model.value(beam.node(k + 1), Field::r_y))));
        return most;
    }
};

using DrivenArm = Driven<2>;
using DrivenCrank = Driven<3>;

}  // namespace ancf::test
