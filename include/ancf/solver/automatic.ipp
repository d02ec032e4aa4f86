// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/error.hpp>
#include <ancf/solver/automatic.hpp>
#include <ancf/solver/block_tridiagonal_layout.hpp>
#include <ancf/solver/eigen_ldlt.hpp>

namespace ancf {

ANCF_LAZY Automatic::Automatic() : general_(std::make_unique<EigenLdlt>()) {}

ANCF_INLINE Automatic::Automatic(std::unique_ptr<LinearSolver> general, BlockTridiagonal chain)
    : chain_(std::move(chain)), general_(std::move(general)) {
    detail::require(general_ != nullptr, "Automatic needs a general solver, got none");
    detail::require(general_->storage() == Storage::lower,
                    "Automatic needs a solver of symmetric matrices, of lower storage, got ",
                    general_->name());
}

ANCF_INLINE void Automatic::analyze(const SparseMatrix& lower) {
    detail::require_storage("automatic", lower, storage());
    const int widest = detail::widest_block(detail::chain_starts(lower));
    is_chain_ = widest <= BlockTridiagonal::max_block;
    is_chain() ? chain_.analyze(lower) : general_->analyze(lower);
    explanation_ =
        is_chain()
            ? detail::joined({name(), ": a chain of ", chain_.blocks(), " blocks of up to ", widest,
                              " unknowns"})
            : detail::joined({name(), ": no chain, it would take a block of ", widest,
                              " unknowns, and ", BlockTridiagonal::max_block, " are the most"});
}

ANCF_INLINE FactorReport Automatic::factorize(const SparseMatrix& lower) {
    return is_chain() ? chain_.factorize(lower) : general_->factorize(lower);
}

ANCF_INLINE void Automatic::solve(const VectorX& b, VectorX& x) const { chosen().solve(b, x); }

}  // namespace ancf
