// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The scenes of one_step that several elements are made for.

#pragma once

#include <ancf/constants.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/section/profiles.hpp>

#include <one_step/elements.hpp>
#include <one_step/scene.hpp>

#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

namespace ancf::bench::one_step {

template <class Element>
void add_elastica(std::vector<Row>& rows) {
    const Vector<double, 2> tip(0.445004402246, 0.810609024880);  // inextensible, under 10
    for (const double load : {10.0, 100.0})
        for (const double height : {1e-1, 1e-2, 1e-3})
            for (const int steps : {1, 5, 20}) {
                // Green's strain has no equilibrium there: the clamp is crushed
                constexpr bool green = std::is_same_v<Element, Green> ||
                                       std::is_same_v<Element, Continuum> ||
                                       std::is_same_v<Element, Cable>;
                if (green && load > 50.0 && height > 0.05) continue;
                const Point across(0.0, std::cos(0.6), std::sin(0.6));
                Row row{"elastica " + std::to_string(std::lround(load)) + ", h/L 1/" +
                            std::to_string(std::lround(1.0 / height)) + ", " + measure<Element>(),
                        steps, [load, height, across] {
                            return cantilever<Element>(height, 32, load * across, Point::Zero());
                        }};
                row.has_theory = load == 10.0;
                row.theory = Point(tip[0], tip[1] * across[1], tip[1] * across[2]);
                rows.push_back(row);
            }
}

/// A bend of 45 degrees under 600, for whose section `theory` holds.
template <class Element>
void add_bends(std::vector<Row>& rows, const std::string& what,
               const typename Element::Options& options, const Point& theory) {
    for (const int elements : {8, 16, 32}) {
        Row row{"bend 45, " + std::to_string(elements) + " elements, " + what,
                1,
                [elements, options] {
                    Problem p;
                    const auto beam =
                        arc<Element>(p.scene, Material::from_moduli(1e7, 5e6, 1.0),
                                     rectangle(1.0, 1.0).with_shear_correction(1.0, 1.0), {0, 0, 0},
                                     {1, 0, 0}, {0, 1, 0}, 100.0, 0.25 * pi, elements, options);
                    p.scene.clamp(beam.first(), clamp_of<Element>);
                    p.scene.add(Force<3>(beam.last(), {0, 0, 600}));
                    p.end = beam.last();
                    return p;
                },
                true,
                theory,
                100.0};
        rows.push_back(row);
    }
}

template <class Element>
void add_bends(std::vector<Row>& rows) {
    add_bends<Element>(rows, measure<Element>(), Element::Options::best(),
                       Point(46.89192495, 15.55778591, 53.60736918));
}

/// A full circle by an end moment at 0.7 rad to the axes.
template <class Element>
void add_circle(std::vector<Row>& rows) {
    for (const double slenderness : {28.0, 100.0})
        for (const int steps : {1, 10}) {
            const Point axis(0.0, -std::sin(0.7), std::cos(0.7));
            rows.push_back({"circle, h/L 1/" + std::to_string(std::lround(slenderness)) + ", " +
                                measure<Element>(),
                            steps,
                            [slenderness, axis] {
                                return cantilever<Element>(1.0 / slenderness, 32, Point::Zero(),
                                                           2.0 * pi * axis);
                            },
                            std::is_same_v<Element, Engineering>});
        }
}

/// Three beams welded around two corners.
template <class Element>
void add_frame(std::vector<Row>& rows) {
    rows.push_back({"frame 0.01 x 0.06, " + measure<Element>(), 4, [] {
                        Problem p;
                        const auto steel = Material::isotropic(2.1e11, 0.3, 7850.0);
                        const auto section = rectangle(0.01, 0.06);
                        const Point corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0.8}};
                        NodeId last;
                        for (int leg = 0; leg < 3; ++leg) {
                            const auto beam = straight_beam<Element>(p.scene, steel, section,
                                                                     corners[leg], corners[leg + 1],
                                                                     8, best_options<Element>());
                            if (leg == 0)
                                p.scene.clamp(beam.first());
                            else
                                p.scene.add(Weld(p.scene, last, beam.first()));
                            last = beam.last();
                        }
                        p.scene.add(Force<3>(last, {3000, 2000, 1500}));
                        p.end = last;
                        return p;
                    }});
}

}  // namespace ancf::bench::one_step
