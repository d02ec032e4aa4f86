// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/constants.hpp>
#include <ancf/error.hpp>
#include <ancf/model/builders/curve.hpp>

#include <algorithm>
#include <cmath>

namespace ancf::detail {

ANCF_INLINE Matrix<double, 3> slopes_of(const char* names, const Vector<double, 3>& direction,
                                        const Vector<double, 3>& y_axis) {
    const double size = span(direction) * span(y_axis);
    require(span(cross(direction, y_axis)) > 1e-8 * size, names,
            " need lengths and must not be parallel, got ", components(direction), " and ",
            components(y_axis));
    return reference_slopes(direction, y_axis);
}

template <int Dimension>
Curve<Dimension> arc_curve(const Vector<double, Dimension>& from,
                           const Matrix<double, Dimension>& start, double radius, double angle,
                           int elements) {
    require_positive("arc: radius", radius);
    require(std::isfinite(angle) && angle != 0.0, "arc: the angle must not be zero, got ", angle);
    require(elements >= 1, "arc: at least one element is needed, got ", elements);
    const double side = angle > 0.0 ? 1.0 : -1.0;
    std::vector<CurvePoint<Dimension>> points;
    for (int k = 0; k <= elements; ++k) {
        const double turn = angle * k / elements, sine = std::sin(turn), cosine = std::cos(turn);
        Matrix<double, Dimension> slopes = start;
        slopes.col(0) = cosine * start.col(0) + sine * start.col(1);
        slopes.col(1) = cosine * start.col(1) - sine * start.col(0);
        points.push_back(
            {from + side * radius * (sine * start.col(0) + (1.0 - cosine) * start.col(1)), slopes,
             side / radius * slopes.col(1)});
    }
    return {std::move(points), {radius * std::abs(angle) / elements}};
}

ANCF_LAZY Curve<3> helix_curve(const Vector<double, 3>& centre, const Vector<double, 3>& axis,
                               const Vector<double, 3>& outward, double radius, double pitch,
                               double turns, int elements) {
    require_positive("helix: radius", radius);
    require_finite("helix: pitch", pitch);
    require_positive("helix: turns", turns);
    require(elements >= 1, "helix: at least one element is needed, got ", elements);
    const Matrix<double, 3> frame =
        slopes_of("helix: axis and outward", axis, outward);  // axis, outward, across
    const double rise = pitch / (2.0 * pi);
    const double per_radian = std::sqrt(radius * radius + rise * rise);
    std::vector<CurvePoint<3>> points;
    for (int k = 0; k <= elements; ++k) {
        const double turn = 2.0 * pi * turns * k / elements;
        const Vector<double, 3> radial =
            std::cos(turn) * frame.col(1) + std::sin(turn) * frame.col(2);
        const Vector<double, 3> around =
            std::cos(turn) * frame.col(2) - std::sin(turn) * frame.col(1);
        const Vector<double, 3> tangent = (rise * frame.col(0) + radius * around) / per_radian;
        points.push_back({centre + radius * radial + rise * turn * frame.col(0),
                          reference_slopes(tangent, Vector<double, 3>(-radial)),
                          -radius / (per_radian * per_radian) * radial});
    }
    return {std::move(points), {2.0 * pi * turns * per_radian / elements}};
}

ANCF_LAZY Curve<3> spline_curve(const std::vector<Vector<double, 3>>& through,
                                const Vector<double, 3>& y_axis) {
    const std::size_t count = through.size();
    require(count >= 2, "spline: at least two points are needed, got ", count);
    std::vector<double> chords;
    for (std::size_t k = 0; k + 1 < count; ++k) {
        chords.push_back((through[k + 1] - through[k]).norm());
        require(std::isfinite(chords[k]) && chords[k] > 0.0, "spline: points ", k, " and ", k + 1,
                " must be finite and apart");
    }
    const auto secant = [&](std::size_t k) -> Vector<double, 3> {
        return (through[k + 1] - through[k]) / chords[k];
    };
    std::vector<CurvePoint<3>> points;
    for (std::size_t k = 0; k < count; ++k) {
        Vector<double, 3> tangent, bend = Vector<double, 3>::Zero();
        if (count == 2) {
            tangent = secant(0);
        } else {
            const std::size_t middle = k == 0 ? 1 : k + 1 == count ? count - 2 : k;
            const double a = chords[middle - 1], b = chords[middle];
            tangent = (b * secant(middle - 1) + a * secant(middle)) / (a + b);
            bend = 2.0 / (a + b) * (secant(middle) - secant(middle - 1));
            if (k == 0) tangent = 2.0 * secant(0) - tangent;
            if (k + 1 == count) tangent = 2.0 * secant(count - 2) - tangent;
        }
        const double size = tangent.norm();
        require(size > 1e-9, "spline: the line folds back on itself at point ", k);
        tangent /= size;
        bend = (bend - bend.dot(tangent) * tangent) / (size * size);
        Vector<double, 3> across = y_axis;
        if (k > 0) {
            const Vector<double, 3> before = points.back().slopes.col(0);
            const Vector<double, 3> carried = points.back().slopes.col(1);
            const double turn = 1.0 + before.dot(tangent);
            require(turn > 1e-9, "spline: the line folds back on itself between points ", k - 1,
                    " and ", k);
            across = carried - carried.dot(tangent) / turn * (before + tangent);
        }
        points.push_back({through[k], reference_slopes(tangent, across), bend});
    }
    return {std::move(points), chords};
}

template <int Dimension>
std::vector<NodeId> add_curve_nodes(BasicModel<Dimension>& model,
                                    const std::vector<CurvePoint<Dimension>>& points,
                                    const std::vector<double>& lengths) {
    require(points.size() >= 2, "beam_through: at least two points are needed, got ",
            points.size());
    require(lengths.size() == 1 || lengths.size() + 1 == points.size(),
            "beam_through: expected one length or ", points.size() - 1, ", got ", lengths.size());
    std::vector<NodeId> nodes;
    for (const auto& point : points)
        nodes.push_back(model.add_node(point.position, point.slopes, point.curvature));
    return nodes;
}

template <int Dimension>
void reference_coordinates(Fields fields, const CurvePoint<Dimension>& first,
                           const CurvePoint<Dimension>& second, double* e) {
    for (const auto* point : {&first, &second}) {
        const auto vectors =
            node_vectors<Dimension>(point->position, point->slopes, point->curvature);
        for (int k = 0; k < fields.count(); ++k)
            e = std::copy_n(vectors.data() + 3 * static_cast<int>(fields.at(k)), Dimension, e);
    }
}

template <int Dimension>
void check_equal_elements(Fields fields, const std::vector<CurvePoint<Dimension>>& points,
                          const std::vector<double>& lengths) {
    if (points.size() <= 2 || lengths.size() != 1) return;
    if (!(lengths[0] > 0.0)) return;  // elements refuse it
    const int count = fields.count();
    // products of an element's vectors, those of positions its chord, all by the length: what a
    // rigid motion does not change
    const auto products = [&](std::size_t element) {
        Matrix<double, Dimension, Eigen::Dynamic> e(Dimension, 2 * count);
        reference_coordinates(fields, points[element], points[element + 1], e.data());
        e.col(0) = e.col(count) - e.col(0);
        e.col(count).setZero();
        for (int k = 0; k < 2 * count; ++k)
            e.col(k) *= std::pow(lengths[0], -length_power(fields.at(k % count)));
        std::vector<double> all;
        for (int i = 0; i < 2 * count; ++i)
            for (int k = 0; k <= i; ++k) all.push_back(e.col(i).dot(e.col(k)));
        return all;
    };
    const std::vector<double> first = products(0);
    for (std::size_t element = 1; element + 1 < points.size(); ++element) {
        const std::vector<double> other = products(element);
        for (std::size_t k = 0; k < first.size(); ++k)
            require(std::abs(other[k] - first[k]) <= 1e-6 * std::max(1.0, std::abs(first[k])),
                    "beam_through: element ", element, " is not as the first one, give ",
                    points.size() - 1, " lengths");
    }
}

#if defined(ANCF_SOURCE)
template Curve<2> arc_curve<2>(const Vector<double, 2>&, const Matrix<double, 2>&, double, double,
                               int);
template Curve<3> arc_curve<3>(const Vector<double, 3>&, const Matrix<double, 3>&, double, double,
                               int);
template void check_equal_elements<2>(Fields, const std::vector<CurvePoint<2>>&,
                                      const std::vector<double>&);
template void check_equal_elements<3>(Fields, const std::vector<CurvePoint<3>>&,
                                      const std::vector<double>&);
template std::vector<NodeId> add_curve_nodes<2>(BasicModel<2>&, const std::vector<CurvePoint<2>>&,
                                                const std::vector<double>&);
template void reference_coordinates<2>(Fields, const CurvePoint<2>&, const CurvePoint<2>&, double*);
template std::vector<NodeId> add_curve_nodes<3>(BasicModel<3>&, const std::vector<CurvePoint<3>>&,
                                                const std::vector<double>&);
template void reference_coordinates<3>(Fields, const CurvePoint<3>&, const CurvePoint<3>&, double*);
#endif

}  // namespace ancf::detail
