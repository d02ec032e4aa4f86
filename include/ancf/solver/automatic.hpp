// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A solver that looks at the pattern, picks the one for chains or a general one, and says why.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace ancf {

/// BlockTridiagonal where the unknowns form a chain, a general solver where they do not.
///
/// The choice depends on the pattern alone, so it is the same for every factorisation:
///
///     ancf::Automatic solver;                                  // with EigenLdlt
///     ancf::Automatic solver{ancf::suitesparse::Cholmod()};    // with SuiteSparse
///     solver.analyze(tangent);
///     std::cout << solver.explanation();
///
/// prints `block-tridiagonal: a chain of 64 blocks of up to 12 unknowns`. One that was moved from
/// has no general solver any more: it serves chains alone.
class Automatic final : public LinearSolver {
public:
    /// The general solver is EigenLdlt.
    ANCF_LAZY Automatic();

    /// Takes the two solvers, with the options they were given.
    /// @throws InvalidArgument unless the general one reads the lower half of symmetric matrices.
    explicit Automatic(std::unique_ptr<LinearSolver> general,
                       BlockTridiagonal chain = BlockTridiagonal());

    /// Takes the general solver by value.
    template <class Solver, std::enable_if_t<std::is_base_of_v<LinearSolver, Solver>, int> = 0>
    explicit Automatic(Solver general, BlockTridiagonal chain = BlockTridiagonal())
        : Automatic(std::make_unique<Solver>(std::move(general)), std::move(chain)) {}

    /// The lower half is read.
    [[nodiscard]] Storage storage() const noexcept override { return Storage::lower; }

    /// Chooses. @throws InvalidArgument unless square, compressed and lower.
    ANCF_INLINE_VIRTUAL void analyze(const SparseMatrix& lower) override;

    [[nodiscard]] ANCF_INLINE_VIRTUAL FactorReport factorize(const SparseMatrix& lower) override;

    ANCF_INLINE_VIRTUAL void solve(const VectorX& b, VectorX& x) const override;

    /// The name of the solver chosen.
    [[nodiscard]] std::string_view name() const noexcept override { return chosen().name(); }

    /// That of the solver chosen.
    [[nodiscard]] std::unique_ptr<ComplexSolver> complex_solver() const override {
        return chosen().complex_solver();
    }

    /// Which solver was chosen and why, in one line; empty before analyze.
    [[nodiscard]] const std::string& explanation() const noexcept { return explanation_; }

    /// Whether the pattern is a chain.
    [[nodiscard]] bool is_chain() const noexcept { return is_chain_ || !general_; }

private:
    [[nodiscard]] const LinearSolver& chosen() const noexcept {
        return is_chain() ? static_cast<const LinearSolver&>(chain_) : *general_;
    }

    BlockTridiagonal chain_;
    std::unique_ptr<LinearSolver> general_;
    bool is_chain_ = true;
    std::string explanation_;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/automatic.ipp>  // IWYU pragma: export
#endif
