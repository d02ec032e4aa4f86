// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// How far a scene is from equilibrium, in numbers without units.
///
/// Forces and the moments that work on slopes are measured apart, each against the loads and
/// reactions of the scene, so that neither units nor slenderness decide when a solution stops.

#pragma once

#include <ancf/assembly/assembly.hpp>
#include <ancf/assembly/numbering.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ancf {

namespace detail {

/// Returns the diagonal of the box around all positions, m; 0 of none.
/// @param exchange  of a part of a scene, whose other parts count too
[[nodiscard]] inline double diagonal_of(const Layout& layout, int dimension, const VectorX& q,
                                        const Exchange* exchange = nullptr) {
    double square = 0.0;
    for (int k = 0; k < dimension; ++k) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (int node = 0; node < layout.nodes(); ++node) {
            if (!layout.fields(node).contains(Field::r)) continue;
            low = std::min(low, q[layout.first(node) + k]);
            high = std::max(high, q[layout.first(node) + k]);
        }
        if (exchange != nullptr) {
            low = -exchange->largest(-low);
            high = exchange->largest(high);
        }
        if (high > low) square += (high - low) * (high - low);
    }
    return std::sqrt(square);
}

/// Returns a length to the power that it has in the unit of each free coordinate.
[[nodiscard]] inline VectorX length_powers(double length, const Layout& layout,
                                           const Numbering& numbering) {
    VectorX powers(numbering.free_coordinates());
    for (int k = 0; k < numbering.coordinates(); ++k)
        if (const int equation = numbering.equation(k); equation >= 0)
            powers[equation] = std::pow(length, length_power(layout.field_of(k)));
    return powers;
}

}  // namespace detail

/// Measures residuals and corrections of one scene.
class ConvergenceMonitor {
public:
    /// Measures the scene as it stands.
    ConvergenceMonitor(const Scene& model, const Numbering& numbering)
        : numbering_(numbering), exchange_(model.exchange()) {
        const Layout& layout = model.layout();
        for (int k = 0; k < layout.size(); ++k) power_.push_back(length_power(layout.field_of(k)));
        double sums[2] = {};
        auto& [length, count] = sums;  // of all elements
        for (const auto& group : model.groups()) {
            if (group->one_node()) continue;
            for (const Connection& connection : group->connections) {
                length += group->length(connection.prototype);
                count += 1.0;
            }
        }
        if (exchange_ != nullptr) exchange_->sum(sums, 2);
        const VectorX& q = model.state().q;
        detail::require(q.size() == layout.size(), "the state has ", q.size(),
                        " coordinates, the model has ", layout.size());
        const double diagonal = detail::diagonal_of(layout, model.dimension(), q, exchange_);
        if (count > 0.0)
            element_size_ = length / count;
        else if (diagonal > 0.0)
            element_size_ = diagonal;
        size_ = std::max(diagonal, element_size_);
    }

    /// Returns the violation of constraints of the last evaluation relative to what changes by the
    /// scene's size, of slopes by one, make of it.
    [[nodiscard]] double violation(const Assembly& assembly) const {
        const VectorX scale = assembly.violation_scale(size_);
        double sum = 0.0;
        for (Eigen::Index k = 0; k < scale.size(); ++k) {
            const double value = assembly.violation()[k];
            if (value == 0.0) continue;
            // what no coordinate changes is violated as a whole
            const double share = scale[k] > 0.0 || std::isnan(value) ? value / scale[k] : 1.0;
            sum += share * share;
        }
        if (exchange_ != nullptr) exchange_->sum(&sum, 1);
        return std::sqrt(sum);
    }

    /// Returns the larger of violation() and the residual of the last evaluation relative to loads,
    /// reactions and constraint forces.
    [[nodiscard]] double residual(const Assembly& assembly) const {
        const Norms loads = norms([&](int k) { return assembly.external_force()[k]; });
        const Norms joints = norms([&](int k) { return assembly.constraint_force()[k]; });
        const Norms reactions =
            norms([&](int k) { return numbering_.equation(k) < 0 ? assembly.unbalanced(k) : 0.0; });
        const Norms rest = unbalanced(assembly);

        const double moment = loads.moment + joints.moment + reactions.moment;
        const double force = loads.force + joints.force + reactions.force;
        const double smallest = std::numeric_limits<double>::min();
        const double of_force = rest.force / std::max(force + moment / size_, smallest);
        const double of_moment = rest.moment / std::max(moment + force * element_size_, smallest);
        const double violation = this->violation(assembly);
        // std::max would drop a NaN, and infinite loads hide any residual
        if (std::isnan(of_force + of_moment + violation) || !std::isfinite(force + moment) ||
            !std::isfinite(rest.force + rest.moment + violation))
            return std::numeric_limits<double>::quiet_NaN();
        // stressed inside, without loads and, as yet, without reactions: far from equilibrium
        return std::min(std::max({of_force, of_moment, violation}),
                        std::numeric_limits<double>::max());
    }

