// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/dynamics/constraint_set.hpp>
#include <ancf/list.hpp>
#include <ancf/solver/redundancy.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ancf::detail {

template <class Visitor>
void ConstraintSet::for_each(const Visitor& visit) const {
    for (std::size_t k = 0; k < results_.size(); ++k)
        visit(static_cast<int>(k), results_[k], assembly_.constraint_coordinates(k).acted(),
              first_[k]);
}

template <class Visitor>
void ConstraintSet::for_each_entry(const Visitor& visit) const {
    for_each([&](int, const ConstraintResult& result, const List<int>& at, int first) {
        for (std::size_t j = 0; j < at.size(); ++j) {
            const int equation = assembly_.numbering().equation(at[j]);
            if (equation < 0) continue;
            for (int i = 0; i < result.jacobian.rows(); ++i)
                if (!left_out(first + i)) visit(first + i, equation, result.jacobian(i, j));
        }
    });
}

ANCF_INLINE ConstraintSet::ConstraintSet(const Assembly& assembly)
    : assembly_(assembly), constraints_(assembly.model().constraints()) {
    int first = 0;
    for (const AnyConstraint& constraint : constraints_) {
        first_.push_back(first);
        first += constraint.equations();
    }
    results_.resize(constraints_.size());
    left_out_.assign(static_cast<std::size_t>(first), 0);
    violation_.setZero(first);
    rate_.setZero(first);
    full_rate_.setZero(first);
    convection_.setZero(first);
}

ANCF_INLINE void ConstraintSet::evaluate(double time, const VectorX& q, const VectorX& v,
                                         bool convection) {
    if (convection) {
        time_ = time;
        q_ = q;
        v_ = v;
    }
    local_.time = time;
    for (std::size_t k = 0; k < results_.size(); ++k) {
        const AnyConstraint& constraint = constraints_[k];
        const LocalCoordinates& coordinates = assembly_.constraint_coordinates(k);
        ConstraintResult& result = results_[k];
        const int equations = constraint.equations(), first = first_[k];
        gather(q, coordinates.read(), local_.q);
        gather(v, coordinates.read(), local_.v);
        local_.multipliers.setZero(equations);
        if (convection) {
            constraint.evaluate(local_, result);
        } else {
            constraint.terms(local_, result);
        }
        for (int i = 0; i < equations; ++i) {
            double slide = 0.0;
            for (Eigen::Index j = 0; j < result.jacobian.cols(); ++j)
                slide += result.jacobian(i, j) * local_.v[j];
            violation_[first + i] = result.violation[i];
            full_rate_[first + i] = slide + result.rate[i];
            rate_[first + i] = left_out(first + i) ? 0.0 : full_rate_[first + i];
            if (convection)
                convection_[first + i] = left_out(first + i) ? 0.0 : result.convection[i];
        }
        coordinates.carry_columns(result.jacobian);
    }
}

ANCF_INLINE VectorX ConstraintSet::product(const VectorX& a) const {
    VectorX out = VectorX::Zero(size());
    for_each([&](int, const ConstraintResult& result, const List<int>& at, int first) {
        VectorX local;
        gather(a, at, local);
        const VectorX part = multiply(result.jacobian, local);
        std::copy_n(part.data(), part.size(), out.data() + first);
    });
    for (int i = 0; i < size(); ++i)
        if (left_out(i)) out[i] = 0.0;
    return out;
}

ANCF_INLINE VectorX ConstraintSet::magnitude(const VectorX& x) const {
    VectorX out = VectorX::Zero(size());
    for_each([&](int, const ConstraintResult& result, const List<int>& at, int first) {
        for (Eigen::Index j = 0; j < result.jacobian.cols(); ++j)
            for (Eigen::Index i = 0; i < result.jacobian.rows(); ++i)
                out[first + i] += std::abs(result.jacobian(i, j)) * x[at[j]];
    });
    return out;
}

ANCF_INLINE void ConstraintSet::add_transpose_product(const VectorX& mu, double scale,
                                                      VectorX& free) const {
    for_each_entry(
        [&](int row, int free_one, double entry) { free[free_one] += scale * entry * mu[row]; });
}

