// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A direct solver for chains that constraints hold or join, in motion.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/solver/bordered_factors.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace ancf {

/// Solves by the blocks of a chain and a dense border of multipliers, or by a general solver.
///
/// For beams whose nodes follow each other in the model, with a few joints: at most 24 multipliers.
/// In motion it takes a third of a general solver's time. The general one is asked where there is
/// no such chain, and for each matrix that the chain does not solve to nine digits: that of a beam
/// at rest which only its multipliers hold, or one that is not symmetric. So it takes any matrix:
///
///     ancf::BorderedChain solver;                               // with EigenLu
///     ancf::BorderedChain solver{ancf::suitesparse::Klu()};     // with SuiteSparse
class BorderedChain final : public LinearSolver {
public:
    /// Most unknowns in the border.
    static constexpr int max_border = detail::BorderedFactors<double>::max_border;

    /// The general solver is EigenLu.
    ANCF_LAZY BorderedChain();

    /// @param singular_rcond  see default_singular_rcond; the general solver has its own.
    /// @throws InvalidArgument unless there is a solver, and it reads all of a matrix.
    explicit BorderedChain(std::unique_ptr<LinearSolver> general,
                           double singular_rcond = default_singular_rcond);

    /// Takes the general solver by value.
    template <class Solver, std::enable_if_t<std::is_base_of_v<LinearSolver, Solver>, int> = 0>
    explicit BorderedChain(Solver general, double singular_rcond = default_singular_rcond)
        : BorderedChain(std::make_unique<Solver>(std::move(general)), singular_rcond) {}

    /// All entries are read.
    [[nodiscard]] Storage storage() const noexcept override { return Storage::full; }

    /// @throws InvalidArgument unless square and compressed. The one that is moved from keeps no
    ///         general solver: it takes chains alone.
    ANCF_INLINE_VIRTUAL void analyze(const SparseMatrix& matrix) override;

    /// Factorises in the pattern analysed.
    /// @throws InvalidArgument if its size or the number of entries in a column differs.
    [[nodiscard]] ANCF_INLINE_VIRTUAL FactorReport factorize(const SparseMatrix& matrix) override;

    /// Solves A x = b. @throws InvalidArgument unless factorised and b has its size.
    ANCF_INLINE_VIRTUAL void solve(const VectorX& b, VectorX& x) const override;

    /// "bordered-chain", or that of the general solver where the pattern is no chain.
    [[nodiscard]] std::string_view name() const noexcept override {
        return is_chain_ || !general_ ? "bordered-chain" : general_->name();
    }

    /// That of the general solver, where it made the last factorisation.
    [[nodiscard]] std::string failure() const override {
        return by_chain_ || !general_ ? std::string() : general_->failure();
    }

    /// The same for complex matrices.
    [[nodiscard]] ANCF_INLINE_VIRTUAL std::unique_ptr<ComplexSolver> complex_solver()
        const override;

    /// Whether the pattern analysed is a chain with a border.
    [[nodiscard]] bool is_chain() const noexcept { return is_chain_; }

    /// Whether the last factorisation is that of the chain.
    [[nodiscard]] bool by_chain() const noexcept { return by_chain_; }

private:
    std::unique_ptr<LinearSolver> general_;
    detail::BorderedFactors<double> factors_;
    bool is_chain_ = true, by_chain_ = true;
    bool analysed_ = false;  // by the general solver
    double singular_rcond_ = default_singular_rcond;
    detail::SolverStage stage_;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/bordered_chain.ipp>  // IWYU pragma: export
#endif
