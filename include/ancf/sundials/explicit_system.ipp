// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of explicit_system.hpp.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/dynamics/frequency.hpp>
#include <ancf/sundials/explicit_system.hpp>

#include <cmath>
#include <exception>
#include <limits>

namespace ancf::sundials::detail {

ANCF_INLINE ExplicitSystem::ExplicitSystem(DynamicProblem& problem, Reach reach, int every)
    : problem_(problem),
      reach_(reach),
      every_(every),
      n_(problem.size()),
      request_(problem.model().loads().empty() ? Request::tangent : Request::tangent_and_damping),
      stable_step_(std::numeric_limits<double>::infinity()) {}

template <class Work>
int ExplicitSystem::guarded(const Work& work) noexcept {
    try {
        return work(*this);
    } catch (...) {
        failure_ = std::current_exception();
        return -1;
    }
}

ANCF_INLINE int ExplicitSystem::rate(sunrealtype t, N_Vector y, N_Vector dy, void* self) noexcept {
    return static_cast<ExplicitSystem*>(self)->guarded([&](ExplicitSystem& system) {
        const auto at = view(y);
        auto out = view(dy);
        system.q_ = system.q(at);
        system.v_ = system.v(at);
        ++system.evaluations_;
        const auto fault =
            system.problem_.evaluate(t, system.q_, system.v_, system.none_, Request::force);
        if (fault) {
            system.fault_ = fault;
            return 1;  // ARKODE tries a smaller step
        }
        system.problem_.solve_mass(system.problem_.force(), system.acceleration_);
        system.q(out) = system.v_;
        system.v(out) = -system.acceleration_;
        return 0;
    });
}

ANCF_INLINE int ExplicitSystem::stability(N_Vector y, sunrealtype t, sunrealtype* step,
                                          void* self) noexcept {
    return static_cast<ExplicitSystem*>(self)->guarded([&](ExplicitSystem& system) {
        if (++system.since_ >= system.every_) {
            const auto at = view(y);
            system.q_ = system.q(at);
            system.v_ = system.v(at);
            system.estimate(t, system.q_, system.v_);
        }
        *step = std::isfinite(system.stable_step_) ? system.stable_step_ : 0.0;  // 0: no limit
        return 0;
    });
}

ANCF_INLINE double ExplicitSystem::largest(const SparseMatrix& matrix) const {
    const Storage storage = problem_.assembly().pattern().storage();
    VectorX all_modes = ancf::detail::scattered(problem_.scales(), 0);
    return ancf::detail::largest_eigenvalue(
        all_modes, [&](const VectorX& x) { return ancf::detail::multiply(matrix, storage, x); },
        [&](const VectorX& x) {
            return ancf::detail::multiply(problem_.compact_mass(), Storage::full, x);
        },
        [&](const VectorX& b) {
            VectorX x;
            problem_.solve_mass(b, x);
            return x;
        });
}

ANCF_INLINE void ExplicitSystem::estimate(double t, const VectorX& q, const VectorX& v) {
    since_ = 0;
    ++estimates_;
    if (problem_.evaluate(t, q, v, none_, request_)) return;
    frequency_ = std::sqrt(largest(problem_.tangent()));
    const double damping = request_ == Request::tangent ? 0.0 : 0.5 * largest(problem_.damping());
    const bool damped = damping > 1e-3 * frequency_;
    const double fastest = damping + std::sqrt(damping * damping + frequency_ * frequency_);
    stable_step_ = (damped ? reach_.disc : reach_.axis) / fastest;
}

}  // namespace ancf::sundials::detail
