// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Cables whose stress-free state is a curve, for tests.

#pragma once

#include <element/cable_samples.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <vector>

namespace ancf::test {

/// References of one element: arcs, in space helices too, and a line with an inflection.
template <int Dimension>
std::vector<Vector<double, 4 * Dimension>> references() {
    std::vector<Vector<double, 4 * Dimension>> all{
        Helix{1.0, 0.0}.coordinates<Dimension>(0.0, cable_length),
        Helix{20.0, 0.0}.coordinates<Dimension>(0.0, cable_length),
        inflected_coordinates<Dimension>()};
    if constexpr (Dimension == 3) {
        all.push_back(Helix{0.8, 0.5}.coordinates<3>(0.0, cable_length));
        all.push_back(Helix{0.5, -1.5}.coordinates<3>(0.0, cable_length));
    }
    return all;
}

inline std::vector<Rule> rules() {
    return {cable_rule(), Rule::mixed(), Rule::gauss(3), Rule::paper()};
}

template <class Element>
Element curved(const typename Element::Coordinates& reference, const Rule& rule = cable_rule()) {
    return {cable_material(), cable_section(), reference, cable_length, {rule, 1.0}};
}

/// Visits every reference with every rule: visit(element, reference).
template <class Element, class Visit>
int for_each_curved(const Visit& visit) {
    int count = 0;
    for (const auto& reference : references<Element::dimension>()) {
        for (const Rule& rule : rules()) {
            INFO("reference " << reference.transpose() << ", rule " << rule.name());
            visit(curved<Element>(reference, rule), VectorX(reference));
            ++count;
        }
    }
    return count;
}

/// The reference turned and moved at random, and bent out of shape.
inline VectorX disturbed(const Shape& shape, const VectorX& reference, Random& random,
                         double size) {
    const VectorX e = reference + size * random.vector(shape.dofs());
    const MatrixX turn = random_rotation(shape.dimension, random);
    return moved(shape, e, turn, random.vector(shape.dimension));
}

}  // namespace ancf::test
