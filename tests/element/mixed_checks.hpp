// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What must hold for a tangent of mixed integration points whose stresses are linear in strains.

#pragma once

#include <ancf/types.hpp>

#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/random_state.hpp>

#include <complex>
#include <cstdint>

namespace ancf::test {

/// Without a correction the mixed tangent is the plain one. With one its stresses are those of the
/// state before plus their derivative along the correction, here by complex step; they enter
/// linearly, in the tangent as in the force.
/// @param draw  returns a random state, given a Random
template <class Element, class Draw>
void check_mixed_tangent(const Element& element, const Draw& draw) {
    constexpr int dofs = Element::dofs;
    using Complex = std::complex<double>;
    using ComplexVector = Vector<Complex, dofs>;
    const Vector<double, dofs> none = Vector<double, dofs>::Zero();
    const ComplexVector still = none.template cast<Complex>();
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        Random random(seed);
        const Vector<double, dofs> e = draw(random), before = draw(random);
        const Vector<double, dofs> change = 0.1 * (draw(random) - before);
        const auto plain = element.evaluate(e);
        // no step: the stresses are those of e; measured 1e-15
        const auto here = element.evaluate(e, e, none);
        CHECK(relative_error(here.tangent, plain.tangent) <= 1e-13);
        CHECK(relative_error(here.predicted, plain.force) <= 1e-13);

        const auto step = element.evaluate(e, before, change);
        const auto start = element.evaluate(e, before, none);
        const ComplexVector probe =
            before.template cast<Complex>() + Complex(0.0, complex_step) * change;
        const auto moved =
            element.evaluate(ComplexVector(e.template cast<Complex>()), probe, still);
        const Matrix<double, dofs> tangent = start.tangent + moved.tangent.imag() / complex_step;
        const Vector<double, dofs> predicted =
            start.predicted + moved.predicted.imag() / complex_step;
        CHECK((tangent - start.tangent).norm() >= 1e-4 * start.tangent.norm());
        CHECK((predicted - start.predicted).norm() >= 1e-4 * start.predicted.norm());
        CHECK(relative_error(step.tangent, tangent) <= 1e-13);  // measured 1e-15
        CHECK(relative_error(step.predicted, predicted) <= 1e-13);
        CHECK(relative_error(step.force, plain.force) <= 1e-15);
        CHECK(step.energy == plain.energy);

        // at fixed stresses the derivative of their force by e is what they add to the tangent
        const ComplexVector at = before.template cast<Complex>();
        const ComplexVector by = change.template cast<Complex>();
        Matrix<double, dofs> difference;
        for (int k = 0; k < dofs; ++k) {
            ComplexVector along = e.template cast<Complex>();
            along[k] += Complex(0.0, complex_step);
            const ComplexVector force = element.evaluate(along, at, by).predicted -
                                        element.evaluate(along, at, still).predicted;
            difference.col(k) = force.imag() / complex_step;
        }
        CHECK((step.tangent - start.tangent - difference).norm() <= 1e-13 * start.tangent.norm());
    }
}

template <class Element>
void check_mixed_tangent(const Element& element) {
    check_mixed_tangent(element, [&](Random& random) { return random_state(element, random); });
}

}  // namespace ancf::test
