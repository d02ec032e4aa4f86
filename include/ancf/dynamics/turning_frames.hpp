// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Frames that turn with the nodes, in which the tangent of a stiff body that turns hardly changes.
///
/// docs/theory-radau.md, "Bodies that turn", derives them.

#pragma once

#include <ancf/assembly/numbering.hpp>
#include <ancf/compiler.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/report.hpp>
#include <ancf/element/vec3.hpp>
#include <ancf/list.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ancf::detail {

/// Whether corrections are solved in frames that turn with the nodes, and vectors that turn so.
///
/// One slope of a node tells its turn, in space two where it has as many; a node without a free
/// slope does not turn. Where supports keep slopes normal to one global axis, as those of a hinge,
/// their other components turn about that. Where Newton's method fails often, the other way is
/// tried, and kept where it takes less work.
class TurningFrames {
public:
    /// Begins with frames that do not turn.
    /// @param patience  after how many failures they turn for the first time.
    ANCF_NOINLINE TurningFrames(const Scene& scene, const Numbering& numbers, double patience = 4.0)
        : dimension_(scene.layout().dimension()), patience_(patience) {
        const Layout& layout = scene.layout();
        for (int node = 0; node < layout.nodes(); ++node) {
            const std::size_t begin = free_.size();
            const int axis = hinge_axis(scene, numbers, node);
            int slopes[2] = {-1, -1}, count = 0;
            for (int k = layout.first(node); k < layout.first(node + 1); k += dimension_) {
                const int held = held_component(numbers, k);
                if (held == several || (held >= 0 && held != axis)) continue;
                const int place = static_cast<int>(free_.size());
                for (const int number : {numbers.equation(held == 0 ? k + 1 : k), held})
                    free_.push_back(number);
                const int power = length_power(layout.field_of(k));
                if (power != 1 && held < 0) directions_.push_back(free_[place]);
                if (power == 0 && count < dimension_ - 1) slopes[count++] = place;
            }
            if (count == 0) {
                free_.resize(begin);
                continue;
            }
            for (const int k : {slopes[0], slopes[1], static_cast<int>(free_.size())})
                nodes_.push_back(k);
        }
    }

    /// Turns vectors as their nodes turn between two configurations.
    /// @param from, to  n entries each.
    /// @param x         n entries, of coordinates or forces.
    void carry(const VectorX& from, const VectorX& to, double* x) const {
        int k = 0;
        for (std::size_t node = 0; node < nodes_.size(); node += 3) {
            // a turn is two reflections: that of the first slope, then that of the second about it
            Vec3<double> mirrors[4];
            const Vec3<double> a = unit(vector(from.data(), nodes_[node]));
            const Vec3<double> b = unit(vector(to.data(), nodes_[node]));
            const Vec3<double> normal =
                dimension_ == 2 ? Vec3<double>{{-a[1], a[0], 0.0}} : normals_of(a)[0];
            set_mirrors(a, b, normal, mirrors);
            const int second = nodes_[node + 1];
            if (second >= 0) {
                Vec3<double> c = vector(from.data(), second), d = vector(to.data(), second);
                reflect(mirrors, 2, c);
                add(c, -dot(b, c), b);
                add(d, -dot(b, d), b);
                set_mirrors(unit(c), unit(d), cross(b, unit(c)), mirrors + 2);
            }
            for (; k < nodes_[node + 2]; k += 2) {
                Vec3<double> turned = vector(x, k);
                reflect(mirrors, second >= 0 ? 4 : 2, turned);
                double* entry = x + free_[k];
                for (int i = 0; i < dimension_; ++i)
                    if (i != free_[k + 1]) *entry++ = turned[i];
            }
        }
    }

