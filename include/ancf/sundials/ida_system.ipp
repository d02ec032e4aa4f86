// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of ida_system.hpp.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/sundials/ida_system.hpp>

#include <sunmatrix/sunmatrix_sparse.h>

#include <cmath>

namespace ancf::sundials::detail {

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
    problem_.evaluate_constraints(t, q_, v_);
    problem_.add_constraint_force(mu_, 1.0, kinematic_);
    q(r) = kinematic_;
    mu(r) = problem_.constraint_rate();
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
