// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The checks of every element type, of elements without their type.

#include <element/property_checks.hpp>
#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/dense.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ancf::test {

namespace {

/// Returns the number of rigid-body motions of the straight element: 6 in space, 3 in the plane; 5
/// in space for a line, which has no slopes across to show its turning about itself.
int rigid_motions(const Shape& shape) {
    if (shape.dimension == 2) return 3;
    return shape.fields.contains(Field::r_y) ? 6 : 5;
}

/// Returns the rate of e in a rotation about `axis` through the origin: n x on every vector. In the
/// plane axis has one component.
VectorX rotation_rate(int dimension, const VectorX& e, const Vector<double, 3>& axis) {
    VectorX rate(e.size());
    for (Eigen::Index first = 0; first < e.size(); first += dimension) {
        if (dimension == 3) {
            const Vector<double, 3> v = e.segment<3>(first);
            rate.segment<3>(first) << axis(1) * v(2) - axis(2) * v(1),
                axis(2) * v(0) - axis(0) * v(2), axis(0) * v(1) - axis(1) * v(0);
        } else {
            rate(first) = -axis(2) * e(first + 1);
            rate(first + 1) = axis(2) * e(first);
        }
    }
    return rate;
}

/// A scale for energies of an element: that of its tangent at rest moved by one in a slope.
double stiffness_scale(const AnyElement& element) {
    return element.evaluate(reference_coordinates(element.shape)).tangent.diagonal().maxCoeff();
}

}  // namespace

VectorX rigid_state(const Shape& shape, Random& random, double distance) {
    const MatrixX turn = random_rotation(shape.dimension, random);
    const VectorX shift = distance * shape.length * random.vector(shape.dimension);
    return moved(shape, reference_coordinates(shape), turn, shift);
}

void check_softened(const Shape& shape, const VectorX& reference, bool softens,
                    const std::function<bool(const VectorX&)>& softened) {
    for (const double stretch : {0.1, 0.57, 0.58, 1.0}) {
        VectorX e = reference;
        shape.for_each_vector([&](int, Field field, int first) {
            if (field != Field::r_y && field != Field::r_z)
                e.segment(first, shape.dimension) *= stretch;
        });
        INFO("stretch " << stretch);
        CHECK(softened(e) == (softens && stretch < 0.5774));
    }
}

void check_zero_at_rest(const AnyElement& element) {
    const double scale = stiffness_scale(element);
    CHECK(std::abs(element.energy(reference_coordinates(element.shape))) <= 1e-30 * scale);
    CHECK(element.force(reference_coordinates(element.shape)).norm() <= 1e-15 * scale);
    for (std::uint64_t seed = 0; seed < states; ++seed) {
        Random random(seed);
        const auto e = rigid_state(element.shape, random, 1.0);
        // U is of second order in the rounding of e, Q of first.
        CHECK(std::abs(element.energy(e)) <= 1e-28 * scale);
        CHECK(element.force(e).norm() <= 2e-14 * scale);
    }
}

