// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// How the damping of one element is timed.

#pragma once

#include <ancf/model/loads/damping.hpp>
#include <ancf/types.hpp>

#include <benchmark/benchmark.h>

#include <kernels/measure.hpp>

#include <memory>

namespace ancf::bench::kernels {

template <class Element>
void measure_damping(const Subject& subject, const Element& element) {
    constexpr int n = Element::dofs;
    const KelvinVoigt<Element> damper(std::make_shared<const Element>(element), {}, 1e-3);
    LoadState state{bent_state<Element>(), VectorX::LinSpaced(n, -1.0, 1.0), 0.0};
    LoadResult out{VectorX::Zero(n), MatrixX::Zero(n, n), MatrixX::Zero(n, n), 0.0};
    const double time = nanoseconds(
        [&] {
            state.q[0] += 1e-13;
            damper.evaluate(state, out);
            benchmark::ClobberMemory();
        },
        calls, subject.settings.repeats);
    report(subject, 1, "damp", time, 0);
}

}  // namespace ancf::bench::kernels
