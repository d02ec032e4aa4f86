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
#include <ancf/model/layout.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace ancf {

/// Measures residuals and corrections of one scene.
class ConvergenceMonitor {
public:
    /// Measures the scene as it stands.
    template <class Scene>
    ConvergenceMonitor(const Scene& model, const Numbering& numbering);

    /// Returns the residual of the last evaluation relative to loads, reactions and constraint
    /// forces; the violation of constraints counts relative to what changes by the scene's size, of
    /// slopes by one, make of it.
    template <class Assembly>
    [[nodiscard]] double residual(const Assembly& assembly) const;

    /// Returns whether the residual is within the round-off of its own evaluation: below
    /// eps |K| |q|, what a relative change of every coordinate by eps makes of it.
    template <class Assembly>
    [[nodiscard]] bool at_round_off(const Assembly& assembly, const VectorX& q) const;

    /// Returns the largest change of a position relative to the scene's size, of a slope, or of
    /// r_xx times the elements' length.
    [[nodiscard]] double correction(const VectorX& unknowns) const;

    /// Returns the diagonal of the scene, m.
    [[nodiscard]] double size() const noexcept { return size_; }

private:
    // Euclidean norms over positions, over slopes and what works on r_xx by the elements' length
    struct Norms {
        double force = 0.0;
        double moment = 0.0;
    };

    template <class Entry>
    [[nodiscard]] Norms norms(Entry&& entry) const;

    template <class Assembly>
    [[nodiscard]] double violation(const Assembly& assembly) const;

    const Numbering& numbering_;
    std::vector<signed char> power_;  // of a length in the unit, per coordinate
    double size_ = 1.0;               // diagonal of the scene, m
    double element_size_ = 1.0;       // mean reference length, m
};

template <class Scene>
ConvergenceMonitor::ConvergenceMonitor(const Scene& model, const Numbering& numbering)
    : numbering_(numbering) {
    constexpr int dimension = Scene::dimension;
    const Layout& layout = model.layout();
    power_.assign(static_cast<std::size_t>(layout.size()), 0);
    for (int node = 0; node < layout.nodes(); ++node)
        for (const Field field : {Field::r, Field::r_xx})
            if (const int first = layout.index({{node}, field}); first >= 0)
                std::fill_n(power_.begin() + first, dimension,
                            static_cast<signed char>(length_power(field)));
    double length = 0.0;
    int count = 0;
    model.for_each_group([&](const auto& group) {
        for (std::size_t k = 0; k < group.connections.size(); ++k, ++count)
            length += group.element(static_cast<int>(k)).length();
    });
    if (count == 0) return;
    element_size_ = length / count;
    const VectorX& q = model.state().q;
    detail::require(q.size() == layout.size(), "the state has ", q.size(),
                    " coordinates, the model has ", layout.size());
    Vector<double, dimension> low =
        Vector<double, dimension>::Constant(std::numeric_limits<double>::infinity());
    Vector<double, dimension> high = -low;
    for (int node = 0; node < layout.nodes(); ++node) {
        if (!layout.fields(node).contains(Field::r)) continue;
        low = low.cwiseMin(q.template segment<dimension>(layout.first(node)));
        high = high.cwiseMax(q.template segment<dimension>(layout.first(node)));
    }
    size_ = std::max((high - low).norm(), element_size_);
}

template <class Entry>
ConvergenceMonitor::Norms ConvergenceMonitor::norms(Entry&& entry) const {
    Norms sums;
    for (std::size_t k = 0; k < power_.size(); ++k) {
        double value = entry(static_cast<int>(k));
        if (power_[k] < 0) value /= element_size_;
        (power_[k] > 0 ? sums.force : sums.moment) += value * value;
    }
    return {std::sqrt(sums.force), std::sqrt(sums.moment)};
}

template <class Assembly>
double ConvergenceMonitor::violation(const Assembly& assembly) const {
    const VectorX scale = assembly.violation_scale(size_);
    double sum = 0.0;
    for (Eigen::Index k = 0; k < scale.size(); ++k) {
        const double value = assembly.violation()[k];
        if (value == 0.0) continue;
        // what no coordinate changes is violated as a whole
        const double share = scale[k] > 0.0 || std::isnan(value) ? value / scale[k] : 1.0;
        sum += share * share;
    }
    return std::sqrt(sum);
}

template <class Assembly>
double ConvergenceMonitor::residual(const Assembly& assembly) const {
    const VectorX& internal = assembly.internal_force();
    const VectorX& external = assembly.external_force();
    const VectorX& constraint = assembly.constraint_force();
    const auto unbalanced = [&](int k) { return internal[k] + constraint[k] - external[k]; };
    const Norms loads = norms([&](int k) { return external[k]; });
    const Norms joints = norms([&](int k) { return constraint[k]; });
    const Norms reactions =
        norms([&](int k) { return numbering_.equation(k) < 0 ? unbalanced(k) : 0.0; });
    const Norms rest =
        norms([&](int k) { return numbering_.equation(k) < 0 ? 0.0 : unbalanced(k); });

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
    return std::min(std::max({of_force, of_moment, violation}), std::numeric_limits<double>::max());
}

template <class Assembly>
bool ConvergenceMonitor::at_round_off(const Assembly& assembly, const VectorX& q) const {
    const SparseMatrix& tangent = assembly.tangent();
    const int unknowns = numbering_.free_coordinates();
    VectorX magnitude;
    numbering_.gather_free(q.cwiseAbs(), magnitude);
    VectorX floor = VectorX::Zero(numbering_.unknowns());
    const bool lower = assembly.pattern().storage() == Storage::lower;
    for (int j = 0; j < unknowns; ++j)
        for (SparseMatrix::InnerIterator it(tangent, j); it; ++it) {
            const auto i = static_cast<int>(it.row());
            if (i >= unknowns) continue;
            floor[i] += std::abs(it.value()) * magnitude[j];
            if (lower && i != j) floor[j] += std::abs(it.value()) * magnitude[i];
        }
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const auto free_entry = [&](const auto& entry) {
        return [&](int k) { return numbering_.equation(k) < 0 ? 0.0 : entry(k); };
    };
    const auto unbalanced = [&](int k) {
        return assembly.internal_force()[k] + assembly.constraint_force()[k] -
               assembly.external_force()[k];
    };
    const auto noise = [&](int k) { return epsilon * floor[numbering_.equation(k)]; };
    const Norms rest = norms(free_entry(unbalanced));
    const Norms limit = norms(free_entry(noise));
    return std::isfinite(rest.force + rest.moment) && rest.force <= limit.force &&
           rest.moment <= limit.moment && violation(assembly) <= 16.0 * epsilon;
}

inline double ConvergenceMonitor::correction(const VectorX& unknowns) const {
    double largest = 0.0;
    for (std::size_t k = 0; k < power_.size(); ++k) {
        const int equation = numbering_.equation(static_cast<int>(k));
        if (equation < 0) continue;
        const double value = std::abs(unknowns[equation]);
        largest = std::max(largest, power_[k] > 0   ? value / size_
                                    : power_[k] < 0 ? value * element_size_
                                                    : value);
    }
    return largest;
}

}  // namespace ancf
