// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What a linear solver must offer, and what it reports.
///
/// Statics, dynamics and modal analysis take any class that meets is_linear_solver_v. The smallest
/// one wraps a dense factorisation:
///
///     class Dense {
///     public:
///         static constexpr ancf::Storage storage = ancf::Storage::full;
///         void analyze(const ancf::SparseMatrix&) {}
///         ancf::FactorReport factorize(const ancf::SparseMatrix& matrix) {
///             lu_.compute(ancf::MatrixX(matrix));
///             const bool good = lu_.rcond() > 1e-15;
///             return {good ? ancf::Status::converged : ancf::Status::singular};
///         }
///         void solve(const ancf::VectorX& b, ancf::VectorX& x) const { x = lu_.solve(b); }
///         static std::string_view name() { return "dense"; }
///     private:
///         Eigen::PartialPivLU<ancf::MatrixX> lu_;
///     };

#pragma once

#include <ancf/error.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ancf {

/// The outcome of one numerical factorisation.
///
/// `status` is converged, singular (where the method needs it also: not positive definite) or
/// not_finite. Only after converged may solve be called.
///
/// The solvers of this library estimate `rcond` within a factor of about 3, independent of units:
/// it is 1 / |(S A S)^-1|, with the diagonal matrix S that makes the diagonal of S A S one. That is
/// the reciprocal condition number up to |S A S|, which is between 1 and the number of entries in a
/// row where A is positive definite. Relative errors of a solution reach about eps / rcond.
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

namespace detail {

template <class Solver, class = void>
struct HasStorage : std::false_type {};
template <class Solver>
struct HasStorage<Solver, std::void_t<decltype(&Solver::storage)>>
    : std::is_same<decltype(&Solver::storage), const Storage*> {};  // static and constant

template <class Solver>
using AnalyzeResult =
    decltype(std::declval<Solver&>().analyze(std::declval<const SparseMatrix&>()));
template <class Solver, class = void>
struct HasAnalyze : std::false_type {};
template <class Solver>
struct HasAnalyze<Solver, std::void_t<AnalyzeResult<Solver>>> : std::true_type {};

template <class Solver>
using FactorizeResult =
    decltype(std::declval<Solver&>().factorize(std::declval<const SparseMatrix&>()));
template <class Solver, class = void>
struct HasFactorize : std::false_type {};
template <class Solver>
struct HasFactorize<Solver, std::void_t<FactorizeResult<Solver>>>
    : std::is_same<FactorizeResult<Solver>, FactorReport> {};

template <class Solver>
using SolveResult = decltype(std::declval<const Solver&>().solve(std::declval<const VectorX&>(),
                                                                 std::declval<VectorX&>()));
template <class Solver, class = void>
struct HasSolve : std::false_type {};
template <class Solver>
struct HasSolve<Solver, std::void_t<SolveResult<Solver>>> : std::true_type {};

template <class Solver>
using NameResult = decltype(std::declval<const Solver&>().name());
template <class Solver, class = void>
struct HasName : std::false_type {};
template <class Solver>
struct HasName<Solver, std::void_t<NameResult<Solver>>>
    : std::is_convertible<NameResult<Solver>, std::string_view> {};

}  // namespace detail

/// True if `Solver` meets the requirement:
///
/// - `static constexpr Storage storage`: the lower half of a symmetric matrix, or all of any;
/// - `void analyze(const SparseMatrix&)`: once per pattern;
/// - `FactorReport factorize(const SparseMatrix&)`: new values in that pattern, as often as wanted;
/// - `void solve(const VectorX& b, VectorX& x) const`: after a factorisation that converged;
/// - `std::string_view name() const`, may be static: the word that tables print.
///
/// The solvers of this library throw InvalidArgument for a matrix that is not square, compressed
/// and of their storage, for sizes that differ from those analysed, and for a solve without a
/// factorisation. In solve, b and x may be the same vector.
template <class Solver>
inline constexpr bool is_linear_solver_v =
    std::conjunction_v<detail::HasStorage<Solver>, detail::HasAnalyze<Solver>,
                       detail::HasFactorize<Solver>, detail::HasSolve<Solver>,
                       detail::HasName<Solver>>;

