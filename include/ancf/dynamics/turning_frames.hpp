// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Frames that turn with the nodes, in which the tangent of a stiff body that turns hardly changes.
///
/// docs/theory-radau.md, "Bodies that turn", derives them.

#pragma once

#include <ancf/assembly/numbering.hpp>
#include <ancf/dynamics/report.hpp>
#include <ancf/element/vec3.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/types.hpp>

#include <limits>
#include <utility>
#include <vector>

namespace ancf::detail {

/// Whether corrections are solved in frames that turn with the nodes, and vectors that turn so.
///
/// One slope of a node tells its turn, in space two where it has as many; a node without a free
/// slope does not turn. Where Newton's method fails often, the other way is tried, and kept where
/// it takes less work.
class TurningFrames {
public:
    /// Begins with frames that do not turn.
    TurningFrames(const Scene& scene, const Numbering& numbers)
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
    void carry(const VectorX& from, const VectorX& to, VectorX& x) const {
        for (const Node& node : nodes_) {
            const Block<double> turn = turn_of(node, from, to);
            for (const int first : node.vectors) {
                const Vec3<double> a = vector(x, first);
                for (int i = 0; i < dimension_; ++i)
                    x[first + i] = turn(i, 0) * a[0] + turn(i, 1) * a[1] + turn(i, 2) * a[2];
            }
        }
    }

    /// Tells whether they turn.
    [[nodiscard]] bool turn() const { return turn_; }

    /// Counts a correction.
    void add_correction() { work_ += 1.0; }
    /// Counts a tangent with its factorisation.
    void add_tangent() { work_ += 3.0; }

    /// Counts a failure of Newton's method, or of a matrix that served for few steps; tells whether
    /// the frames begin to turn, or cease to, on trial.
    /// @param at_once  whether they turn at the first failure, for good.
    bool fail(bool at_once = false) {
        if (trial_ > 0.0 || (at_once ? turn_ : ++failures_ < patience_)) return false;
        trial_ = at_once ? 0.0 : trial_steps;
        change();
        return true;
    }

    /// Counts a step, s. A trial that took more work in a second than before is taken back. The next
    /// one waits for twice as many failures.
    void end_step(double width) {
        time_ += width;
        if (trial_ == 0.0 || --trial_ > 0.0) return;
        patience_ *= 2.0;
        if (work_ > rate_ * time_) change();
    }

    /// Returns what a run that goes on needs.
    [[nodiscard]] VectorX memory() const {
        VectorX numbers(7);
        numbers << (turn_ ? 1.0 : 0.0), failures_, patience_, trial_, work_, time_, rate_;
        return numbers;
    }

    /// Takes it from a memory.
    void recall(const Memory& memory) {
        const VectorX& numbers = memory.get("frames", 7);
        turn_ = numbers[0] != 0.0;
        failures_ = numbers[1];
        patience_ = numbers[2];
        trial_ = numbers[3];
        work_ = numbers[4];
        time_ = numbers[5];
        rate_ = numbers[6];
    }

private:
    static constexpr double trial_steps = 20.0;

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
        if (dimension_ == 2) {
            const double c = dot(a, b), d = cross(a, b)[2];
            return {{c, d, 0.0, -d, c, 0.0, 0.0, 0.0, 1.0}};
        }
        if (node.slopes.size() == 1) return least_turn(a, b);
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

    // Between unit vectors; where they are nearly opposite, by way of a half turn.
    [[nodiscard]] static Block<double> least_turn(const Vec3<double>& a, const Vec3<double>& b) {
        const Vec3<double> k = cross(a, b);
        const double cosine = dot(a, b);
        if (cosine < -0.9) {
            const Vec3<double> n = normals_of(a)[0];
            Block<double> half;
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i) half(i, j) = 2.0 * n[i] * n[j] - (i == j ? 1.0 : 0.0);
            return least_turn(-1.0 * a, b) * half;
        }
        Block<double> turn = cross_block(k);
        for (int j = 0; j < 3; ++j) {
            turn(j, j) += cosine;
            for (int i = 0; i < 3; ++i) turn(i, j) += k[i] * k[j] / (1.0 + cosine);
        }
        return turn;
    }

    void change() {
        turn_ = !turn_;
        rate_ = time_ > 0.0 ? work_ / time_ : std::numeric_limits<double>::max();
        failures_ = work_ = time_ = 0.0;
    }

    int dimension_;
    std::vector<Node> nodes_;
    bool turn_ = false;
    double failures_ = 0.0;
    double patience_ = 4.0;  // after how many failures the other way is tried
    double trial_ = 0.0;     // steps left of a trial
    double work_ = 0.0;      // corrections and tangents since they turn or do not
    double time_ = 0.0;      // s, of the steps since then
    double rate_ = 0.0;      // work in a second before
};

}  // namespace ancf::detail