    /// Returns whether the residual is within the round-off of its own evaluation: below
    /// eps |K| |q|, what a relative change of every coordinate by eps makes of it. |K| is that of
    /// the free coordinates; what is held enters as docs/theory-statics.md says.
    [[nodiscard]] bool at_round_off(const Assembly& assembly, const VectorX& q) const {
        const SparseMatrix& tangent = assembly.tangent();
        const int unknowns = numbering_.free_coordinates();
        // Held coordinates have no column in the tangent: each free one is counted with held ones
        // of the size of its node's position and an element.
        VectorX sizes = q, at,
                reach = VectorX::Constant(numbering_.block_sizes().size(), element_size_);
        const auto node = [&](std::size_t k) { return numbering_.block(static_cast<int>(k)); };
        for (std::size_t k = 0; k < power_.size(); ++k) {
            double& size = sizes[k];
            size = std::abs(size);
            if (power_[k] > 0) reach[node(k)] = std::max(reach[node(k)], size + element_size_);
        }
        for (std::size_t k = 0; k < power_.size(); ++k)
            sizes[k] += reach[node(k)] * std::pow(element_size_, power_[k] - 1);
        numbering_.gather_free(sizes, at);
        VectorX floor = VectorX::Zero(numbering_.unknowns());
        const bool lower = assembly.pattern().storage() == Storage::lower;
        for (int j = 0; j < unknowns; ++j)
            for (int k = tangent.outerIndexPtr()[j]; k < tangent.outerIndexPtr()[j + 1]; ++k) {
                const int i = tangent.innerIndexPtr()[k];
                if (i >= unknowns) continue;
                const double value = std::abs(tangent.valuePtr()[k]);
                floor[i] += value * at[j];
                if (lower && i != j) floor[j] += value * at[i];
            }
        VectorX sums;  // of the coordinates, over all parts
        if (exchange_ != nullptr) {
            sums.setZero(numbering_.coordinates());
            numbering_.add_free_force(floor, 1.0, sums);
            exchange_->add(sums);
        }
        constexpr double epsilon = std::numeric_limits<double>::epsilon();
        const Norms rest = unbalanced(assembly);
        const Norms limit = norms([&](int k) {
            const int equation = numbering_.equation(k);
            if (equation < 0) return 0.0;
            return epsilon * (exchange_ != nullptr ? sums[k] : floor[equation]);
        });
        const double violated = violation(assembly);
        return std::isfinite(rest.force + rest.moment) && rest.force <= limit.force &&
               rest.moment <= limit.moment &&
               violated * size() <=
                   16.0 * epsilon * std::max(size(), detail::largest_magnitude(reach));
    }

    /// Returns the largest change of a position relative to the scene's size, of a slope, or of
    /// r_xx times the elements' length.
    [[nodiscard]] double correction(const VectorX& unknowns) const {
        double largest = 0.0;
        for (std::size_t k = 0; k < power_.size(); ++k) {
            const int equation = numbering_.equation(static_cast<int>(k));
            if (equation < 0) continue;
            const double value = std::abs(unknowns[equation]);
            largest = std::max(largest, power_[k] > 0   ? value / size_
                                        : power_[k] < 0 ? value * element_size_
                                                        : value);
        }
        if (exchange_ != nullptr) largest = exchange_->largest(largest);
        return largest;
    }

    /// Returns the diagonal of the scene, m.
    [[nodiscard]] double size() const noexcept { return size_; }

private:
    // Euclidean norms over positions, over slopes and what works on r_xx by the elements' length
    struct Norms {
        double force = 0.0;
        double moment = 0.0;
    };

    template <class Entry>
    [[nodiscard]] Norms norms(const Entry& entry) const {
        double sums[2] = {};
        auto& [force, moment] = sums;
        for (std::size_t k = 0; k < power_.size(); ++k) {
            if (exchange_ != nullptr && !exchange_->owns(static_cast<int>(k))) continue;
            double value = entry(static_cast<int>(k));
            if (power_[k] < 0) value /= element_size_;
            (power_[k] > 0 ? force : moment) += value * value;
        }
        if (exchange_ != nullptr) exchange_->sum(sums, 2);
        return {std::sqrt(force), std::sqrt(moment)};
    }
    // Of the forces that no support takes.
    [[nodiscard]] Norms unbalanced(const Assembly& assembly) const {
        return norms(
            [&](int k) { return numbering_.equation(k) < 0 ? 0.0 : assembly.unbalanced(k); });
    }

    const Numbering& numbering_;
    const detail::Exchange* exchange_;  // of a part of a scene
    List<int> power_;                   // of a length in the unit, per coordinate
    double size_ = 1.0;                 // diagonal of the scene, m
    double element_size_ = 1.0;         // mean reference length, m
};

}  // namespace ancf
