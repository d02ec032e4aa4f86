// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Random scenes for the tests of integrators.

#pragma once

#include <ancf/dynamics/problem.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/loads/damping.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>

#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>

// compiled once, with those of the tests of model
extern template class ancf::KelvinVoigt<ancf::Cable<2>>;
extern template class ancf::KelvinVoigt<ancf::CrossSectionBeam<2>>;
extern template class ancf::KelvinVoigt<ancf::CrossSectionBeam<3>>;

namespace ancf::test {

/// A random scene: a beam of some element and mesh, of any stiffness, held and loaded at random.
template <class Element>
struct RandomScene {
    static constexpr int dimension = Element::dimension;
    using Point = Vector<double, dimension>;

    BasicModel<dimension> model;
    Beam<Element> beam;
    double young, length, depth;
    double step;
    bool by_tolerance;
    int stages;

    explicit RandomScene(Random& random) {
        const auto pick = [&](int count) { return static_cast<int>(random.uniform(0.0, count)); };
        young = std::pow(10.0, random.uniform(4.0, 12.0));
        length = std::pow(10.0, random.uniform(-1.0, 1.0));
        depth = length * random.uniform(0.02, 0.1);
        step = std::pow(10.0, random.uniform(-6.0, 0.0));
        by_tolerance = pick(2) == 0;
        stages = pick(2) == 0 ? 3 : 5;
        const int elements = 1 + pick(3);
        Point end = Point::Zero();
        end[0] = length;
        beam = straight_beam<Element>(
            model, Material::isotropic(young, 0.3, random.uniform(500.0, 8000.0)),
            rectangle(depth, depth), Point(Point::Zero()), end, elements);
        Point above = Point::Zero();
        above[1] = 0.4 * length;
        const int hold = pick(4);
        if (hold == 0) model.pin(beam.first());
        if (hold == 1) model.clamp(beam.first());
        if (hold == 2) model.add(Distance<dimension>(beam.first(), above, 0.4 * length));
        if (hold == 3) model.add(Pin<dimension>(beam.first(), Point(Point::Zero())));
        Point gravity = Point::Zero();
        gravity[1] = -random.uniform(0.0, 10.0);
        model.set_gravity(gravity);
        if (pick(2) == 0) {
            const double weight = 1000.0 * depth * depth * length * 10.0;
            Point force = Point::Zero();
            for (int i = 0; i < dimension; ++i) force[i] = weight * random.uniform(-1.0, 1.0);
            model.add(Force<dimension>(beam.last(), force));
        }
        if (pick(3) == 0) add_drag(model, beam, random.uniform(0.0, 10.0) * depth * depth * 1e3);
    }
};

/// The other element that joints connect with one.
template <class Element>
struct Partner;
template <int Dimension>
struct Partner<CrossSectionBeam<Dimension>> {
    using type = Cable<Dimension>;
};
template <int Dimension>
struct Partner<Cable<Dimension>> {
    using type = CrossSectionBeam<Dimension>;
};

/// A random scene with a second beam on a joint, of that element or of its partner. Joints, their
/// drives, what holds the second beam's end, loads that follow, dampers and rates are random too.
template <class Element>
struct JointedScene : RandomScene<Element> {
    using Base = RandomScene<Element>;
    static constexpr int dimension = Element::dimension;
    using Point = typename Base::Point;
    using Base::beam, Base::depth, Base::length, Base::model, Base::step;

