// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Angles along a beam, counted beyond half a turn.

#pragma once

#include <ancf/model/builders/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/types.hpp>

#include <cmath>

namespace examples {

/// Sums the turns from one direction to the next in a plane; each is taken as less than half a
/// turn.
class TurnCounter {
public:
    void add(double first, double second) {
        const double angle = std::atan2(second, first);
        if (seen_) sum_ += std::remainder(angle - last_, 8.0 * std::atan(1.0));
        last_ = angle;
        seen_ = true;
    }

    /// Returns the angle between the first direction and the last, in degrees.
    [[nodiscard]] double degrees() const { return sum_ * 45.0 / std::atan(1.0); }

private:
    bool seen_ = false;
    double last_ = 0.0;
    double sum_ = 0.0;
};

/// Returns the angle by which r_x of the last node stands to the X axis in the XY plane, degrees;
/// whole turns are counted along the centre line.
template <class Element>
[[nodiscard]] double bending_angle(const ancf::BasicModel<Element::dimension>& model,
                                   const ancf::Beam<Element>& beam) {
    constexpr int chords = 32;  // per element
    TurnCounter turns;
    turns.add(1.0, 0.0);
    for (const int index : beam.elements) {
        const auto& element = model.template group<Element>().element(index);
        const auto e = model.template element_coordinates<Element>(index);
        auto before = element.position(e, 0.0);
        for (int k = 1; k <= chords; ++k) {
            const auto after = element.position(e, static_cast<double>(k) / chords);
            turns.add(after[0] - before[0], after[1] - before[1]);
            before = after;
        }
    }
    const auto tangent = model.value(beam.last(), ancf::Field::r_x);
    turns.add(tangent[0], tangent[1]);
    return turns.degrees();
}

/// Returns the angle by which r_y of the last node has turned about X, degrees; whole turns are
/// counted from node to node.
template <class Element>
[[nodiscard]] double twist_angle(const ancf::BasicModel<Element::dimension>& model,
                                 const ancf::Beam<Element>& beam) {
    TurnCounter turns;
    turns.add(1.0, 0.0);
    for (const ancf::NodeId node : beam.nodes) {
        const auto slope = model.value(node, ancf::Field::r_y);
        turns.add(slope[1], slope[2]);
    }
    return turns.degrees();
}

}  // namespace examples
