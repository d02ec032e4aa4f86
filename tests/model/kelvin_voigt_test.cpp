// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Kelvin and Voigt's damping of one element of every type: derivatives, rigid motions, closed
/// forms.

#include <ancf/element/cable.hpp>
#include <ancf/element/continuum_beam.hpp>
#include <ancf/element/cross_section_beam.hpp>
#include <ancf/element/planar_beam.hpp>
#include <ancf/element/torsion_beam.hpp>
#include <ancf/model/damping.hpp>
#include <ancf/section/section.hpp>

#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <limits>
#include <memory>
#include <type_traits>

#define EVERY_ELEMENT                                                                         \
    CrossSectionBeam<2>, CrossSectionBeam<3>, (CrossSectionBeam<3, Geodesic>),                \
        (CrossSectionBeam<3, Projected, PointwiseShear>), ContinuumBeam<2>, ContinuumBeam<3>, \
        TorsionBeam, Cable<2>, (Cable<2, EngineeringAxial>), Cable<3>

namespace {

using namespace ancf;

constexpr double young = 2e7, side = 0.1, span = 0.7, eta = 0.3;
constexpr int states = 20;

template <class Element>
std::shared_ptr<const Element> element() {
    return std::make_shared<const Element>(Material::from_moduli(young, 0.8e7, 7800.0),
                                           rectangle(side, side), span);
}

template <class Element>
KelvinVoigt<Element> damper() {
    return {element<Element>(), {}, eta};
}

template <class Element>
LoadResult evaluate(const KelvinVoigt<Element>& damping, const Vector<double, Element::dofs>& e,
                    const Vector<double, Element::dofs>& v) {
    constexpr int n = Element::dofs;
    LoadResult out{VectorX::Zero(n), MatrixX::Zero(n, n), MatrixX::Zero(n, n), 0.0};
    damping.evaluate({e, v, 0.0}, out);
    return out;
}

/// Returns the rates of a rigid motion: a random spin of the size 1 and a random speed.
template <class Element>
Vector<double, Element::dofs> rigid_rates(const Vector<double, Element::dofs>& e,
                                          test::Random& random) {
    constexpr int dimension = Element::dimension;
    Matrix<double, dimension> spin = Matrix<double, dimension>::Zero();
    const Vector<double, dimension> speed = random.vector<dimension>();
    if constexpr (dimension == 2) {
        spin << 0.0, -1.0, 1.0, 0.0;
    } else {
        const Vector<double, 3> w = random.direction<3>();
        spin << 0.0, -w[2], w[1], w[2], 0.0, -w[0], -w[1], w[0], 0.0;
    }
    return test::moved<Element>(e, spin, speed);
}

}  // namespace

TEMPLATE_TEST_CASE("KelvinVoigt: derivatives equal the complex step of the force",
                   "[model][damping]", EVERY_ELEMENT) {
    constexpr int n = TestType::dofs;
    const auto damping = damper<TestType>();
    test::Random random(61);
    double by_q = 0.0, by_v = 0.0, lack = 0.0;
    for (int k = 0; k < states; ++k) {
        const Vector<double, n> e = test::random_state(*element<TestType>(), random);
        const Vector<double, n> v = random.vector<n>();
        const LoadResult out = evaluate(damping, e, v);
        const auto force = [&](const auto& x, const auto& y) {
            using Scalar = std::complex<double>;
            return damping.template force<Scalar>(x.template cast<Scalar>(),
                                                  y.template cast<Scalar>());
        };
        const auto of_q = [&](const auto& x) { return force(x, v); };
        const auto of_v = [&](const auto& x) { return force(e, x); };
        by_q = std::max(by_q,
                        test::relative_error(out.stiffness, test::complex_step_jacobian(of_q, e)));
        by_v =
            std::max(by_v, test::relative_error(out.damping, test::complex_step_jacobian(of_v, v)));
        lack = std::max(lack, (out.damping - out.damping.transpose()).norm() / out.damping.norm());
    }
    INFO("by q " << by_q << ", by v " << by_v << ", lack of symmetry " << lack);
    CHECK(by_q <= 1e-12);  // both are exact: round-off of about 1e-15
    CHECK(by_v <= 1e-12);
    CHECK(lack <= 1e-13);
}

