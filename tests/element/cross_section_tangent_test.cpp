// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The cross-section beam: force and tangent against derivatives.

#include <ancf/element/cross_section/beam.hpp>

#include <element/cross_section_beam_samples.hpp>
#include <element/property_checks.hpp>
#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/random_state.hpp>

#include <complex>
#include <cstdint>

namespace cross_section_tangent_test {

using namespace ancf;
using test::Carried;
using test::Paper;
using test::Pointwise;
using test::Transporting;

TEMPLATE_TEST_CASE("CrossSectionBeam: force and tangent equal the complex-step derivatives",
                   "[element][cross-section][tangent]", Paper, Pointwise, Carried, Transporting) {
    const auto variant = test::any_variant<TestType>();
    INFO(variant.name);
    test::check_derivatives(test::element_of<TestType>(variant));
}

/// A state of an element, another one before it, and a correction that leads from there.
struct Correction {
    template <class Element>
    Correction(const Element& element, std::uint64_t seed) {
        test::Random random(seed);
        e = test::random_state(element, random);
        before = test::random_state(element, random);
        change = 0.1 * (test::random_state(element, random) - before);
    }

    Vector<double, 24> e, before, change;
    Vector<double, 24> none = Vector<double, 24>::Zero();
};

TEMPLATE_TEST_CASE("CrossSectionBeam: the mixed tangent has the stresses of linearised strains",
                   "[element][cross-section][tangent]", Paper, Pointwise, Carried, Transporting) {
    using Complex = std::complex<double>;
    const auto variant = test::any_variant<TestType>();
    INFO(variant.name);
    const auto element = test::element_of<TestType>(variant);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const Correction given(element, seed);
        const auto &e = given.e, &before = given.before, &change = given.change;
        const auto& none = given.none;
        const auto plain = element.evaluate(e);
        // no step: the stresses are those of e; measured 1e-15
        CHECK(test::relative_error(element.evaluate(e, e, none).tangent, plain.tangent) <= 1e-13);

        // stresses enter linearly, and those of a step are the derivative along it
        const auto step = element.evaluate(e, before, change);
        const Matrix<double, 24> still = element.evaluate(e, before, none).tangent;
        const Vector<Complex, 24> probe =
            before.template cast<Complex>() + Complex(0.0, test::complex_step) * change;
        const Matrix<Complex, 24> moved =
            element
                .evaluate(Vector<Complex, 24>(e.template cast<Complex>()), probe,
                          Vector<Complex, 24>(none.template cast<Complex>()))
                .tangent;
        const Matrix<double, 24> expected = still + moved.imag() / test::complex_step;
        CHECK((expected - still).norm() >= 1e-4 * still.norm());
        CHECK(test::relative_error(step.tangent, expected) <= 1e-13);  // measured 1e-15
        CHECK(test::relative_error(step.force, plain.force) <= 1e-15);
        CHECK(step.energy == plain.energy);
    }
}

TEMPLATE_TEST_CASE("CrossSectionBeam: the predicted force has the stresses of linearised strains",
                   "[element][cross-section][tangent]", Paper, Pointwise, Carried, Transporting) {
    using Complex = std::complex<double>;
    using ComplexVector = Vector<Complex, 24>;
    const Complex i_step(0.0, test::complex_step);
    const auto variant = test::any_variant<TestType>();
    INFO(variant.name);
    const auto element = test::element_of<TestType>(variant);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const Correction given(element, seed);
        const auto &e = given.e, &before = given.before, &change = given.change;
        const auto& none = given.none;
        // no step: the stresses are those of e
        const auto still = element.evaluate(e, e, none);
        CHECK(test::relative_error(still.predicted, still.force) <= 1e-13);

        // a step's stresses are those before it, and their derivative along it
        const auto step = element.evaluate(e, before, change);
        const auto start = element.evaluate(e, before, none);
        const ComplexVector probe = before.template cast<Complex>() + i_step * change;
        const ComplexVector zero = none.template cast<Complex>();
        const ComplexVector moved =
            element.evaluate(ComplexVector(e.template cast<Complex>()), probe, zero).predicted;
        const Vector<double, 24> expected = start.predicted + moved.imag() / test::complex_step;
        CHECK((expected - start.predicted).norm() >= 1e-4 * start.predicted.norm());
        CHECK(test::relative_error(step.predicted, expected) <= 1e-13);

        // at fixed stresses its derivative by e is what the stresses add to the tangent
        Matrix<double, 24> difference;
        for (int k = 0; k < 24; ++k) {
            ComplexVector along = e.template cast<Complex>();
            along[k] += i_step;
            const auto predicted = [&](const Vector<double, 24>& by) {
                return element
                    .evaluate(along, ComplexVector(before.template cast<Complex>()),
                              ComplexVector(by.template cast<Complex>()))
                    .predicted;
            };
            difference.col(k) = (predicted(change) - predicted(none)).imag() / test::complex_step;
        }
        CHECK((step.tangent - start.tangent - difference).norm() <= 1e-13 * start.tangent.norm());
    }
}

}  // namespace cross_section_tangent_test
