// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The element that a program's options name, as a type: included by what is compiled for each.

#pragma once

#include <ancf/element/cable/cable.hpp>
#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/element/quadrature.hpp>
#include <ancf/error.hpp>

#include <support/named_beam.hpp>

#include <type_traits>

namespace examples {

/// Names an element type as a value.
template <class T>
struct ElementType {
    using Element = T;
};

/// Calls visit(ElementType<...>) with the element that the options name.
template <int Dimension, class Visit>
auto with_element(const BeamOptions& options, const Visit& visit) {
    using namespace ancf;
    ancf::detail::require(options.is_planar() == (Dimension == 2), "--element ", options.element,
                          " does not live in ", Dimension, " dimensions");
    if (options.is_cable()) return visit(ElementType<Cable<Dimension>>{});
    if (options.is_continuum()) return visit(ElementType<ContinuumBeam<Dimension>>{});
    if constexpr (Dimension == 3) {
        if (options.is_quintic()) return visit(ElementType<QuinticBeam<>>{});
        if (options.element == "cross-section-pointwise")
            return visit(ElementType<CrossSectionBeam<3, Projected, PointwiseShear>>{});
        if (options.directors == "transported")
            return visit(ElementType<CrossSectionBeam<3, Transported>>{});
        if (options.measure == "engineering" && options.directors == "geodesic")
            return visit(
                ElementType<CrossSectionBeam<3, Geodesic, LinearShear, EngineeringMeasure>>{});
        if (options.directors == "geodesic")
            return visit(ElementType<CrossSectionBeam<3, Geodesic>>{});
    }
    if constexpr (Dimension == 2) {
        if (options.is_quintic() && options.measure == "engineering")
            return visit(ElementType<PlanarQuinticBeam<EngineeringMeasure>>{});
        if (options.is_quintic()) return visit(ElementType<PlanarQuinticBeam<>>{});
    }
    if (options.measure == "engineering")
        return visit(
            ElementType<CrossSectionBeam<Dimension, Projected, LinearShear, EngineeringMeasure>>{});
    return visit(ElementType<CrossSectionBeam<Dimension>>{});
}

/// Returns the options of an element's constructor.
template <class Options>
Options element_options(const BeamOptions& beam) {
    const ancf::Rule quadrature =
        beam.rule == "cable" ? ancf::cable_rule() : ancf::Rule::named(beam.rule);
    if constexpr (std::is_same_v<Options, ancf::ContinuumOptions>) {
        const auto law = beam.element == "continuum-hooke"      ? ancf::ContinuumMaterial::hooke
                         : beam.element == "continuum-enhanced" ? ancf::ContinuumMaterial::enhanced
                                                                : ancf::ContinuumMaterial::diagonal;
        return {quadrature, law};
    } else if constexpr (std::is_same_v<Options, ancf::CableOptions>) {
        return {quadrature, 1.0};
    } else {
        Options options;
        options.rule = quadrature;
        options.three_points_where_short = beam.preset == "best";
        options.transverse = beam.transverse == "green" ? ancf::TransverseStrain::green
                                                        : ancf::TransverseStrain::stretch;
        options.section_model = beam.section_model == "paper" ? ancf::SectionModel::paper
                                                              : ancf::SectionModel::saint_venant;
        options.rotary_inertia = beam.rotary_inertia == "lumped" ? ancf::RotaryInertia::lumped
                                                                 : ancf::RotaryInertia::consistent;
        return options;
    }
}

template <class Element>
NamedBeam named(const ancf::Beam<Element>& beam) {
    return {beam,
            [beam](const ancf::Scene& scene, const ancf::Section& section, ancf::Surface& surface) {
                surface.add(scene, beam, section, NamedBeam::stations);
            },
            [beam](const ancf::Scene& scene, const ancf::Section& section, int stations) {
                return ancf::deformed_shape(scene, beam, section, stations);
            }};
}

template <int Dimension>
NamedBeam straight_beam(ancf::BasicModel<Dimension>& model, const BeamOptions& options,
                        const ancf::Material& material, const ancf::Section& section,
                        const ancf::Vector<double, Dimension>& from,
                        const ancf::Vector<double, Dimension>& to, int elements) {
    return with_element<Dimension>(options, [&](auto type) {
        using Element = typename decltype(type)::Element;
        return named(
            ancf::straight_beam<Element>(model, material, section, from, to, elements,
                                         element_options<typename Element::Options>(options)));
    });
}

template <int Dimension>
NamedBeam straight_beam(ancf::BasicModel<Dimension>& model, const BeamOptions& options,
                        int elements) {
    using Point = ancf::Vector<double, Dimension>;
    return straight_beam<Dimension>(model, options, options.material(), options.section(),
                                    Point::Zero(), options.geometry.length * Point::UnitX(),
                                    elements);
}

template <int Dimension>
void check(const BeamOptions& options) {
    with_element<Dimension>(options, [&options](auto type) {
        using Element = typename decltype(type)::Element;
        static_cast<void>(Element(options.material(), options.section(), options.geometry.length,
                                  element_options<typename Element::Options>(options)));
    });
}

}  // namespace examples
