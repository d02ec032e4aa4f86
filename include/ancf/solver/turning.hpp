// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Corrections whose rotations stay rotations: docs/theory-statics.md, "Corrections that turn".
///
/// Adding a linear correction stretches a slope that turns by tan of the angle. Here a correction
/// turns slopes and chords instead. Both agree to first order, so Newton's method keeps its speed.

#pragma once

#include <ancf/assembly/numbering.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/types.hpp>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ancf {

/// Replaces the sum of coordinates and correction by one in which things turn.
template <class Scene>
class Turning {
public:
    /// Finds what turns in a scene.
    Turning(const Scene& model, const Numbering& numbering);

    /// Turns slopes about the tangents alone: what a twist does.
    /// @param before,change  coordinates and correction, all coordinates
    /// @param q              before + change on entry
    void twist(const VectorX& before, const VectorX& change, VectorX& q) const;

    /// Turns slopes by their rotation and the chords of elements by theirs; positions follow the
    /// chords as well as they can, in least squares.
    void turn(const VectorX& before, const VectorX& change, VectorX& q);

    /// Returns the largest angle by which a correction turns a slope, to first order.
    [[nodiscard]] double largest_angle(const VectorX& before, const VectorX& change) const;

private:
    static constexpr int dimension = Scene::dimension;
    using Point = Vector<double, dimension>;
    using Frame = Matrix<double, dimension>;

    /// Returns v + change with the part of the change across v as an angle.
    [[nodiscard]] static Point turned(const Point& v, const Point& change);
    [[nodiscard]] static Frame rotation(const Frame& skew);
    [[nodiscard]] static Frame product(const Frame& a, const Frame& b);

    /// Writes the inverse of a frame of unit size.
    /// @return false where its determinant is below 1e-12.
    [[nodiscard]] static bool invert(const Frame& a, Frame& inverse);

    /// Moves a node's frame G = [r_x r_y r_z] to exp(W) (I + D) G, W + D = dG G^-1, W skew.
    /// @param tangent_only  W keeps the part about r_x
    static void turn_frame(const double* before, const double* change, bool tangent_only,
                           double* after);

    template <class Visitor>
    void for_each_node(Visitor&& visit) const;
    void factorize();

    const Layout& layout_;
    const Numbering& numbering_;
    std::vector<std::array<int, 2>> chords_;
    std::array<std::vector<int>, Scene::dimension> unknown_;  // of each node, by component
    std::array<Eigen::SimplicialLDLT<SparseMatrix>, Scene::dimension> factors_;
    bool factorised_ = false;
};

template <class Scene>
Turning<Scene>::Turning(const Scene& model, const Numbering& numbering)
    : layout_(model.layout()), numbering_(numbering) {
    model.for_each_group([&](const auto& group) {
        for (const auto& c : group.connections) chords_.push_back({c.first.index, c.second.index});
    });
}

template <class Scene>
auto Turning<Scene>::turned(const Point& v, const Point& change) -> Point {
    const double length = v.norm();
    if (length == 0.0) return v + change;
    const Point unit = v / length;
    const double along = unit.dot(change);
    const Point across = change - along * unit;
    const double size = across.norm();
    if (size < 1e-12 * length) return v + change;
    const double angle = size / length;
    return (length + along) * (std::cos(angle) * unit + std::sin(angle) / size * across);
}

template <class Scene>
auto Turning<Scene>::rotation(const Frame& skew) -> Frame {
    const double square = 0.5 * skew.squaredNorm();
    const double angle = std::sqrt(square);
    const bool small = angle < 1e-4;  // where the series is exact to round-off
    const double first = small ? 1.0 - square / 6.0 : std::sin(angle) / angle;
    const double second = small ? 0.5 - square / 24.0 : (1.0 - std::cos(angle)) / square;
    Frame result = product(skew, skew);
    for (int j = 0; j < dimension; ++j)
        for (int i = 0; i < dimension; ++i)
            result(i, j) = (i == j ? 1.0 : 0.0) + first * skew(i, j) + second * result(i, j);
    return result;
}

