// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Scaling of unknowns before a factorisation, and refinement of the solution after it.
///
/// Lengths, slopes, forces and moments differ by powers of slenderness. S A S with
/// S = diag(1/sqrt|a_ii|) has a unit diagonal, whatever the units, and is near the best conditioned
/// matrix that a diagonal scaling can reach. S is of powers of two, so it adds no round-off.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace ancf {

/// With how many digits a residual b - A x is summed.
enum class ResidualPrecision {
    working,  ///< of a double: takes out most of the factorisation's round-off
    twice     ///< of two doubles: takes out all of it, at some times the cost
};

/// How Scaled refines a solution.
struct ScaledOptions {
    int refinement_steps = 1;                                 ///< in each solve
    ResidualPrecision residual = ResidualPrecision::working;  ///< of each step
};

/// Scales a matrix symmetrically for another solver, and refines its solutions.
///
/// Reports what the inner solver reports of S A S; `rcond` is that of the scaled matrix.
///
///     ancf::Scaled solver{ancf::EigenLu()};
class Scaled final : public LinearSolver {
public:
    /// @throws InvalidArgument for no solver, and for negative refinement steps.
    explicit Scaled(std::unique_ptr<LinearSolver> solver, const ScaledOptions& options = {});

    /// Takes a solver by value, with the options it was given.
    template <class Solver, std::enable_if_t<std::is_base_of_v<LinearSolver, Solver>, int> = 0>
    explicit Scaled(Solver solver, const ScaledOptions& options = {})
        : Scaled(std::make_unique<Solver>(std::move(solver)), options) {}

    /// That of the inner solver.
    [[nodiscard]] Storage storage() const noexcept override { return storage_; }

    /// @throws InvalidArgument unless square, compressed, and of the storage and pattern that the
    ///         inner solver takes, and where this one was moved from.
    ANCF_INLINE_VIRTUAL void analyze(const SparseMatrix& matrix) override;

    [[nodiscard]] ANCF_INLINE_VIRTUAL FactorReport factorize(const SparseMatrix& matrix) override;

    ANCF_INLINE_VIRTUAL void solve(const VectorX& b, VectorX& x) const override;

    /// "scaled" and the name of the inner solver.
    [[nodiscard]] std::string_view name() const noexcept override { return name_; }

    /// That of the inner solver, of matrices that are not scaled.
    [[nodiscard]] std::unique_ptr<ComplexSolver> complex_solver() const override {
        return solver_ ? solver_->complex_solver() : nullptr;
    }

    /// The diagonal of S of the last factorisation.
    [[nodiscard]] const VectorX& scale() const noexcept { return scale_; }

    /// The solver that gets the scaled matrix.
    [[nodiscard]] const LinearSolver& inner() const noexcept { return *solver_; }

private:
    std::unique_ptr<LinearSolver> solver_;
    ScaledOptions options_;
    Storage storage_ = Storage::lower;
    std::string name_;
    SparseMatrix scaled_;
    VectorX scale_;
    detail::SolverStage stage_;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/scaled.ipp>  // IWYU pragma: export
#endif
