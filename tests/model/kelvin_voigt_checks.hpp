// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What Kelvin and Voigt's damping of one element of any type keeps: derivatives, rigid motions,
/// closed forms.

#pragma once

#include <ancf/model/loads/damping.hpp>
#include <ancf/section/section.hpp>

#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <complex>
#include <limits>
#include <memory>

namespace ancf::test::kelvin_voigt {

inline constexpr double young = 2e7, side = 0.1, span = 0.7, eta = 0.3;
inline constexpr int states = 20;

/// Returns an element whose dampers are checked.
template <class Element>
std::shared_ptr<const Element> damped_element() {
    return std::make_shared<const Element>(Material::from_moduli(young, 0.8e7, 7800.0),
                                           rectangle(side, side), span);
}

/// Returns its damper.
template <class Element>
KelvinVoigt<Element> damper() {
    return {damped_element<Element>(), {}, eta};
}

/// Returns force and derivatives at e with the rates v.
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
Vector<double, Element::dofs> rigid_rates(const Vector<double, Element::dofs>& e, Random& random) {
    constexpr int dimension = Element::dimension;
    Matrix<double, dimension> spin = Matrix<double, dimension>::Zero();
    const Vector<double, dimension> speed = random.vector<dimension>();
    if constexpr (dimension == 2) {
        spin << 0.0, -1.0, 1.0, 0.0;
    } else {
        const Vector<double, 3> w = random.direction<3>();
        spin << 0.0, -w[2], w[1], w[2], 0.0, -w[0], -w[1], w[0], 0.0;
    }
    return moved<Element>(e, spin, speed);
}

/// Derivatives equal the complex step of the force.
template <class Element>
void check_derivatives() {
    constexpr int n = Element::dofs;
    const auto damping = damper<Element>();
    Random random(61);
    double by_q = 0.0, by_v = 0.0, lack = 0.0;
    for (int k = 0; k < states; ++k) {
        const Vector<double, n> e = random_state(*damped_element<Element>(), random);
        const Vector<double, n> v = random.vector<n>();
        const LoadResult out = evaluate(damping, e, v);
        const auto force = [&](const auto& x, const auto& y) {
            using Scalar = std::complex<double>;
            return damping.template force<Scalar>(x.template cast<Scalar>(),
                                                  y.template cast<Scalar>());
        };
        const auto of_q = [&](const auto& x) { return force(x, v); };
        const auto of_v = [&](const auto& x) { return force(e, x); };
        by_q = std::max(by_q, relative_error(out.stiffness, complex_step_jacobian(of_q, e)));
        by_v = std::max(by_v, relative_error(out.damping, complex_step_jacobian(of_v, v)));
        lack = std::max(lack, (out.damping - out.damping.transpose()).norm() / out.damping.norm());
    }
    INFO("by q " << by_q << ", by v " << by_v << ", lack of symmetry " << lack);
    CHECK(by_q <= 1e-12);  // both are exact: round-off of about 1e-15
    CHECK(by_v <= 1e-12);
    CHECK(lack <= 1e-13);
}

/// Rigid motions of a deformed element meet no force; other motions lose power.
template <class Element>
void check_rigid_motions() {
    constexpr int n = Element::dofs, node = n / 2, dimension = Element::dimension;
    const auto damping = damper<Element>();
    Random random(62);
    double most = 0.0, resultant = 0.0, power = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < states; ++k) {
        const Vector<double, n> e = random_state(*damped_element<Element>(), random);
        const Vector<double, n> v = rigid_rates<Element>(e, random), any = random.vector<n>();
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

/// Free of stress the force is that of eta K v, however turned.
template <class Element>
void check_force_at_rest() {
    constexpr int n = Element::dofs, dimension = Element::dimension;
    const auto free = damped_element<Element>();
    Random random(63);
    for (int k = 0; k < states; ++k) {
        const Vector<double, n> e =
            moved<Element>(reference_coordinates(*free), random_rotation<dimension>(random),
                           random.vector<dimension>());
        const Vector<double, n> v = random.vector<n>();
        const Vector<double, n> expected = -eta * free->evaluate(e).tangent * v;
        CHECK(relative_error(evaluate(damper<Element>(), e, v).force, expected) <= 1e-12);
    }
}

/// A bar being stretched dissipates eta E A l times the square of its strain rate.
template <class Element>
void check_stretching() {
    constexpr int n = Element::dofs, dimension = Element::dimension;
    const double stretch = 1.4, rate = 0.6;
    const auto bar = damped_element<Element>();
    const Vector<double, n> rest = reference_coordinates(*bar);
    Vector<double, n> along = Vector<double, n>::Zero();  // r and r_x of the stretched line
    for_each_vector<Element>([&](int, Field field, int first) {
        if (field == Field::r || field == Field::r_x)
            along.template segment<dimension>(first) = rest.template segment<dimension>(first);
    });
    const Vector<double, n> e = rest + (stretch - 1.0) * along, v = rate * along;
    const double strain_rate = stretch * rate;  // of (stretch^2 - 1)/2
    const double expected = eta * young * side * side * span * strain_rate * strain_rate;
    CHECK(-evaluate(damper<Element>(), e, v).force.dot(v) == Approx(expected).epsilon(1e-12));
}

}  // namespace ancf::test::kelvin_voigt
