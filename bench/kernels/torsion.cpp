// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/torsion/beam.hpp>

#include <kernels/measure.hpp>

namespace ancf::bench::kernels {

void torsion(const Settings& settings) {
    run<TorsionBeam>(settings, "torsion", {Rule::paper(), Rule::mixed()});
}

}  // namespace ancf::bench::kernels
