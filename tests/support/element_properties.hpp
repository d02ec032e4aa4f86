// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What must hold for every element type: one list of checks, run over each of them.
///
/// An element has `dimension`, `dofs`, `fields`, `length()`, `energy`, `force`, `evaluate`, `mass`,
/// `gravity` and `admissible`; its straight reference along e_x is
/// test::reference_coordinates(element).

#pragma once

#include <ancf/section/moments.hpp>
#include <ancf/types.hpp>

#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/random_state.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace ancf::test {

inline constexpr std::uint64_t states = 100;

/// Nodal coordinates of an element.
template <class Element>
using Coordinates = Vector<double, Element::dofs>;

/// Returns the number of rigid-body motions of the straight element: 6 in space, 3 in the plane; 5
/// in space for a line, which has no slopes across to show its turning about itself.
template <class Element>
constexpr int rigid_motions() {
    if (Element::dimension == 2) return 3;
    return Element::fields.contains(Field::r_y) ? 6 : 5;
}

/// Returns the rate of e in a rotation about `axis` through the origin: n x on every vector. In the
/// plane axis has one component.
template <class Element>
[[nodiscard]] Coordinates<Element> rotation_rate(const Coordinates<Element>& e,
                                                 const Vector<double, 3>& axis) {
    constexpr int dimension = Element::dimension;
    Coordinates<Element> rate;
    for (int first = 0; first < Element::dofs; first += dimension) {
        if constexpr (dimension == 3) {
            const Vector<double, 3> v = e.template segment<3>(first);
            rate.template segment<3>(first) << axis(1) * v(2) - axis(2) * v(1),
                axis(2) * v(0) - axis(0) * v(2), axis(0) * v(1) - axis(1) * v(0);
        } else {
            rate(first) = -axis(2) * e(first + 1);
            rate(first + 1) = axis(2) * e(first);
        }
    }
    return rate;
}

/// Returns a rigid motion of the reference: random rotation, shift of up to `distance` lengths.
template <class Element>
[[nodiscard]] Coordinates<Element> rigid_state(const Element& element, Random& random,
                                               double distance) {
    constexpr int dimension = Element::dimension;
    const auto turn = random_rotation<dimension>(random);
    const Vector<double, dimension> shift =
        distance * element.length() * random.vector<dimension>();
    return moved<Element>(reference_coordinates(element), turn, shift);
}

/// Checks that an element tells when its line is shorter than 1/sqrt(3) of its length, and that one
/// whose law does not soften never does.
template <class Element>
void check_softened(const Element& element, const Coordinates<Element>& reference, bool softens) {
    for (const double stretch : {0.1, 0.57, 0.58, 1.0}) {
        Coordinates<Element> e = reference;
        for_each_vector<Element>([&](int, Field field, int first) {
            if (field != Field::r_y && field != Field::r_z)
                e.template segment<Element::dimension>(first) *= stretch;
        });
        INFO("stretch " << stretch);
        CHECK(element.softened(e) == (softens && stretch < 0.5774));
    }
}

/// A scale for energies of an element: that of its tangent at rest moved by one in a slope.
template <class Element>
[[nodiscard]] double stiffness_scale(const Element& element) {
    return element.evaluate(reference_coordinates(element)).tangent.diagonal().maxCoeff();
}

/// At rest, and in any rigid motion of it, energy and force vanish.
template <class Element>
void check_zero_at_rest(const Element& element) {
    const double scale = stiffness_scale(element);
    CHECK(std::abs(element.energy(reference_coordinates(element))) <= 1e-30 * scale);
    CHECK(element.force(reference_coordinates(element)).norm() <= 1e-15 * scale);
    for (std::uint64_t seed = 0; seed < states; ++seed) {
        Random random(seed);
        const auto e = rigid_state(element, random, 1.0);
        // U is of second order in the rounding of e, Q of first.
        CHECK(std::abs(element.energy(e)) <= 1e-28 * scale);
        CHECK(element.force(e).norm() <= 2e-14 * scale);
    }
}

