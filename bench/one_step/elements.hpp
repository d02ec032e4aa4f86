// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The elements of one_step: how each is named, held and told its options, and its cantilever.

#pragma once

#include <ancf/element/cable/cable.hpp>
#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>

#include <one_step/scene.hpp>

#include <cmath>
#include <string>
#include <type_traits>

namespace ancf::bench::one_step {

using Green = CrossSectionBeam<3, Geodesic>;
using Engineering = CrossSectionBeam<3, Geodesic, LinearShear, EngineeringMeasure>;
using Quintic = QuinticBeam<>;
using QuinticEngineering = QuinticBeam<EngineeringMeasure>;
using Continuum = ContinuumBeam<3>;
using Cable = ancf::Cable<3>;

/// What holds a beam without shear is its slope too.
template <class Element>
inline constexpr Clamp clamp_of =
    std::is_same_v<Element, TorsionBeam> || std::is_same_v<Element, Cable> ? Clamp::full
                                                                           : Clamp::free_slope;

/// The best options of an element that has some, else the usual ones.
template <class Element>
typename Element::Options best_options() {
    if constexpr (std::is_same_v<Element, Continuum> || std::is_same_v<Element, Cable>)
        return {};
    else
        return Element::Options::best();
}

template <class Element>
std::string measure() {
    if (std::is_same_v<Element, Engineering>) return "engineering";
    if (std::is_same_v<Element, QuinticEngineering>) return "quintic, engineering";
    if (std::is_same_v<Element, TorsionBeam>) return "torsion beam";
    if (std::is_same_v<Element, Continuum>) return "continuum beam";
    if (std::is_same_v<Element, Cable>) return "cable";
    return std::is_same_v<Element, Quintic> ? "quintic" : "green";
}

/// A cantilever of length 1 and height h, loaded at `angle` to the axes of its section.
template <class Element>
Problem cantilever(double height, int elements, const Point& force, const Point& moment) {
    Problem p;
    const double young = 12.0 / std::pow(height, 4);  // E I = 1
    const auto beam = straight_beam<Element>(p.scene, Material::isotropic(young, 0.3, 1.0),
                                             rectangle(height, height), {0, 0, 0}, {1, 0, 0},
                                             elements, best_options<Element>());
    p.scene.clamp(beam.first(), clamp_of<Element>);
    if (force.norm() > 0.0) p.scene.add(Force<3>(beam.last(), force));
    if (moment.norm() > 0.0) p.scene.add(Moment(beam.last(), moment));
    p.end = beam.last();
    return p;
}

}  // namespace ancf::bench::one_step
