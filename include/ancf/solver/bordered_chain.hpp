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

/// Solves chains with a border of multipliers block by block, and everything else by a general
/// solver.
///
/// It is made for beams in motion whose nodes follow each other in the model, with at most 24
/// multipliers. Every factorisation is tested. Where the chain does not solve to nine digits, the
/// general solver factorises this matrix. That happens for matrices that are not symmetric, as
/// EnergyMomentum makes them, and for beams at rest that only joints hold.
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

    /// Looks for a chain with a border; without one the general solver analyses the pattern.
    /// @param matrix  square, compressed, all entries; values do not matter.
    /// @throws InvalidArgument unless square and compressed; for what is no chain, in a solver that
    ///         was moved from: it has no general solver any more.
    ANCF_INLINE_VIRTUAL void analyze(const SparseMatrix& matrix) override;

    /// Factorises by the chain where that solves to nine digits, else by the general solver.
    /// @return  the report of the one that made it; of the chain negative_pivots is unknown.
    /// @throws InvalidArgument unless it has the pattern analysed. Without a chain only the size
    ///         and the number of entries in a column are compared.
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

    /// The same for complex matrices; its general solver may be that of complex_solver_for.
    [[nodiscard]] ANCF_INLINE_VIRTUAL std::unique_ptr<ComplexSolver> complex_solver()
        const override;

    /// Whether the pattern analysed is a chain with a border.
    [[nodiscard]] bool is_chain() const noexcept { return is_chain_; }

    /// Whether the last factorisation is that of the chain; false before one.
    [[nodiscard]] bool by_chain() const noexcept { return by_chain_; }

private:
    std::unique_ptr<LinearSolver> general_;
    detail::BorderedFactors<double> factors_;
    bool is_chain_ = true, by_chain_ = false;
    bool analysed_ = false;  // by the general solver
    double singular_rcond_ = default_singular_rcond;
    detail::SolverStage stage_;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/bordered_chain.ipp>  // IWYU pragma: export
#endif
