// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The linear solvers by name, those of SuiteSparse among them where it is there.

#pragma once

#if ANCF_WITH_SUITESPARSE
#include <ancf/suitesparse/solver_named.hpp>
#else
#include <ancf/solver/solver_named.hpp>
#endif

namespace ancf::bench {

#if ANCF_WITH_SUITESPARSE
using suitesparse::solver_named;
#else
using ancf::solver_named;
#endif

/// The solver of unsymmetric systems and saddle points.
inline constexpr const char* general_solver = ANCF_WITH_SUITESPARSE ? "klu" : "eigen-lu";

}  // namespace ancf::bench
