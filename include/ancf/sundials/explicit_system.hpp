// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A dynamic problem without multipliers as y' = f(t, y), behind C callbacks:
///
///     y = (q, v),    f = (v, -M^-1 r(t, q, v)).
///
/// No exception leaves a callback: it is kept and thrown again once ARKODE has returned.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/sundials/context.hpp>
#include <ancf/sundials/table.hpp>
#include <ancf/types.hpp>

#include <exception>
#include <optional>
#include <utility>

namespace ancf::sundials::detail {

/// What an explicit method integrates, and how long its steps may be.
class ExplicitSystem {
public:
    /// @pre problem.start() has converged; no multipliers.
    /// @param every  steps between two estimates of the stable one.
    ExplicitSystem(DynamicProblem& problem, Reach reach, int every);

    [[nodiscard]] Eigen::Index size() const noexcept { return 2 * static_cast<Eigen::Index>(n_); }

    /// The parts of y or of a vector of its size.
    template <class Column>
    [[nodiscard]] auto q(Column&& y) const {
        return y.head(n_);
    }
    template <class Column>
    [[nodiscard]] auto v(Column&& y) const {
        return y.tail(n_);
    }

    static int rate(sunrealtype t, N_Vector y, N_Vector dy, void* self) noexcept;
    static int stability(N_Vector y, sunrealtype t, sunrealtype* step, void* self) noexcept;

    /// Estimates the longest stable step from the largest eigenvalues of M^-1 K and M^-1 D.
    ///
    /// Every eigenvalue mu of the linearised system has |mu| <= d/2 + sqrt(d^2/4 + w^2), with w^2
    /// and d those of M^-1 K and M^-1 D. Where an element fails the last estimate stays.
    void estimate(double t, const VectorX& q, const VectorX& v);

    [[nodiscard]] double stable_step() const noexcept { return stable_step_; }  ///< s
    [[nodiscard]] double frequency() const noexcept { return frequency_; }      ///< rad/s
    [[nodiscard]] long evaluations() const noexcept { return evaluations_; }    ///< of the force
    [[nodiscard]] long estimates() const noexcept { return estimates_; }        ///< of the step

    /// Throws what a callback of the scene threw.
    void rethrow() {
        if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    }

    /// Returns the element that failed in the last evaluation, if one did.
    [[nodiscard]] const std::optional<Fault>& fault() const noexcept { return fault_; }
    void forget_fault() noexcept { fault_.reset(); }

private:
    template <class Work>
    int guarded(const Work& work) noexcept;
    [[nodiscard]] double largest(const SparseMatrix& matrix) const;

    DynamicProblem& problem_;
    Reach reach_;
    int every_;
    int n_;
    Request request_;
    VectorX q_, v_, none_, acceleration_;
    double stable_step_, frequency_ = 0.0;
    int since_ = 0;  // steps since the last estimate
    long evaluations_ = 0, estimates_ = 0;
    std::exception_ptr failure_;
    std::optional<Fault> fault_;
};

}  // namespace ancf::sundials::detail

#if !defined(ANCF_COMPILED)
#include <ancf/sundials/explicit_system.ipp>  // IWYU pragma: export
#endif