    /// Tells whether the last two corrections of multipliers leave little of them.
    ///
    /// Where a constraint holds a node in place, no coordinate shows what a kept matrix leaves of
    /// its force: |R - 1| of each correction, R the turn since the matrix was made.
    /// @param change       the last correction, m entries.
    /// @param multipliers  with it.
    /// @param before       size of the correction before, N m; becomes that of the last one.
    [[nodiscard]] static bool balances(const DynamicProblem& problem, const VectorX& change,
                                       const VectorX& multipliers, double& before) {
        constexpr double enough = 1e-4;
        const VectorX arms = problem.assembly().violation_scale(problem.length_scale());
        const auto size = [&](const VectorX& x) {
            double sum = 0.0;
            for (Eigen::Index k = 0; k < x.size(); ++k) sum += arms[k] * x[k] * (arms[k] * x[k]);
            return std::sqrt(problem.sum_of_parts(sum));
        };
        const double last = size(change);
        const double shrinks = std::min(last / before, 0.99);
        before = last;
        return !(shrinks / (1.0 - shrinks) * last > enough * size(multipliers));
    }

    /// Gives slopes and curvatures the strains that they had: those of `from`, turned as the nodes
    /// turn to q.
    /// @param from, q  n entries each.
    void keep_strains(const VectorX& from, VectorX& q) const {
        VectorX turned = from;
        carry(from, q, turned.data());
        for (const int first : directions_)
            q.segment(first, dimension_) = turned.segment(first, dimension_);
    }

    /// Begins a step: takes back the strains of a prediction, unless the last step was predicted
    /// better with them.
    /// @param from  of the step's start.
    /// @param q     the prediction; of several the last one tells.
    void begin_step(const VectorX& from, VectorX& q) {
        predicted_ = true;
        strained_ = q;
        unstrained_ = q;
        keep_strains(from, unstrained_);
        if (keeps_) q = unstrained_;
    }
    /// Compares the predictions of the step with its end. The one with strains is to be twice as
    /// near to be kept: a stiff body feels false strains first.
    void compare(const DynamicProblem& problem, const VectorX& end) {
        if (turn_ && predicted_)  // alike in all parts, whatever they hold
            keeps_ = problem.largest_ratio(end - unstrained_) <=
                     2.0 * problem.largest_ratio(end - strained_);
        predicted_ = false;
    }
    /// Tells whether steps begin with the strains of their start.
    [[nodiscard]] bool keeps() const { return turn_ && keeps_; }

    /// Begins with frames that turn, in a scene that is known to be stiff.
    void turn_at_once() { turn_ = true; }
    /// Tells whether the frames turn.
    [[nodiscard]] bool turn() const { return turn_; }

    /// Counts a correction.
    void add_correction() { work_ += 1.0; }
    /// Counts a tangent with its factorisation.
    void add_tangent() { work_ += 3.0; }

    /// Counts a failure of Newton's method, or of a matrix; tells whether a trial of the other way
    /// begins.
    bool fail() {
        if (trial_ > 0.0 || ++failures_ < patience_) return false;
        trial_ = trial_steps;
        change();
        return true;
    }

    /// Counts a step, s. A trial that took more work in a second than before is taken back. The
    /// next one waits for twice as many failures.
    void end_step(double width) {
        time_ += width;
        if (trial_ == 0.0 || --trial_ > 0.0) return;
        patience_ *= 2.0;
        if (work_ > rate_ * time_) change();
    }

    /// Returns what a run that goes on needs.
    [[nodiscard]] VectorX memory() const {
        VectorX numbers(8);
        numbers << (turn_ ? 1.0 : 0.0), failures_, patience_, trial_, work_, time_, rate_,
            (keeps_ ? 1.0 : 0.0);
        return numbers;
    }

    /// Takes it from a memory.
    void recall(const Memory& memory) {
        const VectorX& numbers = memory.get("frames", 8);
        turn_ = numbers[0] != 0.0;
        failures_ = numbers[1];
        patience_ = numbers[2];
        trial_ = numbers[3];
        work_ = numbers[4];
        time_ = numbers[5];
        rate_ = numbers[6];
        keeps_ = numbers[7] != 0.0;
    }

private:
    static constexpr double trial_steps = 20.0;
    static constexpr int none = -1, several = -2;

