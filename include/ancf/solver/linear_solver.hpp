// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The interface of linear solvers, and what they report.
///
/// Statics, dynamics and modal analysis take any class derived from LinearSolver. The smallest one
/// wraps a dense factorisation:
///
///     class Dense final : public ancf::LinearSolver {
///     public:
///         ancf::Storage storage() const noexcept override { return ancf::Storage::full; }
///         void analyze(const ancf::SparseMatrix&) override {}
///         ancf::FactorReport factorize(const ancf::SparseMatrix& matrix) override {
///             lu_.compute(ancf::MatrixX(matrix));
///             const bool good = lu_.rcond() > 1e-15;
///             return {good ? ancf::Status::converged : ancf::Status::singular};
///         }
///         void solve(const ancf::VectorX& b, ancf::VectorX& x) const override {
///             x = lu_.solve(b);
///         }
///         std::string_view name() const noexcept override { return "dense"; }
///     private:
///         Eigen::PartialPivLU<ancf::MatrixX> lu_;
///     };

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/solver/complex_solver.hpp>
#include <ancf/types.hpp>

#include <limits>
#include <memory>
#include <string>
#include <string_view>

namespace ancf {

/// The outcome of one numerical factorisation.
///
/// `status` is converged, singular (where the method needs it also: not positive definite) or
/// not_finite. Only after converged may solve be called.
///
/// The solvers of this library estimate `rcond` within a factor of about 3, independent of units:
/// it is 1 / |(S A S)^-1|, with the diagonal matrix S that makes the diagonal of S A S one. That is
/// the reciprocal condition number up to |S A S|, which is between 1 and the number of entries in a
/// row where A is positive definite. Relative errors of a solution reach about eps / rcond. Where
/// that is at or below the limit, but 1 / rho(|A^-1| |A|) above a thousand times it, rcond is the
/// latter, within a factor of 7: direct_solver.hpp.
struct FactorReport {
    Status status = Status::converged;  ///< see above
    int failed_column = -1;    ///< column of the matrix where it failed; -1 = none, or unknown
    double rcond = 0.0;        ///< reciprocal condition number, estimated; 0 = unknown, or none
    int negative_pivots = -1;  ///< negative eigenvalues of a symmetric matrix; -1 = unknown
};

/// The reciprocal condition number at or below which the solvers of this library call a matrix
/// singular: no digit of a solution would be right. For scale: a cantilever of n elements has about
/// 0.6 / n^4, so that its static deflection drowns in round-off beyond n = 6500.
inline constexpr double default_singular_rcond = 1.5 * std::numeric_limits<double>::epsilon();

/// Solves A x = b by a factorisation of A.
///
/// A solver serves one run at a time, which relies on its last factors: in an observer or another
/// callback of the run take another solver.
///
/// The solvers of this library throw InvalidArgument for a matrix that is not square, compressed
/// and of their storage, for sizes that differ from those analysed, and for a solve without a
/// factorisation.
class LinearSolver {
public:
    virtual ~LinearSolver() = default;

    /// What of a matrix is read: the lower half of a symmetric one, or all of any.
    [[nodiscard]] virtual Storage storage() const noexcept = 0;

    /// Prepares for a pattern; called once for each.
    virtual void analyze(const SparseMatrix& matrix) = 0;

    /// Factorises new values in the pattern analysed, as often as wanted.
    [[nodiscard]] virtual FactorReport factorize(const SparseMatrix& matrix) = 0;

    /// Solves A x = b after a factorisation that converged; b and x may be the same vector.
    virtual void solve(const VectorX& b, VectorX& x) const = 0;

    /// The word that tables print.
    [[nodiscard]] virtual std::string_view name() const noexcept = 0;

    /// Returns why the last factorisation or solution failed, empty where the status says all. A
    /// solution that failed has entries that are NaN.
    [[nodiscard]] virtual std::string failure() const { return {}; }

    /// Tells whether it iterates: the library then makes no factorisation besides.
    [[nodiscard]] virtual bool iterative() const noexcept { return false; }

    /// Returns a solver of complex matrices by the same library, or none: complex_solver_for takes
    /// one of the core then.
    [[nodiscard]] virtual std::unique_ptr<ComplexSolver> complex_solver() const { return nullptr; }

protected:
    LinearSolver() = default;
    LinearSolver(const LinearSolver&) = default;             ///< by derived classes alone
    LinearSolver(LinearSolver&&) = default;                  ///< by derived classes alone
    LinearSolver& operator=(const LinearSolver&) = default;  ///< by derived classes alone
    LinearSolver& operator=(LinearSolver&&) = default;       ///< by derived classes alone
};

namespace detail {

/// Solves A x = b; b and x may be the same vector.
/// @throws InvalidArgument where the solver gives another number of entries than b has.
void solve_with(const LinearSolver& solver, const VectorX& b, VectorX& x);

/// Owns what is complete only where hidden() makes it.
template <class T>
using Hidden = std::unique_ptr<T, void (*)(const T*)>;

/// Makes such an object.
template <class T, class... Arguments>
[[nodiscard]] Hidden<T> hidden(const Arguments&... arguments) {
    return {new T(arguments...), [](const T* object) { delete object; }};
}

/// Throws unless the matrix is square, compressed, sorted, and of the storage asked for.
void require_storage(std::string_view solver, const SparseMatrix& matrix, Storage storage);

/// How far a solver is: nothing analysed, a pattern analysed, a factorisation that stands.
///
/// Keeps where the columns of the pattern start, a cheap test that factorize gets the same one. A
/// solver that was moved from starts again.
class SolverStage {
public:
    void reset() noexcept {
        columns_.clear();
        factorised_ = false;
    }

    void analysed(const SparseMatrix& matrix);

    /// Forgets the factorisation that stands.
    /// @throws InvalidArgument unless the matrix has the size and the columns analysed.
    void begin_factorisation(std::string_view solver, const SparseMatrix& matrix);

    /// Takes note of the outcome and returns it.
    const FactorReport& finished(const FactorReport& report) noexcept {
        factorised_ = report.status == Status::converged;
        return report;
    }

    /// @throws InvalidArgument unless a factorisation stands and the right-hand side has its size.
    void require_solvable(std::string_view solver, const VectorX& b) const;

private:
    [[nodiscard]] Eigen::Index size() const noexcept {
        return static_cast<Eigen::Index>(columns_.size()) - 1;
    }

    List<int> columns_;  // outer indices of the pattern; none before analyze
    bool factorised_ = false;
};

}  // namespace detail
}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/linear_solver.ipp>  // IWYU pragma: export
#endif
