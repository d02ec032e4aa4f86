// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/cross_section_options.hpp>
#include <ancf/element/quadrature.hpp>
#include <ancf/error.hpp>

#include <support/beam.hpp>

#include <algorithm>

namespace examples {

void BeamOptions::add_element_to(CommandLine& line, const std::vector<std::string>& elements) {
    line.set_group("Element");
    line.add_choice("--preset", preset, {"paper", "best"},
                    "defaults of this group, the paper's or the library's own");
    line.add_choice("--element", element, elements, "element");
    const auto names = ancf::Rule::names();
    std::vector<std::string> rules(names.begin(), names.end());
    if (std::find(elements.begin(), elements.end(), "cable") != elements.end())
        rules.emplace_back("cable");
    line.add_choice("--rule", rule, rules, "integration along the element");
    line.add_choice("--directors", directors, {"projected", "transported", "geodesic"},
                    "how directors follow the slopes");
    line.add_choice("--measure", measure, {"green", "engineering"},
                    "strain of a section: Green's, or that of Reissner's beam");
    line.add_choice("--transverse", transverse, {"green", "stretch"},
                    "transverse strain of the cross-section element");
    line.add_choice("--section", section_model, {"paper", "saint-venant"},
                    "torsional stiffness: k G Ip, or G J of a section that warps");
}

void BeamOptions::add_geometry_to(CommandLine& line) {
    line.set_group("Beam");
    line.add_number("--length", geometry.length, Range::positive, "m");
    line.add_number("--width", geometry.width, Range::positive, "along Z, m");
    line.add_number("--height", geometry.height, Range::positive, "along Y, m");
    line.add_number("--young", geometry.young, Range::positive, "Young's modulus, Pa");
    line.add_number("--shear", geometry.shear, Range::positive, "shear modulus, Pa");
    line.add_number("--shear-correction", geometry.shear_correction, Range::positive,
                    "factor k of the shear modulus");
}

void BeamOptions::add_inertia_to(CommandLine& line) {
    moving = true;
    line.set_group("Element");
    line.add_choice("--rotary-inertia", rotary_inertia, {"consistent", "lumped"},
                    "of sections that turn: by interpolated slopes, or at the nodes");
}

void BeamOptions::add_clamp_to(CommandLine& line) {
    clampable = true;
    line.set_group("Beam");
    line.add_choice("--clamp", clamp, {"free-slope", "full"},
                    "hold position and slopes but r_x, or all slopes; cables: all");
}

void BeamOptions::settle(const CommandLine& line) {
    const BeamOptions paper{};
    // What the element has no use for may be given as the paper has it, no other way.
    const auto refuse = [&](bool applies, const char* option, std::string& value,
                            const std::string& usual) {
        ancf::detail::require(applies || !line.given(option) || value == usual, option, " ", value,
                              " does not apply to --element ", element);
        if (!applies) value = usual;
    };
    if (preset == "best") {
        const auto own = ancf::CrossSectionOptions::best();
        const bool green = own.transverse == ancf::TransverseStrain::green;
        const bool as_paper = own.section_model == ancf::SectionModel::paper;
        const bool lumped = own.rotary_inertia == ancf::RotaryInertia::lumped;
        // two points are too few for shear that is not interpolated between the nodes
        const bool few_points = is_cross_section() && element != "cross-section-pointwise";
        line.settle<std::string>("--rule", rule,
                                 is_quintic() ? "quintic"
                                 : is_cable() ? "cable"
                                 : few_points ? own.rule.name()
                                              : paper.rule);
        line.settle<std::string>("--directors", directors, "geodesic");
        line.settle<std::string>("--transverse", transverse, green ? "green" : "stretch");
        line.settle<std::string>("--section", section_model, as_paper ? "paper" : "saint-venant");
        if (moving && is_cross_section() && !has_cubic_shear())
            line.settle<std::string>("--rotary-inertia", rotary_inertia,
                                     lumped ? "lumped" : "consistent");
    }
    if (is_quintic()) line.settle<std::string>("--rule", rule, "quintic");
    const bool carried = is_quintic() && !is_planar();
    refuse(has_directors(), "--directors", directors, carried ? "geodesic" : paper.directors);
    refuse(has_measures(), "--measure", measure, paper.measure);
    if (moving)
        refuse(is_cross_section() && !has_cubic_shear(), "--rotary-inertia", rotary_inertia,
               paper.rotary_inertia);
    refuse(is_cross_section(), "--transverse", transverse, paper.transverse);
    refuse(is_cross_section() && !is_planar(), "--section", section_model, paper.section_model);
    if (clampable && is_cable()) refuse(false, "--clamp", clamp, "full");  // no other slope
    ancf::detail::require(is_cable() || rule != "cable",
                          "--rule cable does not apply to --element ", element);
}

std::string BeamOptions::description() const {
    std::string text = element + " element, rule " + rule;
    if (!is_cross_section()) return text;
    if (!is_planar()) text += ", directors " + directors + ", section model " + section_model;
    if (measure != "green") text += ", " + measure + " strain";
    if (moving) text += ", rotary inertia " + rotary_inertia;
    return text + ", transverse strain " + transverse;
}

}  // namespace examples