/// The energy does not change in a rigid motion: to 1e-12 within one length, and far away to what
/// the rounding of the positions leaves, 10 eps D/largest strain for a distance of D lengths.
template <class Element>
void check_rigid_invariance(const Element& element, double strain = 0.3) {
    constexpr int dimension = Element::dimension;
    double worst_near = 0.0, worst_far = 0.0;
    for (std::uint64_t seed = 0; seed < states; ++seed) {
        Random random(seed);
        const auto e = deformed_state(element, random, strain);
        const double energy = element.energy(e);
        REQUIRE(energy > 0.0);
        for (const double distance : {1.0, 1e2, 1e4, 1e6}) {
            const auto turn = random_rotation<dimension>(random);
            const Vector<double, dimension> shift =
                distance * element.length() * random.direction<dimension>();
            const double error =
                std::abs(element.energy(moved<Element>(e, turn, shift)) / energy - 1.0);
            if (distance == 1.0) {
                worst_near = std::max(worst_near, error);
            } else {
                worst_far = std::max(worst_far, error / distance);
            }
        }
    }
    CHECK(worst_near <= 1e-12);
    CHECK(worst_far <= 10.0 * std::numeric_limits<double>::epsilon() / strain);
}

/// Force and tangent are the first and second derivative of the energy, to round-off; one pass and
/// separate functions agree; the tangent is symmetric.
template <class Element>
void check_derivatives(const Element& element, double strain = 0.3) {
    double force = 0.0, tangent = 0.0, symmetry = 0.0, pass = 0.0;
    for (std::uint64_t seed = 0; seed < states; ++seed) {
        Random random(seed);
        const auto e = random_state(element, random, strain);
        const auto evaluation = element.evaluate(e);
        const auto gradient =
            complex_step_gradient([&](const auto& z) { return element.energy(z); }, e);
        const auto jacobian =
            complex_step_jacobian([&](const auto& z) { return element.force(z); }, e);
        REQUIRE(gradient.norm() > 0.0);
        force = std::max(force, relative_error(evaluation.force, gradient));
        tangent = std::max(tangent, relative_error(evaluation.tangent, jacobian));
        symmetry = std::max(
            symmetry, relative_error(evaluation.tangent, evaluation.tangent.transpose().eval()));
        pass = std::max({pass, relative_error(element.force(e), evaluation.force),
                         std::abs(element.energy(e) / evaluation.energy - 1.0)});
    }
    CHECK(force <= 1e-12);
    CHECK(tangent <= 1e-12);
    CHECK(symmetry <= 1e-14);
    CHECK(pass <= 1e-14);
}

/// The tangent of a stress-free state has exactly as many zero eigenvalues as rigid motions, and no
/// negative one.
template <class Element>
void check_zero_modes(const Element& element) {
    // Slopes scaled by the length, so that all coordinates are lengths; the least elastic
    // eigenvalue belongs to bending, h^2/l^2 of the largest.
    Coordinates<Element> scale;
    for_each_vector<Element>([&](int, Field field, int first) {
        scale.template segment<Element::dimension>(first).setConstant(
            std::pow(element.length(), length_power(field) - 1));
    });
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Random random(seed);
        const auto e = rigid_state(element, random, seed == 0 ? 0.0 : 1.0);
        Matrix<double, Element::dofs> tangent = element.evaluate(e).tangent;
        tangent = scale.asDiagonal() * tangent * scale.asDiagonal();
        const Eigen::SelfAdjointEigenSolver<Matrix<double, Element::dofs>> modes(tangent);
        const auto values = (modes.eigenvalues() / modes.eigenvalues().maxCoeff()).eval();
        CHECK(values.head(rigid_motions<Element>()).cwiseAbs().maxCoeff() <= 1e-13);
        CHECK(values(rigid_motions<Element>()) >= 1e-9);
    }
}

