// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <support/random_state.hpp>

#include <cmath>

namespace ancf::test {

VectorX Random::vector(int n) {
    VectorX v(n);
    for (double& each : v) each = uniform(-1.0, 1.0);
    return v;
}

VectorX Random::direction(int n) {
    for (;;) {
        const VectorX v = vector(n);
        const double norm = v.norm();
        if (norm > 0.1 && norm < 1.0) return v / norm;
    }
}

Matrix<double, 3> rotation(const Vector<double, 3>& v) {
    const double angle = v.norm();
    Matrix<double, 3> result = Matrix<double, 3>::Identity();
    if (angle == 0.0) return result;
    Matrix<double, 3> k;
    k << 0.0, -v(2), v(1), v(2), 0.0, -v(0), -v(1), v(0), 0.0;
    k /= angle;
    return result + std::sin(angle) * k + (1.0 - std::cos(angle)) * k * k;
}

Matrix<double, 2> rotation(double angle) {
    Matrix<double, 2> result;
    result << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    return result;
}

MatrixX random_rotation(int dimension, Random& random, double angle) {
    if (dimension == 2) return rotation(random.uniform(-angle, angle));
    const double turn = random.uniform(0.0, angle);
    return rotation(Vector<double, 3>(turn * random.direction<3>()));
}

VectorX reference_direction(int dimension, Field field) {
    if (length_power(field) != 0) return VectorX::Zero(dimension);
    return VectorX::Unit(dimension, static_cast<int>(field) - 1);
}

VectorX reference_coordinates(const Shape& shape) {
    VectorX e(shape.dofs());
    shape.for_each_vector([&](int node, Field field, int first) {
        VectorX v = reference_direction(shape.dimension, field);
        if (field == Field::r) v(0) = node * shape.length;
        e.segment(first, shape.dimension) = v;
    });
    return e;
}

VectorX moved(const Shape& shape, const VectorX& e, const MatrixX& rotation, const VectorX& shift) {
    VectorX result(e.size());
    shape.for_each_vector([&](int, Field field, int first) {
        VectorX v = rotation * e.segment(first, shape.dimension);
        if (field == Field::r) v += shift;
        result.segment(first, shape.dimension) = v;
    });
    return result;
}

VectorX deformed_state(const Shape& shape, Random& random, double strain) {
    const int dimension = shape.dimension;
    VectorX e(shape.dofs());
    MatrixX frame[2];
    for (auto& each : frame) each = random_rotation(dimension, random, 2.3 * strain);
    shape.for_each_vector([&](int node, Field field, int first) {
        VectorX v = reference_direction(dimension, field);
        if (field == Field::r) {
            if (node == 1) v(0) = 1.0;
            if (node == 1) v += strain * random.vector(dimension);
            v *= shape.length;
        } else {
            v = frame[node] * (v + strain * random.vector(dimension));
            if (length_power(field) < 0) v /= shape.length;
        }
        e.segment(first, dimension) = v;
    });
    return e;
}

VectorX random_state(const Shape& shape, Random& random, double strain) {
    const VectorX e = deformed_state(shape, random, strain);
    const MatrixX turn = random_rotation(shape.dimension, random);
    return moved(shape, e, turn, shape.length * random.vector(shape.dimension));
}

}  // namespace ancf::test