template <class Scene>
auto Turning<Scene>::product(const Frame& a, const Frame& b) -> Frame {
    Frame result = Frame::Zero();
    for (int j = 0; j < dimension; ++j)
        for (int k = 0; k < dimension; ++k)
            for (int i = 0; i < dimension; ++i) result(i, j) += a(i, k) * b(k, j);
    return result;
}

template <class Scene>
bool Turning<Scene>::invert(const Frame& a, Frame& inverse) {
    if constexpr (dimension == 2) {
        const double determinant = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
        if (!(std::abs(determinant) > 1e-12)) return false;
        inverse(0, 0) = a(1, 1) / determinant;
        inverse(0, 1) = -a(0, 1) / determinant;
        inverse(1, 0) = -a(1, 0) / determinant;
        inverse(1, 1) = a(0, 0) / determinant;
    } else {
        double determinant = 0.0;
        for (int k = 0; k < 3; ++k) {  // row k is the vector product of the other two columns
            const Point p = a.col((k + 1) % 3), q = a.col((k + 2) % 3);
            const Point row = cross(p, q);
            for (int j = 0; j < 3; ++j) inverse(k, j) = row[j];
            if (k == 0) determinant = row[0] * a(0, 0) + row[1] * a(1, 0) + row[2] * a(2, 0);
        }
        if (!(std::abs(determinant) > 1e-12)) return false;
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i) inverse(i, j) /= determinant;
    }
    return true;
}

template <class Scene>
void Turning<Scene>::turn_frame(const double* before, const double* change, bool tangent_only,
                                double* after) {
    Frame G, dG, inverse, skew;
    std::copy_n(before, G.size(), G.data());
    std::copy_n(change, G.size(), dG.data());
    if (!invert(G, inverse)) return;
    Frame rate = product(dG, inverse);
    for (int j = 0; j < dimension; ++j)
        for (int i = 0; i < dimension; ++i) skew(i, j) = 0.5 * (rate(i, j) - rate(j, i));
    if constexpr (dimension == 3) {
        if (tangent_only) {
            const Point t = G.col(0);
            const Point spin(skew(2, 1), skew(0, 2), skew(1, 0));
            skew = cross_matrix(Point(spin.dot(t) / t.squaredNorm() * t));
        }
    }
    for (int j = 0; j < dimension; ++j)  // I + D
        for (int i = 0; i < dimension; ++i) rate(i, j) += (i == j ? 1.0 : 0.0) - skew(i, j);
    const Frame result = product(rotation(skew), product(rate, G));
    std::copy_n(result.data(), result.size(), after);
}

/// Calls visit(first slope coordinate, number of slopes, whether they are a frame and all free).
template <class Scene>
template <class Visitor>
void Turning<Scene>::for_each_node(Visitor&& visit) const {
    for (int node = 0; node < layout_.nodes(); ++node) {
        const int first =
            layout_.first(node) + (layout_.fields(node).contains(Field::r) ? dimension : 0);
        const int last = layout_.index({{node}, Field::r_xx});  // which is no slope
        const int slopes = ((last < 0 ? layout_.first(node + 1) : last) - first) / dimension;
        bool whole = slopes == dimension;
        for (int k = first; k < first + slopes * dimension; ++k)
            whole = whole && numbering_.equation(k) >= 0;
        visit(first, slopes, whole);
    }
}

template <class Scene>
void Turning<Scene>::twist(const VectorX& before, const VectorX& change, VectorX& q) const {
    if constexpr (dimension == 3) {
        for_each_node([&](int first, int, bool whole) {
            if (whole)
                turn_frame(before.data() + first, change.data() + first, true, q.data() + first);
        });
    }
}