/// Turning the element turns its force, K (n x e) = n x Q, and moving it changes nothing, also at
/// stressed states.
template <class Element>
void check_turning(const Element& element) {
    double worst = 0.0;
    double moved = 0.0;
    for (std::uint64_t seed = 0; seed < states; ++seed) {
        Random random(seed);
        const auto e = random_state(element, random);
        const auto evaluation = element.evaluate(e);
        const Vector<double, 3> axis =
            Element::dimension == 3 ? random.direction<3>() : Vector<double, 3>(0.0, 0.0, 1.0);
        const auto left = (evaluation.tangent * rotation_rate<Element>(e, axis)).eval();
        const auto right = rotation_rate<Element>(evaluation.force, axis);
        // relative to the terms of the product, which cancel
        worst = std::max(worst, (left - right).norm() / (evaluation.tangent.norm() * e.norm()));
        const auto along = random.direction<Element::dimension>();
        typename Element::Coordinates translation = Element::Coordinates::Zero();
        for_each_vector<Element>([&](int, Field field, int first) {
            if (field == Field::r) translation.template segment<Element::dimension>(first) = along;
        });
        moved = std::max(moved, (evaluation.tangent * translation).norm() /
                                    (evaluation.tangent.norm() * translation.norm()));
    }
    CHECK(worst <= 1e-12);
    CHECK(moved <= 1e-12);
}

/// The mass is symmetric, positive definite, and gives the translational and rotary inertia of a
/// straight bar of the given moments, in any orientation.
/// @param density  kg/m^3
template <class Element>
void check_mass(const Element& element, double density, const Moments& m) {
    constexpr int dimension = Element::dimension;
    const auto mass = element.mass();
    CHECK(relative_error(mass, mass.transpose().eval()) <= 1e-15);
    const Eigen::SelfAdjointEigenSolver<Matrix<double, Element::dofs>> modes(mass);
    CHECK(modes.eigenvalues().minCoeff() > 0.0);

    // second moments of the mass about the reference's origin, axes along the bar
    const double l = element.length(), line = density * l;
    Matrix<double, 3> second;
    second << m.area * l * l / 3.0, m.y * l / 2.0, m.z * l / 2.0, m.y * l / 2.0, m.yy, m.yz,
        m.z * l / 2.0, m.yz, m.zz;
    second *= line;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Random random(seed);
        const auto turn = random_rotation<dimension>(random);
        const auto e =
            moved<Element>(reference_coordinates(element), turn, Vector<double, dimension>::Zero());
        Coordinates<Element> shift = Coordinates<Element>::Zero();
        const Vector<double, dimension> direction = random.direction<dimension>();
        for_each_vector<Element>([&](int, Field field, int first) {
            if (field == Field::r) shift.template segment<dimension>(first) = direction;
        });
        CHECK(shift.dot(mass * shift) == Approx(line * m.area).epsilon(1e-13));
        const Vector<double, 3> axis =
            dimension == 3 ? random.direction<3>() : Vector<double, 3>(0.0, 0.0, 1.0);
        const auto rate = rotation_rate<Element>(e, axis);
        Matrix<double, 3> inertia;
        if constexpr (dimension == 3) {
            const Matrix<double, 3> turned = turn * second * turn.transpose();
            inertia = turned.trace() * Matrix<double, 3>::Identity() - turned;
        } else {
            inertia = (second(0, 0) + second(1, 1)) * Matrix<double, 3>::Identity();
        }
        CHECK(rate.dot(mass * rate) == Approx(axis.dot(inertia * axis)).epsilon(1e-13));
    }
}