void check_rigid_invariance(const AnyElement& element, double strain) {
    const int dimension = element.shape.dimension;
    double worst_near = 0.0, worst_far = 0.0;
    for (std::uint64_t seed = 0; seed < states; ++seed) {
        Random random(seed);
        const auto e = deformed_state(element.shape, random, strain);
        const double energy = element.energy(e);
        REQUIRE(energy > 0.0);
        for (const double distance : {1.0, 1e2, 1e4, 1e6}) {
            const auto turn = random_rotation(dimension, random);
            const VectorX shift = distance * element.shape.length * random.direction(dimension);
            const double error =
                std::abs(element.energy(moved(element.shape, e, turn, shift)) / energy - 1.0);
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

void raise(DerivativeErrors& worst, const AnyElement::Evaluated& pass, double energy,
           const VectorX& force, const ComplexElement& stepped, const VectorX& e) {
    const VectorX gradient = complex_step_gradient(stepped.energy, e);
    const MatrixX jacobian = complex_step_jacobian(stepped.force, e);
    const MatrixX transposed = pass.tangent.transpose();
    REQUIRE(gradient.norm() > 0.0);
    worst.force = std::max(worst.force, relative_error(pass.force, gradient));
    worst.tangent = std::max(worst.tangent, relative_error(pass.tangent, jacobian));
    worst.symmetry = std::max(worst.symmetry, relative_error(pass.tangent, transposed));
    worst.pass = std::max(
        {worst.pass, relative_error(force, pass.force), std::abs(energy / pass.energy - 1.0)});
}

void raise(DerivativeErrors& worst, const AnyElement& element, const ComplexElement& stepped,
           const VectorX& e) {
    raise(worst, element.evaluate(e), element.energy(e), element.force(e), stepped, e);
}

void check_derivatives(const AnyElement& element, const ComplexElement& stepped, double strain) {
    DerivativeErrors worst;
    for (std::uint64_t seed = 0; seed < states; ++seed) {
        Random random(seed);
        raise(worst, element, stepped, random_state(element.shape, random, strain));
    }
    CHECK(worst.force <= 1e-12);
    CHECK(worst.tangent <= 1e-12);
    CHECK(worst.symmetry <= 1e-14);
    CHECK(worst.pass <= 1e-14);
}

void check_zero_modes(const AnyElement& element) {
    // Slopes scaled by the length, so that all coordinates are lengths; the least elastic
    // eigenvalue belongs to bending, h^2/l^2 of the largest.
    VectorX scale(element.shape.dofs());
    element.shape.for_each_vector([&](int, Field field, int first) {
        scale.segment(first, element.shape.dimension)
            .setConstant(std::pow(element.shape.length, length_power(field) - 1));
    });
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Random random(seed);
        const auto e = rigid_state(element.shape, random, seed == 0 ? 0.0 : 1.0);
        MatrixX tangent = element.evaluate(e).tangent;
        tangent = scale.asDiagonal() * tangent * scale.asDiagonal();
        VectorX values = eigenvalues(tangent);
        values /= values.maxCoeff();
        CHECK(values.head(rigid_motions(element.shape)).cwiseAbs().maxCoeff() <= 1e-13);
        CHECK(values(rigid_motions(element.shape)) >= 1e-9);
    }
}

void check_turning(const AnyElement& element) {
    const int dimension = element.shape.dimension;
    double worst = 0.0;
    double moved = 0.0;
    for (std::uint64_t seed = 0; seed < states; ++seed) {
        Random random(seed);
        const auto e = random_state(element.shape, random);
        const auto evaluation = element.evaluate(e);
        const Vector<double, 3> axis =
            dimension == 3 ? random.direction<3>() : Vector<double, 3>(0.0, 0.0, 1.0);
        const auto left = (evaluation.tangent * rotation_rate(dimension, e, axis)).eval();
        const auto right = rotation_rate(dimension, evaluation.force, axis);
        // relative to the terms of the product, which cancel
        worst = std::max(worst, (left - right).norm() / (evaluation.tangent.norm() * e.norm()));
        const VectorX along = random.direction(dimension);
        VectorX translation = VectorX::Zero(element.shape.dofs());
        element.shape.for_each_vector([&](int, Field field, int first) {
            if (field == Field::r) translation.segment(first, dimension) = along;
        });
        moved = std::max(moved, (evaluation.tangent * translation).norm() /
                                    (evaluation.tangent.norm() * translation.norm()));
    }
    CHECK(worst <= 1e-12);
    CHECK(moved <= 1e-12);
}

void check_mass(const AnyElement& element, double density, const Moments& m) {
    const int dimension = element.shape.dimension;
    const auto mass = element.mass();
    CHECK(relative_error(mass, mass.transpose().eval()) <= 1e-15);
    CHECK(eigenvalues(mass).minCoeff() > 0.0);

    // second moments of the mass about the reference's origin, axes along the bar
    const double l = element.shape.length, line = density * l;
    Matrix<double, 3> second;
    second << m.area * l * l / 3.0, m.y * l / 2.0, m.z * l / 2.0, m.y * l / 2.0, m.yy, m.yz,
        m.z * l / 2.0, m.yz, m.zz;
    second *= line;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Random random(seed);
        const auto turn = random_rotation(dimension, random);
        const auto e = moved(element.shape, reference_coordinates(element.shape), turn,
                             VectorX::Zero(dimension));
        VectorX shift = VectorX::Zero(element.shape.dofs());
        const VectorX direction = random.direction(dimension);
        element.shape.for_each_vector([&](int, Field field, int first) {
            if (field == Field::r) shift.segment(first, dimension) = direction;
        });
        CHECK(shift.dot(mass * shift) == Approx(line * m.area).epsilon(1e-13));
        const Vector<double, 3> axis =
            dimension == 3 ? random.direction<3>() : Vector<double, 3>(0.0, 0.0, 1.0);
        const auto rate = rotation_rate(dimension, e, axis);
        Matrix<double, 3> inertia;
        if (dimension == 3) {
            const Matrix<double, 3> turned = turn * second * turn.transpose();
            inertia = turned.trace() * Matrix<double, 3>::Identity() - turned;
        } else {
            inertia = (second(0, 0) + second(1, 1)) * Matrix<double, 3>::Identity();
        }
        CHECK(rate.dot(mass * rate) == Approx(axis.dot(inertia * axis)).epsilon(1e-13));
    }
}

void check_gravity(const AnyElement& element, double density, const Moments& m) {
    const int dimension = element.shape.dimension;
    Random random(7);
    const VectorX g = 9.81 * random.direction(dimension);
    const auto force = element.gravity(g);
    const auto turn = random_rotation(dimension, random);
    const VectorX shift = random.vector(dimension);
    const auto e = moved(element.shape, reference_coordinates(element.shape), turn, shift);
    const double weight = density * m.area * element.shape.length;
    VectorX sum = VectorX::Zero(dimension);
    element.shape.for_each_vector([&](int, Field field, int first) {
        if (field == Field::r) sum += force.segment(first, dimension);
    });
    CHECK((sum - weight * g).norm() <= 1e-13 * weight * g.norm());
    VectorX centre = VectorX::Zero(dimension);
    centre(0) = element.shape.length / 2.0;
    centre(1) = m.y / m.area;
    if (dimension == 3) centre(2) = m.z / m.area;
    // The body is linear in e: the work on e itself is that on the centre of mass.
    CHECK(force.dot(e) == Approx(weight * g.dot(turn * centre + shift)).epsilon(1e-12));
}

void check_planar(const AnyElement& element) {
    REQUIRE(element.shape.dimension == 3);
    for (std::uint64_t seed = 0; seed < states; ++seed) {
        Random random(seed);
        auto e = deformed_state(element.shape, random);
        element.shape.for_each_vector([&](int, Field field, int first) {
            e(first + 2) = field == Field::r_z ? 1.0 : 0.0;
            if (field == Field::r_z) e(first) = e(first + 1) = 0.0;
        });
        const Vector<double, 3> normal(0.0, 0.0, random.uniform(-3.0, 3.0));
        e = moved(element.shape, e, rotation(normal), Vector<double, 3>(0.3, -0.2, 0.0));
        const auto evaluation = element.evaluate(e);
        double out = 0.0, coupling = 0.0;
        element.shape.for_each_vector([&](int, Field field, int first) {
            for (int k = 0; k < 3; ++k) {
                const bool outside = (k == 2) != (field == Field::r_z);
                if (!outside) continue;
                out = std::max(out, std::abs(evaluation.force(first + k)));
                element.shape.for_each_vector([&](int, Field other, int column) {
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

void check_admissible(const AnyElement& element) {
    Random random(5);
    const auto e = random_state(element.shape, random, 0.2);
    CHECK(element.admissible(e));
    for (int i = 0; i < element.shape.dofs(); ++i) {
        auto broken = e;
        broken(i) = std::numeric_limits<double>::quiet_NaN();
        CHECK_FALSE(element.admissible(broken));
        broken(i) = std::numeric_limits<double>::infinity();
        CHECK_FALSE(element.admissible(broken));
    }
    int slopes = 0;
    element.shape.for_each_vector([&](int node, Field field, int first) {
        if (field != Field::r_y && field != Field::r_z) return;
        const int dimension = element.shape.dimension;
        auto broken = e;
        broken.segment(first, dimension).setZero();
        CHECK_FALSE(element.admissible(broken));
        const int tangent = dimension * (node * element.shape.fields.count() +
                                         element.shape.fields.rank(Field::r_x));
        broken.segment(first, dimension) =
            0.7 * e.segment(tangent, dimension) + 1e-8 * random.vector(dimension);
        CHECK_FALSE(element.admissible(broken));
        ++slopes;
    });
    CHECK(slopes > 0);
}

}  // namespace ancf::test
