// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A solver that looks at the pattern, picks the one for chains or a general one, and says why.

#pragma once

#include <ancf/error.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <string>
#include <string_view>
#include <utility>

namespace ancf {

/// BlockTridiagonal where the unknowns form a chain, `General` where they do not.
///
/// The choice depends on the pattern alone, so it is the same for every factorisation:
///
///     ancf::Automatic<> solver;                              // Eigen alone
///     ancf::Automatic<ancf::suitesparse::Cholmod> solver;    // with SuiteSparse
///     solver.analyze(tangent);
///     std::cout << solver.explanation();
///
/// prints `block-tridiagonal: a chain of 64 blocks of up to 12 unknowns`.
template <class General = EigenLdlt>
class Automatic {
    static_assert(is_linear_solver_v<General>, "Automatic<General> needs a linear solver");
    static_assert(General::storage == Storage::lower,
                  "Automatic<General> needs a solver of symmetric matrices: Storage::lower");

public:
    static constexpr Storage storage = Storage::lower;  ///< the lower half is read

    /// Takes the two solvers, with the options they were given.
    explicit Automatic(BlockTridiagonal chain = BlockTridiagonal(), General general = General())
        : chain_(std::move(chain)), general_(std::move(general)) {}

    /// Chooses. @throws InvalidArgument unless square, compressed and lower.
    void analyze(const SparseMatrix& lower) {
        detail::require_storage("automatic", lower, storage);
        is_chain_ = BlockTridiagonal::accepts(lower);
        if (is_chain_) {
            chain_.analyze(lower);
        } else {
            general_.analyze(lower);
        }
        explain(lower);
    }

    /// Factorises in the pattern analysed.
    /// @throws InvalidArgument if its size or the number of entries in a column differs.
    [[nodiscard]] FactorReport factorize(const SparseMatrix& lower) {
        return is_chain_ ? chain_.factorize(lower) : general_.factorize(lower);
    }

    /// Solves A x = b. @throws InvalidArgument unless factorised and b has its size.
    void solve(const VectorX& b, VectorX& x) const {
        if (is_chain_) {
            chain_.solve(b, x);
        } else {
            general_.solve(b, x);
        }
    }

    /// The name of the solver chosen.
    [[nodiscard]] std::string_view name() const noexcept {
        return is_chain_ ? chain_.name() : general_.name();
    }

    /// Which solver was chosen and why, in one line; empty before analyze.
    [[nodiscard]] const std::string& explanation() const noexcept { return explanation_; }

    /// Whether the pattern is a chain.
    [[nodiscard]] bool is_chain() const noexcept { return is_chain_; }

private:
    void explain(const SparseMatrix& lower) {
        const int widest = detail::widest_block(detail::chain_starts(lower));
        explanation_ =
            is_chain_
                ? detail::joined({name(), ": a chain of ", chain_.blocks(), " blocks of up to ",
                                  widest, " unknowns"})
                : detail::joined({name(), ": no chain, it would take a block of ", widest,
                                  " unknowns, and ", BlockTridiagonal::max_block, " are the most"});
    }

    BlockTridiagonal chain_;
    General general_;
    bool is_chain_ = true;
    std::string explanation_;
};

}  // namespace ancf