/// Gravity does the work of the weight in translations, and that of the weight at the centre of
/// mass in rotations.
template <class Element>
void check_gravity(const Element& element, double density, const Moments& m) {
    constexpr int dimension = Element::dimension;
    Random random(7);
    const Vector<double, dimension> g = 9.81 * random.direction<dimension>();
    const auto force = element.gravity(g);
    const auto turn = random_rotation<dimension>(random);
    const Vector<double, dimension> shift = random.vector<dimension>();
    const auto e = moved<Element>(reference_coordinates(element), turn, shift);
    const double weight = density * m.area * element.length();
    Vector<double, dimension> sum = Vector<double, dimension>::Zero();
    for_each_vector<Element>([&](int, Field field, int first) {
        if (field == Field::r) sum += force.template segment<dimension>(first);
    });
    CHECK((sum - weight * g).norm() <= 1e-13 * weight * g.norm());
    Vector<double, dimension> centre = Vector<double, dimension>::Zero();
    centre(0) = element.length() / 2.0;
    centre(1) = m.y / m.area;
    if constexpr (dimension == 3) centre(2) = m.z / m.area;
    // The body is linear in e: the work on e itself is that on the centre of mass.
    CHECK(force.dot(e) == Approx(weight * g.dot(turn * centre + shift)).epsilon(1e-12));
}

/// A state in the plane of x and y, the z slopes along z, has no force out of it.
template <class Element>
void check_planar(const Element& element) {
    static_assert(Element::dimension == 3);
    for (std::uint64_t seed = 0; seed < states; ++seed) {
        Random random(seed);
        auto e = deformed_state(element, random);
        for_each_vector<Element>([&](int, Field field, int first) {
            e(first + 2) = field == Field::r_z ? 1.0 : 0.0;
            if (field == Field::r_z) e(first) = e(first + 1) = 0.0;
        });
        const Vector<double, 3> normal(0.0, 0.0, random.uniform(-3.0, 3.0));
        e = moved<Element>(e, rotation(normal), Vector<double, 3>(0.3, -0.2, 0.0));
        const auto evaluation = element.evaluate(e);
        double out = 0.0, coupling = 0.0;
        for_each_vector<Element>([&](int, Field field, int first) {
            for (int k = 0; k < 3; ++k) {
                const bool outside = (k == 2) != (field == Field::r_z);
                if (!outside) continue;
                out = std::max(out, std::abs(evaluation.force(first + k)));
                for_each_vector<Element>([&](int, Field other, int column) {
                    for (int j = 0; j < 3; ++j) {
                        if ((j == 2) == (other == Field::r_z)) {
                            coupling = std::max(
                                coupling, std::abs(evaluation.tangent(first + k, column + j)));
                        }
                    }
                });
            }
        });
        CHECK(out <= 1e-14 * evaluation.force.norm());
        CHECK(coupling <= 1e-14 * evaluation.tangent.norm());
    }
}

/// Elements refuse what has no strain: no number, a slope of no length or along the tangent.
template <class Element>
void check_admissible(const Element& element) {
    Random random(5);
    const auto e = random_state(element, random, 0.2);
    CHECK(element.admissible(e));
    for (int i = 0; i < Element::dofs; ++i) {
        auto broken = e;
        broken(i) = std::numeric_limits<double>::quiet_NaN();
        CHECK_FALSE(element.admissible(broken));
        broken(i) = std::numeric_limits<double>::infinity();
        CHECK_FALSE(element.admissible(broken));
    }
    int slopes = 0;
    for_each_vector<Element>([&](int node, Field field, int first) {
        if (field != Field::r_y && field != Field::r_z) return;
        constexpr int dimension = Element::dimension;
        auto broken = e;
        broken.template segment<dimension>(first).setZero();
        CHECK_FALSE(element.admissible(broken));
        const int tangent =
            dimension * (node * Element::fields.count() + Element::fields.rank(Field::r_x));
        broken.template segment<dimension>(first) =
            0.7 * e.template segment<dimension>(tangent) + 1e-8 * random.vector<dimension>();
        CHECK_FALSE(element.admissible(broken));
        ++slopes;
    });
    CHECK(slopes > 0);
}

}  // namespace ancf::test
