// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// An element without the tangent of mixed integration points.

#pragma once

#include <ancf/element/evaluation.hpp>
#include <ancf/types.hpp>

namespace ancf::test {

/// An element of the library less its mixed tangent, as a user's own may be.
template <class Base>
class Unmixed : public Base {
public:
    using Base::Base;

    /// Hides the overload of three states.
    template <class Scalar>
    [[nodiscard]] Evaluation<Scalar, Base::dofs> evaluate(
        const Vector<Scalar, Base::dofs>& e) const noexcept {
        return Base::evaluate(e);
    }
};

}  // namespace ancf::test
