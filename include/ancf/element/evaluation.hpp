// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What one pass over an element returns: energy, elastic force and tangent together.

#pragma once

#include <ancf/types.hpp>

namespace ancf {

/// Energy and its first and second derivative with respect to the nodal coordinates e.
///
/// An aggregate: `const auto [energy, force, tangent] = element.evaluate(e);`
template <class Scalar, int Dofs>
struct Evaluation {
    Scalar energy;                 ///< U, J
    Vector<Scalar, Dofs> force;    ///< Q = dU/de, N for positions and N m for slopes
    Matrix<Scalar, Dofs> tangent;  ///< K = dQ/de, symmetric
};

}  // namespace ancf