    explicit JointedScene(Random& seeded) : Base(seeded), random(seeded) {
        wave_speed = std::sqrt(Base::young / 1000.0);
        if (pick(3) == 0)
            add_second<typename Partner<Element>::type>();
        else
            add_second<Element>();
        set_rates();
    }

private:
    template <class Second>
    void add_second() {
        const Point direction = random.template direction<dimension>();
        const Point end = model.value(beam.last(), Field::r);
        kind = pick(9);
        const bool apart = kind == 1 || kind == 2;
        const Point from =
            apart ? Point(end + 0.2 * length * random.template direction<dimension>()) : end;
        const double stiffer = std::pow(10.0, random.uniform(-2.0, 2.0));
        const double other_length = length * random.uniform(0.3, 1.5);
        const auto second = straight_beam<Second>(
            model, Material::isotropic(stiffer * Base::young, 0.3, 1000.0), rectangle(depth, depth),
            from, Point(from + other_length * direction), 1 + pick(2));
        const NodeId a = beam.last(), b = second.first(), tip = second.last();
        const double gap = (from - end).norm();
        constexpr bool frame_a = Element::fields.contains(Field::r_y);
        constexpr bool frame_b = Second::fields.contains(Field::r_y);
        if (kind == 1) model.add(Distance<dimension>(a, b, gap));
        if (kind == 2) model.add(Distance<dimension>(a, b, motion(gap, 0.2 * gap)));
        if (kind == 3) model.add(ancf::Driven(Pin<dimension>(a, b), {{0, motion(0.0, length)}}));
        if constexpr (dimension == 2) {
            if (kind == 0 || kind == 4) model.add(Pin<2>(a, b));
            if (kind == 5 || kind == 6) model.add(PlanarWeld(model, a, b));
            if (kind > 6) model.add(PlanarWeld(model, a, b, motion(0.0, 10.0)));
        } else {
            join_in_space<frame_a, frame_b>(a, b);
        }
        if (kind != 1 && kind != 2 && kind != 3 && pick(8) == 0)
            model.add(Pin<dimension>(b, a));  // held twice
        hold_tip<frame_b>(tip);
        push<frame_b>(tip);
        const int damper = pick(6);
        const double eta = step * std::pow(10.0, uniform(-3.0, 0.0));
        // of a cable in space it is not smooth where the line is straight
        if constexpr (frame_a || dimension == 2)
            if (damper == 0) add_kelvin_voigt(model, beam, eta);
        if (damper == 1) add_rayleigh_damping(model, second, uniform(0.0, 1.0) / step, 0.1 * step);
    }

    template <bool FrameA, bool FrameB>
    void join_in_space(NodeId a, NodeId b) {
        const Vector<double, 3> axis = random.template direction<3>();
        if constexpr (FrameA && FrameB) {
            if (kind == 0) model.add(Pin<3>(a, b));
            if (kind == 4) model.add(Weld(model, a, b));
            if (kind == 5) model.add(Revolute(model, a, b, axis));
            if (kind == 6) model.add(DrivenRevolute(model, a, b, axis, motion(0.0, 10.0)));
            if (kind == 7) model.add(Universal(model, a, b, axis, random.template direction<3>()));
            if (kind == 8) {
                model.add(Pin<3>(a, b));
                model.add(AlignedTangent(model, FrameAt(a), b));
            }
        } else {
            if (kind == 0 || kind > 3) model.add(Pin<3>(a, b));
            if (FrameA && kind > 5) model.add(AlignedTangent(model, FrameAt(a), b));
            if (FrameB && kind > 5) model.add(AlignedTangent(model, FrameAt(b), a));
        }
    }

    template <bool Frame>
    void hold_tip(NodeId tip) {
        const Point place = model.value(tip, Field::r);
        const Point away = place + 0.5 * length * random.template direction<dimension>();
        const int hold = pick(14);
        const int component = pick(dimension);
        if (hold == 0) model.add(Pin<dimension>(tip, place));
        if (hold == 1) model.add(Distance<dimension>(tip, away, 0.5 * length));
        if (hold == 2)
            model.add(Distance<dimension>(tip, away, motion(0.5 * length, 0.2 * length)));
        if (hold == 3) {
            const Motion along = motion(0.0, length);
            const Point way = random.template direction<dimension>();
            model.add(Pin<dimension>(
                tip, PointMotion<dimension>(
                         [=](double t) { return Point(place + along.value(t) * way); },
                         [=](double t) { return Point(along.rate(t) * way); },
                         [=](double t) { return Point(along.acceleration(t) * way); })));
        }
        if (hold == 4)
            model.add(FixedCoordinate<dimension>(tip, Field::r, component,
                                                 motion(place[component], length)));
        if (hold == 5) {
            const Motion path = motion(place[component], length);
            model.prescribe(tip, Field::r, component, path.value, path.rate, path.acceleration);
        }
        if (hold == 6) model.add(Distance<dimension>(tip, beam.first(), distance_to_first(tip)));
        if (hold == 10)
            model.add(PointOnLine<dimension>(tip, place, random.template direction<dimension>()));
        if constexpr (dimension == 2) {
            if (hold == 7) model.add(PlanarWeld(model, tip));
            if (hold == 8) model.add(PlanarWeld(model, tip, motion(0.0, 10.0)));
        } else if constexpr (Frame) {
            const Vector<double, 3> axis = random.template direction<3>();
            if (hold == 7) model.add(Revolute(model, tip, axis));
            if (hold == 8) model.add(DrivenRevolute(model, tip, axis, motion(0.0, 10.0)));
            if (hold == 9) model.add(RigidSection(tip));
        } else {
            if (hold == 7) model.add(AlignedTangent(model, tip));
        }
    }

