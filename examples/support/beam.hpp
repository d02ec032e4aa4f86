// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The options of a beam of rectangular section and of its element.

#pragma once

#include <ancf/model/state.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>

#include <support/command_line.hpp>

#include <string>
#include <tuple>
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
inline const std::vector<std::string> all_elements = {"cross-section",
                                                      "cross-section-quintic",
                                                      "cross-section-pointwise",
                                                      "continuum",
                                                      "continuum-hooke",
                                                      "continuum-enhanced",
                                                      "cross-section-2d",
                                                      "cross-section-quintic-2d",
                                                      "continuum-2d",
                                                      "cable",
                                                      "cable-2d"};

/// A beam as the command line describes it; the defaults are the paper's.
struct BeamOptions {
    Geometry geometry;
    std::string preset = "paper";
    std::string element = "cross-section";
    std::string rule = "paper";
    std::string directors = "projected";
    std::string measure = "green";
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

    [[nodiscard]] bool is_quintic() const { return element.rfind("cross-section-quintic", 0) == 0; }

    /// Returns whether shear is cubic along the element, which fixes the rotary inertia.
    [[nodiscard]] bool has_cubic_shear() const { return is_quintic() && is_planar(); }

    /// Returns whether the element's directors may be chosen.
    [[nodiscard]] bool has_directors() const { return element == "cross-section"; }

    /// Returns whether the element's strain measure may be chosen.
    [[nodiscard]] bool has_measures() const {
        return (element == "cross-section" && directors != "transported") ||
               element == "cross-section-2d" || element == "cross-section-quintic-2d";
    }

    /// Returns whether every choice but that of the element is the paper's.
    [[nodiscard]] bool as_paper() const {
        const BeamOptions paper{};
        return std::tie(rule, directors, measure, transverse, section_model, rotary_inertia,
                        clamp) == std::tie(paper.rule, paper.directors, paper.measure,
                                           paper.transverse, paper.section_model,
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
};

}  // namespace examples
