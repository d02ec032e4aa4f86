// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Scenes in any units of length, mass and time, for tests that results do not depend on them.

#pragma once

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/types.hpp>

#include <support/catch.hpp>

#include <cmath>
#include <ostream>
#include <vector>

namespace ancf::test {

/// How many metres, kilograms and seconds the units of a scene are.
struct Scale {
    double length = 1.0;
    double mass = 1.0;
    double time = 1.0;

    [[nodiscard]] double force() const { return mass * length / (time * time); }

    [[nodiscard]] Material material(double young, double poisson, double density) const {
        return Material::isotropic(young * force() / (length * length), poisson,
                                   density * mass / (length * length * length));
    }
};

inline std::ostream& operator<<(std::ostream& out, const Scale& scale) {
    return out << "length " << scale.length << " m, mass " << scale.mass << " kg, time "
               << scale.time << " s";
}

/// Powers of a base in length, mass and time, in two of them and in all three at once.
[[nodiscard]] inline std::vector<Scale> powers_of(double base) {
    const double up = base, down = 1.0 / base;
    return {{up, 1.0, 1.0},    {down, 1.0, 1.0}, {1.0, up, 1.0},    {1.0, down, 1.0},
            {1.0, 1.0, up},    {1.0, 1.0, down}, {up, up, down},    {down, up, 1.0},
            {down, 1.0, down}, {up, up, up},     {down, down, down}};
}

/// A slender steel cantilever in the plane, bent by a force at its tip.
[[nodiscard]] inline PlanarModel cantilever(const Scale& scale, double force = 1000.0) {
    const double m = scale.length;
    PlanarModel model;
    const auto beam =
        straight_beam<CrossSectionBeam<2>>(model, scale.material(2.07e11, 0.3, 7850.0),
                                           rectangle(0.01 * m, 0.01 * m), {0.0, 0.0}, {m, 0.0}, 4);
    model.clamp(beam.first());
    model.add(Force<2>(beam.last(), {0.0, force * scale.force()}));
    return model;
}

/// Three beams in the plane: welded to space, welded to the first, hinged to the second and tied to
/// a place.
[[nodiscard]] inline PlanarModel linkage(const Scale& scale, double force = 8000.0) {
    const double m = scale.length;
    PlanarModel model;
    const Material steel = scale.material(2.07e11, 0.3, 7850.0);
    const Section section = rectangle(0.05 * m, 0.05 * m);
    const auto column =
        straight_beam<CrossSectionBeam<2>>(model, steel, section, {0.0, 0.0}, {0.0, m}, 2);
    const auto beam =
        straight_beam<CrossSectionBeam<2>>(model, steel, section, {0.0, m}, {m, m}, 2);
    const auto arm =
        straight_beam<CrossSectionBeam<2>>(model, steel, section, {m, m}, {1.5 * m, 0.5 * m}, 2);
    model.add(PlanarWeld(model, column.first()));
    model.add(PlanarWeld(model, column.last(), beam.first()));
    model.add(Pin<2>(beam.last(), arm.first()));
    model.add(Distance<2>(arm.last(), {2.0 * m, 0.5 * m}, 0.5 * m));
    model.add(Force<2>(arm.last(), {0.0, -force * scale.force()}));
    return model;
}

/// Two beams in space, welded to space and to each other at a right angle.
[[nodiscard]] inline Model elbow(const Scale& scale, double force = 20000.0) {
    const double m = scale.length;
    Model model;
    const Material steel = scale.material(2.07e11, 0.3, 7850.0);
    const Section section = rectangle(0.08 * m, 0.04 * m);
    const auto first = straight_beam<CrossSectionBeam<3>>(model, steel, section, {0.0, 0.0, 0.0},
                                                          {m, 0.0, 0.0}, 2);
    const auto second =
        straight_beam<CrossSectionBeam<3>>(model, steel, section, {m, 0.0, 0.0}, {m, m, 0.0}, 2);
    model.add(Weld(model, first.first()));
    model.add(Weld(model, first.last(), second.first()));
    model.add(Force<3>(second.last(), Vector<double, 3>(0.0, 0.0, force * scale.force())));
    return model;
}

}  // namespace ancf::test
