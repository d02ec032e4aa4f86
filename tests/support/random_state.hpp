// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Seeded random rotations, motions and deformed states for any element type.
///
/// An element type has `dimension`, `dofs`, `fields` and `length()`; its nodal coordinates are
/// vectors in Field order, node by node. The generator is our own, so that a seed means the same
/// everywhere.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/types.hpp>

#include <cmath>
#include <cstdint>

namespace ancf::test {

/// The SplitMix64 generator.
class Random {
public:
    explicit Random(std::uint64_t seed) noexcept : state_(seed) { next(), next(); }

    /// Returns a number uniform in [low, high).
    double uniform(double low, double high) noexcept {
        return low + (high - low) * static_cast<double>(next() >> 11U) * 0x1.0p-53;
    }

    /// Returns a vector uniform in the cube [-1, 1)^N.
    template <int N>
    Vector<double, N> vector() noexcept {
        Vector<double, N> v;
        for (int i = 0; i < N; ++i) v(i) = uniform(-1.0, 1.0);
        return v;
    }

    /// Returns a unit vector, uniform on the sphere.
    template <int N>
    Vector<double, N> direction() noexcept {
        for (;;) {
            const Vector<double, N> v = vector<N>();
            const double norm = v.norm();
            if (norm > 0.1 && norm < 1.0) return v / norm;
        }
    }

private:
    std::uint64_t next() noexcept {
        std::uint64_t z = (state_ += 0x9E3779B97F4A7C15U);
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31U);
    }

    std::uint64_t state_;
};

/// Returns the rotation by |v| about v (three dimensions), by Rodrigues' formula.
[[nodiscard]] inline Matrix<double, 3> rotation(const Vector<double, 3>& v) {
    const double angle = v.norm();
    Matrix<double, 3> result = Matrix<double, 3>::Identity();
    if (angle == 0.0) return result;
    Matrix<double, 3> k;
    k << 0.0, -v(2), v(1), v(2), 0.0, -v(0), -v(1), v(0), 0.0;
    k /= angle;
    return result + std::sin(angle) * k + (1.0 - std::cos(angle)) * k * k;
}

/// Returns the rotation by an angle in the plane.
[[nodiscard]] inline Matrix<double, 2> rotation(double angle) {
    Matrix<double, 2> result;
    result << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    return result;
}

/// Returns a rotation of up to `angle` radians about a random axis.
template <int Dimension>
[[nodiscard]] Matrix<double, Dimension> random_rotation(Random& random,
                                                        double angle = 3.14159265358979) {
    if constexpr (Dimension == 2) {
        return rotation(random.uniform(-angle, angle));
    } else {
        return rotation(Vector<double, 3>(random.uniform(0.0, angle) * random.direction<3>()));
    }
}

/// Returns the unit vector along which a field of the straight reference points: e_x, e_y, e_z of
/// slopes, 0 of the others.
template <int Dimension>
[[nodiscard]] Vector<double, Dimension> reference_direction(Field field) {
    return length_power(field) != 0
               ? Vector<double, Dimension>::Zero().eval()
               : Vector<double, Dimension>::Unit(static_cast<int>(field) - 1).eval();
}

/// Calls visit(node, field, first coordinate) for every vector of an element.
template <class Element, class Visit>
void for_each_vector(const Visit& visit) {
    constexpr int dimension = Element::dimension;
    for (int node = 0; node < 2; ++node) {
        for (const Field field : {Field::r, Field::r_x, Field::r_y, Field::r_z, Field::r_xx}) {
            if (!Element::fields.contains(field)) continue;
            visit(node, field,
                  dimension * (node * Element::fields.count() + Element::fields.rank(field)));
        }
    }
}

/// Returns the coordinates of the straight element along e_x from the origin.
template <class Element>
[[nodiscard]] Vector<double, Element::dofs> reference_coordinates(const Element& element) {
    constexpr int dimension = Element::dimension;
    Vector<double, Element::dofs> e;
    for_each_vector<Element>([&](int node, Field field, int first) {
        Vector<double, dimension> v = reference_direction<dimension>(field);
        if (field == Field::r) v(0) = node * element.length();
        e.template segment<dimension>(first) = v;
    });
    return e;
}

/// Returns R e on every vector, plus the shift on the positions.
template <class Element>
[[nodiscard]] Vector<double, Element::dofs> moved(
    const Vector<double, Element::dofs>& e, const Matrix<double, Element::dimension>& rotation,
    const Vector<double, Element::dimension>& shift) {
    constexpr int dimension = Element::dimension;
    Vector<double, Element::dofs> result;
    for_each_vector<Element>([&](int, Field field, int first) {
        Vector<double, dimension> v = rotation * e.template segment<dimension>(first);
        if (field == Field::r) v += shift;
        result.template segment<dimension>(first) = v;
    });
    return result;
}

/// Returns a deformed element: its end frames turned against each other (bending and twist, up to
/// about 40 degrees a node), every slope sheared and stretched and the chord stretched by up to
/// `strain`.
template <class Element>
[[nodiscard]] Vector<double, Element::dofs> deformed_state(const Element& element, Random& random,
                                                           double strain = 0.3) {
    constexpr int dimension = Element::dimension;
    Vector<double, Element::dofs> e;
    Matrix<double, dimension> frame[2];
    for (auto& each : frame) each = random_rotation<dimension>(random, 2.3 * strain);
    for_each_vector<Element>([&](int node, Field field, int first) {
        Vector<double, dimension> v = reference_direction<dimension>(field);
        if (field == Field::r) {
            if (node == 1) v(0) = 1.0;
            if (node == 1) v += strain * random.vector<dimension>();
            v *= element.length();
        } else {
            v = frame[node] * (v + strain * random.vector<dimension>());
            if (field == Field::r_xx) v /= element.length();
        }
        e.template segment<dimension>(first) = v;
    });
    return e;
}

/// Returns a deformed element, rotated at random and shifted by up to one length.
template <class Element>
[[nodiscard]] Vector<double, Element::dofs> random_state(const Element& element, Random& random,
                                                         double strain = 0.3) {
    constexpr int dimension = Element::dimension;
    const Vector<double, Element::dofs> e = deformed_state(element, random, strain);
    const Matrix<double, dimension> turn = random_rotation<dimension>(random);
    return moved<Element>(e, turn, element.length() * random.vector<dimension>());
}

}  // namespace ancf::test
