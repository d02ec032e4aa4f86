// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The options of a beam of rectangular section, and the choice of its element when the program
/// runs.

#pragma once

#include <ancf/element/quadrature.hpp>
#include <ancf/model/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/model/support.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>

#include <support/command_line.hpp>
#include <support/elements.hpp>

#include <iostream>
#include <string>
#include <tuple>
#include <type_traits>
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

/// A beam as the command line describes it; the defaults are the paper's.
struct BeamOptions {
    Geometry geometry;
    std::string preset = "paper";
    std::string element = "cross-section";
    std::string rule = "paper";
    std::string directors = "projected";
    std::string transverse = "green";
    std::string section_model = "paper";
    std::string clamp = "free-slope";

    /// Adds the choice of the element and of its options.
    /// @param elements,director_words  what the program offers of both
    void add_element_to(CommandLine& line,
                        const std::vector<std::string>& elements = {"cross-section",
                                                                    "cross-section-pointwise",
                                                                    "continuum", "continuum-hooke",
                                                                    "continuum-enhanced"},
                        const std::vector<std::string>& director_words = {"projected"}) {
        line.set_group("Element");
        line.add_choice("--preset", preset, {"paper", "best"},
                        "defaults of this group, the paper's or the library's own");
        line.add_choice("--element", element, elements, "element");
        const auto rules = ancf::Rule::names();
        line.add_choice("--rule", rule, {rules.begin(), rules.end()},
                        "integration along the element");
        line.add_choice("--directors", directors, director_words,
                        "how directors follow the slopes");
        line.add_choice("--transverse", transverse, {"green", "stretch"},
                        "transverse strain of the cross-section element");
        line.add_choice("--section", section_model, {"paper", "saint-venant"},
                        "torsional stiffness: k G Ip, or G J of a section that warps");
    }

    /// Adds what the beam is made of.
    void add_geometry_to(CommandLine& line) {
        line.set_group("Beam");
        line.add_number("--length", geometry.length, Range::positive, "m");
        line.add_number("--width", geometry.width, Range::positive, "along Z, m");
        line.add_number("--height", geometry.height, Range::positive, "along Y, m");
        line.add_number("--young", geometry.young, Range::positive, "Young's modulus, Pa");
        line.add_number("--shear", geometry.shear, Range::positive, "shear modulus, Pa");
        line.add_number("--shear-correction", geometry.shear_correction, Range::positive,
                        "factor k of the shear modulus");
    }

    /// Adds how the beam is held.
    void add_clamp_to(CommandLine& line) {
        line.set_group("Beam");
        line.add_choice("--clamp", clamp, {"free-slope", "full"},
                        "hold all vectors but r_x, or all vectors");
    }

    /// Fills in what depends on other options; call after CommandLine::parse.
    void settle(const CommandLine& line) {
        if (preset == "best") {
            const ancf::CrossSectionOptions own;
            const bool green = own.transverse == ancf::TransverseStrain::green;
            const bool as_paper = own.section_model == ancf::SectionModel::paper;
            line.settle<std::string>("--rule", rule, own.rule.name());
            line.settle<std::string>("--transverse", transverse, green ? "green" : "stretch");
            line.settle<std::string>("--section", section_model,
                                     as_paper ? "paper" : "saint-venant");
        }
        if (!is_continuum()) return;
        for (const char* option : {"--transverse", "--section"})
            if (line.given(option))
                std::cerr << option << " has no effect on the element " << element << '\n';
        transverse = "green";
        section_model = "paper";
    }

    [[nodiscard]] bool is_continuum() const { return element.rfind("continuum", 0) == 0; }

    /// Returns whether every choice but that of the element is the paper's.
    [[nodiscard]] bool as_paper() const {
        const BeamOptions paper{};
        return std::tie(rule, directors, transverse, section_model, clamp) ==
               std::tie(paper.rule, paper.directors, paper.transverse, paper.section_model,
                        paper.clamp);
    }

    /// Returns the element and its options in words.
    [[nodiscard]] std::string description() const {
        std::string text = element + " element, rule " + rule;
        if (!is_continuum())
            text += ", directors " + directors + ", transverse strain " + transverse +
                    ", section model " + section_model;
        return text;
    }

    /// Refuses values that the element does not take, before any work is done.
    /// @throws InvalidArgument naming the value.
    void check() const;

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
        const ancf::Rule quadrature = ancf::Rule::named(rule);
        if constexpr (std::is_same_v<Element, Continuum>) {
            const auto law = element == "continuum-hooke"      ? ancf::ContinuumMaterial::hooke
                             : element == "continuum-enhanced" ? ancf::ContinuumMaterial::enhanced
                                                               : ancf::ContinuumMaterial::diagonal;
            return ancf::ContinuumOptions{quadrature, law};
        } else {
            ancf::CrossSectionOptions options = ancf::CrossSectionOptions::paper();
            options.rule = quadrature;
            options.transverse = transverse == "green" ? ancf::TransverseStrain::green
                                                       : ancf::TransverseStrain::stretch;
            options.section_model = section_model == "paper" ? ancf::SectionModel::paper
                                                             : ancf::SectionModel::saint_venant;
            return options;
        }
    }
};

/// Adds the beam to a model, from the origin along X.
template <class Element>
[[nodiscard]] ancf::Beam<Element> straight_beam(ancf::Model<Element>& model,
                                                const BeamOptions& beam, int elements) {
    return ancf::straight_beam(model, beam.material(), beam.section(), {0.0, 0.0, 0.0},
                               {beam.geometry.length, 0.0, 0.0}, elements,
                               beam.element_options<Element>());
}

/// Names an element type as a value.
template <class T>
struct ElementType {
    using Element = T;
};

/// Calls visit(ElementType<...>) with the element of the command line.
template <class Visit>
decltype(auto) with_element(const BeamOptions& beam, Visit&& visit) {
    if (beam.is_continuum()) return visit(ElementType<Continuum>{});
    if (beam.element == "cross-section-pointwise")
        return visit(ElementType<CrossSectionPointwise>{});
    return visit(ElementType<CrossSection>{});
}

/// Makes one element of the beam's whole length.
template <class Element>
[[nodiscard]] Element element(const BeamOptions& beam) {
    return {beam.material(), beam.section(), beam.geometry.length, beam.element_options<Element>()};
}

inline void BeamOptions::check() const {
    with_element(*this, [&](auto type) {
        static_cast<void>(examples::element<typename decltype(type)::Element>(*this));
    });
}

}  // namespace examples
