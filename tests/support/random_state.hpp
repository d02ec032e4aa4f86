// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Seeded random rotations, motions and deformed states for any element type.
///
/// An element type has `dimension`, `dofs`, `fields` and `length()`; its nodal coordinates are
/// vectors in Field order, node by node. What is computed depends on its Shape alone, and is
/// compiled once for all types, in random_state.cpp. The generator is our own, so that a seed
/// means the same everywhere.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/types.hpp>

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

    /// Returns a vector uniform in the cube [-1, 1)^n.
    VectorX vector(int n);

    /// Returns a unit vector of n components, uniform on the sphere.
    VectorX direction(int n);

    template <int N>
    Vector<double, N> vector() {
        return vector(N);
    }

    template <int N>
    Vector<double, N> direction() {
        return direction(N);
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
[[nodiscard]] Matrix<double, 3> rotation(const Vector<double, 3>& v);

/// Returns the rotation by an angle in the plane.
[[nodiscard]] Matrix<double, 2> rotation(double angle);

/// Returns a rotation of up to `angle` radians about a random axis, in the plane or in space.
[[nodiscard]] MatrixX random_rotation(int dimension, Random& random,
                                      double angle = 3.14159265358979);

template <int Dimension>
[[nodiscard]] Matrix<double, Dimension> random_rotation(Random& random,
                                                        double angle = 3.14159265358979) {
    return random_rotation(Dimension, random, angle);
}

/// What a state depends on.
struct Shape {
    int dimension;
    Fields fields;
    double length;  ///< m

    [[nodiscard]] int dofs() const { return 2 * dimension * fields.count(); }

    /// Calls visit(node, field, first coordinate) for every vector of an element.
    template <class Visit>
    void for_each_vector(const Visit& visit) const {
        for (int node = 0; node < 2; ++node) {
            for (int k = 0; k < field_count; ++k) {
                const auto field = static_cast<Field>(k);
                if (!fields.contains(field)) continue;
                visit(node, field, dimension * (node * fields.count() + fields.rank(field)));
            }
        }
    }
};

template <class Element>
[[nodiscard]] Shape shape_of(double length = 1.0) {
    return {Element::dimension, Element::fields, length};
}

template <class Element, class Visit>
void for_each_vector(const Visit& visit) {
    shape_of<Element>().for_each_vector(visit);
}

/// Returns the unit vector along which a field of the straight reference points: e_x, e_y, e_z of
/// slopes, 0 of the others.
[[nodiscard]] VectorX reference_direction(int dimension, Field field);

/// Returns the coordinates of the straight element along e_x from the origin.
[[nodiscard]] VectorX reference_coordinates(const Shape& shape);

template <class Element>
[[nodiscard]] Vector<double, Element::dofs> reference_coordinates(const Element& element) {
    return reference_coordinates(shape_of<Element>(element.length()));
}

/// Returns R e on every vector, plus the shift on the positions.
[[nodiscard]] VectorX moved(const Shape& shape, const VectorX& e, const MatrixX& rotation,
                            const VectorX& shift);

template <class Element>
[[nodiscard]] Vector<double, Element::dofs> moved(
    const Vector<double, Element::dofs>& e, const Matrix<double, Element::dimension>& rotation,
    const Vector<double, Element::dimension>& shift) {
    return moved(shape_of<Element>(), e, rotation, shift);
}

/// Returns a deformed element: its end frames turned against each other (bending and twist, up to
/// about 40 degrees a node), every slope sheared and stretched and the chord stretched by up to
/// `strain`.
[[nodiscard]] VectorX deformed_state(const Shape& shape, Random& random, double strain = 0.3);

template <class Element>
[[nodiscard]] Vector<double, Element::dofs> deformed_state(const Element& element, Random& random,
                                                           double strain = 0.3) {
    return deformed_state(shape_of<Element>(element.length()), random, strain);
}

/// Returns a deformed element, rotated at random and shifted by up to one length.
[[nodiscard]] VectorX random_state(const Shape& shape, Random& random, double strain = 0.3);

template <class Element>
[[nodiscard]] Vector<double, Element::dofs> random_state(const Element& element, Random& random,
                                                         double strain = 0.3) {
    return random_state(shape_of<Element>(element.length()), random, strain);
}

}  // namespace ancf::test
