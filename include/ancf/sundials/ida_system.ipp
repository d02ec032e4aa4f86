// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of ida_system.hpp.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/sundials/ida.hpp>
#include <ancf/sundials/ida_system.hpp>

#include <sunmatrix/sunmatrix_sparse.h>

#include <algorithm>
#include <cmath>

namespace ancf::sundials::detail {

ANCF_INLINE void JacobianMap::append(const SparseMatrix& pattern, int column, int from, int to,
                                     int shift, std::vector<sunindextype>& place) {
    for (int k = pattern.outerIndexPtr()[column]; k < pattern.outerIndexPtr()[column + 1]; ++k) {
        const int row = pattern.innerIndexPtr()[k];
        if (row < from || row >= to) continue;
        place[k] = static_cast<sunindextype>(inner_.size());
        inner_.push_back(static_cast<sunindextype>(row) + shift);
    }
}

ANCF_INLINE JacobianMap::JacobianMap(const SparseMatrix& pattern, int n, Form form)
    : n_(n), form_(form) {
    const int all = static_cast<int>(pattern.cols());
    const int m = all - n;
    const bool stabilised = form == Form::gear_gupta_leimkuhler;
    static_cast<void>(checked_index(2 * pattern.cols(), "unknowns"));  // and so every row of J fits
    const auto count = static_cast<std::size_t>(pattern.nonZeros());
    motion_.assign(count, -1);
    rate_.assign(count, -1);
    kinematic_.assign(count, -1);
    kinematic_v_.assign(count, -1);
    const auto append_columns = [&](std::vector<sunindextype>& kinematic,
                                    std::vector<sunindextype>& motion, int end) {
        for (int j = 0; j < n; ++j) {
            if (stabilised)
                append(pattern, j, 0, n, 0, kinematic);
            else
                inner_.push_back(j);
            append(pattern, j, 0, end, n, motion);
            if (stabilised) append(pattern, j, n, all, n + m, kinematic);
            close_column();
        }
    };
    append_columns(kinematic_, motion_, all);  // q
    append_columns(kinematic_v_, rate_, n);    // v
    for (int j = n; j < all; ++j) {            // lambda
        append(pattern, j, 0, all, n, motion_);
        close_column();
    }
    for (int j = n; stabilised && j < all; ++j) {  // mu
        append(pattern, j, 0, n, 0, kinematic_);
        append(pattern, j, n, all, n + m, kinematic_);
        close_column();
    }
}

ANCF_INLINE void JacobianMap::fill(const JacobianParts& parts, double c, sunindextype* outer,
                                   sunindextype* inner, double* values) const noexcept {
    std::copy(outer_.begin(), outer_.end(), outer);
    std::copy(inner_.begin(), inner_.end(), inner);
    const SparseMatrix& pattern = parts.tangent;
    const double* tangent = parts.tangent.valuePtr();
    const double* mass = parts.mass.valuePtr();
    const double* damping = parts.damping != nullptr ? parts.damping->valuePtr() : nullptr;
    if (form_ == Form::index3)
        for (int j = 0; j < n_; ++j) {
            values[outer_[j]] = c;
            values[outer_[n_ + j]] = -1.0;
        }
    for (std::size_t k = 0; k < motion_.size(); ++k) {
        values[motion_[k]] = tangent[k];
        if (rate_[k] >= 0) values[rate_[k]] = c * mass[k] + (damping != nullptr ? damping[k] : 0.0);
    }
    if (form_ == Form::index3) return;
    const double* level = parts.velocity_level->valuePtr();
    for (int j = 0; j < static_cast<int>(pattern.cols()); ++j)
        for (int at = pattern.outerIndexPtr()[j]; at < pattern.outerIndexPtr()[j + 1]; ++at) {
            const auto k = static_cast<std::size_t>(at);
            const bool inertia = j < n_ && pattern.innerIndexPtr()[at] < n_;
            const bool of_q = j < n_;
            values[kinematic_[k]] = of_q ? level[k] + (inertia ? c * mass[k] : 0.0) : tangent[k];
            if (of_q) values[kinematic_v_[k]] = inertia ? -mass[k] : tangent[k];
        }
}

ANCF_INLINE IdaSystem::IdaSystem(DynamicProblem& problem, Form form)
    : SceneCalls(problem),
      form_(form),
      m_(problem.multipliers()),
      map_(problem.mass(), n_, form),
      units_(VectorX::Ones(map_.size())) {}

ANCF_INLINE void IdaSystem::set_units(const VectorX& sizes) {
    for (Eigen::Index i = 0; i < units_.size(); ++i)
        units_[i] =
            sizes[i] > 0.0 ? ancf::detail::power_of_two(std::ilogb(sizes[i])) : 1.0;  // exact
}

ANCF_INLINE int IdaSystem::residual(sunrealtype t, N_Vector y, N_Vector dy, N_Vector r,
                                    void* self) noexcept {
    auto& system = *static_cast<IdaSystem*>(self);
    return system.guarded([&] { return system.write_residual(t, view(y), view(dy), view(r)); });
}

ANCF_INLINE int IdaSystem::jacobian(sunrealtype t, sunrealtype c, N_Vector y, N_Vector, N_Vector,
                                    SUNMatrix matrix, void* self, N_Vector, N_Vector,
                                    N_Vector) noexcept {
    auto& system = *static_cast<IdaSystem*>(self);
    return system.guarded([&] { return system.write_jacobian(t, c, view(y), matrix); });
}

ANCF_INLINE bool IdaSystem::evaluate(double t, const View& y, Request request) {
    y_ = y.cwiseProduct(units_);
    q_ = q(y_);
    v_ = v(y_);
    lambda_ = lambda(y_);
    mu_ = mu(y_);
    return SceneCalls::evaluate(t, lambda_, request);
}

ANCF_INLINE bool IdaSystem::turns_fit(double t) {
    const auto& constraints = problem_.model().constraints();
    const auto turn = ancf::detail::driven_turn(constraints, begin_, t);
    turn_ = turn.fits() ? "" : ancf::detail::driven_turn_text(constraints, turn, begin_, t);
    return turn.fits();
}

ANCF_INLINE int IdaSystem::write_residual(double t, const View& y, const View& dy, View r) {
    if (!turns_fit(t) || !evaluate(t, y, Request::force)) return recoverable;
    const SparseMatrix& mass = problem_.compact_mass();
    dy_ = dy.cwiseProduct(units_);
    v(r) = problem_.force();
    v(r).noalias() += mass * v(dy_);
    lambda(r) = problem_.constraint_residual();
    gap_ = q(dy_) - v_;
    if (form_ == Form::index3) {
        q(r) = gap_;
        return good;
    }
    kinematic_.noalias() = mass * gap_;
    problem_.evaluate_constraints(t, q_, v_, false);
    problem_.constraints().add_transpose_product(mu_, 1.0, kinematic_);
    q(r) = kinematic_;
    mu(r) = problem_.constraints().rate();
    for (const int equation : problem_.left_out()) mu(r)[equation] = mu_[equation];
    return good;
}

ANCF_INLINE int IdaSystem::write_jacobian(double t, double c, const View& y, SUNMatrix matrix) {
    if (!evaluate(t, y, request_)) return recoverable;
    const bool stabilised = form_ == Form::gear_gupta_leimkuhler;
    if (stabilised) {
        problem_.evaluate_constraints(t, q_, v_);
        problem_.velocity_level(mu_, velocity_level_);
    }
    const JacobianParts parts{problem_.tangent(), problem_.mass(),
                              request_ == Request::tangent ? nullptr : &problem_.damping(),
                              stabilised ? &velocity_level_ : nullptr};
    sunindextype* outer = SUNSparseMatrix_IndexPointers(matrix);
    double* values = SUNSparseMatrix_Data(matrix);
    map_.fill(parts, c, outer, SUNSparseMatrix_IndexValues(matrix), values);
    for (Eigen::Index j = 0; j < units_.size(); ++j)
        for (sunindextype k = outer[j]; k < outer[j + 1]; ++k) values[k] *= units_[j];
    return good;
}

}  // namespace ancf::sundials::detail
