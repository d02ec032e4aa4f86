// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/error.hpp>
#include <ancf/solver/direct_solver.hpp>

#include <algorithm>
#include <cmath>

namespace ancf::detail {

ANCF_INLINE void require_singular_rcond(double limit) {
    require(limit >= 0.0 && limit < 1.0, "solver: singular_rcond must be in [0, 1), got ", limit);
}

ANCF_INLINE void symmetric_roots(const SparseMatrix& matrix, VectorX& roots) {
    roots.resize(matrix.cols());
    const int* inner = matrix.innerIndexPtr();
    bool complete = true;
    for (int column = 0; column < matrix.outerSize(); ++column) {
        const int* end = inner + matrix.outerIndexPtr()[column + 1];
        const int* entry = std::lower_bound(inner + matrix.outerIndexPtr()[column], end, column);
        const bool stored = entry != end && *entry == column;
        roots[column] = stored ? std::sqrt(std::abs(matrix.valuePtr()[entry - inner])) : 0.0;
        complete = complete && roots[column] > 0.0;
    }
    if (!complete) complete_roots(matrix, 1.0, roots);
}

ANCF_INLINE double probe_load(const VectorX& roots, VectorX& load) {
    load.resize(roots.size());
    double sum = 0.0;
    for (Eigen::Index i = 0; i < roots.size(); ++i) {
        const double weight = probe_weight(i);
        load[i] = roots[i] * weight;
        sum += weight * weight;
    }
    return sum;
}

ANCF_INLINE double rcond_by_energy(double weights, double energy) noexcept {
    if (!std::isfinite(energy)) return 0.0;
    return energy > 0.0 ? std::min(1.0, probe_share * probe_share * weights / energy) : 1.0;
}

ANCF_INLINE int softest_unknown(const VectorX& roots, const VectorX& solution) {
    eigen_assert(roots.size() == solution.size());
    int softest = -1;
    double largest = -1.0;
    for (Eigen::Index i = 0; i < roots.size(); ++i) {
        const double motion = std::abs(roots[i] * solution[i]);
        if (!std::isfinite(motion)) return -1;
        if (motion > largest) softest = static_cast<int>(i);
        largest = std::max(largest, motion);
    }
    return softest;
}

ANCF_INLINE void report_failure(const SparseMatrix& matrix, int column, FactorReport& report) {
    report.status = all_finite(matrix) ? Status::singular : Status::not_finite;
    report.failed_column = column;
    report.negative_pivots = -1;
}

/// Returns an estimate of 1 / rho(|A^-1| |A|), which no scales of unknowns and equations change.
///
/// Takes the largest growth of x by |A^-1| |A| in a few iterations. |A^-1| y is taken as
/// |A^-1 D y|, D of random signs.
/// @param x  where it begins.
ANCF_INLINE double rcond_of_any_scale(
    const SparseMatrix& matrix, Storage storage, VectorX x,
    const std::function<void(const VectorX& b, VectorX& x)>& solve) {
    constexpr int settled = 2, iterations = 8;
    double growth = 0.0;
    VectorX load;
    for (int k = 0;; ++k) {
        const double size = largest_magnitude(x);
        if (!std::isfinite(size) || size == 0.0) return 0.0;
        if (k > settled) growth = std::max(growth, size);
        if (k == iterations) return 1.0 / growth;
        load.setZero(x.size());
        for (int column = 0; column < matrix.outerSize(); ++column)
            for (int at = matrix.outerIndexPtr()[column]; at < matrix.outerIndexPtr()[column + 1];
                 ++at) {
                const int row = matrix.innerIndexPtr()[at];
                const double value = std::abs(matrix.valuePtr()[at]) / size;
                load[row] += value * std::abs(x[column]);
                if (storage == Storage::lower && row != column)
                    load[column] += value * std::abs(x[row]);
            }
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            const double weight = probe_weight(i + k * x.size());
            load[i] *= weight < 1.0 ? weight - 1.5 : weight;
        }
        solve(load, x);
    }
}

ANCF_INLINE void report_condition(const SparseMatrix& matrix, Storage storage, double limit,
                                  const std::function<void(const VectorX& b, VectorX& x)>& solve,
                                  FactorReport& report) {
    VectorX roots;
    VectorX load;
    VectorX solution;
    symmetric_roots(matrix, roots);
    const double weights = probe_load(roots, load);
    solve(load, solution);
    VectorX motion = solution;
    for (Eigen::Index i = 0; i < roots.size(); ++i) motion[i] *= roots[i];
    const double largest = largest_magnitude(motion);
    double sum = 0.0;
    for (const double entry : motion) sum += (entry / largest) * (entry / largest);
    const double size = largest * std::sqrt(sum);
    report.rcond = largest == 0.0        ? 1.0
                   : std::isfinite(size) ? std::min(1.0, probe_share * std::sqrt(weights) / size)
                                         : 0.0;
    if (!(report.rcond > limit)) {
        // the diagonal of a body that bears little is no scale of its unknowns
        const double any = rcond_of_any_scale(matrix, storage, solution, solve);
        if (any > 1e3 * limit) report.rcond = any;
    }
    if (!(report.rcond > limit)) report_failure(matrix, softest_unknown(roots, solution), report);
}

ANCF_INLINE DirectSolver::DirectSolver(double singular_rcond) : singular_rcond_(singular_rcond) {
    require_singular_rcond(singular_rcond);
}

ANCF_INLINE void DirectSolver::analyze(const SparseMatrix& matrix) {
    require_storage(name(), matrix, storage());
    stage_.reset();
    if (matrix.cols() > 0) analyze_pattern(matrix);
    stage_.analysed(matrix);
}

ANCF_INLINE FactorReport DirectSolver::factorize(const SparseMatrix& matrix) {
    stage_.begin_factorisation(name(), matrix);
    if (matrix.cols() == 0)
        return stage_.finished({Status::converged, -1, 1.0, storage() == Storage::lower ? 0 : -1});
    FactorReport report = factorize_values(matrix);
    if (report.status == Status::converged && report.rcond == 0.0)
        report_condition(
            matrix, storage(), singular_rcond_,
            [this](const VectorX& b, VectorX& x) { substitute(b, x); }, report);
    return stage_.finished(report);
}

ANCF_INLINE void DirectSolver::solve(const VectorX& b, VectorX& x) const {
    stage_.require_solvable(name(), b);
    b.size() > 0 ? substitute(b, x) : x.resize(0);
}

}  // namespace ancf::detail