TEMPLATE_TEST_CASE("KelvinVoigt: rigid motions of a deformed element meet no force",
                   "[model][damping]", EVERY_ELEMENT) {
    constexpr int n = TestType::dofs, node = n / 2, dimension = TestType::dimension;
    const auto damping = damper<TestType>();
    test::Random random(62);
    double most = 0.0, resultant = 0.0, power = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < states; ++k) {
        const Vector<double, n> e = test::random_state(*element<TestType>(), random);
        const Vector<double, n> v = rigid_rates<TestType>(e, random), any = random.vector<n>();
        const LoadResult out = evaluate(damping, e, v);
        most = std::max(most, out.force.norm() / (out.damping.norm() * v.norm()));
        const VectorX force = evaluate(damping, e, any).force;
        // no work on rigid motions: neither a resultant nor a moment
        resultant = std::max(resultant, std::abs(force.dot(v)) / (force.norm() * v.norm()));
        const Vector<double, dimension> sum =
            force.segment<dimension>(0) + force.segment<dimension>(node);
        resultant = std::max(resultant, sum.norm() / force.norm());
        power = std::max(power, force.dot(any));
    }
    INFO("force " << most << ", resultant " << resultant << ", power " << power);
    CHECK(most <= 1e-13);
    CHECK(resultant <= 1e-12);
    CHECK(power < 0.0);
}

TEMPLATE_TEST_CASE("KelvinVoigt: free of stress the force is that of eta K v, however turned",
                   "[model][damping]", EVERY_ELEMENT) {
    constexpr int n = TestType::dofs, dimension = TestType::dimension;
    const auto free = element<TestType>();
    test::Random random(63);
    for (int k = 0; k < states; ++k) {
        const Vector<double, n> e = test::moved<TestType>(test::reference_coordinates(*free),
                                                          test::random_rotation<dimension>(random),
                                                          random.vector<dimension>());
        Vector<double, n> v = random.vector<n>();
        if constexpr (std::is_same_v<TestType, Cable<3>>) {  // axial strain alone: v along the line
            const Vector<double, 3> t = e.template segment<3>(3);
            for (int at = 0; at < n; at += 3)
                v.template segment<3>(at) = t * t.dot(Vector<double, 3>(v.template segment<3>(at)));
        }
        const Vector<double, n> expected = -eta * free->evaluate(e).tangent * v;
        CHECK(test::relative_error(evaluate(damper<TestType>(), e, v).force, expected) <= 1e-12);
    }
}

TEMPLATE_TEST_CASE(
    "KelvinVoigt: a bar being stretched dissipates eta E A l times the square of its "
    "strain rate",
    "[model][damping]", CrossSectionBeam<2>, CrossSectionBeam<3>, ContinuumBeam<2>,
    ContinuumBeam<3>, TorsionBeam, Cable<2>, Cable<3>) {
    constexpr int n = TestType::dofs, dimension = TestType::dimension;
    const double stretch = 1.4, rate = 0.6;
    const auto bar = element<TestType>();
    const Vector<double, n> rest = test::reference_coordinates(*bar);
    Vector<double, n> along = Vector<double, n>::Zero();  // r and r_x of the stretched line
    test::for_each_vector<TestType>([&](int, Field field, int first) {
        if (field == Field::r || field == Field::r_x)
            along.template segment<dimension>(first) = rest.template segment<dimension>(first);
    });
    const Vector<double, n> e = rest + (stretch - 1.0) * along, v = rate * along;
    const double strain_rate = stretch * rate;  // of (stretch^2 - 1)/2
    const double expected = eta * young * side * side * span * strain_rate * strain_rate;
    CHECK(-evaluate(damper<TestType>(), e, v).force.dot(v) == Approx(expected).epsilon(1e-12));
}

TEST_CASE("KelvinVoigt: values that cannot be meant are refused", "[model][damping][bad-input]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double value : {-1.0, nan, std::numeric_limits<double>::infinity()})
        CHECK_THROWS_AS(KelvinVoigt<Cable<2>>(element<Cable<2>>(), {}, value), InvalidArgument);
}
