// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/element/planar/beam.hpp>

#include <kernels/measure.hpp>

namespace ancf::bench::kernels {

void planar(const Settings& settings) {
    run<CrossSectionBeam<2>>(settings, "planar", {Rule::paper(), Rule::mixed()});
}

}  // namespace ancf::bench::kernels
