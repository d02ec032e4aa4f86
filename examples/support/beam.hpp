// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The options of a beam of rectangular section, and the choice of its element when the program
/// runs.

#pragma once

#include <ancf/element/quadrature.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/model/support.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>

#include <support/command_line.hpp>
#include <support/elements.hpp>

#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace examples {

inline constexpr int most_elements = 100'000;

/// Geometry and material of a straight beam along X: width along Z, height along Y.
struct Geometry {
    double length;  ///< m
    double width;   ///< m
    double height;  ///< m
    double young;   ///< E, Pa
    double shear;   ///< G, Pa
    double shear_correction = 5.0 / 6.0;

    /// Returns the bending stiffness E I against loads along Y, N m^2.
    [[nodiscard]] double bending_stiffness() const {
        return young * width * height * height * height / 12.0;
    }

    [[nodiscard]] auto values() const {
        return std::tie(length, width, height, young, shear, shear_correction);
    }
};

/// Words of --element; the cross-section beams come first, then the other spatial ones.
inline const std::vector<std::string> cross_section_beams = {
    "cross-section", "cross-section-quintic", "cross-section-pointwise"};
inline const std::vector<std::string> spatial_beams = {
    "cross-section", "cross-section-quintic", "cross-section-pointwise",
    "continuum",     "continuum-hooke",       "continuum-enhanced"};
inline const std::vector<std::string> all_elements = {
    "cross-section",    "cross-section-quintic", "cross-section-pointwise",
    "continuum",        "continuum-hooke",       "continuum-enhanced",
    "cross-section-2d", "continuum-2d",          "cable",
    "cable-2d"};

/// A beam as the command line describes it; the defaults are the paper's.
struct BeamOptions {
    Geometry geometry;
    std::string preset = "paper";
    std::string element = "cross-section";
    std::string rule = "paper";
    std::string directors = "projected";
    std::string transverse = "green";
    std::string section_model = "paper";
    std::string rotary_inertia = "consistent";
    std::string clamp = "free-slope";
    bool clampable = false;  ///< whether the program takes --clamp
    bool moving = false;     ///< whether the program takes --rotary-inertia

    /// Adds the choice of the element and of its options.
    /// @param elements  what the program offers
    void add_element_to(CommandLine& line, const std::vector<std::string>& elements);

    /// Adds what the beam is made of.
    void add_geometry_to(CommandLine& line);

    /// Adds how the beam resists turning.
    void add_inertia_to(CommandLine& line);

    /// Adds how the beam is held.
    void add_clamp_to(CommandLine& line);

    /// Fills in what depends on other options and refuses what the element does not take; call
    /// after CommandLine::parse.
    /// @throws InvalidArgument naming the option and its value.
    void settle(const CommandLine& line);

    [[nodiscard]] bool is_cross_section() const { return element.rfind("cross-section", 0) == 0; }
    [[nodiscard]] bool is_continuum() const { return element.rfind("continuum", 0) == 0; }
    [[nodiscard]] bool is_cable() const { return element.rfind("cable", 0) == 0; }
    [[nodiscard]] bool is_planar() const {
        return element.size() > 3 && element.compare(element.size() - 3, 3, "-2d") == 0;
    }

    [[nodiscard]] bool is_quintic() const { return element == "cross-section-quintic"; }

    /// Returns whether the element's directors may be chosen.
    [[nodiscard]] bool has_directors() const { return element == "cross-section"; }

    /// Returns whether an element type is the one that was chosen.
    template <class Element>
    [[nodiscard]] bool is() const {
        if (is_planar() != (Element::dimension == 2)) return false;
        if constexpr (std::is_same_v<Element, CrossSectionPointwise>)
            return element == "cross-section-pointwise";
        else if constexpr (std::is_same_v<Element, CrossSectionQuintic>)
            return is_quintic();
        else if constexpr (std::is_same_v<typename Element::Options, ancf::CrossSectionOptions>)
            return is_cross_section() && element != "cross-section-pointwise" && !is_quintic() &&
                   (directors == "geodesic") == std::is_same_v<Element, CrossSectionGeodesic> &&
                   (directors == "transported") == std::is_same_v<Element, CrossSectionTransported>;
        else if constexpr (std::is_same_v<typename Element::Options, ancf::ContinuumOptions>)
            return is_continuum();
        else
            return is_cable();
    }