template <class Scene>
double Turning<Scene>::largest_angle(const VectorX& before, const VectorX& change) const {
    double largest = 0.0;
    for_each_node([&](int first, int slopes, bool) {
        for (int k = first; k < first + slopes * dimension; k += dimension) {
            const Point v = before.template segment<dimension>(k);
            const Point d = change.template segment<dimension>(k);
            const double square = v.squaredNorm();
            if (square > 0.0)
                largest = std::max(largest, (d - v.dot(d) / square * v).norm() / std::sqrt(square));
        }
    });
    return largest;
}

/// Factorises the graph of chords: sum over chords of (x_j - x_i - wanted)^2, and a little of the
/// distance from the linear sum, for parts that nothing holds.
template <class Scene>
void Turning<Scene>::factorize() {
    constexpr double tether = 1e-9;  // beside chords of weight 1
    for (int k = 0; k < dimension; ++k) {
        const auto component = static_cast<std::size_t>(k);
        std::vector<int>& unknown = unknown_[component];
        unknown.assign(static_cast<std::size_t>(layout_.nodes()), -1);
        int count = 0;
        for (int node = 0; node < layout_.nodes(); ++node)
            if (layout_.fields(node).contains(Field::r) &&
                numbering_.equation(layout_.first(node) + k) >= 0)
                unknown[static_cast<std::size_t>(node)] = count++;
        std::vector<Eigen::Triplet<double>> entries;
        entries.reserve(static_cast<std::size_t>(count) + 4 * chords_.size());
        for (int i = 0; i < count; ++i) entries.emplace_back(i, i, tether);
        for (const auto& chord : chords_) {
            const int i = unknown[static_cast<std::size_t>(chord[0])];
            const int j = unknown[static_cast<std::size_t>(chord[1])];
            if (i >= 0) entries.emplace_back(i, i, 1.0);
            if (j >= 0) entries.emplace_back(j, j, 1.0);
            if (i >= 0 && j >= 0) {
                entries.emplace_back(i, j, -1.0);
                entries.emplace_back(j, i, -1.0);
            }
        }
        SparseMatrix graph(count, count);
        graph.setFromTriplets(entries.begin(), entries.end());
        factors_[component].compute(graph);
    }
    factorised_ = true;
}

template <class Scene>
void Turning<Scene>::turn(const VectorX& before, const VectorX& change, VectorX& q) {
    for_each_node([&](int first, int slopes, bool whole) {
        if (whole) {
            turn_frame(before.data() + first, change.data() + first, false, q.data() + first);
            return;
        }
        for (int k = first; k < first + slopes * dimension; k += dimension)
            q.template segment<dimension>(k) = turned(before.template segment<dimension>(k),
                                                      change.template segment<dimension>(k));
    });
    if (!factorised_) factorize();
    // wanted: how far each chord ends from where the linear sum ends it
    std::vector<Point> wanted;
    wanted.reserve(chords_.size());
    for (const auto& chord : chords_) {
        const int i = layout_.first(chord[0]), j = layout_.first(chord[1]);
        const Point moved =
            turned(before.template segment<dimension>(j) - before.template segment<dimension>(i),
                   change.template segment<dimension>(j) - change.template segment<dimension>(i));
        wanted.push_back(moved - q.template segment<dimension>(j) +
                         q.template segment<dimension>(i));
    }
    for (int k = 0; k < dimension; ++k) {
        const auto component = static_cast<std::size_t>(k);
        const std::vector<int>& unknown = unknown_[component];
        VectorX pull = VectorX::Zero(factors_[component].rows());
        if (pull.size() == 0) continue;
        for (std::size_t c = 0; c < chords_.size(); ++c) {
            const int i = unknown[static_cast<std::size_t>(chords_[c][0])];
            const int j = unknown[static_cast<std::size_t>(chords_[c][1])];
            if (i >= 0) pull[i] -= wanted[c][k];
            if (j >= 0) pull[j] += wanted[c][k];
        }
        const VectorX shift = factors_[component].solve(pull);
        for (int node = 0; node < layout_.nodes(); ++node)
            if (const int i = unknown[static_cast<std::size_t>(node)]; i >= 0)
                q[layout_.first(node) + k] += shift[i];
    }
}

}  // namespace ancf
