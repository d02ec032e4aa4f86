// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/element/vec3.hpp>
#include <ancf/list.hpp>
#include <ancf/model/builders/beam.hpp>

#include <cmath>

namespace ancf {

ANCF_INLINE NodeId Chain::node(int place) const {
    detail::require(place >= 0 && place < static_cast<int>(nodes.size()), "Beam: there are ",
                    nodes.size(), " nodes, got place ", place);
    return nodes[place];
}

ANCF_INLINE Coupling coupling_of(const Connection& connection, Fields fields) {
    Coupling coupling;
    for (const NodeId node : {connection.first, connection.second})
        for (int k = 0; k < fields.count(); ++k) coupling.push_back({node, fields.at(k)});
    return coupling;
}

namespace detail {

/// Returns the length of a direction.
/// @throws InvalidArgument where it has none or is not finite.
template <int Dimension>
[[nodiscard]] double require_length(const char* name, const Vector<double, Dimension>& direction) {
    const double length = span(direction);
    require(std::isfinite(length) && length > 0.0, "reference_slopes: ", name,
            " must have a length, got ", components(direction));
    return length;
}

template <int Dimension>
double distance_apart(const Vector<double, Dimension>& from, const Vector<double, Dimension>& to) {
    const double length = span(between<Dimension>(from, to));
    require(std::isfinite(length) && length > 0.0,
            "straight_beam: the ends must be finite and apart, got a length of ", length);
    return length;
}

template <int Dimension>
void check_straight_slopes(Fields fields, const Vector<double, Dimension>& along,
                           const Matrix<double, Dimension>& slopes) {
    constexpr double tolerance = 1e-6;
    const double length = span(along);
    const auto carried = [&](int k) { return fields.contains(static_cast<Field>(1 + k)); };
    bool good = true, all = true;
    for (int a = 0; a < Dimension; ++a) {
        all = all && carried(a);
        if (!carried(a)) continue;
        for (int i = 0; a == 0 && i < Dimension; ++i)
            good = good && std::abs(slopes(i, 0) - along[i] / length) <= tolerance;
        for (int b = 0; b <= a; ++b) {
            if (!carried(b)) continue;
            double product = a == b ? -1.0 : 0.0;
            for (int i = 0; i < Dimension; ++i) product += slopes(i, a) * slopes(i, b);
            good = good && std::abs(product) <= tolerance;
        }
    }
    if (all) {
        const auto minor = [&](int i, int j) {
            return slopes(i, 0) * slopes(j, 1) - slopes(j, 0) * slopes(i, 1);
        };
        double volume = minor(0, 1);
        if constexpr (Dimension == 3)
            volume =
                minor(1, 2) * slopes(0, 2) + minor(2, 0) * slopes(1, 2) + volume * slopes(2, 2);
        good = good && volume > 0.0;
    }
    require(good,
            "straight_beam_with_slopes: the slopes must be orthonormal and right-handed, r_x along "
            "the beam, got (by columns) ",
            components(slopes));
}

template <int Dimension>
List<NodeId> add_nodes_between(BasicModel<Dimension>& model, const Vector<double, Dimension>& from,
                               const Vector<double, Dimension>& to,
                               const Matrix<double, Dimension>& slopes, int elements) {
    List<NodeId> nodes;
    for (int k = 0; k <= elements; ++k) {
        const double part = static_cast<double>(k) / elements;
        Vector<double, Dimension> position;
        for (int i = 0; i < Dimension; ++i) position[i] = (1.0 - part) * from[i] + part * to[i];
        nodes.push_back(model.add_node(position, slopes));
    }
    return nodes;
}

}  // namespace detail

ANCF_INLINE Matrix<double, 3> reference_slopes(const Vector<double, 3>& direction,
                                               const Vector<double, 3>& y_axis) {
    using detail::vec3;
    const auto t = vec3<double>(direction) / detail::require_length("the direction", direction);
    const auto y = vec3<double>(y_axis) / detail::require_length("the y axis", y_axis);
    const auto across = y - dot(y, t) * t;
    const double width = length(across);
    detail::require(width > 1e-8,
                    "reference_slopes: the y axis must not be parallel to the beam, got ",
                    detail::components(y_axis));
    const auto n = across / width, c = cross(t, n);
    Matrix<double, 3> slopes;
    for (int k = 0; k < 3; ++k) {
        slopes(k, 0) = t[k];
        slopes(k, 1) = n[k];
        slopes(k, 2) = c[k];
    }
    return slopes;
}

ANCF_INLINE Matrix<double, 3> reference_slopes(const Vector<double, 3>& direction) {
    const double length = detail::require_length("the direction", direction);
    const double x = direction[0] / length, y = direction[1] / length, z = direction[2] / length;
    if (x < -0.9) return reference_slopes(direction, {0.0, 1.0, 0.0});
    return reference_slopes(direction, {-y, 1.0 - y * y / (1.0 + x), -y * z / (1.0 + x)});
}

ANCF_INLINE Matrix<double, 2> reference_slopes(const Vector<double, 2>& direction) {
    const double length = detail::require_length("the direction", direction);
    Matrix<double, 2> slopes;
    slopes(0, 0) = slopes(1, 1) = direction[0] / length;
    slopes(1, 0) = direction[1] / length;
    slopes(0, 1) = -slopes(1, 0);
    return slopes;
}

#if defined(ANCF_SOURCE)
template double detail::distance_apart<2>(const Vector<double, 2>&, const Vector<double, 2>&);
template void detail::check_straight_slopes<2>(Fields, const Vector<double, 2>&,
                                               const Matrix<double, 2>&);
template List<NodeId> detail::add_nodes_between<2>(BasicModel<2>&, const Vector<double, 2>&,
                                                   const Vector<double, 2>&,
                                                   const Matrix<double, 2>&, int);
template double detail::distance_apart<3>(const Vector<double, 3>&, const Vector<double, 3>&);
template void detail::check_straight_slopes<3>(Fields, const Vector<double, 3>&,
                                               const Matrix<double, 3>&);
template List<NodeId> detail::add_nodes_between<3>(BasicModel<3>&, const Vector<double, 3>&,
                                                   const Vector<double, 3>&,
                                                   const Matrix<double, 3>&, int);
#endif

}  // namespace ancf
