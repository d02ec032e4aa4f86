// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/model/loads/forces.hpp>

#include <utility>

namespace ancf {

template <int Dimension>
Force<Dimension>::Force(NodeId node, const VectorArgument<Dimension>& force)
    : node_(node), force_(force) {
    detail::require(detail::all_finite(force), "Force: components must be finite, got ",
                    detail::components(force));
}

template <int Dimension>
void Force<Dimension>::evaluate(const LoadState& state, LoadResult& out) const {
    for (int i = 0; i < Dimension; ++i) {
        out.force[i] = force_[i];
        out.potential -= force_[i] * state.q[i];
    }
}

ANCF_INLINE GeneralisedForce::GeneralisedForce(Coupling coupling, VectorX force)
    : coupling_(std::move(coupling)), force_(std::move(force)) {
    detail::require(detail::all_finite(force_), "GeneralisedForce: components must be finite, got ",
                    detail::components(force_));
}

ANCF_INLINE void GeneralisedForce::evaluate(const LoadState& state, LoadResult& out) const {
    detail::require(force_.size() == state.q.size(), "GeneralisedForce: ", state.q.size(),
                    " coordinates are coupled, got ", force_.size(), " force components");
    out.force = force_;
    out.potential = -detail::dot(force_, state.q);
}

#if defined(ANCF_SOURCE)
template class Force<2>;
template class Force<3>;
#endif

}  // namespace ancf
