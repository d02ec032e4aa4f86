// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// How far each node turns from one configuration to another, and vectors that turn with it: in
/// frames that turn so, a body that turns keeps its tangent.

#pragma once

#include <ancf/assembly/numbering.hpp>
#include <ancf/element/vec3.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/types.hpp>

#include <vector>

namespace ancf::detail {

/// The free vectors of the nodes. One slope of a node tells its turn, in space two where it has as
/// many; a node without a free slope does not turn.
class NodalTurns {
public:
    NodalTurns(const Scene& scene, const Numbering& numbers)
        : dimension_(scene.layout().dimension()) {
        const Layout& layout = scene.layout();
        for (int node = 0; node < layout.nodes(); ++node) {
            Node turning;
            for (int k = layout.first(node); k < layout.first(node + 1); k += dimension_) {
                const int first = numbers.equation(k);
                bool free = first >= 0;
                for (int i = 1; i < dimension_; ++i)
                    free = free && numbers.equation(k + i) == first + i;
                if (!free) continue;
                turning.vectors.push_back(first);
                if (length_power(layout.field_of(k)) == 0) turning.slopes.push_back(first);
            }
            if (!turning.slopes.empty()) nodes_.push_back(std::move(turning));
        }
    }

    /// Turns the vectors among n entries as their nodes turn between two configurations.
    void turn(const VectorX& from, const VectorX& to, VectorX& x) const {
        for (const Node& node : nodes_) {
            const Block<double> turn = turn_of(node, from, to);
            for (const int first : node.vectors) {
                const Vec3<double> a = vector(x, first);
                for (int i = 0; i < dimension_; ++i)
                    x[first + i] = turn(i, 0) * a[0] + turn(i, 1) * a[1] + turn(i, 2) * a[2];
            }
        }
    }

private:
    struct Node {
        std::vector<int> vectors, slopes;  // the equation of the first component of each
    };

    [[nodiscard]] Vec3<double> vector(const VectorX& x, int first) const {
        return {{x[first], x[first + 1], dimension_ == 3 ? x[first + 2] : 0.0}};
    }

    [[nodiscard]] Block<double> turn_of(const Node& node, const VectorX& from,
                                        const VectorX& to) const {
        const auto axis = [&](const VectorX& q) {
            const Vec3<double> slope = vector(q, node.slopes[0]);
            return slope / length(slope);
        };
        const Vec3<double> a = axis(from), b = axis(to);
        if (dimension_ == 2 || node.slopes.size() == 1) return least_turn(a, b);
        const auto normal = [&](const Vec3<double>& t, const VectorX& q) {
            const Vec3<double> n = cross(t, vector(q, node.slopes[1]));
            return n / length(n);
        };
        const Vec3<double> n = normal(a, from), m = normal(b, to);
        const Vec3<double> c = cross(n, a), d = cross(m, b);
        Block<double> turn;
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i) turn(i, j) = b[i] * a[j] + m[i] * n[j] + d[i] * c[j];
        return turn;
    }

    // Between unit vectors; of those that are nearly opposite none.
    [[nodiscard]] static Block<double> least_turn(const Vec3<double>& a, const Vec3<double>& b) {
        const Vec3<double> k = cross(a, b);
        const double cosine = dot(a, b);
        if (cosine < -0.99) return {{1, 0, 0, 0, 1, 0, 0, 0, 1}};
        Block<double> turn = cross_block(k);
        for (int j = 0; j < 3; ++j) {
            turn(j, j) += cosine;
            for (int i = 0; i < 3; ++i) turn(i, j) += k[i] * k[j] / (1.0 + cosine);
        }
        return turn;
    }

    int dimension_;
    std::vector<Node> nodes_;
};

}  // namespace ancf::detail
