// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Elements that the tests of the cross-section beam share.

#pragma once

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/section/polygon.hpp>
#include <ancf/section/profiles.hpp>

#include <support/catch.hpp>

#include <iterator>
#include <string_view>
#include <type_traits>

namespace ancf::test {

using Paper = CrossSectionBeam<3>;
using Pointwise = CrossSectionBeam<3, Projected, PointwiseShear>;
using Carried = CrossSectionBeam<3, Geodesic>;
using Transporting = CrossSectionBeam<3, Transported>;

inline Material sample_material() { return Material::from_moduli(2.0e7, 0.8e7, 7800.0); }

inline Section sample_rectangle() { return rectangle(0.1, 0.2).with_shear_correction(0.8, 0.9); }

/// A quadrilateral without any symmetry, its axis off the centroid: every moment is there.
inline Section sample_odd_section() {
    return polygon({{-0.06, -0.09}, {0.11, -0.07}, {0.09, 0.05}, {-0.04, 0.12}})
        .with_shear_correction(0.8, 0.9)
        .with_torsion_constant(1.7e-5);
}

/// Every combination of the options that the tests walk over.
struct Variant {
    const char* name;
    const char* rule;
    TransverseStrain transverse;
    SectionModel model;
    bool odd;
};

inline constexpr Variant variants[] = {
    {"paper, Eq. 24, rectangle", "paper", TransverseStrain::green, SectionModel::paper, false},
    {"mixed, Eq. 24, odd section", "mixed", TransverseStrain::green, SectionModel::paper, true},
    {"paper, Eq. 25, odd section", "paper", TransverseStrain::stretch, SectionModel::paper, true},
    {"mixed, Eq. 25, rectangle", "mixed", TransverseStrain::stretch, SectionModel::paper, false},
    {"paper, Eq. 24, odd, Saint-Venant", "paper", TransverseStrain::green,
     SectionModel::saint_venant, true},
    {"lobatto3, Eq. 25, Saint-Venant", "lobatto3", TransverseStrain::stretch,
     SectionModel::saint_venant, false},
};

inline Section section_of(const Variant& variant) {
    return variant.odd ? sample_odd_section() : sample_rectangle();
}

template <class Element = Paper>
Element element_of(const Variant& variant, double length = 0.7) {
    return Element(sample_material(), section_of(variant), length,
                   {Rule::named(variant.rule), variant.transverse, variant.model});
}

/// Generates the variants that an element type allows: the mixed rule has too few points for
/// pointwise shear.
template <class Element = Paper>
Variant any_variant() {
    return GENERATE(filter(
        [](const Variant& v) {
            return !std::is_same_v<Element, Pointwise> || std::string_view(v.rule) != "mixed";
        },
        from_range(std::begin(variants), std::end(variants))));
}

}  // namespace ancf::test
