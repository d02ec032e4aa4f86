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

    /// Returns the angle that the joint stands at in a state, rad, but for whole turns and for that
    /// of the start. A joint to space turns its node by the negative angle.
    [[nodiscard]] double joint_angle(const VectorX& q) const {
        const int slope = model.layout().index({beam.first(), Field::r_y});
        return -std::atan2(q[slope + 1], q[slope]);
    }

    /// Returns how far the root is off an angle, but for whole turns.
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

/// Two beams of half a metre in a row, the first clamped, the second driven against its end. Three
/// turns a second pull the clamped one by 500 N, so the material is ten times as stiff.
template <int Dimension>
struct Elbow {
    using Element = CrossSectionBeam<Dimension>;
    using Scene = BasicModel<Element::dimension>;
    using Point = Vector<double, Dimension>;

    Scene model;
    Beam<Element> upper, beam;

    /// @param young  Young's modulus, Pa.
    explicit Elbow(Motion angle, double young = 1e9)
        : upper(half_metre(Point(Point::Zero()), young)),
          beam(half_metre(Point(0.5 * Point::UnitX()), young)) {
        model.clamp(upper.first());
        if constexpr (Dimension == 2)
            model.add(PlanarWeld(model, upper.last(), beam.first(), std::move(angle)));
        else
            model.add(DrivenRevolute(model, upper.last(), beam.first(),
                                     Vector<double, 3>(0.0, 0.0, 1.0), std::move(angle)));
    }

    /// Returns the angle that the joint stands at in a state, rad, but for whole turns.
    [[nodiscard]] double joint_angle(const VectorX& q) const {
        const auto heading = [&](NodeId node) {
            const int slope = model.layout().index({node, Field::r_y});
            return std::atan2(q[slope + 1], q[slope]);
        };
        return heading(beam.first()) - heading(upper.last());
    }

    /// Returns how far the joint is off an angle, but for whole turns.
    [[nodiscard]] double off(double angle) const {
        return std::abs(std::remainder(joint_angle(model.state().q) - angle, 2.0 * pi));
    }

    /// Returns the largest angle between the sections of neighbours.
    [[nodiscard]] double wound() const {
        double most = 0.0;
        for (const Beam<Element>* part : {&upper, &beam})
            for (int k = 0; k < 2; ++k) {
                const Point a = model.value(part->node(k), Field::r_y);
                const Point b = model.value(part->node(k + 1), Field::r_y);
                most = std::max(most, std::abs(Driven<Dimension>::between(a, b)));
            }
        return most;
    }

private:
    [[nodiscard]] Beam<Element> half_metre(const Point& from, double young) {
        return straight_beam<Element>(
            model, Material::isotropic(young, 0.3, 1000.0), rectangle(0.05, 0.05), from,
            Point(from + 0.5 * Point::UnitX()), 2, CrossSectionOptions::best());
    }
};

using DrivenElbow = Elbow<2>;
using DrivenElbowInSpace = Elbow<3>;

/// Follows the angle of an arm's joint through a run that is observed so often that the joint turns
/// by less than half a turn in between: with its whole turns, which no single state tells.
template <class Arm>
class TurnCounter {
public:
    TurnCounter(const Arm& arm, Motion motion) : arm_(arm), motion_(std::move(motion)) {}

    void see(const State& state) {
        const double now = arm_.joint_angle(state.q);
        if (seen_++ > 0) turned_ += std::remainder(now - before_, 2.0 * pi);
        before_ = now;
        farthest_ = std::max(farthest_, std::abs(turned_ - motion_.value(state.time)));
    }

    /// Returns the angle from the start, rad.
    [[nodiscard]] double turned() const { return turned_; }

    /// Returns the most that it was off the motion, rad.
    [[nodiscard]] double farthest() const { return farthest_; }

private:
    const Arm& arm_;
    Motion motion_;
    double turned_ = 0.0, before_ = 0.0, farthest_ = 0.0;
    long seen_ = 0;
};

}  // namespace ancf::test