/// Stops the compilation, naming each missing member, unless is_linear_solver_v holds.
template <class Solver>
constexpr void require_linear_solver() noexcept {
    static_assert(detail::HasStorage<Solver>::value,
                  "a linear solver needs: static constexpr ancf::Storage storage;");
    static_assert(detail::HasAnalyze<Solver>::value,
                  "a linear solver needs: void analyze(const ancf::SparseMatrix&);");
    static_assert(
        detail::HasFactorize<Solver>::value,
        "a linear solver needs: ancf::FactorReport factorize(const ancf::SparseMatrix&);");
    static_assert(
        detail::HasSolve<Solver>::value,
        "a linear solver needs: void solve(const ancf::VectorX& b, ancf::VectorX& x) const;");
    static_assert(detail::HasName<Solver>::value,
                  "a linear solver needs: std::string_view name() const; it may be static");
}

namespace detail {

/// Throws unless the matrix is square, compressed, sorted, and of the storage asked for.
inline void require_storage(std::string_view solver, const SparseMatrix& matrix, Storage storage) {
    require(matrix.rows() == matrix.cols(), solver, " needs a square matrix, got ", matrix.rows(),
            " x ", matrix.cols());
    require(matrix.isCompressed(), solver,
            " needs a compressed matrix: call makeCompressed() first");
    const int* outer = matrix.outerIndexPtr();
    const int* inner = matrix.innerIndexPtr();
    for (int column = 0; column < static_cast<int>(matrix.cols()); ++column) {
        for (int slot = outer[column]; slot < outer[column + 1]; ++slot) {
            const int row = inner[slot];
            require(slot == outer[column] || inner[slot - 1] < row, solver,
                    " needs ascending rows, got row ", row, " out of order in column ", column);
            require(storage == Storage::full || row >= column, solver,
                    " needs the lower half of a symmetric matrix, got an entry at row ", row,
                    ", column ", column);
        }
    }
}

/// How far a solver is: nothing analysed, a pattern analysed, a factorisation that stands.
///
/// Keeps where the columns of the pattern start, a cheap test that factorize gets the same one. A
/// solver that was moved from starts again.
class SolverStage {
public:
    SolverStage() = default;
    SolverStage(const SolverStage&) = default;
    SolverStage& operator=(const SolverStage&) = default;
    SolverStage(SolverStage&& other) noexcept
        : columns_(std::move(other.columns_)),
          factorised_(std::exchange(other.factorised_, false)) {
        other.columns_.clear();
    }
    SolverStage& operator=(SolverStage&& other) noexcept {
        columns_.swap(other.columns_);
        factorised_ = other.factorised_;
        other.reset();
        return *this;
    }
    ~SolverStage() = default;

    void reset() noexcept {
        columns_.clear();
        factorised_ = false;
    }

    void analysed(const SparseMatrix& matrix) {
        const int* outer = matrix.outerIndexPtr();
        columns_.assign(1, 0);  // an empty matrix may have no such array
        if (matrix.cols() > 0) columns_.assign(outer, outer + matrix.cols() + 1);
        factorised_ = false;
    }

    /// Forgets the factorisation that stands.
    /// @throws InvalidArgument unless the matrix has the size and the columns analysed.
    void begin_factorisation(std::string_view solver, const SparseMatrix& matrix) {
        require(!columns_.empty(), solver, ": analyze must be called before factorize");
        require(matrix.rows() == size() && matrix.cols() == size(), solver,
                " analysed a matrix of ", size(), " x ", size(), ", got ", matrix.rows(), " x ",
                matrix.cols());
        const bool compressed = matrix.isCompressed();
        require(compressed && matrix.nonZeros() == columns_.back(), solver,
                " analysed a pattern of ", columns_.back(), " entries, got ", matrix.nonZeros(),
                compressed ? "" : ", not compressed");
        require(size() == 0 || std::equal(columns_.begin(), columns_.end(), matrix.outerIndexPtr()),
                solver, " analysed another pattern of as many entries");
        factorised_ = false;
    }

    /// Takes note of the outcome and returns it.
    const FactorReport& finished(const FactorReport& report) noexcept {
        factorised_ = report.status == Status::converged;
        return report;
    }

    /// @throws InvalidArgument unless a factorisation stands and the right-hand side has its size.
    void require_solvable(std::string_view solver, const VectorX& b) const {
        require(factorised_, solver, ": solve needs a factorisation that converged");
        require(b.size() == size(), solver, " factorised a matrix of ", size(), " x ", size(),
                ", got a right-hand side of ", b.size());
    }

private:
    [[nodiscard]] Eigen::Index size() const noexcept {
        return static_cast<Eigen::Index>(columns_.size()) - 1;
    }

    std::vector<int> columns_;  // outer indices of the pattern; none before analyze
    bool factorised_ = false;
};

}  // namespace detail
}  // namespace ancf