    /// Returns whether every choice but that of the element is the paper's.
    [[nodiscard]] bool as_paper() const {
        const BeamOptions paper{};
        return std::tie(rule, directors, transverse, section_model, rotary_inertia, clamp) ==
               std::tie(paper.rule, paper.directors, paper.transverse, paper.section_model,
                        paper.rotary_inertia, paper.clamp);
    }

    /// Returns the element and its options in words.
    [[nodiscard]] std::string description() const;

    [[nodiscard]] ancf::Material material() const {
        constexpr double density = 7850.0;  // no static case depends on it
        return ancf::Material::from_moduli(geometry.young, geometry.shear, density);
    }

    [[nodiscard]] ancf::Section section() const {
        return ancf::rectangle(geometry.width, geometry.height)
            .with_shear_correction(geometry.shear_correction, geometry.shear_correction);
    }

    [[nodiscard]] ancf::Clamp clamped() const {
        return clamp == "full" ? ancf::Clamp::full : ancf::Clamp::free_slope;
    }

    /// Returns the options of an element's constructor.
    template <class Element>
    [[nodiscard]] auto element_options() const {
        using Options = typename Element::Options;
        const ancf::Rule quadrature =
            rule == "cable" ? ancf::cable_rule() : ancf::Rule::named(rule);
        if constexpr (std::is_same_v<Options, ancf::ContinuumOptions>) {
            const auto law = element == "continuum-hooke"      ? ancf::ContinuumMaterial::hooke
                             : element == "continuum-enhanced" ? ancf::ContinuumMaterial::enhanced
                                                               : ancf::ContinuumMaterial::diagonal;
            return Options{quadrature, law};
        } else if constexpr (std::is_same_v<Options, ancf::CableOptions>) {
            return Options{quadrature, 1.0};
        } else {
            Options options;
            options.rule = quadrature;
            options.transverse = transverse == "green" ? ancf::TransverseStrain::green
                                                       : ancf::TransverseStrain::stretch;
            options.section_model = section_model == "paper" ? ancf::SectionModel::paper
                                                             : ancf::SectionModel::saint_venant;
            options.rotary_inertia = rotary_inertia == "lumped" ? ancf::RotaryInertia::lumped
                                                                : ancf::RotaryInertia::consistent;
            return options;
        }
    }
};

/// Adds the beam to a model, from the origin along X.
template <class Element>
[[nodiscard]] ancf::Beam<Element> straight_beam(ancf::BasicModel<Element::dimension>& model,
                                                const BeamOptions& beam, int elements) {
    using Point = typename ancf::BasicModel<Element::dimension>::Point;
    return ancf::straight_beam<Element>(
        model, beam.material(), beam.section(), Point(Point::Zero()),
        Point(beam.geometry.length * Point::UnitX()), elements, beam.element_options<Element>());
}

/// Returns a point of the plane or of space in space.
template <int Dimension>
[[nodiscard]] ancf::Vector<double, 3> in_space(const ancf::Vector<double, Dimension>& point) {
    ancf::Vector<double, 3> result = ancf::Vector<double, 3>::Zero();
    result.template head<Dimension>() = point;
    return result;
}

/// Names an element type as a value.
template <class T>
struct ElementType {
    using Element = T;
};

/// Calls visit(ElementType<...>) with the element of the command line, one of the list.
template <class First, class... Others, class Visit>
decltype(auto) with_element(ElementList<First, Others...>, const BeamOptions& beam, Visit&& visit) {
    if constexpr (sizeof...(Others) > 0)
        if (!beam.is<First>())
            return with_element(ElementList<Others...>{}, beam, std::forward<Visit>(visit));
    return visit(ElementType<First>{});
}

/// Makes one element of the beam's whole length.
template <class Element>
[[nodiscard]] Element element(const BeamOptions& beam) {
    return {beam.material(), beam.section(), beam.geometry.length, beam.element_options<Element>()};
}

/// Refuses values that the element does not take, before any work is done.
/// @throws InvalidArgument naming the value.
template <class List>
void check(List list, const BeamOptions& beam) {
    with_element(list, beam, [&](auto type) {
        static_cast<void>(examples::element<typename decltype(type)::Element>(beam));
    });
}

}  // namespace examples
