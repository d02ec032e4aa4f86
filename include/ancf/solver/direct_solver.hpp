// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What the solvers by one sparse factorisation share: the order of calls, empty systems, and the
/// condition, so that a matrix that is singular but for round-off is found out.
///
/// The condition takes one solve or less. B = S A S has a unit diagonal, w is a fixed vector. The
/// softest motion dominates B^-1 w, so
///
///     |w| / |B^-1 w| = r / c,      w^T w / w^T B^-1 w = r / c^2,      r = 1 / |B^-1|,
///
/// where c is the share of w in that motion. Softest motions of structures vary slowly along them;
/// so does w, all of whose entries are about 1, and c = 0.3 is assumed. Measured on clamped, hinged
/// and free beams of 1 to 10 000 elements, askew to the axes, 3 to 1e6 times as long as high: r is
/// between a third and three times the converged value, and below 1.3 eps where round-off alone
/// keeps the matrix from being singular.
///
/// A matrix whose r is at or below the limit gets a second look, because its diagonal may tell no
/// scale: that of a body between welds is made of the forces in it, or of their round-off.
/// 1/rho(|A^-1| |A|) depends on no scales (F. L. Bauer, Numerische Mathematik 5, 1963). Where it is
/// above 1000 times the limit, the matrix is regular and it replaces r. In the tests it is below
/// 1e-15 where a matrix is singular, and above 1e-7 where not.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <cstdint>
#include <functional>

namespace ancf::detail {

/// The share c of w in the softest motion.
inline constexpr double probe_share = 0.3;

/// Throws unless the reciprocal condition number at which matrices count as singular makes sense.
void require_singular_rcond(double limit);

/// Returns entry `index` of w: in [0.5, 1.5), without a pattern.
[[nodiscard]] inline double probe_weight(std::int64_t index) noexcept {
    std::uint64_t bits = (static_cast<std::uint64_t>(index) + 1U) * 0x9E3779B97F4A7C15U;
    bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
    bits ^= bits >> 27U;
    return 0.5 + static_cast<double>(bits >> 11U) * 0x1.0p-53;
}

/// Fills `roots` with the diagonal of S^-1: sqrt|a_ii|; where that is zero, in a constraint's row,
/// with what scales its largest entry to 1.
void symmetric_roots(const SparseMatrix& matrix, VectorX& roots);

/// Fills `load` with S^-1 w and returns w^T w.
double probe_load(const VectorX& roots, VectorX& load);

/// Returns r from w^T w and w^T B^-1 w.
[[nodiscard]] double rcond_by_energy(double weights, double energy) noexcept;

/// Returns the unknown that takes most part in a motion S^-1 y, or -1 if there is none.
[[nodiscard]] int softest_unknown(const VectorX& roots, const VectorX& solution);

/// Turns a report into that of a singular matrix, or of one that is not finite.
void report_failure(const SparseMatrix& matrix, int column, FactorReport& report);

/// Completes the report of a factorisation that went through: rcond, and singular at `limit`.
/// @param storage  of the matrix
/// @param solve    the solver's own, called as solve(b, x)
void report_condition(const SparseMatrix& matrix, Storage storage, double limit,
                      const std::function<void(const VectorX& b, VectorX& x)>& solve,
                      FactorReport& report);

/// A linear solver by a sparse factorisation. A derived class brings its three phases, and is never
/// asked for an empty one.
class DirectSolver : public LinearSolver {
public:
    ANCF_INLINE_VIRTUAL void analyze(const SparseMatrix& matrix) final;

    [[nodiscard]] ANCF_INLINE_VIRTUAL FactorReport factorize(const SparseMatrix& matrix) final;

    ANCF_INLINE_VIRTUAL void solve(const VectorX& b, VectorX& x) const final;

protected:
    /// @param singular_rcond  see default_singular_rcond; 0 refuses zero pivots only.
    /// @throws InvalidArgument for one outside of [0, 1).
    explicit DirectSolver(double singular_rcond);

    [[nodiscard]] double singular_rcond() const noexcept { return singular_rcond_; }

private:
    /// The symbolic phase: takes the pattern of a matrix.
    virtual void analyze_pattern(const SparseMatrix& matrix) = 0;

    /// The numerical phase. A report without the condition is completed by one solution.
    [[nodiscard]] virtual FactorReport factorize_values(const SparseMatrix& matrix) = 0;

    /// The solution by the factors. b and x may be the same vector.
    virtual void substitute(const VectorX& b, VectorX& x) const = 0;

    double singular_rcond_;
    SolverStage stage_;
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/solver/direct_solver.ipp>  // IWYU pragma: export
#endif
