// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What cross-section beams of any directors give side by side; each family has a unit of its own.

#pragma once

#include <ancf/element/cross_section/beam.hpp>

#include <element/cross_section_beam_samples.hpp>
#include <element/pack_difference.hpp>
#include <support/catch.hpp>

#include <array>
#include <iterator>

namespace ancf::test {

/// Equal elements in the lanes of a pack give what each gives alone.
template <class Element>
void check_equal_lanes() {
    const auto variant = GENERATE(from_range(std::begin(variants), std::end(variants)));
    INFO(variant.name);
    const auto element = element_of<Element>(variant);
    CHECK(pack_difference<4>(std::array{&element, &element, &element, &element}, element) <=
          1e-14);  // round-off
}

/// Elements of different length, section and material share a pack.
template <class Element>
void check_shared_pack() {
    CrossSectionOptions options;
    options.rule = Rule::mixed();
    const Element one(sample_material(), sample_rectangle(), 0.7, options);
    const Element two(sample_material(), sample_odd_section(), 1.3, options);
    const Element three(Material::from_moduli(1e9, 3e8, 100.0), sample_rectangle(), 0.2, options);
    const std::array<const Element*, 4> elements{&one, &two, &three, &one};
    CHECK(pack_difference<4>(elements, Element::template together<4>(elements)) <=
          1e-14);  // round-off
}

}  // namespace ancf::test
