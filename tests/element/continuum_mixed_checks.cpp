// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <element/continuum_mixed_checks.hpp>

namespace ancf {

template MixedEvaluation<double, 24> detail::Evaluator<ContinuumBeam<3>>::evaluate(
    const Vector<double, 24>&, const Vector<double, 24>&, const Vector<double, 24>&) const noexcept;

}  // namespace ancf
