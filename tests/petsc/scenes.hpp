// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Scenes that are solved in series and by several processes; all have joints with a stiffness.

#pragma once

#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/builders/rigid_body.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/loads/springs.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>

#include <cmath>
#include <vector>

namespace petsc_test {

using Beam = ancf::CrossSectionBeam<3>;
using Rope = ancf::Cable<3>;
using Point = ancf::Vector<double, 3>;

inline const ancf::Material steel = ancf::Material::isotropic(2e11, 0.3, 7800.0);
inline ancf::Section bar() { return ancf::rectangle(0.01, 0.01); }

/// A cubic lattice on clamped feet, pushed aside and down; gravity acts.
inline ancf::Model lattice(int n, double push = 40.0) {
    const auto place = [n](int i, int j, int k) { return i + n * (j + n * k); };
    std::vector<Point> points;
    std::vector<ancf::Member> members;
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                points.emplace_back(0.25 * i, 0.25 * j, 0.25 * k);
                const int here = place(i, j, k);
                if (k > 0) members.push_back({place(i, j, k - 1), here, 0, 1});
                if (k > 0 && i > 0) members.push_back({place(i - 1, j, k), here, 0, 1});
                if (k > 0 && j > 0) members.push_back({place(i, j - 1, k), here, 0, 1});
            }
    ancf::Model model;
    const auto frame = ancf::frame<Beam>(model, {{steel, bar()}}, points, members);
    model.set_gravity({0, 0, -9.81});
    for (int k = 0; k < n * n; ++k) {
        model.clamp(frame.joints[static_cast<std::size_t>(k)]);
        model.add(ancf::Force<3>(frame.joints[points.size() - 1 - static_cast<std::size_t>(k)],
                                 Point(push, 0, -push)));
    }
    return model;
}

/// A chain of members with a joint between two of them, driven up at its end.
inline ancf::Model chain(int members = 6, int elements = 8) {
    std::vector<Point> points = {Point::Zero()};
    std::vector<ancf::Member> all;
    for (int k = 0; k < members; ++k) {
        points.emplace_back(0.25 * (k + 1), 0, 0);
        all.push_back({k, k + 1, 0, elements});
    }
    ancf::Model model;
    const auto frame = ancf::frame<Beam>(model, {{steel, bar()}}, points, all);
    model.set_gravity({0, 0, -9.81});
    model.clamp(frame.joints.front());
    model.add(ancf::Force<3>(frame.joints[3], Point(0, 30, 0)));
    model.prescribe(
        frame.joints.back(), ancf::Field::r, 2, [](double t) { return 0.1 * t * t; },
        [](double t) { return 0.2 * t; }, [](double) { return 0.2; });
    return model;
}

/// One element between two joints: less than one for each of several processes.
inline ancf::Model short_beam() {
    ancf::Model model;
    const auto frame = ancf::frame<Beam>(model, {{steel, bar()}}, {Point(0, 0, 0), Point(1, 0, 0)},
                                         {{0, 1, 0, 1}});
    model.clamp(frame.joints.front());
    model.add(ancf::Force<3>(frame.joints.back(), Point(0, 0, -100)));
    return model;
}

/// A rigid body between two welded beams, on which a third one slides, held by a spring.
inline ancf::Model body_with_slider() {
    ancf::Model model;
    const auto bar_along_x = [&](double x, double z) {
        return ancf::straight_beam<Beam>(model, steel, bar(), {x, 0, z}, {x + 0.5, 0, z}, 4);
    };
    const auto before = bar_along_x(0, 0), after = bar_along_x(0.7, 0),
               above = bar_along_x(0.7, 0.1);
    const auto body = model.add_node({0.6, 0, 0});
    ancf::add_body(model, body, 0.5, ancf::Matrix<double, 3>::Identity() * 1e-3);
    const auto point = [&](double x, double z) {
        return ancf::point_of_body(model, body, {x, 0, z});
    };
    model.clamp(before.first());
    model.add(ancf::Weld(model, before.last(), point(0.5, 0)));
    model.add(ancf::Weld(model, after.first(), point(0.7, 0)));
    const auto guide = point(0.6, 0.1);
    model.add(ancf::Slider<3>(above.first(), ancf::straight_guide<3>(model, guide, {1, 0, 0})));
    model.add(ancf::FixedOrientation(model, above.first(), guide));
    model.add(ancf::Spring<3>(above.last(), after.last(), 1e3, 0.05));
    model.set_gravity({0, 0, -9.81});
    model.add(ancf::Force<3>(after.last(), Point(0, 5, 5)));
    return model;
}

/// An arc on a mast, joined by a joint; its end carries a load that does not move.
inline ancf::Model curved_beam(int elements = 24) {
    ancf::Model model;
    const auto frame = ancf::frame<Beam>(model, {{steel, bar()}},
                                         {Point(0, 0, 0), Point(0, 0, 0.5)}, {{0, 1, 0, 4}});
    const auto arc = ancf::arc<Beam>(model, steel, bar(), Point(0, 0, 0.5), Point(0, 0, 1),
                                     Point(1, 0, 0), 0.5, 2.0, elements);
    model.attach(arc.first(), frame.joints.back());
    model.clamp(frame.joints.front());
    model.set_gravity({0, 0, -9.81});
    model.add(ancf::Force<3>(arc.last(), Point(40, 80, -120)));
    return model;
}

/// A net of ropes between four masts with clamped feet and a ring of bars at their heads.
inline ancf::Model net(int n = 5) {
    std::vector<Point> knots, posts;
    std::vector<ancf::Member> ropes, masts;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int here = i + n * j;
            const double x = static_cast<double>(i) / (n - 1), y = static_cast<double>(j) / (n - 1);
            knots.emplace_back(x, y, 0.5);
            if (i > 0) ropes.push_back({here - 1, here, 0, 1});
            if (j > 0) ropes.push_back({here - n, here, 0, 1});
        }
    for (const int corner : {0, n - 1, n * n - 1, n * (n - 1)}) {
        const Point top = knots[static_cast<std::size_t>(corner)];
        const int foot = static_cast<int>(posts.size());
        posts.emplace_back(top[0], top[1], 0);
        posts.push_back(top);
        masts.push_back({foot, foot + 1, 0, 2});
        if (foot > 0) masts.push_back({foot - 1, foot + 1, 0, 1});
    }
    masts.push_back({7, 1, 0, 1});
    ancf::Model model;
    const auto frame = ancf::frame<Beam>(model, {{steel, bar()}}, posts, masts);
    ancf::NetOptions taut;
    taut.strain = 5e-3;
    const auto web = ancf::net<Rope>(
        model, {{ancf::Material::isotropic(2e9, 0.3, 1000.0), ancf::rectangle(0.004, 0.004)}},
        knots, ropes, taut);
    std::size_t post = 0;
    for (const int corner : {0, n - 1, n * n - 1, n * (n - 1)}) {
        model.attach(web.joints[static_cast<std::size_t>(corner)], frame.joints[2 * post + 1],
                     ancf::Field::r);
        model.clamp(frame.joints[2 * post++]);
    }
    model.set_gravity({0, 0, -9.81});
    model.add(ancf::Force<3>(web.joints[static_cast<std::size_t>(n * n / 2)], Point(0, 0, -5)));
    return model;
}

}  // namespace petsc_test
