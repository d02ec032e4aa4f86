// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of momentum.hpp.

#pragma once

#include <ancf/assembly/resultant.hpp>
#include <ancf/dynamics/momentum.hpp>

namespace ancf {

ANCF_INLINE Momentum momentum(const DynamicProblem& problem, const State& state) {
    const Resultant sum =
        resultant(problem.model(), state.q, problem.assembly().mass_product(state.v));
    return {sum.force, sum.moment};
}

}  // namespace ancf