    /// Returns which component of a vector a support holds.
    /// @param first  coordinate of the vector
    [[nodiscard]] int held_component(const Numbering& numbers, int first) const {
        int held = none;
        for (int i = 0; i < dimension_; ++i)
            if (numbers.equation(first + i) < 0) held = held == none ? i : several;
        return dimension_ == 2 && held >= 0 ? several : held;
    }

    /// Returns the axis that all held slopes of a node in space are normal to.
    [[nodiscard]] int hinge_axis(const Scene& scene, const Numbering& numbers, int node) const {
        const Layout& layout = scene.layout();
        const VectorX& q = scene.state().q;
        int axis = none;
        for (int k = layout.first(node); k < layout.first(node + 1); k += dimension_) {
            const int held = held_component(numbers, k);
            if (held < 0 || length_power(layout.field_of(k)) != 0) continue;
            const bool normal = std::abs(q[k + held]) < 1e-3 * length(vec3<double>(q, k));
            axis = normal && (axis == none || axis == held) ? held : several;
        }
        return axis;
    }

    // Returns a vector by its place in free_.
    [[nodiscard]] Vec3<double> vector(const double* x, int place) const {
        const double* entry = x + free_[place];
        Vec3<double> all = {};
        for (int i = 0; i < dimension_; ++i)
            if (i != free_[place + 1]) all[i] = *entry++;
        return all;
    }
    [[nodiscard]] static Vec3<double> unit(const Vec3<double>& a) { return a / length(a); }

    // The least turn between unit vectors; where they are opposite, by way of a normal of a.
    ANCF_NOINLINE static void set_mirrors(const Vec3<double>& a, const Vec3<double>& b,
                                          const Vec3<double>& normal, Vec3<double>* mirrors) {
        const Vec3<double> sum = a + b;
        const double size = length(sum);
        mirrors[0] = a;
        mirrors[1] = size > 1e-6 ? sum / size : normal;
    }

    ANCF_NOINLINE static void reflect(const Vec3<double>* mirrors, int count, Vec3<double>& x) {
        for (int k = 0; k < count; ++k) add(x, -2.0 * dot(mirrors[k], x), mirrors[k]);
    }

    void change() {
        turn_ = !turn_;
        rate_ = time_ > 0.0 ? work_ / time_ : std::numeric_limits<double>::max();
        failures_ = work_ = time_ = 0.0;
    }

    int dimension_;
    List<int> free_;        // of each vector its first equation and the component held or -1
    List<int> directions_;  // of free vectors but positions the first equation
    List<int> nodes_;       // of each node places of slopes in free_ or -1, and of its last's end
    bool turn_ = false;
    double failures_ = 0.0;
    double patience_;         // after how many failures the other way is tried
    double trial_ = 0.0;      // steps left of a trial
    double work_ = 0.0;       // corrections and tangents since they turn or do not
    double time_ = 0.0;       // s, of the steps since then
    double rate_ = 0.0;       // work in a second before
    bool keeps_ = true;       // whether a prediction without strains was at most twice as far off
    bool predicted_ = false;  // whether there are predictions to be compared
    VectorX strained_, unstrained_;  // predictions of a step
};

/// Returns a typical energy of a step, J: the kinetic one of its start, or of what the
/// accelerations there move, and the strain energy.
/// @param v, a    n rates and accelerations.
/// @param strain  its energy at the start, J.
/// @param width   of the step, s.
ANCF_NOINLINE inline double typical_energy(const DynamicProblem& problem, const VectorX& v,
                                           const VectorX& a, double strain, double width) {
    const auto product = [&problem](const VectorX& x) {
        VectorX momentum = VectorX::Zero(x.size());
        problem.add_mass_product(0.5, x, momentum);
        return momentum.dot(x);
    };
    return std::max(product(v), width * width * product(a)) + strain;
}

}  // namespace ancf::detail