    // Up to what bends a beam by a radian.
    template <bool Frame>
    void push(NodeId tip) {
        const double moment =
            Base::young * std::pow(depth, 4) / 12.0 / length * std::pow(10.0, uniform(-3.0, 0.0));
        const int load = pick(6);
        const double rate = uniform(0.0, 1.0) / step;
        Amplitude amplitude;
        if (pick(2) == 0) amplitude = [=](double t) { return std::sin(rate * t); };
        if constexpr (dimension == 2) {
            if (load < 2) model.add(PlanarSlopeMoment(tip, Field::r_x, moment), amplitude);
            if (load == 2) {
                const Vector<double, 2> along = random.template direction<2>();
                model.add(PlanarFollowerForce(tip, moment / length * along), amplitude);
            }
            if (Frame && load == 3)
                model.add(PlanarSlopeMoment(tip, Field::r_y, moment), amplitude);
        } else {
            const Vector<double, 3> along = random.template direction<3>();
            if constexpr (Frame) {
                if (load == 0) model.add(Moment(tip, moment * along), amplitude);
                if (load == 1) model.add(Moment(tip, moment * along, Attachment::frame), amplitude);
                if (load == 2) model.add(FollowerForce(tip, moment / length * along), amplitude);
                if (load == 3) model.add(SlopeMoment(tip, Field::r_y, along, moment), amplitude);
            } else {
                if (load < 3) model.add(TangentMoment(tip, moment * along), amplitude);
            }
        }
    }

    /// A smooth motion from a value, mostly one that a beam follows with small strains.
    Motion motion(double start, double most) {
        const double w = std::pow(10.0, uniform(-1.5, 0.0)) / step;
        const double followed = 0.1 * wave_speed / (length * w);
        const double size = most * std::min(1.0, followed) * std::pow(10.0, uniform(-3.0, 0.0));
        if (pick(3) == 0)
            return {[=](double t) { return start + size * std::sin(w * t); },
                    [=](double t) { return size * w * std::cos(w * t); },
                    [=](double t) { return -size * w * w * std::sin(w * t); }};
        return {[=](double t) { return start + size * (1.0 - std::cos(w * t)); },
                [=](double t) { return size * w * std::sin(w * t); },
                [=](double t) { return size * w * w * std::cos(w * t); }};
    }

    /// Rest, or a rigid turn and a translation, brought onto the constraints where that can be.
    void set_rates() {
        const double most = std::min(0.1 * wave_speed / length, 1.0 / step);
        const double w = pick(2) == 0 ? 0.0 : most * std::pow(10.0, uniform(-3.0, 0.0));
        Matrix<double, dimension> turn = Matrix<double, dimension>::Zero();
        for (int i = 0; i < dimension; ++i)
            for (int j = 0; j < i; ++j) turn(i, j) = w * uniform(-1.0, 1.0);
        turn -= Matrix<double, dimension>(turn.transpose());
        const Point translation = w * length * random.template direction<dimension>();
        for (int node = 0; node < model.nodes(); ++node)
            for (int k = 0; k < field_count; ++k) {
                const auto field = static_cast<Field>(k);
                if (model.layout().index({{node}, field}) < 0) continue;
                Point rate = turn * model.value({node}, field);
                if (field == Field::r) rate += translation;
                model.set_rate({node}, field, rate);
            }
        DynamicProblem problem(model);
        Start start = problem.start();
        static_cast<void>(problem.project(start.time, start.q, start.v));
        problem.store(start.time, start.q, start.v, start.multipliers);
    }

    [[nodiscard]] double distance_to_first(NodeId tip) const {
        return (model.value(tip, Field::r) - model.value(beam.first(), Field::r)).norm();
    }

    int pick(int count) { return static_cast<int>(random.uniform(0.0, count)); }
    double uniform(double low, double high) { return random.uniform(low, high); }

    Random& random;
    int kind = 0;
    double wave_speed = 0.0;
};

}  // namespace ancf::test
