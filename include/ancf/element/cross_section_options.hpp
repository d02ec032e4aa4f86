// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What the cross-section beams of space and of the plane share: their options, and the names of
/// their policies.

#pragma once

#include <ancf/element/mass.hpp>
#include <ancf/element/quadrature.hpp>
#include <ancf/section/section.hpp>

#include <type_traits>
#include <utility>

namespace ancf {

struct Projected;
struct Transported;
struct Geodesic;
struct LinearShear;
struct PointwiseShear;
struct CubicShear;
struct GreenMeasure;
struct EngineeringMeasure;
struct CubicLine;
struct QuinticLine;

template <int Dimension = 3, class Directors = Projected, class Shear = LinearShear,
          class Measure = GreenMeasure, class Line = CubicLine>
class CrossSectionBeam;

/// The beam whose centre line is quintic: each node has the second derivative r_xx as well. Most
/// accurate for its coordinates; docs/theory-quintic.md.
template <class Measure = GreenMeasure>
using QuinticBeam = CrossSectionBeam<3, Geodesic, LinearShear, Measure, QuinticLine>;

/// The beam in the plane with a quintic centre line and cubic shear: each node has r_xx and the
/// rate r_xy of its slope as well. Of the sixth order, thick or thin; docs/theory-quintic.md.
template <class Measure = GreenMeasure>
using PlanarQuinticBeam = CrossSectionBeam<2, Projected, CubicShear, Measure, QuinticLine>;

/// How the length of a slope across becomes a strain.
enum class TransverseStrain {
    green,   ///< (r_y.r_y - 1)/2, [Dufva2006, Eq. 24]
    stretch  ///< |r_y| - 1, [Dufva2006, Eq. 25]: fewer Newton iterations where it is large
};

/// Choices that are values: they change constant data, not the kernel.
struct CrossSectionOptions {
    Rule rule = Rule::paper();                              ///< stations along the element
    TransverseStrain transverse = TransverseStrain::green;  ///< measure of the transverse strains
    SectionModel section_model = SectionModel::paper;       ///< how the section resists torsion
    RotaryInertia rotary_inertia = RotaryInertia::consistent;  ///< where sections resist turning
    /// Rule::gauss(3) in place of Rule::mixed() where a spatial element with engineering strains is
    /// shorter than its section is deep, 4 sqrt(I/A): what sections bent to a radius of their depth
    /// need. docs/limits.md.
    bool three_points_where_short = false;

    /// The element of [Dufva2006]: four Gauss points, Eq. 24, the correction factor on torsion too.
    [[nodiscard]] static CrossSectionOptions paper() { return {}; }

    /// What is most accurate for its cost, Geodesic directors with it: the axial term on points of
    /// its own, the torsional stiffness of a section that warps, rotary inertia at the nodes, three
    /// points where an element with engineering strains is short.
    [[nodiscard]] static CrossSectionOptions best() {
        return {Rule::mixed(), TransverseStrain::green, SectionModel::saint_venant,
                RotaryInertia::lumped, true};
    }
};

/// The choices of a beam with a quintic centre line; by default the best there are.
struct QuinticOptions : CrossSectionOptions {
    /// A rule, and the rest of CrossSectionOptions::best().
    QuinticOptions(Rule chosen = Rule::quintic())  // NOLINT: {rule}, as of every element's options
        : CrossSectionOptions(CrossSectionOptions::best()) {
        rule = std::move(chosen);
    }

    static QuinticOptions paper() = delete;  ///< the paper has no such element
    /// What is most accurate for its cost: the default.
    [[nodiscard]] static QuinticOptions best() { return QuinticOptions(); }
};

/// The choices of PlanarQuinticBeam; by default the best there are.
struct PlanarQuinticOptions : QuinticOptions {
    /// A rule, and the rest of QuinticOptions but for the rotary inertia, which is consistent.
    PlanarQuinticOptions(Rule chosen = Rule::quintic())  // NOLINT: {rule}, as of every element's
        : QuinticOptions(std::move(chosen)) {
        rotary_inertia = RotaryInertia::consistent;
    }

    static PlanarQuinticOptions paper() = delete;  ///< the paper has no such element
    /// What is most accurate for its cost: the default.
    [[nodiscard]] static PlanarQuinticOptions best() { return PlanarQuinticOptions(); }
};

namespace detail {

/// The options that go with a shear and a centre line.
template <class Shear, class Line>
using CrossSectionOptionsOf = std::conditional_t<
    std::is_same_v<Shear, CubicShear>, PlanarQuinticOptions,
    std::conditional_t<std::is_same_v<Line, QuinticLine>, QuinticOptions, CrossSectionOptions>>;

}  // namespace detail

}  // namespace ancf