ANCF_INLINE void ConstraintSet::write_jacobian(SparseMatrix& matrix) const {
    const BlockPattern& pattern = assembly_.pattern();
    double* const values = matrix.valuePtr();
    for_each([&](int constraint, const ConstraintResult& result, const List<int>& at, int first) {
        assembly_.visit_border(constraint, at, [&](int, int, int place, int mirrored) {
            values[place] = values[mirrored] = 0.0;
        });
        // added: a coupling may list a vector twice
        assembly_.visit_border(constraint, at, [&](int i, int j, int place, int mirrored) {
            if (left_out(first + i)) return;
            values[place] += result.jacobian(i, j);
            values[mirrored] += result.jacobian(i, j);
        });
        const int own = assembly_.numbering().constraint_block(constraint);
        for (int i = 0; i < result.jacobian.rows(); ++i)
            values[pattern.base(own, own) + pattern.column_offset(own, i) + i] =
                left_out(first + i) ? 1.0 : 0.0;
    });
}

ANCF_INLINE void ConstraintSet::write_rows(const List<int>& columns, MatrixX& rows) const {
    rows.setZero();
    for_each_entry(
        [&](int row, int free_one, double entry) { rows(row, columns[free_one]) += entry; });
}

/// Returns dG/dt = d(g_t)/dq, as of a joint whose drive turns its axes: by a difference over the
/// time in which the drive moves 1e-5 of what vectors of their lengths make of an equation.
[[nodiscard]] ANCF_INLINE MatrixX turn_of_jacobian(const AnyConstraint& constraint,
                                                   ConstraintState state, int dimension) {
    constexpr double share = 1e-5;
    constexpr double resolved = 1e-10;  // of the time, at least
    state.multipliers.setZero(constraint.equations());
    ConstraintResult now, later;
    constraint.terms(state, now);
    double pace = 0.0;  // 1/s
    for (Eigen::Index e = 0; e < now.jacobian.rows(); ++e) {
        double size = 0.0;
        for (Eigen::Index k = 0; k < state.q.size(); k += dimension)
            size += now.jacobian.row(e).segment(k, dimension).norm() *
                    state.q.segment(k, dimension).norm();
        if (size > 0.0) pace = std::max(pace, std::abs(now.rate[e]) / size);
    }
    if (!(pace > 0.0)) return MatrixX::Zero(now.jacobian.rows(), now.jacobian.cols());
    const double later_by = std::max(share / pace, resolved * std::abs(state.time));
    const double start = std::exchange(state.time, state.time + later_by);
    constraint.terms(state, later);
    if (!later.jacobian.allFinite()) return MatrixX::Zero(now.jacobian.rows(), now.jacobian.cols());
    return (later.jacobian - now.jacobian) / (state.time - start);
}

ANCF_INLINE void ConstraintSet::add_velocity_level(const VectorX& mu, SparseMatrix& matrix) const {
    double* values = matrix.valuePtr();
    ConstraintState local;
    ConstraintResult result;
    local.time = time_;
    const int dimension = assembly_.model().layout().dimension();
    for (std::size_t k = 0; k < results_.size(); ++k) {
        const AnyConstraint& constraint = constraints_[k];
        const LocalCoordinates& coordinates = assembly_.constraint_coordinates(k);
        const List<int>&read = coordinates.read(), &at = coordinates.acted();
        const int equations = constraint.equations();
        gather(q_, read, local.q);
        gather(v_, read, local.v);
        const MatrixX turn = turn_of_jacobian(constraint, local, dimension);
        for (int e = 0; e < equations; ++e) {
            if (left_out(first_[k] + e)) continue;
            // with one multiplier 1 the stiffness is the Hessian of that equation
            local.multipliers.setZero(equations);
            local.multipliers[e] = 1.0;
            constraint.evaluate(local, result);
            const auto own = [&](Eigen::Index i) {
                return result.active.empty() ? static_cast<int>(i) : result.active[i];
            };
            VectorX row = turn.row(e).transpose();
            for (Eigen::Index j = 0; j < result.stiffness.cols(); ++j)
                for (Eigen::Index i = 0; i < result.stiffness.rows(); ++i)
                    row[own(i)] += result.stiffness(i, j) * local.v[own(j)];
            coordinates.carry(row);
            const List<int>& stiff = coordinates.carry(result.stiffness, result.active);
            assembly_.visit_border(static_cast<int>(k), at, [&](int i, int j, int place, int) {
                if (i == e) values[place] += row[j];
            });
            const double weight = mu[first_[k] + e];
            if (weight != 0.0) assembly_.add_matrix(stiff, weight, result.stiffness, matrix);
        }
    }
}

ANCF_INLINE std::string ConstraintSet::describe(int equation) const {
    return describe_equation(constraints_, equation);
}

}  // namespace ancf::detail
